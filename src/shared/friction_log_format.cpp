// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/friction_log_format.h"

#include "shared/plain_number.h"

#include <cmath>

namespace mcawr::friction_log {

std::string formatLine()
{
  return std::string(headMark) + " format: " + format;
}

std::string columnLine()
{
  std::string line;
  for (const Column &column : columns)
    line += column.name + std::string(" ");
  return line + checkName;
}

bool isIn(Range range, double value)
{
  const auto isOrdinary = [](double x) { return x >= 1.0 / largest && x <= largest; };
  switch (range) {
  case Range::Positive:
    return isOrdinary(value);
  case Range::NotNegative:
    return value == 0.0 || isOrdinary(value);
  case Range::Signed:
    return value == 0.0 || isOrdinary(std::abs(value));
  case Range::PoissonsRatio:
    return value > -1.0 && value < 0.5;
  case Range::Whole:
    return value >= 0.0 && value <= largest && value == std::floor(value);
  case Range::SignedWhole:
    return std::abs(value) <= largestWhole && value == std::floor(value);
  }
  return false;
}

bool isInRow(double value)
{
  return std::abs(value) <= largest;
}

std::string describe(Range range, const std::string &unit)
{
  const std::string top = numberWord(largest), topWhole = numberWord(largestWhole);
  const std::string ordinary = numberWord(1.0 / largest) + " to " + top;
  const std::string inUnit = unit.empty() ? "" : " (" + unit + ")";
  switch (range) {
  case Range::Positive:
    return "> 0" + inUnit + ", " + ordinary;
  case Range::NotNegative:
    return ">= 0" + inUnit + ", 0 or " + ordinary;
  case Range::Signed:
    return "of either sign" + inUnit + ", 0 or " + ordinary;
  case Range::PoissonsRatio:
    return "in -1 .. 0.5";
  case Range::Whole:
    return ">= 0, whole, at most " + top;
  case Range::SignedWhole:
    return "that is whole, -" + topWhole + " to " + topWhole;
  }
  return "";
}

} // namespace mcawr::friction_log
