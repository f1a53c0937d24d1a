// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/friction_log_format.h"

#include <cmath>
#include <sstream>

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
  std::ostringstream text;
  const std::string inUnit = unit.empty() ? "" : " (" + unit + ")";
  switch (range) {
  case Range::Positive:
    text << "> 0" << inUnit << ", " << 1.0 / largest << " to " << largest;
    break;
  case Range::NotNegative:
    text << ">= 0" << inUnit << ", 0 or " << 1.0 / largest << " to " << largest;
    break;
  case Range::Signed:
    text << "of either sign" << inUnit << ", 0 or " << 1.0 / largest << " to " << largest;
    break;
  case Range::PoissonsRatio:
    text << "in -1 .. 0.5";
    break;
  case Range::Whole:
    text << ">= 0, whole, at most " << largest;
    break;
  case Range::SignedWhole:
    text << "that is whole, " << -largestWhole << " to " << largestWhole;
    break;
  }
  return text.str();
}

} // namespace mcawr::friction_log
