// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_MEASURED_SERIES_H
#define WHEELRAIL_FIT_MEASURED_SERIES_H

#include "fit/stationarity.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

/// A friction coefficient that somebody measured against time: no friction log, since it has no
/// automata, and no condition of a law, but a series whose mean and error are found as those of a
/// log.
namespace wheelrail {

/// As the file has it; times in its own unit.
struct MeasuredSeries {
  std::string file;
  std::vector<double> time; ///< rises evenly, to 2 % of a step
  std::vector<double> mu;   ///< as many
};

/// Whether a path is taken for such a series: it ends with .csv, in either case.
bool isMeasuredSeries(const std::string &path);

/// Reads a table with columns `time` and `mu`: named in its first line, in any order and beside
/// others, or without names the only two. Separators and decimal signs as `NumberRows` reads them;
/// lines that begin with '#' are comments.
/// \throws Error (BadInput) with file and line: no such columns, fewer than seven rows, what is no
///         number, times that do not rise evenly
MeasuredSeries readMeasuredSeries(const std::string &path);

/// What a series says: mean and error of its stationary part, as `stationaryPart` and
/// `widenedError` have them.
struct MeasuredMean {
  std::string file;
  SeriesMean mean;
  double standardError = 0.0;   ///< widened: mean +- 1.96 of it holds the true mean at 95 %
  double start = 0.0;           ///< time of the first row that is averaged
  double correlationTime = 0.0; ///< in the file's unit
  std::string note;             ///< why there is no stationary part; empty: there is
};

/// \param start  time from which on all is averaged; absent: the stationary part is looked for
/// \throws Error (BadInput) if the start leaves fewer than four rows
MeasuredMean meanOf(const MeasuredSeries &series, std::optional<double> start);

/// One line each, for people.
std::string textReport(const std::vector<MeasuredMean> &means);

/// Format "mca-measured-friction 1".
nlohmann::ordered_json jsonReport(const std::vector<MeasuredMean> &means);

} // namespace wheelrail

#endif
