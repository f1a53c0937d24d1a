// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_CURVE_H
#define WHEELRAIL_CREEP_PATCH_CURVE_H

#include "contact/patch/solvers/kalker.h"
#include "creep/patch/moving_patch.h"
#include "creep/sweep/field_selection.h"
#include "creep/sweep/sweep.h"
#include "law/law_choice.h"

#include <map>
#include <string>
#include <vector>

namespace wheelrail {

/// How the surfaces behave: they stand still in the contact (steady rolling), travel through it
/// with the material, or do not roll at all. In frozen and static mode time plays no part.
enum class PatchMode { Frozen, Moving, Static };

/// A sweep over a point contact: everything with everything. SI units.
/// Every list has at least one value where its mode reads it. Of creepage and force of one
/// direction only one is given; in mode static only one of force ratio, shift and forces.
struct PatchSpecification {
  PatchContactSpecification contact;
  /// None, generated or measured; several surfaces multiply the points.
  RoughPatchSpecification roughness;
  LawChoice friction;
  /// Strength, temperature and limit of the pressure.
  CreepPhysics physics;
  PatchMode mode = PatchMode::Frozen;
  MovingPatchSpecification moving;          ///< of mode Moving
  PatchSequence sequence;                   ///< Moving; Static: its loads, one after the other
  std::vector<double> creep, lateral;       ///< -; one value each where the force is given
  std::vector<double> spin;                 ///< 1/m
  std::vector<double> forceX, forceY;       ///< N; empty: the creepage is given
  std::vector<double> forceRatio;           ///< Static: -Fx/(sum of mu p), below 1
  std::vector<std::array<double, 2>> shift; ///< Static: of the wheel against the rail, m
  std::vector<double> speed;                ///< m/s
  /// Points whose fields are kept and written; each costs eight doubles a cell.
  FieldSelection fields;
  bool sensitivities = true; ///< Kalker's coefficients of every contact
  /// How a covariance of the law becomes bands; not of mode Static.
  SpreadSpecification spread;
};

/// One point of the sweep before it is computed.
struct PatchTask {
  /// Contacts are numbered by surface, then load.
  std::size_t contact; ///< index in PatchCurves::contacts
  double speed = 0.0;  ///< m/s; 0 in mode static
  PatchDrive drive;    ///< Static: the shift as creepage, m
  /// Static: -Fx/(sum of mu p); absent where forces or a shift are given.
  std::optional<double> forceRatio;
};

/// What a contact of one load and one pair of surfaces is by itself.
/// Both are absent in mode static, and where they were not asked for.
struct PatchContactSummary {
  /// Slopes of the forces at zero creepage: no slip anywhere (Kalker's linear theory, on the
  /// cells).
  std::optional<CreepSensitivity> sensitivity; ///< N, N m, N m^2 per unit of creepage
  /// Dimensionless: divided by G and powers of the area, as Kalker 1990 tabulates C11, C22, C23,
  /// C33.
  std::optional<KalkerCoefficients> kalker; ///< with the nominal ellipse's area
};

/// What a sweep gives.
/// Contacts and points are complete, or `solvePatchCurves` has thrown.
struct PatchCurves {
  std::vector<PatchContact> contacts; ///< by surface, then load
  /// One for each of `contacts`.
  std::vector<PatchContactSummary> summaries;
  /// By surface, load, speed, spin, lateral, longitudinal; those that did not converge too, at
  /// least one that did.
  std::vector<PatchPoint> points;
  LawUse use;                        ///< where all points together asked for mu
  bool hasBand = false;              ///< the law has a covariance
  double redrawn = 0.0;              ///< share of the sampled laws that had to be drawn again
  std::map<int, PatchFields> fields; ///< SI, by number of the point, from 1 on
  std::map<int, std::vector<PatchStep>> series; ///< of mode Moving, likewise
  /// One line each, every line once: what was done to the maps, for example.
  std::vector<std::string> warnings;
  /// Points that were taken over from the journal of an interrupted run.
  int resumed = 0;
  /// Wall-clock time, contacts included.
  double seconds = 0.0;
};

/// The points in the order of the results.
/// The longitudinal creepage or force changes fastest, then lateral, spin, speed; then load and
/// surface. Number k of the results is element k - 1 here.
std::vector<PatchTask> patchTasks(const PatchSpecification &asked);

/// All of them. The work is cut into pieces of a few neighbouring points, each started cold and
/// solved in order, so that the result is the same to the last bit on one thread or many, in one go
/// or resumed.
/// @throws Error (Interrupted) when asked to stop, and what the points throw; Error (NotConverged)
///         where no point at all converges
/// @param law of the specification's friction (`LawChoice::read`)
/// @param options threads, journal, progress; none of them changes a number
PatchCurves solvePatchCurves(const PatchSpecification &asked, const LawPointer &law,
                             const SweepOptions &options = {});

} // namespace wheelrail
#endif
