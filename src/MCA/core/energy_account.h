// SPDX-License-Identifier: GPL-2.0-or-later
/// \file energy_account.h
/// What passes through a sample: energy that the contacts dissipate and work that is done on it,
/// summed up over the steps. Exact for LAMMPS's velocity Verlet steps; the equations stand in
/// laws/energy.h. No LAMMPS type in here.
///
/// A step from one evaluation of the laws to the next has two halves: the first one belongs to the
/// forces at its beginning, the second one to those at its end. So an evaluation is followed by the
/// second half of the step that led to it and by what its change of state sets free, and then, when
/// the automata have moved on, by the first half of the coming step. Both of the former together:
/// a link that breaks has no force at the end of its last step, so that the work of that half step
/// alone would count as less than nothing.
#ifndef MCA_ENERGY_ACCOUNT_H
#define MCA_ENERGY_ACCOUNT_H

#include "laws/energy.h"
#include "step.h"

#include <vector>

namespace mca {

/// The account of one rank: its automata, and half of what contacts with guests dissipate.
class EnergyAccount {
 public:
  /// Where energy goes, and (work) comes from: a link that breaks in the step pays into Fracture,
  /// an unlinked contact into Viscous, any other link and the change of e_zz into Plastic. Box is
  /// the work of a box that changes its size on the contacts over its periodic faces; Changed what
  /// came with automata and left with them, or what somebody changed between two runs. Touching is
  /// what contacts lose in steps in which they touch or part: force and gradient jump there, and
  /// what their means of both ends say too much or too little is no dissipation but the step's
  /// error, of either sign; so is what a spring of friction gives back that turns round within one.
  /// Friction is what unlinked contacts lose as they slide. Two are parts of others, counted there,
  /// too: ContactFlow is that of unlinked contacts in Plastic, Slip that of the stress against slip
  /// in Viscous. Channels is their number.
  enum Channel {
    Plastic,
    Fracture,
    Viscous,
    Work,
    Box,
    Changed,
    Touching,
    Friction,
    ContactFlow,
    Slip,
    Channels
  };
  /// Those that add to what the sample has.
  static constexpr bool comesIn(int channel) { return channel >= Work && channel < Touching; }
  /// What has left the sample by a channel, for one of it: 1, -1 where it comes in, 0 of parts.
  static constexpr double leaves(int channel)
  {
    return channel >= ContactFlow ? 0.0 : comesIn(channel) ? -1.0 : 1.0;
  }

  /// Sums since the beginning [energy], by channel.
  /// Sums of this rank alone: the account of the sample is the sum over all ranks.
  const double *sums() const { return sums_; }
  /// Sets a sum, as a restart file has it [energy].
  void setSum(Channel channel, double value) { sums_[channel] = value; }
  /// Adds what the account does not find itself: Changed, and the kinetic energy that automata get
  /// as they pass a face of a box that moves [energy], on this rank.
  void add(Channel channel, double value) { sums_[channel] += value; }

  /// Edges of the box, an upper triangle: xx, yy, zz, yz, xz, xy [length], as LAMMPS's h.
  struct Edges {
    double h[6];
  };

  /// Elastic energy that the change of state after the evaluation sets free [energy], on this rank:
  /// what the automata hold afterwards is theirs in the evaluation less this.
  double released() const;

  /// After an evaluation: remembers what is needed of it. Arrays are of own automata. Called by all
  /// ranks.
  /// \param x         places [length]
  /// \param f,torque  all that acts on them [force, force length], that of contacts included
  /// \param box       of the evaluation, at whose faces images stood
  void keep(const Step &, const double (*x)[3], const double (*f)[3], const double (*torque)[3],
            const Edges &box);

  /// After keep(), of a step that was done: its second half, and the change of state after it.
  /// \param dt  the step [time]
  void bookSecondHalf(const Step &, double dt);

  /// The automata have moved on, nothing else has changed: the first half of the coming step.
  /// Called by all ranks.
  /// \param x      places [length] of own automata
  /// \param omega  angular velocities in the coming step [1/time]
  /// \param box    of the coming evaluation
  void bookFirstHalf(const Step &, const double (*x)[3], const double (*omega)[3], double dt,
                     const Edges &box);

  /// Memory held [bytes].
  double bytes() const;

 private:
  /// Way and rotation of an automaton in a step; or a force and a torque.
  struct Motion {
    Vector way, turn;
  };
  /// What goes between ranks, a row of all automata that are in pairs: way [length] and turn [rad]
  /// in the coming step; and the mean stress [stress] that the next state has, place [length] and
  /// velocity [length/time] in the evaluation, of the automaton itself and not of an image.
  static constexpr int wayAt = 0, turnAt = 3, meanAt = 6, placeAt = 7, velocityAt = 10,
                       rowLength = 13;
  static_assert(rowLength - meanAt <= Exchange::mostValues);
  RowArray rows_{rowLength};
  /// Forces and torques on an own automaton that are not of contacts [force, force length].
  struct External {
    int row;
    Motion forces;
  };
  /// Own automata on which other fixes act.
  std::vector<External> external_;
  /// Pairs whose state changes after the evaluation, and those that may dissipate in the steps to
  /// and from it, in their order.
  std::vector<int> changing_, active_;
  /// For each row, whether its mean stress changes.
  std::vector<char> touched_;
  /// Edges of the box in the evaluation, and how they change in the step that the other half is of
  /// [length].
  Edges box_ = {}, growth_ = {};
  /// By channel, of this rank [energy].
  double sums_[Channels] = {};
  /// What the change of state after the evaluation sets free, by channel, of this rank [energy].
  double released_[Channels] = {};

  /// The mean stresses of the next state, and the pairs that change.
  void findNextMeans(const Step &);
  void findActive(const Step &);
  /// Half a step's work of the outer forces and torques on an automaton along this motion.
  void bookWork(const External &, const Motion &);
  /// How images at which pair k meets move away from each other with the box, beside the way of
  /// their automata, in the step that growth_ is of [length].
  Vector wayOfBox(const Step &, int k) const;
  /// What all contacts dissipate in half a step; back: of the step just done.
  void bookContacts(const Step &, double dt, bool back);
  /// \param grows  the box does
  void bookContact(const Step &, int k, double dt, bool back, bool grows);
  /// What friction dissipates as pair k moves, in the second half of the step just done.
  /// \param growth  of the shear in the step, a vector [-]
  /// \param volume  of the pair [volume], its share of this rank
  void bookFriction(const Step &, int k, const Vector &growth, double volume);
  /// What the change of state sets free.
  void findReleased(const Step &);
  /// Adds what pair k dissipates by its state [energy] to the channel that it pays into, which it
  /// returns.
  /// \param sums  sums_ or released_
  static Channel pay(const Step &, int k, double loss, double *sums);
};

} // namespace mca

#endif
