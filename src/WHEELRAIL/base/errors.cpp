// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"

#include "shared/printable.h"

#include <fmt/format.h>

namespace wheelrail {

Error::Error(ExitCode code, const std::string &message)
    : std::runtime_error(mcawr::printable(message)), code_(code)
{
}

Error badInput(const std::string &file, int line, const std::string &keyword,
               const std::string &problem)
{
  std::string text = file;
  if (line > 0)
    text += fmt::format(":{}", line);
  if (!keyword.empty())
    text += fmt::format(": {}", keyword);
  Error error(ExitCode::BadInput, fmt::format("{}: {}", text, mcawr::shortened(problem)));
  error.file_ = file;
  error.line_ = line;
  error.keyword_ = keyword;
  return error;
}

} // namespace wheelrail
