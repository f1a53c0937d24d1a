// SPDX-License-Identifier: GPL-2.0-or-later
/// \file never.h
/// fracture none: only collapse breaks a bulk link.
/// For elastic and elastic-plastic bodies whose links are to hold, as in tests against theory.
/// Welds still break (keyword weld), since their strength is no criterion of bulk links.
#ifndef MCA_LAWS_FRACTURE_NEVER_H
#define MCA_LAWS_FRACTURE_NEVER_H

#include "../fracture.h"

namespace mca {

/// Keyword fracture, value none. It counts as one by strain, for the kernel's short way.
struct FractureNever : FractureCriterion {
  static constexpr const char *keyword = "none";
  static constexpr bool strainOnly = true;

  /// No limits: broken() reads none.
  static FractureLimits limits(const LinkMaterials &) { return {}; }

  /// Never; breaks() of fracture.h still lets a link collapse at eps <= collapseStrain.
  template<class Load>
  static bool broken(const Load &, const FractureLimits &)
  {
    return false;
  }
};

} // namespace mca

#endif
