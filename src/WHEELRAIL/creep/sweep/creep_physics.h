// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_CREEP_PHYSICS_H
#define WHEELRAIL_CREEP_SWEEP_CREEP_PHYSICS_H

#include "contact/contact_temperature.h"
#include "law/contact_friction.h"

namespace wheelrail {

/// What acts on what in a sliding contact, whatever its shape: friction heats, heat weakens, and
/// weaker asperities rub and yield differently. SI units.
struct CreepPhysics {
  /// Law or constant; also strength sigma_0 (Pa) and how it falls with temperature.
  FrictionSpecification friction;
  /// Model and material of the temperature; Off: no rise.
  ThermalSpecification thermal;
  bool hardnessLimit = false; ///< pressure stops at the hardness, 3 sigma_0(Theta)

  /// Does the temperature act back on friction or pressure? If not, one pass gives the solution.
  /// True where there is a thermal model, and either the friction falls with the strength or the
  /// pressure has a limit.
  bool hasFeedback() const;

  /// Pa, at a temperature rise in K; infinite without `hardnessLimit`.
  /// The hardness is read from `friction` even where the coefficient is constant.
  double pressureLimit(double temperatureRise) const;

  /// @param hottest temperature rise anywhere in the contact, K
  /// @param speed m/s, and creep: of the point that is computed, for the message
  /// @throws Error (NotConverged) when a temperature rise that acts back leaves no strength
  /// The limit is friction.strength_temperature, at which sigma_0 has fallen to nothing.
  void checkStrength(double hottest, double speed, double creep) const;
};

} // namespace wheelrail
#endif
