// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   Internal fix MCA_ENERGY: what compute mca/energy sums up over the steps
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_ENERGY_H
#define LMP_FIX_MCA_ENERGY_H

#include "fix.h"

#include "laws/energy.h"

#include <vector>

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
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double memory_usage() override;

  enum { PLASTIC, FRACTURE, VISCOUS, WORK, FLOWS }; // energies that pass through the sample
  struct Balance {
    double kinetic, elastic, flow[FLOWS]; // of all ranks
    double error;                         // of their sum since the beginning
  };
  Balance balance();

 private:
  PairMCA *pair;
  double flow[FLOWS]; // of this rank
  double start;       // kinetic and elastic energy when the account began
  bool begun;

  struct Motion { // of an automaton in a step; or force and torque
    mca::Vector way, turn;
  };
  std::vector<Motion> external;    // forces and torques on own automata that are not of contacts
  std::vector<mca::Vector> before; // where own automata were at the end of the step
  std::vector<double> rows;        // what goes between ranks, rowLength values an automaton

  void keep();
  Motion step_done(int i) const;
  mca::Vector place(int i) const;
  void add_work(int i, const Motion &);
  mca::ElasticStrain strain(int k, bool next) const;
  int channel(int k) const;
  void add_contacts(bool back);
  double in_elastic_z(int i) const;
};

} // namespace LAMMPS_NS

#endif
