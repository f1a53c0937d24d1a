// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/plain_text.h"

#include <algorithm>
#include <iterator>

namespace mcawr {
namespace {

constexpr std::string_view utf8Mark = "\xef\xbb\xbf";

bool begins(std::string_view text, std::string_view head)
{
  return text.substr(0, head.size()) == head;
}

unsigned byteAt(std::string_view text, std::size_t i)
{
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

void appendUtf8(std::string &text, unsigned code)
{
  const auto following = [&](unsigned shift) {
    text += static_cast<char>(0x80U | (code >> shift & 0x3fU));
  };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xc0U | code >> 6U);
    following(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xe0U | code >> 12U);
    following(6);
    following(0);
  } else {
    text += static_cast<char>(0xf0U | code >> 18U);
    following(12);
    following(6);
    following(0);
  }
}

/// A half of a pair that is alone becomes a character that no number and no word holds.
std::string fromUtf16(std::string_view bytes, bool bigEndian)
{
  constexpr unsigned unknown = 0xfffd;
  const auto unitAt = [&](std::size_t i) {
    return bigEndian ? byteAt(bytes, i) << 8U | byteAt(bytes, i + 1)
                     : byteAt(bytes, i + 1) << 8U | byteAt(bytes, i);
  };
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    unsigned code = unitAt(i);
    if (code >= 0xd800 && code < 0xe000) {
      const unsigned low = i + 3 < bytes.size() ? unitAt(i + 2) : 0;
      const bool paired = code < 0xdc00 && low >= 0xdc00 && low < 0xe000;
      code = paired ? 0x10000 + ((code - 0xd800) << 10U) + (low - 0xdc00) : unknown;
      i += paired ? 2 : 0;
    }
    appendUtf8(text, code);
  }
  return text;
}

bool isUtf8(std::string_view text)
{
  for (std::size_t i = 0; i < text.size();) {
    const unsigned first = byteAt(text, i);
    const std::size_t length = first < 0x80 ? 1 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if ((first >= 0x80 && first < 0xc2) || first > 0xf4 || i + length > text.size())
      return false;
    for (std::size_t k = 1; k < length; ++k)
      if ((byteAt(text, i + k) & 0xc0U) != 0x80)
        return false;
    i += length;
  }
  return true;
}

std::string fromLatin1(std::string_view bytes)
{
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 16);
  for (const char c : bytes)
    appendUtf8(text, static_cast<unsigned char>(c));
  return text;
}

/// Every "\r\n" and every '\r' becomes '\n'; in place.
void renewLineEnds(std::string &text)
{
  if (text.find('\r') == std::string::npos)
    return;
  std::size_t to = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n')
      continue;
    text[to++] = text[i] == '\r' ? '\n' : text[i];
  }
  text.resize(to);
}

/// What is wrong with a text that has zeros: UTF-16 has one for each letter and digit.
std::string problemOfNul(std::string_view bytes, std::size_t nul)
{
  const std::string_view head = bytes.substr(0, 64);
  const auto zeros = static_cast<std::size_t>(std::count(head.begin(), head.end(), '\0'));
  if (head.size() >= 4 && 3 * zeros >= head.size() && 2 * zeros <= head.size() + 2)
    return "is UTF-16 without a byte order mark; save it as UTF-8";
  return "is binary, not text: byte " + std::to_string(nul) + " is 0";
}

constexpr std::string_view utf16Marks[] = {"\xff\xfe", "\xfe\xff"};
constexpr std::string_view utf32Marks[] = {{"\xff\xfe\0\0", 4}, {"\0\0\xfe\xff", 4}};

template<std::size_t Count>
bool beginsWithOne(std::string_view bytes, const std::string_view (&marks)[Count])
{
  return std::any_of(std::begin(marks), std::end(marks),
                     [&](std::string_view mark) { return begins(bytes, mark); });
}

} // namespace

bool hasTextMark(std::string_view bytes)
{
  return begins(bytes, utf8Mark) || beginsWithOne(bytes, utf16Marks) ||
         beginsWithOne(bytes, utf32Marks);
}

PlainText plainText(std::string_view bytes)
{
  if (beginsWithOne(bytes, utf32Marks))
    return {"", "is UTF-32; save it as UTF-8"};
  PlainText result;
  if (beginsWithOne(bytes, utf16Marks))
    result.text = fromUtf16(bytes.substr(2), begins(bytes, "\xfe"));
  else if (begins(bytes, utf8Mark))
    result.text = bytes.substr(utf8Mark.size());
  else
    result.text = bytes;
  if (const auto nul = result.text.find('\0'); nul != std::string::npos)
    return {"", problemOfNul(bytes, nul)};
  if (!isUtf8(result.text))
    result.text = fromLatin1(result.text);
  renewLineEnds(result.text);
  return result;
}

} // namespace mcawr
