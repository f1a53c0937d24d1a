// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CREEP_PHYSICS_H
#define WHEELRAIL_CREEP_CREEP_PHYSICS_H

#include "contact/contact_temperature.h"
#include "law/contact_friction.h"

namespace wheelrail {

/// What acts on what in a sliding contact, whatever its shape: friction heats, heat weakens, and
/// weaker asperities rub and yield differently. SI units.
struct CreepPhysics {
  FrictionSpecification friction;
  ThermalSpecification thermal;
  bool hardnessLimit = false; ///< pressure stops at the hardness, 3 sigma_0(Theta)

  /// Does the temperature act back on friction or pressure? If not, one pass gives the solution.
  bool hasFeedback() const;

  /// Pa, at a temperature rise in K; infinite without `hardnessLimit`.
  double pressureLimit(double temperatureRise) const;

  /// @param hottest temperature rise anywhere in the contact, K
  /// @param speed m/s, and creep: of the point that is computed, for the message
  /// @throws Error (NotConverged) when a temperature rise that acts back leaves no strength
  void checkStrength(double hottest, double speed, double creep) const;
};

} // namespace wheelrail
#endif
