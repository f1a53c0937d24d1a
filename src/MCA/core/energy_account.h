// SPDX-License-Identifier: GPL-2.0-or-later
/// \file energy_account.h
/// What passes through a sample: energy that the contacts dissipate and work that is done on it,
/// summed up over the steps. Exact for LAMMPS's velocity Verlet steps; the equations stand in
/// laws/energy.h. No LAMMPS type in here.
///
/// A step from one evaluation of the laws to the next has two halves: the first one belongs to the
/// forces at its beginning, the second one to those at its end. So an evaluation is followed by the
/// second half of the step that led to it, and then, when the automata have moved on, by the first
/// half of the coming step, which also books what the change of state sets free.
#ifndef MCA_ENERGY_ACCOUNT_H
#define MCA_ENERGY_ACCOUNT_H

#include "laws/energy.h"
#include "step.h"

#include <vector>

namespace mca {

/// The account of one rank: its automata, and half of what contacts with guests dissipate.
class EnergyAccount {
 public:
  /// Where energy goes, and (work) comes from.
  enum Channel { Plastic, Fracture, Viscous, Work, Channels };

  /// Sums since the beginning [energy], by channel.
  /// Of this rank alone: the account of the sample is the sum over all ranks.
  const double *sums() const { return sums_; }
  /// Sets a sum, as a restart file has it [energy].
  void setSum(Channel channel, double value) { sums_[channel] = value; }

  /// After an evaluation: remembers what is needed of it. Arrays are of own automata.
  /// \param x         places [length]
  /// \param f,torque  all that acts on them [force, force length], that of contacts included
  void keep(const Step &, const double (*x)[3], const double (*f)[3], const double (*torque)[3]);

  /// After keep(), of a step that was done: its second half.
  /// \param dt  the step [time]
  void bookSecondHalf(const Step &, double dt);

  /// The automata have moved on, nothing else has changed: the first half of the coming step, and
  /// the change of state before it. Called by all ranks.
  /// \param x      places [length] of own automata
  /// \param omega  angular velocities in the coming step [1/time]
  void bookFirstHalf(const Step &, const double (*x)[3], const double (*omega)[3], double dt);

  /// Memory held [bytes].
  double bytes() const;

 private:
  /// Way and rotation of an automaton in a step; or a force and a torque.
  struct Motion {
    Vector way, turn;
  };
  /// What goes between ranks, a row of all automata that are in pairs: way and turn in the coming
  /// step, and the mean stress that the next state will have.
  static constexpr int wayAt = 0, turnAt = 3, meanAt = 6, rowLength = 7;
  static_assert(rowLength <= Exchange::mostValues);
  RowArray rows_{rowLength};
  std::vector<Motion> external_; // forces and torques on own automata that are not of contacts
  std::vector<Vector> before_;   // where own automata were in the evaluation
  double sums_[Channels] = {};

  /// Half a step's work of the outer forces and torques on automaton i along this motion.
  void bookWork(int i, const Motion &);
  /// What all contacts dissipate in half a step; back: of the step just done.
  void bookContacts(const Step &, double dt, bool back);
  /// Energy that the change of e_zz sets free with plasticity j2 [energy]; else 0.
  double elasticZLoss(const Step &, int i) const;
};

} // namespace mca

#endif
