// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_FRICTION_TABLE_H
#define WHEELRAIL_LAW_FRICTION_TABLE_H

#include <Eigen/Core>

#include <string>
#include <vector>

namespace wheelrail {

/// Friction coefficients, measured or computed elsewhere, on a grid of pressures and sliding
/// speeds; SI units. Bilinear between the points, constant beyond the grid.
struct FrictionTable {
  std::vector<double> pressure; ///< Pa, >= 0, increasing, at least one
  std::vector<double> speed;    ///< sliding speed, m/s, >= 0, increasing, at least one
  Eigen::MatrixXd mu;           ///< > 0; a row for each pressure, a column for each speed

  /// \param p, v Pa and m/s, >= 0; beyond the grid the value at its border
  double operator()(double p, double v) const;
};

/// Reads a table as CSV: the lines "# pressure: UNIT" and "# speed: UNIT", a line with the names
/// pressure, speed, mu in any order, a row for each pair of a pressure and a speed, in any order.
/// \throws Error (BadInput) naming file and line: no unit, an unknown one, columns missing, no
///         number, a pressure or speed below 0, mu not in (0, 10], a pair given twice or missing
FrictionTable readFrictionTable(const std::string &path);

} // namespace wheelrail

#endif
