// SPDX-License-Identifier: GPL-2.0-or-later
/// \file by_strain.h
/// fracture strain: max(eps, 0)^2 + (4/3) gamma_total^2 >= eps_c^2, geometric.
/// The default. The paper (Bucher et al. 2006) gives eps_c as the strain at which sigma_0 is
/// reached, but no criterion; this one is ours. Plastic flow does not lower the strain that counts.
#ifndef MCA_LAWS_FRACTURE_BY_STRAIN_H
#define MCA_LAWS_FRACTURE_BY_STRAIN_H

#include "../fracture.h"

namespace mca {

/// Squared strain intensity of a link [-]: max(eps, 0)^2 + (4/3) gamma^2. gamma is half the
/// engineering shear strain, for which 4/3 gamma^2 is von Mises' weight.
/// \param eps         total normal strain [-]
/// \param gammaTotal  total shear since linking, not reduced by plasticity [-]
inline double strainIntensity2(double eps, double gammaTotal)
{
  const double opening = eps > 0.0 ? eps : 0.0;
  return opening * opening + (4.0 / 3.0) * gammaTotal * gammaTotal;
}

/// Square of the strain intensity with a shear in space, whose length counts [-].
/// \param eps         total normal strain [-]
/// \param gammaTotal  total shear since linking, perpendicular to the normal [-]
inline double strainIntensity2(double eps, const Vector &gammaTotal)
{
  const double opening = eps > 0.0 ? eps : 0.0;
  return opening * opening + (4.0 / 3.0) * dot(gammaTotal, gammaTotal);
}

/// Keyword fracture, value strain. It reads strains only, so that the strain pass can decide and
/// most blocks take the kernel's short way. A link under shear alone breaks at gamma_total = 0.87
/// eps_c.
struct FractureByStrain : FractureCriterion {
  /// The word in the input script, the default of keyword fracture.
  static constexpr const char *keyword = "strain";
  static constexpr bool strainOnly = true;

  /// eps_c^2 [-], of unlike materials with the smaller eps_c, as value[0]; the other three are 0.
  static FractureLimits limits(const LinkMaterials &m)
  {
    return {{m.breakingStrain() * m.breakingStrain()}};
  }

  /// Whether the squared intensity reaches the limit. Compression does not count, but collapse
  /// does, which breaks() of fracture.h adds.
  /// \param load    a LinkLoad or a LinkStrain [-]; shears are numbers or, of LinkStrain in space,
  ///                vectors
  /// \param limits  of limits()
  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return strainIntensity2(load.eps, load.gammaTotal) >= limits.value[0];
  }
};

} // namespace mca

#endif
