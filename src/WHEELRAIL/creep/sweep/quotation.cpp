// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/quotation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {

std::string quotation(const std::vector<QuotedPoint> &points)
{
  constexpr double wanted = 0.1, farthest = 2.0; // of the creep
  const auto distance = [](const QuotedPoint &point) {
    return point.creep == 0.0 ? INFINITY : std::abs(std::log(std::abs(point.creep) / wanted));
  };
  const auto nearest = std::min_element(
      points.begin(), points.end(),
      [&](const QuotedPoint &a, const QuotedPoint &b) { return distance(a) < distance(b); });
  if (nearest == points.end() || distance(*nearest) > std::log(farthest))
    return "";
  const double speed = points.front().speed;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double sum = 0.0, low = 0.0, high = 0.0, least = infinite, most = -infinite;
  int count = 0;
  for (const QuotedPoint &point : points) {
    if (point.speed != speed || point.creep != nearest->creep)
      continue;
    ++count;
    sum += point.ratio;
    low += point.band.low;
    high += point.band.high;
    least = std::min(least, point.ratio);
    most = std::max(most, point.ratio);
  }
  if (count == 0)
    return "";
  std::string text = fmt::format("T/N at {:.3g} % creep, {:g} m/s: {:.3f}", 100.0 * nearest->creep,
                                 speed, sum / count);
  if (nearest->band.standardError > 0.0)
    text += fmt::format(", 95 % of law {:.3f}..{:.3f}", low / count, high / count);
  if (count > 1)
    text += fmt::format(", of roughness {:.3f}..{:.3f} ({} surfaces)", least, most, count);
  return text + "\n";
}

} // namespace wheelrail
