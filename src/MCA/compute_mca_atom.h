// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   compute mca/atom: state of automata; see doc/compute_mca_atom.md
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_MCA_ATOM_H
#define LMP_COMPUTE_MCA_ATOM_H

#include "compute.h"

#include "core/automaton_states.h"
#include "output_columns.h"

#include <functional>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class PairMCA;

/// Command compute mca/atom: a vector for one attribute, an array with a column for each of
/// several, one row an own atom; 0 outside the group. Stresses in pressure units, energies in
/// energy units, counts as doubles. Attributes are those of the evaluation of this step; which of
/// them exist in this dimension is known in init().
class ComputeMCAAtom : public Compute {
 public:
  ComputeMCAAtom(class LAMMPS *, int, char **);
  /// Stops LAMMPS where an attribute is of the other dimension.
  void init() override;
  /// Every rank for itself: no message between ranks.
  void compute_peratom() override;
  /// Memory of columns and counts on this rank [bytes].
  double memory_usage() override;

 private:
  /// What can be asked for: the states of automata that are shown, and what follows from the step.
  struct Attribute {
    std::string name;
    /// Value of an owned automaton, by its number.
    std::function<double(int)> value;
    /// nullptr: not a state.
    const mca::AutomatonState *state;
    /// Needs count_links() before.
    bool counted;
  };
  std::vector<Attribute> known;
  /// What was asked for, in the order of the command; rows by LAMMPS's numbers of atoms.
  OutputColumns columns;
  /// Found anew in init(), since a pair style may be given again between runs.
  PairMCA *pair;
  /// Counts of owned and ghost automata, three numbers each: links, welds, original links. Those of
  /// ghosts are incomplete and not read.
  std::vector<double> counts;

  /// All of them, in the order of messages; the columns are chosen among these.
  std::vector<Attribute> attributes();
  /// Whether one of the columns is of this sort.
  bool asks_for(const std::function<bool(const Attribute &)> &) const;
  /// Counts links, welds and original links of the present state anew.
  void count_links();
  /// 1 less the share of its original links that still hold [-], 0 to 1; 0 without any.
  double damage(int i) const;
};

} // namespace LAMMPS_NS

#endif
