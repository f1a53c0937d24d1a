// SPDX-License-Identifier: GPL-2.0-or-later
/// \file by_strain.h
/// fracture strain: max(eps, 0)^2 + (4/3) gamma_total^2 >= eps_c^2, geometric.
#ifndef MCA_LAWS_FRACTURE_BY_STRAIN_H
#define MCA_LAWS_FRACTURE_BY_STRAIN_H

#include "../fracture.h"

namespace mca {

/// Squared strain intensity of a link [-]: max(eps, 0)^2 + (4/3) gamma^2.
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

struct FractureByStrain : FractureCriterion {
  static constexpr const char *keyword = "strain";
  static constexpr bool strainOnly = true;

  static FractureLimits limits(const LinkMaterials &m)
  {
    return {{m.breakingStrain() * m.breakingStrain()}};
  }

  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return strainIntensity2(load.eps, load.gammaTotal) >= limits.value[0];
  }
};

} // namespace mca

#endif
