// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_CURVE_H
#define WHEELRAIL_CREEP_PATCH_CURVE_H

#include "contact/patch/kalker.h"
#include "creep/patch/moving_patch.h"
#include "creep/sweep.h"

#include <map>
#include <string>
#include <vector>

namespace wheelrail {

enum class PatchMode { Frozen, Moving, Static };

/// Which points leave their fields.
struct FieldSelection {
  enum class Kind { None, Last, All, Numbers };
  Kind kind = Kind::Last;
  std::vector<int> numbers; ///< from 1 on, in the order of creep.csv

  bool holds(int number, int total) const;
};

/// A sweep over a contact in a point: everything with everything. SI units.
struct PatchSpecification {
  PatchContactSpecification contact;
  RoughPatchSpecification roughness;
  CreepPhysics physics;
  PatchMode mode = PatchMode::Frozen;
  MovingPatchSpecification moving;          ///< of mode Moving
  PatchSequence sequence;                   ///< of mode Moving
  std::vector<double> creep, lateral;       ///< -; one value each where the force is given
  std::vector<double> spin;                 ///< 1/m
  std::vector<double> forceX, forceY;       ///< N; empty: the creepage is given
  std::vector<double> forceRatio;           ///< Static: -Fx/(sum of mu p), below 1
  std::vector<std::array<double, 2>> shift; ///< Static: of the wheel against the rail, m
  std::vector<double> speed;                ///< m/s
  FieldSelection fields;
  bool sensitivities = true; ///< Kalker's coefficients of every contact
};

/// One point of the sweep before it is computed.
struct PatchTask {
  std::size_t contact; ///< index in PatchCurves::contacts
  double speed = 0.0;  ///< m/s; 0 in mode static
  PatchDrive drive;    ///< Static: the shift as creepage, m
  double forceRatio = 0.0;
};

/// What a contact of one load and one pair of surfaces is by itself.
struct PatchContactSummary {
  std::optional<CreepSensitivity> sensitivity; ///< N, N m, N m^2 per unit of creepage
  std::optional<KalkerCoefficients> kalker;    ///< with the nominal ellipse's area
};

/// What a sweep gives.
struct PatchCurves {
  std::vector<PatchContact> contacts; ///< by surface, then load
  std::vector<PatchContactSummary> summaries;
  std::vector<PatchPoint> points;    ///< by surface, load, speed, spin, lateral, longitudinal
  std::map<int, PatchFields> fields; ///< SI, by number of the point, from 1 on
  std::map<int, std::vector<PatchStep>> series; ///< of mode Moving, likewise
  std::vector<std::string> warnings;
  int resumed = 0;
  double seconds = 0.0;
};

/// The points in the order of the results.
std::vector<PatchTask> patchTasks(const PatchSpecification &asked);

/// All of them. The work is cut into pieces of a few neighbouring points, each started cold and
/// solved in order, so that the result is the same to the last bit on one thread or many, in one go
/// or resumed.
/// @throws Error (Interrupted) when asked to stop, and what the points throw
PatchCurves solvePatchCurves(const PatchSpecification &asked, const FrictionLaw &law,
                             const SweepOptions &options = {});

} // namespace wheelrail
#endif
