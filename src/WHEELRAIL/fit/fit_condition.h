// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_FIT_CONDITION_H
#define WHEELRAIL_FIT_FIT_CONDITION_H

#include "fit/friction_run.h"
#include "fit/law_fit.h"

#include <cstddef>
#include <vector>

namespace wheelrail {

/// Runs of one condition: their heads agree in material, loading, geometry, laws, program and time
/// step, and differ in the seed of the roughness at most. The fit counts them once: what a
/// condition differs from the law by is the same for all its seeds, so that counting the runs as
/// independent would make the parameters look surer than they are.
struct FitCondition {
  std::vector<std::size_t> runs; ///< places in the list of runs, at least one
  /// Mean of mu over the runs, and its standard error: the larger of the two below.
  ConditionMean mean;
  double ownError = 0.0; ///< of the mean, from the runs' standard errors
  double scatter = 0.0;  ///< of the mean, from what the seeds differ by; nan of a single run
};

/// The conditions of the runs that are not left out, in the order of their first runs.
/// \param runs with a finite standard error where they are not left out
/// \return each run that is not left out is in one condition
std::vector<FitCondition> conditionsOf(const std::vector<FrictionRun> &runs);

} // namespace wheelrail

#endif
