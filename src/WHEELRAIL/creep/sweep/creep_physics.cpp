// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/creep_physics.h"

#include "base/errors.h"

#include <fmt/format.h>
#include <limits>

namespace wheelrail {

bool CreepPhysics::hasFeedback() const
{
  return thermal.model != ThermalModel::Off && (friction.isScaled() || hardnessLimit);
}

double CreepPhysics::pressureLimit(double temperatureRise) const
{
  return hardnessLimit ? friction.hardnessAt(temperatureRise)
                       : std::numeric_limits<double>::infinity();
}

void CreepPhysics::checkStrength(double hottest, double speed, double creep) const
{
  if (hasFeedback() && hottest >= friction.strengthTemperature)
    throw Error(
        ExitCode::NotConverged,
        fmt::format("creep {} at {} m/s: the temperature rise of {:.0f} K leaves no strength "
                    "(friction.strength_temperature is {} K)",
                    creep, speed, hottest, friction.strengthTemperature));
}

} // namespace wheelrail
