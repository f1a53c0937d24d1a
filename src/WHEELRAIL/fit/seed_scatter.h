// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_SEED_SCATTER_H
#define WHEELRAIL_FIT_SEED_SCATTER_H

#include "fit/fit_condition.h"

#include <cstddef>
#include <vector>

namespace wheelrail {

/// What runs of one condition differ by beyond what each knows of its own error: another roughness,
/// and states of the layer that outlive a run. No series shows it of itself; runs that differ in
/// the seed only do.
struct SeedScatter {
  double share = 0.0; ///< standard deviation between seeds as a share of mu, >= 0
  int freedom = 0;    ///< degrees of freedom: runs less conditions, of those with two runs or more
  int conditions = 0; ///< with two runs or more; 0: nothing is known of it
  /// Places in the list of runs of all its runs, of the other conditions, too; at least one.
  std::vector<std::size_t> runs;
  /// Student's t of 95 % by `freedom`: how many standard errors the interval of a mean reaches; of
  /// a normal distribution where nothing is known.
  double t95() const;
};

/// For all conditions of runs with the same laws, program and packing one share: the one at which
/// the squared deviations of mu from the conditions' weighted means, each over muOwn^2 +
/// (share mu)^2, add up to the degrees of freedom (R. C. Paule and J. Mandel, J. Res. NBS 87 (1982)
/// 377); 0 where the runs' own errors explain them.
/// \param conditions of `conditionsOf(runs)`
/// \return one for each set of laws, program and packing, in the order of their first runs
std::vector<SeedScatter> seedScatters(const std::vector<FrictionRun> &runs,
                                      const std::vector<FitCondition> &conditions);

/// Sets muSe and t95 of its runs.
void addSeedScatter(std::vector<FrictionRun> &runs, const SeedScatter &scatter);

} // namespace wheelrail

#endif
