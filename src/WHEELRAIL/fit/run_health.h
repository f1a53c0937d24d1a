// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_RUN_HEALTH_H
#define WHEELRAIL_FIT_RUN_HEALTH_H

#include "fit/friction_log.h"

#include <limits>
#include <string>
#include <vector>

namespace wheelrail {

/// Whether a run is one that a friction coefficient may rest on: how far it slid, whether its layer
/// is still a solid, what it lost. nan stands for what the log does not say.
struct RunHealth {
  double distance = 0.0;      ///< slid over the whole log, nm
  double startDistance = 0.0; ///< slid before the part that is averaged, nm
  double gap = 0.0;           ///< rise of the driven layer, mean over that part, nm
  /// Area (in space: volume) of an automaton of the layer over that of the unloaded solid, mean
  /// over that part; below `leastRoom` the layer has sunk. Of a log without that column from the
  /// gap and the command in its head, if it has one.
  double room = std::numeric_limits<double>::quiet_NaN();
  double leastRoom = 0.0; ///< mcawr::layer_health::leastRoom of the run
  /// Automata that left through the driven or the held rows, at the end.
  double lost = std::numeric_limits<double>::quiet_NaN();
  /// Share of that part in which nothing broke while the layer slid by an automaton's diameter.
  double smooth = 0.0;
  /// mcawr::layer_health::junctions of the run; nan where nothing links.
  double junctions = std::numeric_limits<double>::quiet_NaN();
  /// What a straight line through mu gains over that part, over the mean there, and the p value of
  /// its slope (trendP); nan of fewer than `leastTested` rows.
  double drift = std::numeric_limits<double>::quiet_NaN();
  double driftP = std::numeric_limits<double>::quiet_NaN();
  /// The most that flow, breaking or unlinked contacts gave back of what they had dissipated, over
  /// the work of the drive; nan without an account.
  double fall = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> strengths; ///< of all materials, MPa, the weakest first
  bool slides = false;           ///< its velocity is not 0
};

/// Blocks grind in over some 200 nm (doc/how_close.md): means begin where this is over [nm].
constexpr double grindingDistance = 250.0;

/// A drift above this that is no chance at `certainDrift` is warned of. Stricter than
/// `driftLevel`, at which one run in twenty would be.
constexpr double largeDrift = 0.1;
constexpr double certainDrift = 0.01;

/// Health of the run of one log.
/// \param first row of the part that is averaged, below the number of rows
RunHealth runHealth(const FrictionLog &log, std::size_t first);

/// What is wrong with runs, one line a kind: how many they are, the first of them, its number, what
/// it means.
/// \param runs names and health of the runs, in order
/// \return no line for a kind that no run has
std::vector<std::string>
healthWarnings(const std::vector<std::pair<std::string, const RunHealth *>> &runs);

} // namespace wheelrail

#endif
