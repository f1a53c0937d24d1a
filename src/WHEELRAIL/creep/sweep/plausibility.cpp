// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/plausibility.h"

#include "base/si.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

constexpr double hardnessOverStrength = 3.0; // as `Strength::hardnessAt`
constexpr double modulusOverBearable = 50.0;

} // namespace

std::string slopeDoubt(const std::string &step, double rmsSlope)
{
  if (!(rmsSlope > 1.0))
    return "";
  return fmt::format("roughness: {}: rms slope {:.4g}; above 1 no half-space is near the surface. "
                     "Are the units of height and spacing right?",
                     step, rmsSlope);
}

std::string pressureDoubt(double peak, double strength, double youngsModulus)
{
  const bool known = strength > 0.0;
  const double limit =
      known ? hardnessOverStrength * strength : youngsModulus / modulusOverBearable;
  if (!(peak > limit * (1.0 + 1e-9))) // a pressure that stops at the hardness is rounded
    return "";
  return fmt::format(
      "contact: peak pressure {:.4g} MPa, above {} = {:.4g} MPa: the material would "
      "flow. contact.hardness_limit stops the pressure there; or a load, a radius or "
      "a unit is wrong",
      peak / MPa, known ? "3 friction.strength" : "youngs_modulus/50", limit / MPa);
}

std::string creepDoubt(const std::string &keyword, const std::vector<double> &values)
{
  double largest = 0.0;
  for (const double value : values)
    if (std::abs(value) > std::abs(largest))
      largest = value;
  if (!(std::abs(largest) > 1.0))
    return "";
  return fmt::format("{}: {:.4g} ({:.4g} %); above 1 the bodies slide faster than they roll",
                     keyword, largest, 100.0 * largest);
}

std::string sizeDoubt(double halfAxis, double radius)
{
  if (!(halfAxis > radius))
    return "";
  return fmt::format(
      "contact: it reaches {:.4g} mm from its middle, the radius is {:.4g} mm; Hertz's "
      "theory is for contacts much smaller than the radius",
      halfAxis / mm, radius / mm);
}

std::string radiusDoubt(double radius)
{
  constexpr double largest = 10.0; // m
  if (!(radius > largest))
    return "";
  return fmt::format("contact: a rolling radius of {:.4g} m; no wheel has more than {:g} m", radius,
                     largest);
}

std::string speedDoubt(const std::string &keyword, const std::vector<double> &values)
{
  constexpr double fastest = 200.0; // m/s; the record of a train is 160
  const auto largest = std::max_element(values.begin(), values.end());
  if (largest == values.end() || !(*largest > fastest))
    return "";
  return fmt::format("{}: {:.4g} m/s ({:.4g} km/h); no wheel on rails is faster than {:g} m/s",
                     keyword, *largest, 3.6 * *largest, fastest);
}

std::string pecletDoubt(const std::string &keyword, const std::vector<double> &values,
                        double halfWidth, const ThermalSpecification &thermal)
{
  constexpr double least = 5.0; // the mean over a line is 2.5 % below that of a half-space
  const auto slowest = std::min_element(values.begin(), values.end());
  if (thermal.model == ThermalModel::Off || slowest == values.end())
    return "";
  const double peclet = pecletNumber(halfWidth, *slowest, thermal.material);
  if (!(peclet < least))
    return "";
  return fmt::format("thermal: the Peclet number is {:.3g} at {}: {:.4g} m/s; temperatures are of "
                     "heat that flows into the depth only, and below {:g} it spreads along the "
                     "contact and across it, too",
                     peclet, keyword, *slowest, least);
}

std::string memoryDoubt(double length, bool dependsOnSpeed)
{
  if (!(length > 0.0) || dependsOnSpeed)
    return "";
  return fmt::format(
      "friction.memory_length: {:.4g} mm have no effect: mu of friction.law does not "
      "depend on the sliding speed",
      length / mm);
}

void addDoubt(std::vector<std::string> &warnings, const std::string &line)
{
  if (!line.empty() && std::find(warnings.begin(), warnings.end(), line) == warnings.end())
    warnings.push_back(line);
}

} // namespace wheelrail
