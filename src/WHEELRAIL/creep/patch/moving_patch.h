// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_MOVING_PATCH_H
#define WHEELRAIL_CREEP_MOVING_PATCH_H

#include "contact/patch/solvers/transient.h"
#include "creep/patch/patch_point.h"
#include "creep/patch/patch_sequence.h"

#include <functional>

namespace wheelrail {

/// Where transient rolling begins.
enum class RollingStart {
  Steady, ///< from traction and temperature of steady rolling on the surfaces as they lie then
  Rest,   ///< without traction
  Shift   ///< from one shift at rest under the forces that are given
};

/// What transient rolling needs beside its drive.
struct MovingPatchSpecification {
  int passes = 12; ///< lengths 2a of the nominal contact that are rolled, >= 2
  RollingStart start = RollingStart::Steady;
  int stepCells = 1; ///< cells that are rolled in a step; 1 where each remembers its heat

  /// Passes at the start that the means leave out: 2, or 4 where the rolling does not begin with
  /// the traction of steady rolling, and at most half of all.
  int discardedPasses() const;
};

/// Standard error of the mean of a series that is correlated, from the means of `batches` equal
/// parts (Law, Kelton, Simulation Modeling and Analysis, sec. 9.5.3). 0 for fewer than two.
/// \param series as long as one likes; values beyond a whole number of batches are left out at its
///         start
/// \param batches number of equal parts, at least 2; each should be longer than the correlation
/// \return in the unit of the series
double batchError(const std::vector<double> &series, int batches);

/// Transient rolling: both surfaces travel through the contact at their own speeds, wheel
/// (1 - xi/2) and rail (1 + xi/2) along x and -+ eta/2 across, and turn by +- phi/2 on their way
/// through the box (`Travel`). Each step is one cell long. Forces are means over the passes that
/// are not discarded, their standard errors from the means of single passes; the point of a
/// sequence is its last step. The normal contact is solved again at each step where the surfaces
/// are rough, the load changes, the hardness depends on temperature or the bodies are unlike; it
/// starts from the pressure moved by a cell. Eq. 11's temperature follows the mean of the length 2a
/// before, the local one is carried along by the material and is a cell behind in the friction
/// coefficient.
class MovingPatch {
 public:
  /// All must outlive the object.
  /// \param contact its surfaces must reach far enough for the way: see `preparePatch`'s travel
  /// \param spinPoint `TangentialProblem::spinPoint`, 0 .. 1
  MovingPatch(const CreepPhysics &physics, const MovingPatchSpecification &moving,
              const PatchSequence &sequence, const FrictionLaw &law, const PatchContact &contact,
              double spinPoint);

  /// \param goOn asked at each step; false to stop
  /// \return nothing when stopped
  /// Each call begins anew: at the place, the pressure and the `RollingStart` of the specification.
  /// \param speed v0, m/s, > 0
  /// \param drive creepages or forces; a sequence's lists take the place of both
  /// \throws Error (NotConverged); Error (BadInput) for contact at the border of the box, for a
  ///         force that friction cannot carry, for a way that leads out of a measured map
  std::optional<PatchPoint> solve(double speed, const PatchDrive &drive,
                                  const std::function<bool()> &goOn);

  /// All steps of the last call, in order, also of one that threw; SI units.
  const std::vector<PatchStep> &series() const { return history_.steps; }
  const PatchHistory &history() const { return history_; }
  const PatchFields &fields() const { return fields_; } ///< of the last step, SI

 private:
  /// Rise per cell, and what Eq. 11 needs of the pass.
  struct Temperature;
  double stepLength() const { return moving_.stepCells * contact_.grid.dx; } ///< m
  /// What drives the contact at an instant. \param drive of the point
  PatchDrive driveAt(double time, const PatchDrive &drive) const;
  /// Number of steps that a point rolls. \param speed of the point, m/s
  int stepsOf(double speed) const;
  /// The pressure, the traction and the creepages that the first step goes on from.
  /// \param load at the first instant, N
  void begin(TransientPatch &transient, Temperature &heat, double speed, const PatchDrive &drive,
             double load);
  /// Moves both surfaces by a step.
  void travel(const Creepage &creepage);
  /// Is the pressure of the step before still that under this load?
  bool pressureStays(double load) const;
  /// The normal contact where the surfaces are now; distance (m) for messages.
  /// \param start    pressure to begin with
  /// \param opening  of the gap by the traction, or empty
  void press(double load, double distance, const Eigen::VectorXd &start,
             const Eigen::VectorXd &opening);
  /// Friction, traction and heat of one step under the present pressure.
  PatchStep roll(TransientPatch &transient, Temperature &heat, double speed,
                 const PatchDrive &drive, double distance, double load);
  /// Steps that the means are over: those of the last passes; of a sequence the last one.
  int countedSteps() const;
  /// Means over what is not discarded of the series; of a sequence its last step.
  PatchPoint pointOf(double speed) const;

  const CreepPhysics &physics_;
  const MovingPatchSpecification &moving_;
  const PatchSequence &sequence_;
  const FrictionLaw &law_;
  const PatchContact &contact_;
  double spinPoint_;
  PatchHalfSpace space_;
  PatchCoupling coupling_;
  NormalContactResult normal_;
  TangentialField imposed_; ///< by the pressure of unlike bodies, at the step before
  Travel wheel_, rail_;
  Creepage creepage_; ///< of the last step
  std::optional<SlipMemory> memory_;
  Eigen::VectorXd memoryRatio_; ///< see `SlipMemory`; goes with the material
  int passSteps_, products_ = 0;
  double hottest_ = 0.0;
  Eigen::VectorXd worn_; ///< `wornRows`, sums over the steps that count
  int discarded_ = 0;    ///< steps of this point before them
  PatchHistory history_;
  PatchFields fields_;
};

/// Distance that a point rolls, m.
/// `passes` lengths 2a, or of a sequence its last instant times the speed.
/// \param hertz in m
/// \param speed m/s
double rolledDistance(const MovingPatchSpecification &moving, const PatchSequence &sequence,
                      const HertzEllipse &hertz, double speed);

} // namespace wheelrail
#endif
