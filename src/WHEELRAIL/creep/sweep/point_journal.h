// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_POINT_JOURNAL_H
#define WHEELRAIL_CREEP_SWEEP_POINT_JOURNAL_H

#include "creep/sweep/columns.h"
#include "law/law_use.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace wheelrail {

/// Points of one piece of a sweep as a journal keeps them: their columns, why they failed and where
/// they asked for mu; each by its name.
/// \param points with `failure` and `use`
template<class Point>
nlohmann::json pointsJson(const std::vector<Column<Point>> &table, const std::vector<Point> &points)
{
  nlohmann::json json = journalRows(table, points);
  json["failure"] = json["law_use"] = nlohmann::json::array();
  for (const Point &point : points) {
    json["failure"].push_back(point.failure);
    json["law_use"].push_back(point.use.ranges);
  }
  return json;
}

/// The way back. \return points that equal the written ones to the last bit
/// \throws nlohmann::json::exception for JSON of another kind
template<class Point>
std::vector<Point> pointsFromJson(const std::vector<Column<Point>> &table,
                                  const nlohmann::json &json)
{
  std::vector<Point> points = pointsFrom(table, json);
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k].failure = json.at("failure").at(k).template get<std::string>();
    json.at("law_use").at(k).get_to(points[k].use.ranges);
  }
  return points;
}

} // namespace wheelrail
#endif
