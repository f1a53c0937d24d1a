// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/law_checksum.h"

#include "base/checksum.h"

#include <fmt/format.h>
#include <stdexcept>

namespace wheelrail {
namespace {

constexpr const char *lineBegin = R"(  "checksum": ")";

std::string lineOf(const std::string &others)
{
  return fmt::format("{}{}\",\n", lineBegin, checksum(others));
}

} // namespace

std::string withChecksum(const std::string &text)
{
  const auto format = text.find("\n  \"format\":");
  const auto end = format == std::string::npos ? format : text.find('\n', format + 1);
  if (end == std::string::npos)
    throw std::logic_error("a law file without the line of its format");
  std::string sealed = text;
  return sealed.insert(end + 1, lineOf(text));
}

bool fitsChecksum(const std::string &text)
{
  const auto newline = text.find(std::string("\n") + lineBegin);
  const auto end = newline == std::string::npos ? newline : text.find('\n', newline + 1);
  if (end == std::string::npos)
    return false;
  const std::string line = text.substr(newline + 1, end - newline);
  std::string others = text;
  others.erase(newline + 1, line.size());
  return line == lineOf(others);
}

} // namespace wheelrail
