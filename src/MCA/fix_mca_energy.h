// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   Internal fix MCA_ENERGY: what compute mca/energy sums up over the steps
   Glue: the account stands in core/energy_account.h
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_ENERGY_H
#define LMP_FIX_MCA_ENERGY_H

#include "fix.h"

#include "core/energy_account.h"

namespace LAMMPS_NS {

class PairMCA;

class FixMCAEnergy : public Fix {
 public:
  static constexpr const char *ID = "MCA_ENERGY";

  FixMCAEnergy(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_integrate() override;
  void end_of_step() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double memory_usage() override;

  static constexpr int FLOWS = mca::EnergyAccount::Channels;
  struct Balance {
    double kinetic, elastic, flow[FLOWS]; // of all ranks
    double error;                         // of their sum since the beginning
  };
  Balance balance();

 private:
  PairMCA *pair;
  mca::EnergyAccount account; // of this rank
  double start;               // kinetic and elastic energy when the account began
  bool begun;

  void keep();
};

} // namespace LAMMPS_NS

#endif
