// SPDX-License-Identifier: GPL-2.0-or-later
/// \file fracture_criteria.h
/// The criteria of bulk links: the one list from which come the words of keyword fracture with
/// their messages and restart files, the check against the documentation, and the kernel's loops,
/// which are compiled for each criterion. A new one is a header in laws/fracture/, its line here,
/// its test and its paragraph.
#ifndef MCA_LAWS_FRACTURE_CRITERIA_H
#define MCA_LAWS_FRACTURE_CRITERIA_H

#include "fracture/by_local_stress.h"
#include "fracture/by_strain.h"
#include "fracture/by_stress.h"
#include "fracture/never.h"

namespace mca {

/// Types in an order that gives each a number, from 0: the numbers are those of
/// FractureLaw::number() and LinkLimits::criterion. Restart files have words, not numbers, so that
/// the order may change.
/// \tparam Criteria  types derived from FractureCriterion, each with a keyword of its own; they
///                   hold no data, and an object of each is made wherever one is handed on
template<class... Criteria>
struct CriterionList {
  /// Number of criteria.
  static constexpr int size = sizeof...(Criteria);

  /// Calls work(criterion) with an object of the type that has this number, so that a generic
  /// lambda is compiled for each criterion: one decision a block of pairs or a pass, none a pair. A
  /// number that is not in the list calls nothing.
  /// \param number  0 to size - 1
  /// \param work    takes any of the types by value, and uses decltype of it
  template<class Work>
  static void with(int number, Work &&work)
  {
    int at = 0;
    static_cast<void>(((at++ == number && (work(Criteria()), true)) || ...));
  }

  /// Calls work(criterion) for all, in their order, as for a table of their properties. The n-th
  /// call is that of the number n.
  template<class Work>
  static void each(Work &&work)
  {
    (work(Criteria()), ...);
  }
};

// clang-format off: one a line
/// The list. Its first one, by strain, is the default of keyword fracture.
using FractureCriteria =
    CriterionList<FractureByStrain, FractureByStress, FractureByEquivalentStress,
                  FractureByDruckerPrager, FractureByMohrCoulomb, FractureNever>;
// clang-format on

} // namespace mca

#endif
