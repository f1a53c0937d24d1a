// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   compute mca/energy: where the energy of the sample goes; see doc/compute_mca_energy.md
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_MCA_ENERGY_H
#define LMP_COMPUTE_MCA_ENERGY_H

#include "compute.h"

namespace LAMMPS_NS {

class ComputeMCAEnergy : public Compute {
 public:
  ComputeMCAEnergy(class LAMMPS *, int, char **);
  ~ComputeMCAEnergy() override;
  void init() override {}
  double compute_scalar() override;
  void compute_vector() override;

 private:
  class FixMCAEnergy *account;
};

} // namespace LAMMPS_NS

#endif
