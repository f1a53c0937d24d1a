// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_FIT_REPORT_H
#define WHEELRAIL_FIT_FIT_REPORT_H

#include "fit/fit_analysis.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace wheelrail {

/// What is wrong with the runs: one line each, without an end. `FitAnalysis::mixture` is one
/// more. They are no part of `textReport`.
std::vector<std::string> warningsOf(const FitAnalysis &analysis);

/// The report for people: a table of the runs, the law with its intervals, the comparison of
/// models, runs that repeat each other.
/// Stresses in MPa, times in ns, velocities in m/s; kappas and mu are pure numbers.
/// \return several lines, each ended
std::string textReport(const FitAnalysis &analysis);

/// The law file (format "mca-friction-law 1", with everything else under "report"), or, when no law
/// was fitted, the same report under format "mca-friction-report 1" with the reason. Numbers that
/// are not finite are null.
/// Keys keep their order, so that equal analyses give equal files.
nlohmann::ordered_json jsonReport(const FitAnalysis &analysis);

} // namespace wheelrail

#endif
