// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/text_lines.h"

#include "base/errors.h"
#include "base/program_files.h"
#include "shared/plain_text.h"

namespace wheelrail {

std::string plainTextOf(const std::string &path, std::string_view bytes)
{
  mcawr::PlainText plain = mcawr::plainText(bytes);
  if (!plain.problem.empty())
    throw badInput(path, 0, "", plain.problem);
  return std::move(plain.text);
}

std::string readTextFile(const std::string &path)
{
  return plainTextOf(path, readInputFile(path));
}

std::string_view trimmedView(std::string_view text)
{
  constexpr const char *blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool LineReader::next(std::string_view &line)
{
  if (rest_.empty())
    return false;
  const auto end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
  if (!line.empty() && line.back() == '\r') // of a head before binary data
    line.remove_suffix(1);
  ++number_;
  return true;
}

} // namespace wheelrail
