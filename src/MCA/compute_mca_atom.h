// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   compute mca/atom: state of automata; see doc/compute_mca_atom.md
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_MCA_ATOM_H
#define LMP_COMPUTE_MCA_ATOM_H

#include "compute.h"

#include "output_columns.h"

#include <vector>

namespace LAMMPS_NS {

class PairMCA;

class ComputeMCAAtom : public Compute {
 public:
  ComputeMCAAtom(class LAMMPS *, int, char **);
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;

 private:
  OutputColumns columns;
  PairMCA *pair;
  std::vector<double> counts; // of owned and ghost automata: links, welds, original links

  void count_links();
  double value(int attribute, int i) const;
};

} // namespace LAMMPS_NS

#endif
