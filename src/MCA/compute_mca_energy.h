// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   compute mca/energy: where the energy of the sample goes; see doc/compute_mca_energy.md
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_MCA_ENERGY_H
#define LMP_COMPUTE_MCA_ENERGY_H

#include "compute.h"

namespace LAMMPS_NS {

/// Command compute mca/energy: the account of the whole sample, over all ranks [energy]. Scalar:
/// its error. Vector of eight: kinetic, elastic, dissipated by flow, by breaking, by viscosity, the
/// work of outer forces and of the box, and what came with automata or by changes between runs. One
/// at a time, for group all.
class ComputeMCAEnergy : public Compute {
 public:
  ComputeMCAEnergy(class LAMMPS *, int, char **);
  /// The account ends with it.
  ~ComputeMCAEnergy() override;
  /// Stops LAMMPS where the account is gone.
  void init() override { account(); }
  /// The error of the account [energy], 0 but for the rotation of contacts within a step and
  /// round-off.
  double compute_scalar() override;
  /// Called by all ranks, in a step whose forces are known.
  void compute_vector() override;

 private:
  /// Owned by LAMMPS; made in the constructor, deleted with this compute. Looked up each time,
  /// since commands can take it away; then LAMMPS stops with one line.
  class FixMCAEnergy &account() const;
};

} // namespace LAMMPS_NS

#endif
