// SPDX-License-Identifier: GPL-2.0-or-later
/// \file never.h
/// fracture none: only collapse breaks a bulk link.
/// For elastic and elastic-plastic bodies whose links are to hold, as in tests against theory.
/// Welds still break (keyword weld), since their strength is no criterion of bulk links.
#ifndef MCA_LAWS_FRACTURE_NEVER_H
#define MCA_LAWS_FRACTURE_NEVER_H

#include "../fracture.h"

namespace mca {

/// Keyword fracture, value none. It counts as one by strain, for the kernel's short way: collapse
/// is seen in the strain pass.
struct FractureNever : FractureCriterion {
  /// The word in the input script is none, as of all keywords that switch something off.
  static constexpr const char *keyword = "none";
  static constexpr bool strainOnly = true;

  /// No limits: broken() reads none, so all are 0.
  static FractureLimits limits(const LinkMaterials &) { return {}; }

  /// Never; breaks() of fracture.h still lets a link collapse at eps <= collapseStrain.
  /// \param load  not read: a LinkLoad or a LinkStrain
  template<class Load>
  static bool broken(const Load &, const FractureLimits &)
  {
    return false;
  }
};

} // namespace mca

#endif
