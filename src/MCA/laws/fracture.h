// SPDX-License-Identifier: GPL-2.0-or-later
/// \file fracture.h
/// When a link breaks. The paper does not state its criterion; these are exchangeable.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free: a criterion that is
/// switched off has an infinite limit.
#ifndef MCA_LAWS_FRACTURE_H
#define MCA_LAWS_FRACTURE_H

#include "elasticity.h"

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

/// The same of a shear in space.
inline double strainIntensity2(double eps, const Vector &gammaTotal)
{
  const double opening = eps > 0.0 ? eps : 0.0;
  return opening * opening + (4.0 / 3.0) * dot(gammaTotal, gammaTotal);
}

/// A bulk link that is pressed together further than this has collapsed and breaks [-].
///
/// Under pressure a bulk link flows without end, but at r -> 0 its axis turns by v_t dt/r in a
/// step, so that its shear is as stiff as 1/r^2: with the weight w of packing.h steps are unstable
/// below about r = sqrt(2w) c_s dt. At the longest step of viscous contacts that is 0.06 d; this is
/// the next round number above it, and steps that would be unstable above it are refused
/// (critical_step.h).
constexpr double collapseStrain = -0.9;

/// Whether a bulk link breaks by its strain.
/// \param gammaTotal      total shear since linking [-], in space a vector
/// \param breakingStrain2  eps_c^2 [-]
template<class Shear>
inline bool breaksByStrain(double eps, const Shear &gammaTotal, double breakingStrain2)
{
  return (strainIntensity2(eps, gammaTotal) >= breakingStrain2) | (eps <= collapseStrain);
}

/// Squared stress intensity of a link [stress^2]: max(sigma, 0)^2 + 3 tau^2 >= strength^2 breaks
/// it (a brittle weld, or any link under the stress criterion).
inline double linkIntensity2(double sigma, double tau)
{
  const double opening = sigma > 0.0 ? sigma : 0.0;
  return opening * opening + 3.0 * tau * tau;
}

/// Stress tensor where two automata meet, in the frame of the contact (after Psakhie, Shilko,
/// Smolin et al., Frattura ed Integrita Strutturale 24 (2013) 26, not compared with its text):
/// sigma and tau are those of the contact, what acts along its face and across the plane is the
/// mean of both automata. All [stress].
struct LocalStress {
  double sigma, tau, along, across;
};

/// \param sigma,tau  stresses of the contact after the radial return [stress]
/// \param xx,yy,xy   mean of both automata's averaged stresses after it [stress]
/// \param mean       mean of both automata's mean stresses [stress]
/// \param nx,ny      unit normal of the contact [-]
inline LocalStress localStress(double sigma, double tau, double xx, double yy, double xy,
                               double mean, double nx, double ny)
{
  return {sigma, tau, xx * ny * ny + yy * nx * nx - 2.0 * xy * nx * ny, 3.0 * mean - xx - yy};
}

/// Limits of a criterion on the local stress, in the form of Drucker and Prager:
///     (a+1)/2 sigma_eq + (3/2)(a-1) sigma_mean >= sigma_c,   a = sigma_c/sigma_t,
/// with the compressive and tensile strength sigma_c, sigma_t: the cone sigma_eq = A + B sigma_mean
/// through both uniaxial states, A = 2 sigma_c sigma_t/(sigma_c + sigma_t),
/// B = -3 (sigma_c - sigma_t)/(sigma_c + sigma_t). a = 1 is the criterion of the equivalent stress,
/// sigma_eq >= sigma_t. An infinite limit switches it off.
struct StressLimit {
  double equivalent2; ///< ((a+1)/2)^2 [-]
  double mean;        ///< (3/2)(a-1) [-]
  double limit;       ///< sigma_c [stress]
};

/// \param tensile  sigma_t [stress], > 0
/// \param ratio    a [-], >= 1
inline StressLimit druckerPrager(double tensile, double ratio)
{
  return {0.25 * (ratio + 1.0) * (ratio + 1.0), 1.5 * (ratio - 1.0), ratio * tensile};
}

/// Whether the criterion is met.
inline bool reaches(const LocalStress &s, const StressLimit &limit)
{
  const double mean = (s.sigma + s.along + s.across) / 3.0;
  const double a = s.sigma - s.along, b = s.along - s.across, c = s.across - s.sigma;
  const double equivalent2 = 0.5 * (a * a + b * b + c * c) + 3.0 * s.tau * s.tau;
  const double rest = limit.limit - limit.mean * mean;
  return (rest <= 0.0) | (limit.equivalent2 * equivalent2 >= rest * rest);
}

} // namespace mca

#endif
