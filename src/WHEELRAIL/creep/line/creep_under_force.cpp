// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/creep_under_force.h"

#include "base/errors.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

namespace wheelrail {

double creepUnder(double force, const std::function<double(double creep)> &traction)
{
  constexpr double firstStep = 1e-6, largest = 10.0, tolerance = 1e-8, noise = 1e-6;
  constexpr int peakBits = 20; // of its creep: the traction there is known to twice as many
  const auto missing = [&](double creep) { return traction(creep) - force; };
  double before = 0.0, inner = 0.0, innerMissing = missing(0.0);
  if (innerMissing == 0.0)
    return 0.0;
  const double direction = innerMissing < 0.0 ? 1.0 : -1.0;
  double outer = firstStep * direction, outerMissing = missing(outer);
  bool grows = false; // where all slips, as unlike bodies may without creep, nothing does
  while (outerMissing * innerMissing > 0.0) {
    const double share = outerMissing / innerMissing;
    const bool falls = grows && share > 1.0 + noise;
    if (falls) { // the peak may still reach it
      std::uintmax_t steps = 60;
      inner = before;
      innerMissing = missing(inner);
      outer = boost::math::tools::brent_find_minima(
                  [&](double creep) { return -direction * missing(creep); }, std::min(inner, outer),
                  std::max(inner, outer), peakBits, steps)
                  .first;
      outerMissing = missing(outer);
      if (outerMissing * innerMissing <= 0.0)
        break;
    }
    if (falls || std::abs(outer) > largest)
      throw Error(ExitCode::NotConverged,
                  fmt::format("force.per_length: {:g} N/m is more than is carried: {:g} N/m at "
                              "creep {:g}",
                              force, outerMissing + force, outer));
    grows = grows || share < 1.0 - noise;
    before = inner;
    inner = outer;
    innerMissing = outerMissing;
    outer *= 2.0;
    outerMissing = missing(outer);
  }
  if (outerMissing == 0.0)
    return outer;
  const bool up = direction > 0.0;
  std::uintmax_t steps = 60;
  const auto [low, high] = boost::math::tools::toms748_solve(
      missing, up ? inner : outer, up ? outer : inner, up ? innerMissing : outerMissing,
      up ? outerMissing : innerMissing,
      [](double a, double b) {
        return std::abs(b - a) <= tolerance * std::max(std::abs(a), std::abs(b));
      },
      steps);
  return 0.5 * (low + high);
}

} // namespace wheelrail
