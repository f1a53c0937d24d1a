// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_CURVE_H
#define WHEELRAIL_CREEP_PATCH_CURVE_H

#include "contact/patch/solvers/kalker.h"
#include "creep/patch/patch_specification.h"
#include "creep/sweep/sweep.h"

#include <map>
#include <string>
#include <vector>

namespace wheelrail {

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
  std::map<int, PatchFields> fields; ///< SI, by `fieldNumber`
  /// Steps of mode Moving and of sequences, by number of the point, from 1 on; where a point failed
  /// in the middle of its sequence, what came before.
  std::map<int, std::vector<PatchStep>> series;
  /// One line each, every line once: what was done to the maps, for example.
  std::vector<std::string> warnings;
  /// Points that were taken over from the journal of an interrupted run.
  int resumed = 0;
  /// Wall-clock time, contacts included.
  double seconds = 0.0;
};

/// Solves all operating points. The work is cut into pieces of a few neighbouring points, each
/// started cold and solved in order, so that the result is the same to the last bit on one thread
/// or many, in one go or resumed.
/// \throws Error (Interrupted) when asked to stop, and what the points throw; Error (NotConverged)
///         where no point at all converges
/// \param law of the specification's friction (`LawChoice::read`)
/// \param options threads, journal, progress; none of them changes a number
PatchCurves solvePatchCurves(const PatchSpecification &asked, const LawPointer &law,
                             const SweepOptions &options = {});

} // namespace wheelrail
#endif
