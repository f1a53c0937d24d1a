// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"

#include "shared/printable.h"

#include <fmt/format.h>

namespace wheelrail {

Error::Error(ExitCode code, const std::string &message)
    : std::runtime_error(mcawr::printable(message)), code_(code)
{
}

namespace {

/// A problem quotes what stands in the file, which may be all of it on one line: the middle is left
/// out, since what is wrong stands at the end.
std::string shortened(const std::string &problem)
{
  constexpr std::size_t longest = 400, begin = 120, end = 160;
  if (problem.size() <= longest)
    return problem;
  const auto atCharacter = [&](std::size_t i) { // not within one of UTF-8
    while (i < problem.size() && (static_cast<unsigned char>(problem[i]) & 0xc0U) == 0x80)
      ++i;
    return i;
  };
  return problem.substr(0, atCharacter(begin)) + " ... " +
         problem.substr(atCharacter(problem.size() - end));
}

} // namespace

Error badInput(const std::string &file, int line, const std::string &keyword,
               const std::string &problem)
{
  std::string text = file;
  if (line > 0)
    text += fmt::format(":{}", line);
  if (!keyword.empty())
    text += fmt::format(": {}", keyword);
  Error error(ExitCode::BadInput, fmt::format("{}: {}", text, shortened(problem)));
  error.file_ = file;
  error.line_ = line;
  error.keyword_ = keyword;
  return error;
}

} // namespace wheelrail
