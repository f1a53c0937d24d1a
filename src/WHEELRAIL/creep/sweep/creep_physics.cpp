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
  return law.dependsOnTemperature() || hardnessLimit ? strength.cold : 0.0;
}

double CreepPhysics::pressureLimit(double temperatureRise) const
{
  return hardnessLimit ? strength.hardnessAt(temperatureRise)
                       : std::numeric_limits<double>::infinity();
}

void CreepPhysics::checkStrength(const FrictionLaw &law, double hottest, double speed,
                                 double creep) const
{
  if (hasFeedback(law) && hottest >= strength.vanishingTemperature)
    throw Error(
        ExitCode::NotConverged,
        fmt::format("creep {} at {} m/s: the temperature rise of {:.0f} K leaves no strength "
                    "(friction.strength_temperature is {} K)",
                    creep, speed, hottest, strength.vanishingTemperature));
}

} // namespace wheelrail
