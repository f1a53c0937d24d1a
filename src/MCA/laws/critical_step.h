// SPDX-License-Identifier: GPL-2.0-or-later
/// \file critical_step.h
/// The longest stable step of the explicit integration of a perfect packing.
#ifndef MCA_LAWS_CRITICAL_STEP_H
#define MCA_LAWS_CRITICAL_STEP_H

#include "material.h"
#include "packing.h"

namespace mca {

/// The limits [time]; infinity where the law is switched off.
struct CriticalStep {
  double elastic; ///< 2/omega over the Brillouin zone of the linked packing
  double viscous; ///< 2/lambda = D m/(N c), c = eta S/d: all N contacts damped, in antiphase
  double pressed; ///< 2/omega of the shear of a link that is pressed together until it collapses,
                  ///< which only plastic flow allows
  double own;     ///< D/N: a contact's share in lambda [-]

  /// Elasticity and viscosity acting on the same contacts, the forces knowing the velocity of half
  /// a step ago, hence damping shortens the step: omega^2 dt^2 + 2 lambda dt = 4.
  double plain() const;

  /// The same where viscous contacts have centredSeparation().
  double centred() const;
};

/// \param D          weight of the mean stress, 1 - 2G/(3K), or 0 for the pairwise law [-]
/// \param viscosity  eta of unlinked contacts [stress time], 0 without
CriticalStep criticalStep(const Material &, double D, double viscosity,
                          const Packing & = packing::hex);

} // namespace mca

#endif
