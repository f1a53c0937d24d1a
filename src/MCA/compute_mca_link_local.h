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

class ComputeMCALinkLocal : public Compute {
 public:
  ComputeMCALinkLocal(class LAMMPS *, int, char **);
  void init() override;
  void compute_local() override;
  double memory_usage() override;

 private:
  OutputColumns columns;
  PairMCA *pair;

  bool mine(int) const;
  mca::Vector tau(int k) const; // as a vector
  double value(int attribute, int k) const;
};

} // namespace LAMMPS_NS

#endif
