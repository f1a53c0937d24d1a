/// \file critical_step.h
/// The longest stable step of the explicit integration of a perfect packing.
#ifndef MCA_LAWS_CRITICAL_STEP_H
#define MCA_LAWS_CRITICAL_STEP_H

#include "material.h"

namespace mca {

/// Both limits [time]; infinity where the law is switched off.
struct CriticalStep {
  double elastic;  ///< 2/omega_max over the Brillouin zone of the linked hexagonal lattice
  double viscous;  ///< m/(3c), c = eta S/d: all six contacts damped, neighbours in antiphase
  double shortest() const { return elastic < viscous ? elastic : viscous; }
};

/// \param D          weight of the mean stress, 1 - 2G/(3K), or 0 for the pairwise law [-]
/// \param viscosity  eta of unlinked contacts [stress time], 0 without
CriticalStep criticalStep(const Material &, double D, double viscosity);

}  // namespace mca

#endif
