// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_REPLICATES_H
#define WHEELRAIL_FIT_REPLICATES_H

#include "fit/friction_run.h"

#include <vector>

namespace wheelrail {

/// Runs at one (kappa1, kappa2): other seeds, or other parameters that the law says do not matter.
/// A scatter much above `expected` says that runs differ by more than their errors tell: too short,
/// or by a parameter that the law leaves out.
struct ReplicateGroup {
  /// Kappas of the group's first run, rho E v^2/sigma_0^2 and p E/sigma_0^2.
  double kappa1 = 0.0;
  double kappa2 = 0.0;
  int n = 0;             ///< runs, >= 2
  double mu = 0.0;       ///< their mean
  double scatter = 0.0;  ///< standard deviation of mu between the runs, relative to the mean
  double expected = 0.0; ///< the scatter that their standard errors explain (root mean square)
};

/// Groups of at least two runs with kappa1 and kappa2 equal to a thousandth, in order of kappa1,
/// then kappa2: how well runs that the law takes for the same agree. Points that are left out, and
/// runs without a finite error, are not counted.
/// \return dimensionless numbers all; empty where no two runs agree in kappa1 and kappa2
std::vector<ReplicateGroup> replicateGroups(const std::vector<FrictionRun> &runs);

} // namespace wheelrail

#endif
