// SPDX-License-Identifier: GPL-2.0-or-later
/// \file by_local_stress.h
/// fracture equivalent and drucker-prager: criteria on the stress tensor where two automata meet,
/// in the form of Drucker and Prager:
///     (a+1)/2 sigma_eq + (3/2)(a-1) sigma_mean >= sigma_c,   a = sigma_c/sigma_t,
/// with the compressive and tensile strength sigma_c, sigma_t: the cone sigma_eq = A + B sigma_mean
/// through both uniaxial states, A = 2 sigma_c sigma_t/(sigma_c + sigma_t),
/// B = -3 (sigma_c - sigma_t)/(sigma_c + sigma_t). a = 1 is the criterion of the equivalent stress,
/// sigma_eq >= sigma_t.
#ifndef MCA_LAWS_FRACTURE_BY_LOCAL_STRESS_H
#define MCA_LAWS_FRACTURE_BY_LOCAL_STRESS_H

#include "../fracture.h"

namespace mca {

/// Limits of the criterion: ((a+1)/2)^2 [-], (3/2)(a-1) [-], sigma_c [stress].
/// \param tensile  sigma_t [stress], > 0
/// \param ratio    a [-], >= 1
inline FractureLimits druckerPrager(double tensile, double ratio)
{
  return {{0.25 * (ratio + 1.0) * (ratio + 1.0), 1.5 * (ratio - 1.0), ratio * tensile}};
}

/// Whether the criterion is met, without a root and without a branch: both sides are squared where
/// the right one is positive, and it is met anyhow where that is not.
/// \param s       stress tensor in the frame of the contact [stress], tension positive
/// \param limits  of druckerPrager()
inline bool reaches(const LocalStress &s, const FractureLimits &limits)
{
  const double equivalentFactor2 = limits.value[0], meanFactor = limits.value[1];
  const double mean = (s.sigma + s.along + s.across) / 3.0;
  const double a = s.sigma - s.along, b = s.along - s.across, c = s.across - s.sigma;
  const double equivalent2 = 0.5 * (a * a + b * b + c * c) + 3.0 * s.tau * s.tau;
  const double rest = limits.value[2] - meanFactor * mean;
  return (rest <= 0.0) | (equivalentFactor2 * equivalent2 >= rest * rest);
}

/// Keyword fracture, value drucker-prager: keyword compressive_strength, >= 1, is the strength in
/// compression over that in tension, which is sigma_0 of the weaker material.
struct FractureByDruckerPrager : FractureCriterion {
  static constexpr const char *keyword = "drucker-prager";
  static constexpr bool needsLocalStress = true;
  static constexpr const char *parameter = "compressive_strength";
  static constexpr const char *parameterRange = ">= 1";
  /// Whether a ratio of strengths [-] has a meaning: the cone opens to compression, not to tension.
  static bool accepts(double ratio) { return ratio >= 1.0; }

  /// Limits of this pair, of unlike materials with the lower strength; m.parameter is a [-].
  static FractureLimits limits(const LinkMaterials &m)
  {
    return druckerPrager(m.strength(), m.parameter);
  }

  /// Whether the local stress of this link reaches the cone; needs a LinkLoad.
  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return reaches(load.local, limits);
  }
};

/// Keyword fracture, value equivalent: the von Mises stress of the local tensor reaches sigma_0 of
/// the weaker material. It is Drucker and Prager's criterion with equal strengths, a = 1, so that
/// it has no number of its own and pressure does not count.
struct FractureByEquivalentStress : FractureCriterion {
  static constexpr const char *keyword = "equivalent";
  static constexpr bool needsLocalStress = true;

  /// Limits of this pair, of unlike materials with the lower strength.
  static FractureLimits limits(const LinkMaterials &m) { return druckerPrager(m.strength(), 1.0); }

  /// Whether the local von Mises stress reaches the strength; needs a LinkLoad.
  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return reaches(load.local, limits);
  }
};

} // namespace mca

#endif
