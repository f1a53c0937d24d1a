// SPDX-License-Identifier: GPL-2.0-or-later
/// \file by_stress.h
/// fracture stress: the link's own tension and shear, max(sigma, 0)^2 + 3 tau^2 >= sigma_0^2.
#ifndef MCA_LAWS_FRACTURE_BY_STRESS_H
#define MCA_LAWS_FRACTURE_BY_STRESS_H

#include "../fracture.h"

namespace mca {

struct FractureByStress : FractureCriterion {
  static constexpr const char *keyword = "stress";

  static FractureLimits limits(const LinkMaterials &m) { return {{m.strength() * m.strength()}}; }

  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return linkIntensity2(load.sigma, load.tau) >= limits.value[0];
  }
};

} // namespace mca

#endif
