// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/hertz.h"

#include "shared/pi.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {
namespace {
using mcawr::pi;
}

HertzContact hertzContact(double load, double radius, double modulus)
{
  const double a = std::sqrt(4.0 * load * radius / (pi * modulus));
  return {load, radius, modulus, a, 2.0 * load / (pi * a)};
}

double HertzContact::pressure(double x) const
{
  const double ratio = x / halfWidth;
  return std::abs(ratio) < 1.0 ? hertzPressure * std::sqrt(1.0 - ratio * ratio) : 0.0;
}

double HertzContact::gap(double x) const
{
  const double ratio = std::abs(x) / halfWidth;
  if (ratio <= 1.0)
    return 0.0;
  const double root = std::sqrt(ratio * ratio - 1.0);
  return halfWidth * halfWidth / (2.0 * radius) * (ratio * root - std::log(ratio + root));
}

double initialSlope(double modulus, double realContactLength)
{
  return 0.25 * pi * modulus * realContactLength;
}

} // namespace wheelrail
