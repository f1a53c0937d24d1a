// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_VALUES_H
#define WHEELRAIL_CREEP_PATCH_VALUES_H

#include "contact/patch/patch_contact.h"
#include "contact/patch/solvers/patch_sums.h"
#include "contact/patch/solvers/tangential.h"
#include "contact/wear.h"
#include "creep/sweep/sliding_values.h"

namespace wheelrail {

/// What one solution of a patch contact gives; in mode moving of one step, or the mean over steps.
/// SI units; forces are those on the wheel, against its slip.
struct PatchValues : SlidingValues {
  double load = 0.0;                 ///< N
  Creepage creepage;                 ///< given, or found; phi in 1/m
  double forceX = 0.0, forceY = 0.0; ///< N
  double momentZ = 0.0;              ///< N m, about the origin, wherever the box lies
  double approach = 0.0;             ///< m
  double peakPressure = 0.0;         ///< Pa
  double realArea = 0.0;             ///< m^2
  double frictionalPower = 0.0;      ///< W, heat by friction
  double frictionWork = 0.0;         ///< the same over the length rolled, N; of a shift the work, J
  double tGamma = 0.0;               ///< -(xi Fx + eta Fy + phi Mz), N
  double peakTraction = 0.0;         ///< Pa
  double wearVolume = 0.0;           ///< over the length rolled, m^2
  /// What one passage takes off where it takes most, m: a place of the rail, across the track, or
  /// of the wheel in one turn. Where the contact moves, of the row whose mean is largest.
  double wearDepth = 0.0;
};

/// Their columns: the order of series.csv.
std::vector<Column<PatchValues>> patchValueColumns();

/// Where a patch has been solved; all must outlive the object.
struct PatchSolution {
  const PatchContact &contact;
  const PatchSums &sums;
  const TangentialResult &tangential;
  const WearLaw &wear;
  double load, approach; ///< N, m
  const Creepage &creepage;
  const Eigen::VectorXd &pressure, &mu, &temperature; ///< per cell; Pa and K
  double speed;                                       ///< v0, m/s; 0 without rolling
};
/// What one passage takes off a place of each row of cells, m; empty without a law of wear. A place
/// of the rail lies under all cells of its row, one after the other.
Eigen::VectorXd wornRows(const PatchSolution &solved);
/// The values of one solution.
/// \param worn its `wornRows`
PatchValues patchValues(const PatchSolution &solved, const Eigen::VectorXd &worn);
inline PatchValues patchValues(const PatchSolution &solved)
{
  return patchValues(solved, wornRows(solved));
}

} // namespace wheelrail
#endif
