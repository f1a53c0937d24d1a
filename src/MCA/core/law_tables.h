// SPDX-License-Identifier: GPL-2.0-or-later
/// \file law_tables.h
/// The laws of a sample as the passes of a step read them: one entry a type of automaton, one an
/// unlike pair of materials.
#ifndef MCA_LAW_TABLES_H
#define MCA_LAW_TABLES_H

#include "laws/law_set.h"

#include <vector>

namespace mca {

/// Made anew whenever a law or a material changes; a list of pairs holds numbers of its entries.
/// One consistent set of units, in which a stress is an energy per volume and mass times
/// acceleration a force.
struct LawTables {
  LawTables() = default;

  /// \param materials  by type; types of equal materials share their laws, since the kernel is
  ///                   fastest where one law serves many pairs. In units in which a stress is an
  ///                   energy per volume
  /// \param thickness  h [length] of a plane packing, > 0; 1 in space
  /// \param interfaces  by types, indices of `materials`, in the same units
  LawTables(const LawSet &, const std::vector<Material> &materials, double thickness,
            const Packing &, const Interfaces &interfaces = {});

  std::vector<AutomatonLaw> automata; ///< by type
  std::vector<double> volumes;        ///< of a cell [volume], by type
  std::vector<PairLaw> pairs;         ///< of ordered pairs of unlike materials, and of interfaces
  bool oneMaterial = true;            ///< the materials of all types are equal

  // which of the passes that are not always needed act
  bool returnsTwice = false;     ///< radial returns see those of the neighbours
  bool centresViscosity = false; ///< viscous contacts see the velocity of their step
  bool resistsSlip = false;      ///< viscosity acts along the tangent, too
  bool rubs = false;             ///< unlinked contacts of a pair have friction
  bool keepsVolume = false;      ///< plasticity isochoric: passes of their own
  bool needsLocal = false;       ///< criteria of local stress or plastic work

  /// In `pairs`, of automata of two types; (i, j) and (j, i) are two entries where the materials
  /// differ.
  /// \param typeI,typeJ  0 to types() - 1; not checked
  int number(int typeI, int typeJ) const { return numbers[typeI * types() + typeJ]; }
  int types() const { return static_cast<int>(automata.size()); }

  std::vector<int> numbers; ///< by typeI * types() + typeJ
};

} // namespace mca

#endif
