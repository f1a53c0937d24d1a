// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/printable.h"

namespace mcawr {
namespace {

unsigned byteAt(std::string_view text, std::size_t i)
{
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

/// Length of the UTF-8 character at `i`; 0 where there is none that a terminal only shows.
std::size_t shownLength(std::string_view text, std::size_t i)
{
  const unsigned first = byteAt(text, i);
  if (first < 0x80)
    return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4)
    return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byteAt(text, i + k) & 0xc0U) != 0x80)
      return 0;
  const unsigned second = byteAt(text, i + 1);
  const bool isControl = first == 0xc2 && second < 0xa0;
  const bool isTooLong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool isNoCharacter = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return isControl || isTooLong || isNoCharacter ? 0 : length;
}

std::string escaped(char c)
{
  constexpr const char *digits = "0123456789abcdef";
  switch (c) {
  case '\n':
    return "\\n";
  case '\r':
    return "\\r";
  case '\t':
    return "\\t";
  default:
    const auto byte = static_cast<unsigned char>(c);
    return {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
  }
}

std::string shown(std::string_view text, bool keepsLines)
{
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = keepsLines && text[i] == '\n' ? 1 : shownLength(text, i);
    if (length == 0)
      result += escaped(text[i++]);
    else
      result += text.substr(i, length);
    i += length;
  }
  return result;
}

} // namespace

std::string printable(std::string_view text)
{
  return shown(text, false);
}

std::string printableLines(std::string_view text)
{
  return shown(text, true);
}

std::string shortened(const std::string &text)
{
  constexpr std::size_t longest = 400, begin = 120, end = 160;
  if (text.size() <= longest)
    return text;
  const auto atCharacter = [&](std::size_t i) {
    while (i < text.size() && (byteAt(text, i) & 0xc0U) == 0x80)
      ++i;
    return i;
  };
  return text.substr(0, atCharacter(begin)) + " ... " + text.substr(atCharacter(text.size() - end));
}

} // namespace mcawr
