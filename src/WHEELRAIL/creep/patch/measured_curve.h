// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_MEASURED_CURVE_H
#define WHEELRAIL_CREEP_MEASURED_CURVE_H

#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

/// One value of a measured traction curve.
struct MeasuredTraction {
  double creep = 0.0;         ///< longitudinal, sliding/rolling speed, > 0
  double speed = 0.0;         ///< rolling speed, m/s, > 0
  double tractionRatio = 0.0; ///< T/N, > 0; braking or driving alike
};

/// Reads a table with the columns creep, speed and traction_ratio, in any order; the unit of speed
/// stands in a line "# speed: UNIT", that of creep may be "# creep: %" or in its name,
/// creep_percent. Other lines that begin with '#' are free text.
/// \param speed of a file without a column of speed, m/s; absent: the column is needed
/// \throws Error (BadInput) with file, line and column
std::vector<MeasuredTraction> readMeasuredCurve(const std::string &path,
                                                std::optional<double> speed = std::nullopt);

} // namespace wheelrail
#endif
