// SPDX-License-Identifier: GPL-2.0-or-later
/// \file never.h
/// fracture none: only collapse breaks a bulk link.
#ifndef MCA_LAWS_FRACTURE_NEVER_H
#define MCA_LAWS_FRACTURE_NEVER_H

#include "../fracture.h"

namespace mca {

struct FractureNever : FractureCriterion {
  static constexpr const char *keyword = "none";
  static constexpr bool strainOnly = true;

  static FractureLimits limits(const LinkMaterials &) { return {}; }

  template<class Load>
  static bool broken(const Load &, const FractureLimits &)
  {
    return false;
  }
};

} // namespace mca

#endif
