// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_journal.h"

#include <initializer_list>

namespace wheelrail {
namespace {

using Json = nlohmann::json;

/// Every number of a point, in a fixed order: written and read through the same list.
template<class Point, class Visit>
void eachNumber(Point &p, const Visit &visit)
{
  for (auto *value : {&p.load,
                      &p.speed,
                      &p.creepage.xi,
                      &p.creepage.eta,
                      &p.creepage.phi,
                      &p.forceX,
                      &p.forceY,
                      &p.momentZ,
                      &p.muMean,
                      &p.temperatureRise,
                      &p.temperatureMaximum,
                      &p.stickFraction,
                      &p.approach,
                      &p.peakPressure,
                      &p.realArea,
                      &p.frictionalPower,
                      &p.powerClosure,
                      &p.errorX,
                      &p.errorY,
                      &p.errorZ})
    visit(*value);
}

template<class Step, class Visit>
void eachNumberOfStep(Step &s, const Visit &visit)
{
  for (auto *value :
       {&s.distance, &s.load, &s.creepage.xi, &s.creepage.eta, &s.creepage.phi, &s.forceX,
        &s.forceY, &s.momentZ, &s.muMean, &s.temperatureRise, &s.stickFraction, &s.approach,
        &s.peakPressure, &s.realArea, &s.frictionalPower})
    visit(*value);
}

} // namespace

Json patchPointsJson(const std::vector<PatchPoint> &points)
{
  Json rows = Json::array();
  for (const PatchPoint &point : points) {
    Json row = {point.surface, point.iterations, point.products};
    eachNumber(point, [&](double value) { row.push_back(value); });
    rows.push_back(row);
  }
  return rows;
}

std::vector<PatchPoint> patchPointsFrom(const Json &rows)
{
  std::vector<PatchPoint> points;
  for (const Json &row : rows) {
    PatchPoint point;
    point.surface = row.at(0);
    point.iterations = row.at(1);
    point.products = row.at(2);
    std::size_t k = 3;
    eachNumber(point, [&](double &value) { value = row.at(k++); });
    points.push_back(point);
  }
  return points;
}

Json patchSeriesJson(const std::map<int, std::vector<PatchStep>> &series)
{
  Json all = Json::object();
  for (const auto &[number, steps] : series) {
    Json rows = Json::array();
    for (const PatchStep &step : steps) {
      Json row = Json::array();
      eachNumberOfStep(step, [&](double value) { row.push_back(value); });
      rows.push_back(row);
    }
    all[std::to_string(number)] = rows;
  }
  return all;
}

std::map<int, std::vector<PatchStep>> patchSeriesFrom(const Json &series)
{
  std::map<int, std::vector<PatchStep>> all;
  for (const auto &[number, rows] : series.items())
    for (const Json &row : rows) {
      PatchStep step;
      std::size_t k = 0;
      eachNumberOfStep(step, [&](double &value) { value = row.at(k++); });
      all[std::stoi(number)].push_back(step);
    }
  return all;
}

} // namespace wheelrail
