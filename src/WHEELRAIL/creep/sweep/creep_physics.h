// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_CREEP_PHYSICS_H
#define WHEELRAIL_CREEP_SWEEP_CREEP_PHYSICS_H

#include "contact/contact_temperature.h"
#include "contact/wear.h"
#include "law/friction_law.h"
#include "law/strength.h"

namespace wheelrail {

/// What acts on what in a sliding contact, whatever its shape: friction heats, heat weakens, and
/// weaker asperities rub and yield differently. SI units.
struct CreepPhysics {
  /// sigma_0 of the asperities, and how it falls with temperature, as the case says it.
  Strength strength;
  /// Model and material of the temperature; Off: no rise.
  ThermalSpecification thermal;
  bool hardnessLimit = false; ///< pressure stops at the hardness, 3 sigma_0(Theta)
  /// Way over which friction falls with the slip of each cell, m; 0: one sliding speed for all.
  double memoryLength = 0.0;
  WearLaw wear; ///< of what friction does; it changes nothing

  /// The strength of the law's own material, or else `strength`. Lives as long as both.
  const Strength &strengthOf(const FrictionLaw &law) const
  {
    return law.strength() ? *law.strength() : strength;
  }

  /// Does the temperature act back on friction or pressure? If not, one pass gives the solution.
  /// True where there is a thermal model, and either the law depends on temperature or the pressure
  /// has a limit.
  bool hasFeedback(const FrictionLaw &law) const;
  /// Does the temperature act back on the pressure, whatever the law?
  bool heatLimitsPressure() const;

  /// sigma_0 where the law or the limit of the pressure takes it, Pa; 0: nothing does.
  double strengthInUse(const FrictionLaw &law) const;

  /// Pa, at a temperature rise in K; infinite without `hardnessLimit`.
  double pressureLimit(const FrictionLaw &law, double temperatureRise) const;
  /// A limit for each cell at its own temperature, Pa, where heat limits the pressure and the model
  /// is local; elsewhere empty: one limit serves all cells.
  Eigen::VectorXd pressureLimits(const FrictionLaw &law,
                                 const Eigen::VectorXd &temperatureRise) const;

  /// \param hottest temperature rise anywhere in the contact, K
  /// \param speed m/s, and creep: of the point that is computed, for the message
  /// \throws Error (NotConverged) when a temperature rise that acts back leaves no strength
  /// The limit is friction.strength_temperature, at which sigma_0 has fallen to nothing.
  void checkStrength(const FrictionLaw &law, double hottest, double speed, double creep) const;
};

} // namespace wheelrail
#endif
