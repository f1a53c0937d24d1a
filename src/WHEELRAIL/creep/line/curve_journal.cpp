// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/curve_journal.h"

#include "creep/sweep/point_journal.h"

namespace wheelrail {

nlohmann::json curvePointsJson(const std::vector<CurvePoint> &points)
{
  return pointsJson(curveColumns(), points);
}

std::vector<CurvePoint> curvePointsFrom(const nlohmann::json &rows)
{
  return pointsFromJson(curveColumns(), rows);
}

} // namespace wheelrail
