// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/monotone_curve.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {

double limitedSlope(double before, double after)
{
  if (before * after <= 0.0)
    return 0.0;
  // of the ratio of both, so that nothing overflows
  const double flat = std::abs(before) < std::abs(after) ? before : after;
  const double r = std::abs(flat / (before + after - flat));
  return 2.0 * flat * r / (1.0 + r * r * r);
}

double hermite(double width, double y0, double s0, double y1, double s1, double at)
{
  const double t = at / width, u = 1.0 - t;
  return u * u * ((1.0 + 2.0 * t) * y0 + t * width * s0) +
         t * t * ((1.0 + 2.0 * u) * y1 - u * width * s1);
}

std::size_t pieceOf(const std::vector<double> &x, double at)
{
  const auto right = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  return static_cast<std::size_t>(right - x.begin()) - 1;
}

double MonotoneCurve::operator()(double at) const
{
  if (at <= x.front())
    return y.front();
  if (at >= x.back())
    return y.back();
  const auto secant = [this](std::size_t k) { return (y[k + 1] - y[k]) / (x[k + 1] - x[k]); };
  const auto slope = [&](std::size_t k) {
    return k == 0 || k + 1 == x.size() ? 0.0 : limitedSlope(secant(k - 1), secant(k));
  };
  const std::size_t k = pieceOf(x, at);
  return hermite(x[k + 1] - x[k], y[k], slope(k), y[k + 1], slope(k + 1), at - x[k]);
}

} // namespace wheelrail
