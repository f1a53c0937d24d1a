// SPDX-License-Identifier: GPL-2.0-or-later
/// \file automaton_law.h
/// What the passes over automata need of the laws of one material.
/// Any consistent set of units; dimensions stand in brackets. Equations: doc/laws.md.
#ifndef MCA_LAWS_AUTOMATON_LAW_H
#define MCA_LAWS_AUTOMATON_LAW_H

#include "plasticity.h"

namespace mca {

/// Laws of one material as an automaton's own; made by makeAutomatonLaw() of law_set.h.
struct AutomatonLaw {
  /// All but the yield curve is 0 and to be filled by name.
  explicit AutomatonLaw(const Material &material) : curve(material) {}

  double bulkModulus = 0.0, shearModulus = 0.0; ///< K, G [stress]
  double D = 0.0; ///< 1 - 2G/(3K), or 0 for the pairwise law [-]; for energies
  /// 1 with radial return, 0 without; a factor in a loop without branches.
  double yields = 0.0;
  /// Most of its deviating stresses that flow takes in a step [-], 1 - M.
  double mostReturn = 0.0;
  YieldCurve curve;
  /// q S/V of the packing [-], the weight of a contact in the averaged stress.
  double weight = 0.0;
};

} // namespace mca

#endif
