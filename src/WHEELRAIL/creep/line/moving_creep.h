// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_MOVING_CREEP_H
#define WHEELRAIL_CREEP_LINE_MOVING_CREEP_H

#include "creep/line/creep_point.h"

#include <functional>
#include <optional>

namespace wheelrail {

/// What transient rolling needs beside the creeps.
struct MovingSpecification {
  int passes = 4;               ///< lengths of the nominal contact that are rolled, >= 2
  double referenceLength = 1.0; ///< of the half-plane's free constant, in Hertz half-widths, > 0
};

/// One creep on its way through the contact, as `MovingCreep` keeps it.
/// Sums are divided by the number of steps only when the point is made.
struct Roller {
  double creep;
  /// Traction and displacements that the last step left.
  TransientRolling rolling;
  /// Heat in the material; only the local model has it.
  std::optional<TravellingHeat> heat;
  Eigen::VectorXd temperature, mu; ///< per cell; K
  Eigen::VectorXd memoryRatio;     ///< see `SlipMemory`; goes with the material
  Eigen::VectorXd pressed;         ///< displacement by the last pressure of unlike bodies, in cells
  RollingResult result;            ///< on the window
  LineValues pass, counted;        ///< sums over the steps of the pass, of the last half of all
  double hottest = 0.0;            ///< K, anywhere in the last half
  double carried = 0.0; ///< over the load where all slides, sum over the steps of the pass
};

/// Transient rolling: the roughness travels with the material, one cell a step. The creeps of a
/// call share the pressures and are rolled together; they do not influence each other, so a
/// pressure limit that depends on temperature wants one creep a call, and so do unlike bodies,
/// whose pressure is a step behind the traction. Traction, friction and stick are means over the
/// last half of the passes. Eq. 11's temperature follows the mean of the pass before; the local one
/// is carried along by the material and is a cell behind in the friction coefficient. Lengths are
/// those of the nominal (Hertz) contact: one pass is 2a long.
class MovingCreep {
 public:
  /// All arguments must outlive the object.
  /// \param setup of a Free boundary, with a measured profile kept whole
  /// \param law not read where friction is constant
  MovingCreep(const CreepPhysics &physics, const MovingSpecification &moving,
              const FrictionLaw &law, const ContactSetup &setup);

  /// \param speed v0, m/s, > 0
  /// \param creeps sliding/rolling speed, of unlike bodies one; a negative one gives the mirror
  ///        image, as of `FrozenCreep::solve`
  /// \param progress called at every step; returns false to stop
  /// \return one point per creep; empty when stopped
  /// \throws Error (NotConverged), Error (BadInput) for a measured profile that is too short
  /// Begins anew with every call: with the profile at its start and no traction.
  std::vector<CreepPoint> solve(double speed, const std::vector<double> &creeps,
                                const std::function<bool()> &progress);

  /// At the end of `solve`, in its last step, over the whole domain; SI units.
  /// \param creep place in the list of creeps
  const ContactFields &fields(std::size_t creep) const { return fields_.at(creep); }

 private:
  /// The pressure of a step, warm from the one before; the temperature of the rollers sets its
  /// limit, that of one cell by cell, of several the warmest mean.
  /// \param step number of cells that the profile has moved
  void solvePressure(int step, const std::vector<Roller> &rollers);
  /// Makes the window large enough for the cells in contact and moves every roller's state along.
  void fitWindow(std::vector<Roller> &rollers);
  /// One step of one creep; `counted` steps are averaged.
  /// \param speed v0, m/s
  void roll(Roller &roller, double speed, bool counted);
  /// Slip in the window by a pressure of unlike bodies that has come to be in this step.
  Eigen::VectorXd imposedBy(const Eigen::VectorXd &pressure, Roller &roller) const;
  /// Eq. 11 after each length of the nominal contact.
  /// \param steps of the length, for the mean
  void endPass(Roller &roller, double speed, int steps);
  /// Means over the `counted` steps of all `steps`.
  CreepPoint pointOf(const Roller &roller, double speed, int steps, int counted) const;
  ContactFields fieldsOf(const Roller &roller) const;

  const CreepPhysics &physics_;
  const MovingSpecification &moving_;
  const FrictionLaw &law_;
  const ContactSetup &setup_;
  HalfPlane domain_;                ///< for the pressure
  std::optional<HalfPlane> window_; ///< for the traction: the cells in contact and a few more
  int windowBegin_ = 0;
  NormalContactResult normal_;
  ContactFields contact_;             ///< its pressure
  std::vector<ContactFields> fields_; ///< of every creep
  double coupling_ = 0.0;             ///< as `FrozenCreep` has it
  std::optional<SlipMemory> memory_;  ///< where friction falls with the slip of each cell
};

} // namespace wheelrail
#endif
