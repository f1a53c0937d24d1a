// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_SEQUENCE_H
#define WHEELRAIL_CREEP_PATCH_SEQUENCE_H

#include "creep/patch/field_files.h"
#include "creep/patch/patch_values.h"

#include <map>
#include <vector>

namespace wheelrail {

/// What changes in time, at instants; SI units. In mode moving it is linear between the instants or
/// held from each to the next, in mode static each instant is a stage. What is held at the last
/// instant does not count: a step would begin there or not, by the length of the cells. Lists that
/// are empty stay as the point has them, others are as long as `time`: the case reader refuses
/// lists of other lengths.
struct PatchSequence {
  std::vector<double> time; ///< s, increasing from 0 on; empty: no sequence
  /// Normal force (N, > 0), xi and eta (sliding/rolling speed) and phi (1/m) at these instants.
  std::vector<double> load, creep, lateral, spin;
  std::vector<double> forceX, forceY; ///< on the wheel, N; the creepages are found
  std::vector<double> approach;       ///< of stages, m: in place of the load where it is not 0
  std::vector<double> speed;  ///< m/s, >= 0; no two neighbours 0, held: only the last may be 0
  bool held = false;          ///< from each instant to the next; else linear
  std::vector<double> fields; ///< instants whose fields are kept, s, increasing

  bool any() const { return !time.empty(); }
  /// A list's value at a time; `constant` where it is empty. Held it is that of the time before an
  /// instant, at the instant itself, too: of a step until there.
  /// \param values one of the lists above
  /// \param seconds since the start; from the last instant on `lastOf` holds
  double at(const std::vector<double> &values, double seconds, double constant) const;
  /// What a list, not an empty one, ends with: the last value, held: the one before it.
  double lastOf(const std::vector<double> &values) const;
  /// Distance rolled until an instant, m.
  /// \param constant  speed where there is no list, m/s
  double distanceAt(double seconds, double constant) const;
  /// The way back: when a distance has been rolled, s. Beyond the last instant its speed holds.
  double timeAt(double distance, double constant) const;
};

/// One step of mode moving, or one stage of mode static; SI units.
/// Forces are those on the wheel, against its slip; powers are friction's heat. A step is one cell
/// of rolling, so that row k of a series ends at k + 1 cells. The creepages of a stage are the sum
/// of all shifts until then, m.
struct PatchStep : PatchValues {
  double distance = 0.0;     ///< rolled at the end of the step, m
  double time = 0.0;         ///< s, at the end of the step
  double speed = 0.0;        ///< rolling speed of the step, m/s
  double drivingPower = 0.0; ///< W; see `PatchSums::drivingPower`

  double tractionRatio() const; ///< size of the tangential force over the load
};

/// All that a step has, in the order of series.csv after `point`: the table from which series.csv
/// and the journal follow.
/// \return the same table in every call
const std::vector<Column<PatchStep>> &seriesColumns();

/// What an operating point leaves of its way: a row a step or stage, fields of chosen instants.
struct PatchHistory {
  std::vector<PatchStep> steps;
  /// SI, by the instant's place in `PatchSequence::fields`, from 1 on.
  std::map<int, PatchFields> fields;
  double now = 0.0; ///< s, of the step that is being solved: for messages

  /// Appends a row; keeps the fields if it is the step for one or more of the chosen instants.
  /// \param next  at the end of the next step, s; it decides which of the two is nearer
  void add(const PatchStep &step, double next, const PatchSequence &sequence,
           const PatchFields &state);
  /// Of the last step: it stands for the instants that are left, too.
  void end(const PatchSequence &sequence, const PatchFields &state);
};

/// The step that stands for an instant: the nearest one, the earlier of two that are as near.
/// \param steps  at least one
/// \return its place in the steps
std::size_t stepAt(const std::vector<PatchStep> &steps, double seconds);

} // namespace wheelrail
#endif
