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

/// Made and deleted by compute mca/energy, whose sums it keeps in each step. Group all. Its two
/// calls in a step book the two halves that meet in an evaluation: end_of_step() the second half of
/// the step just done, post_integrate() the first half of the coming one, when automata have moved
/// but neither ghosts nor list have.
class FixMCAEnergy : public Fix {
 public:
  static constexpr const char *ID = "MCA_ENERGY";

  FixMCAEnergy(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  /// Looks at the evaluation of set-up; the account begins with the first one.
  void setup(int) override;
  /// In a step: the first half of it. The evaluation is still the one before.
  void post_integrate() override;
  /// The second half of the step, from the new evaluation.
  void end_of_step() override;
  /// The sums over all ranks and the start, with a checksum; restart() gives them to rank 0, from
  /// where they go on.
  void write_restart(FILE *) override;
  void restart(char *) override;
  /// Of the account on this rank [bytes].
  double memory_usage() override;

  /// Number of sums of the account: plastic, fracture, viscous, work.
  static constexpr int FLOWS = mca::EnergyAccount::Channels;
  /// Of all ranks [energy]: kinetic of the leap-frog velocities (laws/energy.h), elastic, and the
  /// sums in the order of mca::EnergyAccount::Channel.
  struct Balance {
    double kinetic, elastic, flow[FLOWS]; // of all ranks
    /// Of their sum, less the work, since the beginning.
    double error;
  };
  /// Called by all ranks, after a set-up or a step.
  Balance balance();

 private:
  PairMCA *pair;
  /// Of this rank.
  mca::EnergyAccount account;
  /// Kinetic and elastic energy when the account began [energy].
  double start;
  /// It did, in this run, an earlier one or that of the restart file.
  bool begun;

  /// Takes from the evaluation what both halves need.
  void keep();
};

} // namespace LAMMPS_NS

#endif
