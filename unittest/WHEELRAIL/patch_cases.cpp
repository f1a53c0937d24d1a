// SPDX-License-Identifier: GPL-2.0-or-later
#include "patch_cases.h"
#include "shared/pi.h"

#include <cmath>
#include <random>

namespace patch_cases {

Eigen::VectorXd waves(const wheelrail::PatchGrid &grid, double rmsSlope, double shortest,
                      double longest, unsigned seed)
{
  constexpr int count = 60;
  using mcawr::pi;
  std::mt19937 random(seed); // its sequence is the same everywhere, unlike the distributions'
  const auto uniform = [&] { return random() / 4294967296.0; };
  Eigen::VectorXd height = Eigen::VectorXd::Zero(grid.cells());
  for (int i = 0; i < count; ++i) {
    const double length = shortest * std::pow(longest / shortest, uniform());
    const double direction = 2.0 * pi * uniform(), phase = 2.0 * pi * uniform();
    const double k = 2.0 * pi / length;
    const double amplitude = std::sqrt(2.0 / count) * rmsSlope / k;
    height += sampled(grid, [&](double x, double y) {
      return amplitude * std::cos(k * (std::cos(direction) * x + std::sin(direction) * y) + phase);
    });
  }
  return height;
}

} // namespace patch_cases
