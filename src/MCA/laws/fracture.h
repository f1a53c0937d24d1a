/// \file fracture.h
/// When a link breaks. The paper does not state its criterion; these are exchangeable.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free: a criterion that is
/// switched off has an infinite limit.
#ifndef MCA_LAWS_FRACTURE_H
#define MCA_LAWS_FRACTURE_H

#include <cmath>

namespace mca {

/// Squared strain intensity of a link for the geometric criterion [-]:
/// max(eps, 0)^2 + (4/3) gamma^2 >= eps_c^2 breaks it.
/// \param eps         total normal strain r/d - 1 [-]
/// \param gammaTotal  total shear since linking, not reduced by plasticity [-]
inline double strainIntensity2(double eps, double gammaTotal)
{
  const double opening = eps > 0.0 ? eps : 0.0;
  return opening * opening + (4.0 / 3.0) * gammaTotal * gammaTotal;
}

/// Squared stress intensity of a link [stress^2]: max(sigma, 0)^2 + 3 tau^2 >= strength^2 breaks
/// it (a brittle weld, or any link under the stress criterion).
inline double linkIntensity2(double sigma, double tau)
{
  const double opening = sigma > 0.0 ? sigma : 0.0;
  return opening * opening + 3.0 * tau * tau;
}

} // namespace mca

#endif
