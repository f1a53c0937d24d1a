// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_CURVE_POINT_H
#define WHEELRAIL_CREEP_LINE_CURVE_POINT_H

#include "creep/line/creep_point.h"
#include "creep/sweep/law_spread.h"

#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail {

/// A point with the profile it belongs to and, if the law has a covariance, the band of its T/N.
/// The band is in units of T/N; without a covariance it stays 0.
struct CurvePoint : CreepPoint {
  std::uint64_t profile = 0; ///< seed, or number of the measured profile from 1 on
  Band band;
  std::string failure; ///< why it was not computed: speed, creep and profile only; or empty

  bool converged() const { return failure.empty(); }
};

/// All that an operating point has, in the order of creep.csv: the table from which creep.csv,
/// creep.json and the journal follow.
/// \return the same table in every call
const std::vector<Column<CurvePoint>> &curveColumns();

} // namespace wheelrail
#endif
