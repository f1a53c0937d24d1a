// SPDX-License-Identifier: GPL-2.0-or-later
/// \file by_stress.h
/// fracture stress: the link's own tension and shear, max(sigma, 0)^2 + 3 tau^2 >= sigma_0^2.
/// It sees one contact, not the averaged stress of its automata, and uses the stresses of the
/// contact after the radial return. Welds break by the same intensity (linking.h). The criterion is
/// ours.
#ifndef MCA_LAWS_FRACTURE_BY_STRESS_H
#define MCA_LAWS_FRACTURE_BY_STRESS_H

#include "../fracture.h"

namespace mca {

/// Keyword fracture, value stress. Decides in the force pass, when the stresses are known, so that
/// all blocks go the kernel's longer way.
struct FractureByStress : FractureCriterion {
  static constexpr const char *keyword = "stress";

  /// sigma_0^2 [stress^2], of unlike materials with the lower sigma_0, as value[0].
  static FractureLimits limits(const LinkMaterials &m) { return {{m.strength() * m.strength()}}; }

  /// Whether the squared intensity reaches the limit. Compression alone never breaks a link; shear
  /// alone does at sigma_0/sqrt(3).
  /// \param load    a LinkLoad: sigma and the length tau of the shear stress [stress], after the
  ///                return
  /// \param limits  of limits()
  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return linkIntensity2(load.sigma, load.tau) >= limits.value[0];
  }
};

} // namespace mca

#endif
