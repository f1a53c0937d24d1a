// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_MOVING_PATCH_H
#define WHEELRAIL_CREEP_MOVING_PATCH_H

#include "contact/patch/transient.h"
#include "creep/patch/patch_point.h"

#include <functional>

namespace wheelrail {

/// Where transient rolling begins.
enum class RollingStart {
  Steady, ///< from the traction of steady rolling on the surfaces as they lie at the start
  Rest,   ///< without traction
  Shift   ///< from one shift at rest under the forces that are given
};

/// What transient rolling needs beside its drive.
struct MovingPatchSpecification {
  int passes = 4; ///< lengths 2a of the nominal contact that are rolled, >= 2; the means are over
                  ///< the last half
  RollingStart start = RollingStart::Steady;
};

/// Load and creepages at instants of a sequence, linear between them; SI units. Lists that are
/// empty stay as the point has them, others are as long as `time`.
struct PatchSequence {
  std::vector<double> time; ///< s, increasing from 0 on; empty: no sequence
  std::vector<double> load, creep, lateral, spin;

  bool any() const { return !time.empty(); }
  /// A list's value at a time; `constant` where it is empty.
  double at(const std::vector<double> &values, double seconds, double constant) const;
};

/// One step of the time series; SI units.
struct PatchStep {
  double distance = 0.0; ///< rolled at the end of the step, m
  double load = 0.0;
  Creepage creepage;
  double forceX = 0.0, forceY = 0.0, momentZ = 0.0;
  double muMean = 0.0, temperatureRise = 0.0, stickFraction = 0.0;
  double approach = 0.0, peakPressure = 0.0, realArea = 0.0, frictionalPower = 0.0;
};

/// Standard error of the mean of a series that is correlated, from the means of `batches` equal
/// parts (Law, Kelton, Simulation Modeling and Analysis, sec. 9.5.3). 0 for fewer than two.
double batchError(const std::vector<double> &series, int batches);

/// Transient rolling: both surfaces travel through the contact at their own speeds, wheel
/// (1 - xi/2) and rail (1 + xi/2) along x and -+ eta/2 across; spin turns neither of them. Each
/// step is one cell long. Forces are means over the last half of the passes, their standard errors
/// from the means of single passes; the point of a sequence is its last step.
class MovingPatch {
 public:
  /// All must outlive the object.
  MovingPatch(const CreepPhysics &physics, const MovingPatchSpecification &moving,
              const PatchSequence &sequence, const FrictionLaw &law, const PatchContact &contact,
              double spinPoint);

  /// @param goOn asked at each step; false to stop
  /// @return nothing when stopped
  std::optional<PatchPoint> solve(double speed, const PatchDrive &drive,
                                  const std::function<bool()> &goOn);

  const std::vector<PatchStep> &series() const { return series_; }
  const PatchFields &fields() const { return fields_; } ///< of the last step, SI

 private:
  struct Temperature;
  void begin(TransientPatch &transient, double speed, const PatchDrive &drive);
  void press(int step, double load, double distance, const Creepage &creepage);
  PatchStep roll(TransientPatch &transient, Temperature &heat, double speed,
                 const PatchDrive &drive, double distance, double load);
  PatchPoint pointOf(double speed) const;

  const CreepPhysics &physics_;
  const MovingPatchSpecification &moving_;
  const PatchSequence &sequence_;
  const FrictionLaw &law_;
  const PatchContact &contact_;
  double spinPoint_;
  PatchHalfSpace space_;
  NormalContactResult normal_;
  Travel wheel_, rail_;
  Creepage creepage_; ///< of the last step
  int passSteps_, products_ = 0;
  double hottest_ = 0.0;
  std::vector<PatchStep> series_;
  PatchFields fields_;
};

/// Distance that a point rolls, m.
double rolledDistance(const MovingPatchSpecification &moving, const PatchSequence &sequence,
                      const HertzEllipse &hertz, double speed);

} // namespace wheelrail
#endif
