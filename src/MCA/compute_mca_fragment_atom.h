// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   compute mca/fragment/atom: which automata hang together; see doc/compute_mca_fragment_atom.md
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_MCA_FRAGMENT_ATOM_H
#define LMP_COMPUTE_MCA_FRAGMENT_ATOM_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS {

class PairMCA;

/// Command compute mca/fragment/atom: of each own automaton the lowest ID among those that links
/// join to it, as a double; 0 outside the group, and with `single no` where it has no link. Links
/// count whose automata are both in the group.
class ComputeMCAFragmentAtom : public Compute {
 public:
  ComputeMCAFragmentAtom(class LAMMPS *, int, char **);
  /// Stops LAMMPS without pair_style mca, which is found anew here.
  void init() override;
  /// Called by all ranks. Messages: one to all neighbors for each rank that the longest fragment
  /// winds through, and one more.
  void compute_peratom() override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  /// Memory for own and ghost automata [bytes].
  double memory_usage() override;

 private:
  PairMCA *pair;
  /// Automata without a link are fragments of their own.
  bool single;
  /// Fragments of own and ghost automata; vector_atom.
  std::vector<double> lowest;
};

} // namespace LAMMPS_NS

#endif
