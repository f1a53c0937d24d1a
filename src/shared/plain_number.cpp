// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/plain_number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace mcawr {

std::optional<LeadingNumber> leadingNumber(std::string_view text)
{
  // from_chars knows no plus sign; one is common in hand-written files
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const std::string_view body = plus ? text.substr(1) : text;
  double value = 0.0;
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), value);
  if (error != std::errc() || !std::isfinite(value))
    return std::nullopt;
  return LeadingNumber{value, body.substr(static_cast<std::size_t>(end - body.data()))};
}

std::optional<double> plainNumber(std::string_view text)
{
  const auto number = leadingNumber(text);
  if (!number || !number->rest.empty())
    return std::nullopt;
  return number->value;
}

std::string numberWord(double value, int digits)
{
  std::array<char, 32> word; // sign, 17 digits, point, exponent of five letters
  const auto [end, error] = std::to_chars(word.data(), word.data() + word.size(), value,
                                          std::chars_format::general, digits);
  return error == std::errc() ? std::string(word.data(), end) : std::string();
}

} // namespace mcawr
