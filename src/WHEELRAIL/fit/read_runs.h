// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_READ_RUNS_H
#define WHEELRAIL_FIT_READ_RUNS_H

#include "base/errors.h"
#include "fit/found_logs.h"
#include "fit/friction_run.h"

#include <string>
#include <vector>

namespace wheelrail {

/// What many logs say, and what is wrong with some of them.
struct LogRuns {
  std::vector<FrictionRun> runs;  ///< of the logs without a fault, in their order
  std::vector<std::string> notes; ///< one line each: a cut last line was dropped
  std::vector<Error> problems;    ///< of the others; BadInput
};

/// Reads all logs, so that all that is wrong with them is told together.
/// \throws what is not the fault of a log
LogRuns readRuns(const std::vector<FoundLog> &logs, const AveragingOptions &options);

/// What an option that is a number may be.
struct OptionRange {
  const char *words; ///< "must be a number > 0" without its beginning
  bool (*allows)(double);
};
namespace option_range {
constexpr OptionRange positive{"> 0", [](double x) { return x > 0.0; }};
constexpr OptionRange notNegative{">= 0", [](double x) { return x >= 0.0; }};
/// The level of confidence intervals.
constexpr OptionRange level{"from 0.5 to 0.9999", [](double x) { return x >= 0.5 && x <= 0.9999; }};
} // namespace option_range

} // namespace wheelrail

#endif
