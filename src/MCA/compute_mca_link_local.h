// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   compute mca/link/local: one row a link; see doc/compute_mca_link_local.md
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_MCA_LINK_LOCAL_H
#define LMP_COMPUTE_MCA_LINK_LOCAL_H

#include "compute.h"

#include "laws/vector.h"
#include "output_columns.h"

namespace LAMMPS_NS {

class PairMCA;

/// Command compute mca/link/local: a row for each link with both automata in the group, on one rank
/// only; a vector for one attribute, an array for several. Stresses in pressure units after the
/// radial return, kind and strains of the state during the step. Rows are in the order of the list
/// of pairs, which is new after each build.
class ComputeMCALinkLocal : public Compute {
 public:
  ComputeMCALinkLocal(class LAMMPS *, int, char **);
  /// Stops LAMMPS without pair_style mca, which is found anew here.
  void init() override;
  /// Every rank lists its own rows; the array stands until the next call.
  void compute_local() override;
  /// Memory of the columns on this rank [bytes].
  double memory_usage() override;

 private:
  OutputColumns columns;
  PairMCA *pair;

  /// Pair k is linked, both its automata are in the group, and this rank lists it.
  bool mine(int) const;
  /// Shear stress on the first automaton as a vector [pressure]; in the plane along t.
  mca::Vector tau(int k) const;
  /// \param attribute  number in the list of names, 0 to the last one
  /// \param k          number of a pair that is mine()
  double value(int attribute, int k) const;
};

} // namespace LAMMPS_NS

#endif
