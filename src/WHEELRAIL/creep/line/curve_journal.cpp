// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/curve_journal.h"

#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Json = nlohmann::json;

Json rowOf(const CurvePoint &p)
{
  return {p.speed,
          p.creep,
          p.tractionRatio,
          p.traction,
          p.muMean,
          p.temperatureRise,
          p.temperatureMaximum,
          p.iterations,
          p.stickFraction,
          p.profile,
          p.band.standardError,
          p.band.low,
          p.band.high,
          p.failure,
          p.use.ranges};
}

CurvePoint pointFrom(const Json &j)
{
  CurvePoint p;
  p.speed = j.at(0);
  p.creep = j.at(1);
  p.tractionRatio = j.at(2);
  p.traction = j.at(3);
  p.muMean = j.at(4);
  p.temperatureRise = j.at(5);
  p.temperatureMaximum = j.at(6);
  p.iterations = j.at(7);
  p.stickFraction = j.at(8);
  p.profile = j.at(9);
  p.band = {j.at(10), j.at(11), j.at(12)};
  p.failure = j.at(13);
  p.use.ranges = j.at(14);
  return p;
}

} // namespace

Json curvePointsJson(const std::vector<CurvePoint> &points)
{
  Json rows = Json::array();
  for (const CurvePoint &point : points)
    rows.push_back(rowOf(point));
  return rows;
}

std::vector<CurvePoint> curvePointsFrom(const Json &rows)
{
  std::vector<CurvePoint> points;
  for (const Json &row : rows)
    points.push_back(pointFrom(row));
  return points;
}

} // namespace wheelrail
