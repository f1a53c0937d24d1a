// SPDX-License-Identifier: GPL-2.0-or-later
#include "mutator.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace {

/// What stands where a number is expected.
const std::vector<std::string> numbers = {"0",
                                          "-0",
                                          "1",
                                          "-1",
                                          "0.5",
                                          "1e308",
                                          "-1e308",
                                          "1e309",
                                          "5e-324",
                                          "1e-310",
                                          "nan",
                                          "-nan",
                                          "inf",
                                          "-Infinity",
                                          "NaN",
                                          "0x10",
                                          "1e",
                                          "1.",
                                          ".5",
                                          "+1",
                                          "1,5",
                                          "1 000",
                                          "2147483648",
                                          "4294967295",
                                          "9223372036854775808",
                                          "18446744073709551615",
                                          "99999999999999999999",
                                          "1000000000",
                                          "1e15",
                                          "1e-15",
                                          "",
                                          "''",
                                          "null",
                                          "true",
                                          "[]",
                                          "{}",
                                          "[1, 2]",
                                          "\"1\""};

bool isNumeric(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '+' ||
         c == 'e' || c == 'E';
}
bool isWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

void replaceAll(std::string &text, const std::string &from, const std::string &to)
{
  std::string result;
  for (std::size_t at = 0, next = 0; at <= text.size(); at = next + from.size()) {
    next = std::min(text.find(from, at), text.size());
    result += text.substr(at, next - at) + (next < text.size() ? to : "");
  }
  text = result;
}

/// UTF-16 of what was Latin-1.
std::string utf16(const std::string &text, bool bigEndian)
{
  std::string result;
  for (const char c : text)
    result += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
  return result;
}

/// The run of such letters around a place: begin and length.
template<class Is>
std::pair<std::size_t, std::size_t> runAround(const std::string &text, std::size_t at, Is is)
{
  std::size_t begin = at, end = at;
  while (begin > 0 && is(text[begin - 1]))
    begin--;
  while (end < text.size() && is(text[end]))
    end++;
  return {begin, end - begin};
}

} // namespace

Mutator::Mutator(std::vector<std::string> corpus, std::uint64_t seed)
    : corpus_(std::move(corpus)), seed_(seed)
{
  std::set<std::string> words = {"\n",
                                 "\r\n",
                                 "\t",
                                 "#",
                                 "\"",
                                 "'",
                                 ",",
                                 ":",
                                 "- ",
                                 "{",
                                 "}",
                                 "[",
                                 "]",
                                 "\\",
                                 "\\u0000",
                                 "\x1b[31m",
                                 "\xff\xfe",
                                 "\xc3\xa9",
                                 std::string(1, '\0'),
                                 "&a ",
                                 "*a",
                                 "<<: ",
                                 "!!binary ",
                                 "%"};
  for (const std::string &text : corpus_)
    for (std::size_t at = 0; at < text.size() && words.size() < 4000; at++)
      if (isWord(text[at])) {
        const auto [begin, length] = runAround(text, at, isWord);
        words.insert(text.substr(begin, std::min<std::size_t>(length, 40)));
        at = begin + length;
      }
  words_.assign(words.begin(), words.end());
}

std::size_t Mutator::below(std::size_t n)
{
  return n == 0 ? 0 : random_() % n;
}

std::string Mutator::operator()(std::uint64_t number)
{
  static constexpr Change changes[] = {
      &Mutator::flipBit,       &Mutator::setByte,     &Mutator::insertBytes,
      &Mutator::eraseRange,    &Mutator::repeatRange, &Mutator::replaceNumber,
      &Mutator::replaceNumber, &Mutator::replaceWord, &Mutator::moveLine,
      &Mutator::splice,        &Mutator::nest,        &Mutator::cutEnd,
      &Mutator::otherMachine};
  std::seed_seq both{seed_, seed_ >> 32, number, number >> 32};
  random_.seed(both);
  std::string text = anyOf(corpus_);
  // mostly one change: many at once are refused at the first
  const std::size_t count = below(2) ? 1 : 1 + below(8);
  for (std::size_t k = 0; k < count; k++)
    (this->*changes[below(std::size(changes))])(text);
  return text;
}

void Mutator::flipBit(std::string &text)
{
  if (!text.empty())
    text[below(text.size())] ^= static_cast<char>(1 << below(8));
}

void Mutator::setByte(std::string &text)
{
  if (!text.empty())
    text[below(text.size())] = static_cast<char>(below(256));
}

void Mutator::insertBytes(std::string &text)
{
  std::string bytes(1 + below(below(20) ? 8 : 2000), static_cast<char>(below(256)));
  if (below(2))
    for (char &c : bytes)
      c = static_cast<char>(below(256));
  text.insert(below(text.size() + 1), bytes);
}

void Mutator::eraseRange(std::string &text)
{
  text.erase(below(text.size() + 1), 1 + below(below(2) ? 8 : 200));
}

void Mutator::repeatRange(std::string &text)
{
  const std::string piece = text.substr(below(text.size() + 1), 1 + below(100));
  const std::size_t at = below(text.size() + 1), times = 1 + below(below(20) ? 2 : 200);
  for (std::size_t k = 0; k < times; k++)
    text.insert(at, piece);
}

void Mutator::replaceNumber(std::string &text)
{
  if (text.empty())
    return;
  const std::size_t start = below(text.size());
  for (std::size_t k = 0; k < text.size(); k++) {
    const std::size_t at = (start + k) % text.size();
    if (!std::isdigit(static_cast<unsigned char>(text[at])))
      continue;
    const auto [begin, length] = runAround(text, at, isNumeric);
    text.replace(begin, length, anyOf(numbers));
    return;
  }
}

void Mutator::replaceWord(std::string &text)
{
  const auto [begin, length] = runAround(text, below(text.size()), isWord);
  text.replace(begin, length, anyOf(words_));
}

void Mutator::moveLine(std::string &text)
{
  const std::size_t at = below(text.size());
  const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t after = text.find('\n', at);
  const std::size_t end = after == std::string::npos ? text.size() : after + 1;
  if (begin >= end)
    return;
  const std::string line = text.substr(begin, end - begin);
  if (below(3)) // else it appears twice
    text.erase(begin, end - begin);
  const std::size_t to = text.find('\n', below(text.size() + 1));
  if (below(3)) // else it is gone
    text.insert(to == std::string::npos ? text.size() : to + 1, line);
}

void Mutator::splice(std::string &text)
{
  const std::string &other = anyOf(corpus_);
  const std::string piece = other.substr(below(other.size() + 1), 1 + below(300));
  text.replace(below(text.size() + 1), below(2) ? 0 : piece.size(), piece);
}

void Mutator::nest(std::string &text)
{
  static const std::vector<std::string> marks = {"[", "{", "(", "- ", "{\"a\":", "[[", "? ", "\t"};
  std::string deep;
  const std::string &mark = anyOf(marks);
  for (std::size_t k = 1 + below(below(10) ? 20 : 20000); k > 0; k--)
    deep += mark;
  text.insert(below(text.size() + 1), deep);
}

void Mutator::cutEnd(std::string &text)
{
  text.resize(below(text.size() + 1));
}

void Mutator::otherMachine(std::string &text)
{
  static const std::vector<std::string> separators = {",", ";", "\t", " ", "; ", " , "};
  switch (below(8)) {
  case 0:
    replaceAll(text, "\n", anyOf({"\r\n", "\r", "\n\r", "\n\n"}));
    break;
  case 1:
    text.insert(0, anyOf({"\xef\xbb\xbf", "\xff\xfe", "\xfe\xff", "\xef\xbb\xbf\xef\xbb\xbf"}));
    break;
  case 2: {
    const bool bigEndian = below(2) != 0;
    text = anyOf({"", bigEndian ? "\xfe\xff" : "\xff\xfe"}) + utf16(text, bigEndian);
    break;
  }
  case 3:
    replaceAll(text, "um", anyOf({"\xb5m", "\xc2\xb5m", "\xce\xbcm", "\xe6m"}));
    break;
  case 4:
    replaceAll(text, ".", ",");
    break;
  case 5:
    replaceAll(text, anyOf(separators), anyOf(separators));
    break;
  case 6:
    replaceAll(text, "\n", anyOf(separators) + "\n"); // cells of a spreadsheet that are empty
    break;
  default:
    replaceAll(text, ".", ",");
    replaceAll(text, anyOf(separators), ";");
  }
}
