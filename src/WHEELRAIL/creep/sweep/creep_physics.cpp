// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/creep_physics.h"

#include "base/errors.h"

#include <fmt/format.h>
#include <limits>

namespace wheelrail {

bool CreepPhysics::hasFeedback(const FrictionLaw &law) const
{
  return thermal.model != ThermalModel::Off && (law.dependsOnTemperature() || hardnessLimit);
}

bool CreepPhysics::heatLimitsPressure() const
{
  return thermal.model != ThermalModel::Off && hardnessLimit;
}

double CreepPhysics::strengthInUse(const FrictionLaw &law) const
{
  return law.dependsOnStrength() || hardnessLimit ? strengthOf(law).cold : 0.0;
}

double CreepPhysics::pressureLimit(const FrictionLaw &law, double temperatureRise) const
{
  return hardnessLimit ? strengthOf(law).hardnessAt(temperatureRise)
                       : std::numeric_limits<double>::infinity();
}

Eigen::VectorXd CreepPhysics::pressureLimits(const FrictionLaw &law,
                                             const Eigen::VectorXd &temperatureRise) const
{
  if (!heatLimitsPressure() || thermal.model != ThermalModel::Local)
    return {};
  return temperatureRise.unaryExpr(
      [&strength = strengthOf(law)](double rise) { return strength.hardnessAt(rise); });
}

void CreepPhysics::checkStrength(const FrictionLaw &law, double hottest, double speed,
                                 double creep) const
{
  const bool feels = law.dependsOnStrength() || hardnessLimit;
  if (hasFeedback(law) && feels && strengthOf(law).vanishesAt(hottest))
    throw Error(
        ExitCode::NotConverged,
        fmt::format("creep {:g} at {:g} m/s: the temperature rise of {:.0f} K leaves no strength "
                    "(friction.strength_temperature is {:g} K)",
                    creep, speed, hottest, strengthOf(law).vanishingTemperature));
}

} // namespace wheelrail
