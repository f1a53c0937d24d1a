// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/measured_curve.h"

#include "base/column_file.h"

namespace wheelrail {

std::vector<MeasuredTraction> readMeasuredCurve(const std::string &path,
                                                std::optional<double> speed)
{
  const ColumnFile file(path, {{"creep", "1", false, false, 10.0},
                               {"speed", "m/s", true, false, 1000.0, speed},
                               {"traction_ratio", "", false, false, 10.0}});
  std::vector<MeasuredTraction> curve;
  for (const ColumnFile::Row &row : file.rows)
    curve.push_back({row.values[0], row.values[1], row.values[2]});
  return curve;
}

} // namespace wheelrail
