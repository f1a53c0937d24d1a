// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_LAYER_HEALTH_H
#define MCAWR_SHARED_LAYER_HEALTH_H

/// When a sliding layer is no solid any more: the bounds that the plugin, while it runs, and
/// wr_fit, from the log, warn by. doc/friction_log.md says what they mean.
namespace mcawr::layer_health {

/// A layer may shrink by this beyond its elastic compression p/K: what plasticity isochoric, which
/// keeps the volume, stays within at every pressure that it was tested at (1.9 %).
constexpr double sinkAllowance = 0.03;

/// Least room (friction_log::Row::room) of a layer that is a solid: 1 - p/K - sinkAllowance.
/// \param pressure, bulkModulus  of one unit; p >= 0, K > 0
/// \return pure number, at most 1 - sinkAllowance
constexpr double leastRoom(double pressure, double bulkModulus)
{
  return 1.0 - pressure / bulkModulus - sinkAllowance;
}

/// What flow, breaking and unlinked contacts dissipate never falls; by this share of the work done
/// it may, since contacts that touch or part within a step find up to 3e-4 of it too much or too
/// little.
constexpr double fallAllowance = 1e-3;

} // namespace mcawr::layer_health

#endif
