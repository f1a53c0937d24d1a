// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/formats/map_text.h"

#include "base/errors.h"
#include "base/quantity.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace wheelrail {

bool readDecimal(std::string_view text, double &value)
{
  if (text.size() > 1 && text.front() == '+' && text[1] != '-')
    text.remove_prefix(1);
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

long wholeNumber(const std::string &path, int line, const std::string &keyword,
                 const std::string &text)
{
  long value = -1;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || value < 0)
    throw badInput(path, line, keyword, fmt::format("'{}' is not a whole number >= 0", text));
  return value;
}

double positiveLength(const std::string &path, int line, const std::string &keyword,
                      const std::string &text)
{
  double value = 0.0;
  try {
    value = parseQuantity(text, "m");
  } catch (const std::invalid_argument &problem) {
    throw badInput(path, line, keyword, problem.what());
  }
  if (!(value > 0.0))
    throw badInput(path, line, keyword, fmt::format("'{}' must be positive", text));
  return value;
}

void checkMapSize(const std::string &path, int line, const std::string &keyword, long nx, long ny)
{
  if (nx < fewestMapPoints || ny < fewestMapPoints || nx > mostMapPoints || ny > mostMapPoints ||
      nx * ny > mostMapPoints)
    throw badInput(path, line, keyword,
                   fmt::format("{} x {} points; allowed are {} x {} to {} points in all", nx, ny,
                               fewestMapPoints, fewestMapPoints, mostMapPoints));
}

} // namespace wheelrail
