// SPDX-License-Identifier: GPL-2.0-or-later
/// \file by_local_stress.h
/// fracture equivalent, drucker-prager and mohr-coulomb: criteria on the stress tensor where two
/// automata meet. The first two have the form of Drucker and Prager:
///     (a+1)/2 sigma_eq + (3/2)(a-1) sigma_mean >= sigma_c,   a = sigma_c/sigma_t,
/// with the compressive and tensile strength sigma_c, sigma_t: the cone sigma_eq = A + B sigma_mean
/// through both uniaxial states, A = 2 sigma_c sigma_t/(sigma_c + sigma_t),
/// B = -3 (sigma_c - sigma_t)/(sigma_c + sigma_t). a = 1 is the criterion of the equivalent stress,
/// sigma_eq >= sigma_t.
#ifndef MCA_LAWS_FRACTURE_BY_LOCAL_STRESS_H
#define MCA_LAWS_FRACTURE_BY_LOCAL_STRESS_H

#include "../fracture.h"

#include <cmath>

namespace mca {

/// Limits of the criterion: ((a+1)/2)^2 [-], (3/2)(a-1) [-], sigma_c [stress], as value[0] to
/// value[2]. From A and B above, multiplied by (a+1)/2, so that the right side is sigma_c alone.
/// \param tensile  sigma_t [stress], > 0
/// \param ratio    a [-], >= 1; 1 gives the criterion of the equivalent stress
inline FractureLimits druckerPrager(double tensile, double ratio)
{
  return {{0.25 * (ratio + 1.0) * (ratio + 1.0), 1.5 * (ratio - 1.0), ratio * tensile}};
}

/// Whether the criterion is met, without a root and without a branch: both sides are squared where
/// the right one is positive, and it is met anyhow where that is not: a mean tension beyond the tip
/// of the cone.
/// \param s       stress tensor in the frame of the contact [stress], tension positive: sigma and
///                tau on its face, along and across on the other two
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
/// compression over that in tension, which is sigma_0 of the weaker material (Drucker and Prager's
/// cone; that the local tensor is put in follows Psakhie, Shilko, Smolin et al., Frattura ed
/// Integrita Strutturale 24 (2013) 26). In uniaxial tension a link breaks at sigma_0, in
/// compression at a sigma_0; a test holds both.
struct FractureByDruckerPrager : FractureCriterion {
  /// It reads LinkLoad::local, so that automata show their averaged stresses, a message between
  /// ranks.
  static constexpr const char *keyword = "drucker-prager";
  static constexpr bool needsLocalStress = true;
  static constexpr const char *parameter = "compressive_strength";
  static constexpr const char *parameterRange = ">= 1";
  /// Whether a ratio of strengths [-] has a meaning: the cone opens to compression, not to tension.
  /// FractureLaw::problem() asks.
  static bool accepts(double ratio) { return ratio >= 1.0; }

  /// Limits of this pair, of unlike materials with the lower strength.
  /// \param m  m.parameter is the ratio a [-]; FractureLaw::problem() has seen to a >= 1
  static FractureLimits limits(const LinkMaterials &m)
  {
    return druckerPrager(m.strength(), m.parameter);
  }

  /// Whether the local stress of this link reaches the cone.
  /// \param load    a LinkLoad whose `local` is filled [stress]
  /// \param limits  of limits()
  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return reaches(load.local, limits);
  }
};

/// The ratio a [-] from which on the cone bears any compression in plane strain, with the stresses
/// (sigma, 0, nu sigma) of an elastic solid.
/// \param poissonsRatio  nu [-]
inline double mostConeRatio(double poissonsRatio)
{
  const double equivalent = std::sqrt(1.0 - poissonsRatio + poissonsRatio * poissonsRatio);
  return (1.0 + poissonsRatio + equivalent) / (1.0 + poissonsRatio - equivalent);
}

/// Keyword fracture, value mohr-coulomb: a sigma_1 - sigma_3 >= a sigma_0, with the largest and the
/// least principal stress of the local tensor (Coulomb's law of friction and cohesion; angle of
/// friction asin((a-1)/(a+1))). The stress between both does not count, so that a is the ratio of
/// the strengths in plane strain, too. In space the axes of face and shear are not kept, from which
/// the principal stresses would follow.
struct FractureByMohrCoulomb : FractureCriterion {
  static constexpr const char *keyword = "mohr-coulomb";
  static constexpr bool needsLocalStress = true;
  static constexpr bool inSpace = false;
  static constexpr const char *parameter = FractureByDruckerPrager::parameter;
  static constexpr const char *parameterRange = FractureByDruckerPrager::parameterRange;
  static bool accepts(double ratio) { return FractureByDruckerPrager::accepts(ratio); }

  /// a [-] and a sigma_0 [stress], of unlike materials with the lower strength.
  /// \param m  m.parameter is the ratio a [-]; FractureLaw::problem() has seen to a >= 1
  static FractureLimits limits(const LinkMaterials &m)
  {
    return {{m.parameter, m.parameter * m.strength()}};
  }

  /// Whether the principal stresses reach the limit: two of them in the plane, the third across it.
  /// \param load    a LinkLoad whose `local` is filled [stress]
  /// \param limits  of limits()
  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    const LocalStress &s = load.local;
    const double middle = 0.5 * (s.sigma + s.along), half = 0.5 * (s.sigma - s.along);
    const double radius = std::sqrt(half * half + s.tau * s.tau);
    const double high = middle + radius, low = middle - radius;
    const double largest = high > s.across ? high : s.across;
    const double least = low < s.across ? low : s.across;
    return limits.value[0] * largest - least >= limits.value[1];
  }
};

/// Keyword fracture, value equivalent: the von Mises stress of the local tensor reaches sigma_0 of
/// the weaker material. It is Drucker and Prager's criterion with equal strengths, a = 1, so that
/// it has no number of its own and pressure does not count.
struct FractureByEquivalentStress : FractureCriterion {
  static constexpr const char *keyword = "equivalent";
  static constexpr bool needsLocalStress = true;

  /// Limits of this pair, of unlike materials with the lower strength; m.parameter is not read.
  static FractureLimits limits(const LinkMaterials &m) { return druckerPrager(m.strength(), 1.0); }

  /// Whether the local von Mises stress reaches the strength, whatever the pressure.
  /// \param load    a LinkLoad whose `local` is filled [stress]
  /// \param limits  of limits()
  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return reaches(load.local, limits);
  }
};

} // namespace mca

#endif
