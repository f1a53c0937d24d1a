// SPDX-License-Identifier: GPL-2.0-or-later
/// \file critical_step.h
/// The longest stable step of the explicit integration of a perfect packing.
#ifndef MCA_LAWS_CRITICAL_STEP_H
#define MCA_LAWS_CRITICAL_STEP_H

#include "material.h"
#include "packing.h"

namespace mca {

/// The limits of a packing of one material [time]; infinity where the law is switched off.
/// doc/laws.md, Time integration and Corrected steps, derives them.
struct CriticalStep {
  double elastic; ///< 2/omega over the Brillouin zone of the linked packing
  double viscous; ///< 2/lambda: D m/(N c), c = eta S/d, with all N contacts damped, in antiphase;
                  ///< where they resist slip, all automata turn alike: 4 J/(f N c d^2), f = 1 in
                  ///< the plane and 2/3 in space
  double pressed; ///< 2/omega of the shear of a link that is pressed together until it collapses,
                  ///< which only plastic flow allows
  double share;   ///< the part of lambda that centred velocities take at the new velocity [-]: a
                  ///< contact's own, D/N, or with slip centredSlipShare

  /// Elasticity and viscosity acting on the same contacts, the forces knowing the velocity of half
  /// a step ago, hence damping shortens the step: omega^2 dt^2 + 2 lambda dt = 4 [time]. It does
  /// not hold `pressed`: a caller whose automata flow takes the lesser of both.
  double plain() const;

  /// Critical step where viscous contacts have centredSeparation(), with which longer steps are
  /// stable [time]; by bisection, down to the last bits.
  double centred() const;
};

/// The limits of the perfect, linked packing without a surface; a calculation over the Brillouin
/// zone, for set-up only.
/// \param D          weight of the mean stress, 1 - 2G/(3K), or 0 for the pairwise law [-]; under
///                   plane stress D' K'/K, since the mean stress counts as D K here
/// \param viscosity  eta of unlinked contacts [stress time], >= 0; 0 without, then `viscous` is
///                   infinite
/// \param slips      they resist slip, too (viscosity both)
/// \param isochoric  strains are logarithmic (strain.h): a link collapses at a larger distance,
///                   down to which its normal stiffness grows, too
CriticalStep criticalStep(const Material &, double D, double viscosity,
                          const Packing & = packing::hex, bool slips = false,
                          bool isochoric = false);

} // namespace mca

#endif
