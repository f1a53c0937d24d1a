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

#include <vector>

namespace LAMMPS_NS {

class PairMCA;

/// Made and deleted by compute mca/energy, whose sums it keeps in each step. Group all. Its two
/// calls in a step book the two halves that meet in an evaluation: end_of_step() the second half of
/// the step just done, post_integrate() the first half of the coming one, when automata have moved
/// but neither ghosts nor list have.
///
/// A set-up is looked at in the first post_integrate(), when all fixes have added their forces:
/// setup() comes to the fixes in the order of their commands.
class FixMCAEnergy : public Fix {
 public:
  static constexpr const char *ID = "MCA_ENERGY";

  FixMCAEnergy(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  /// The box of the evaluation.
  void setup_pre_force(int) override;
  void pre_force(int) override;
  /// Keeps where automata are, of whose evaluation the forces of some fixes are still missing.
  void setup(int) override;
  /// In a step: the first half of it. The evaluation is still the one before.
  void post_integrate() override;
  /// The second half of the step, from the new evaluation.
  void end_of_step() override;
  /// What the sample has now is compared with what it has when the next run begins.
  void post_run() override;
  /// The sums over all ranks, the start and the end of the last run, with a checksum; restart()
  /// gives them to rank 0, from where they go on.
  void write_restart(FILE *) override;
  void restart(char *) override;
  /// Memory of the account on this rank [bytes].
  double memory_usage() override;

  /// Number of sums of the account.
  static constexpr int FLOWS = mca::EnergyAccount::Channels;
  /// Energies of all ranks [energy]: kinetic of the leap-frog velocities (laws/energy.h), elastic,
  /// and the sums in the order of mca::EnergyAccount::Channel.
  struct Balance {
    double kinetic, elastic, flow[FLOWS];
    /// Kinetic and elastic, when the account began.
    double start;
    /// Error of their sum, less what comes in, since the beginning.
    double error;
  };
  /// Called by all ranks, after a set-up or a step; stops LAMMPS where automata stand in another
  /// order since.
  Balance balance();

 private:
  PairMCA *pair;
  /// Account of this rank.
  mca::EnergyAccount account;
  /// What own automata have [energy]: kinetic, elastic after the change of state; and the part of
  /// the former of automata that no integrator moves by their forces.
  struct Held {
    double kinetic, elastic, led;
  };
  /// Kinetic and elastic energy when the account began, and after the last evaluation [energy], on
  /// this rank.
  double start, last;
  /// Held::led after the last evaluation.
  double led;
  /// The account after the last evaluation.
  double booked[FLOWS];
  /// The most that each sum has been, of all ranks, where it was looked at.
  double highest[FLOWS];
  /// The account began, in this run, an earlier one or that of the restart file.
  bool begun;
  /// The last evaluation is that of a set-up, which is not booked yet.
  bool fresh;
  /// The warning was given.
  bool told;
  /// Places and velocities of own automata in set-up, each three components.
  std::vector<double> places, velocities, spins;
  /// Forces on own automata in the last evaluation, likewise; 0 where no integrator follows them.
  std::vector<double> forces, torques;
  /// IDs of own automata, in their order.
  std::vector<tagint> ids;
  /// Box of the last evaluation.
  mca::EnergyAccount::Edges box;
  /// Kinetic energy on this rank [energy], before automata may pass a face of a box that moves.
  double before_faces;
  /// Number of automata of the sample in the last list.
  bigint count;

  /// Takes from the evaluation what both halves need.
  /// \param x  places of own automata in it
  void keep(const double (*x)[3]);
  /// \param v,omega  of own automata in the evaluation that keep() has seen
  Held held(const double (*v)[3], const double (*omega)[3]) const;
  Held held() const;
  /// Books a set-up: the account begins, or what the sample has more or less than after the last
  /// evaluation is what somebody has changed.
  /// \param own_held  what own automata have in it
  void begin_run(const Held &own_held);
  /// Notes what the sample has.
  void close(const Held &);
  /// Kinetic energy of the translation of own automata [energy].
  /// \param faces  as the evaluation saw them; else as they are
  double translation(bool faces) const;
  /// Number of automata of the sample; called by all ranks.
  bigint automata() const;
  /// Says once where what was dissipated comes back or the error is large; called by all ranks.
  void warn();
};

} // namespace LAMMPS_NS

#endif
