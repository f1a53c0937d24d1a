// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_journal.h"

#include <cstring>
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
  for (auto *band : {&p.bands.tractionRatio, &p.bands.x, &p.bands.y, &p.bands.momentZ}) {
    visit(band->standardError);
    visit(band->low);
    visit(band->high);
  }
}

template<class Step, class Visit>
void eachNumberOfStep(Step &s, const Visit &visit)
{
  for (auto *value :
       {&s.distance, &s.load, &s.creepage.xi, &s.creepage.eta, &s.creepage.phi, &s.forceX,
        &s.forceY, &s.momentZ, &s.muMean, &s.temperatureRise, &s.stickFraction, &s.approach,
        &s.peakPressure, &s.realArea, &s.frictionalPower, &s.drivingPower})
    visit(*value);
}

/// All fields of a point in a fixed order but for its states; each has one value a cell.
template<class Fields, class Visit>
void eachField(Fields &f, const Visit &visit)
{
  for (auto *field : {&f.gap, &f.pressure, &f.traction.x, &f.traction.y, &f.slip.x, &f.slip.y,
                      &f.mu, &f.temperature})
    visit(*field);
}

constexpr std::size_t fieldsOfPoint = 8;

} // namespace

Json patchPointsJson(const std::vector<PatchPoint> &points)
{
  Json rows = Json::array();
  for (const PatchPoint &point : points) {
    Json row = {point.surface, point.iterations, point.products, point.failure, point.use.ranges};
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
    point.failure = row.at(3);
    point.use.ranges = row.at(4);
    std::size_t k = 5;
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

std::string patchFieldsBytes(const PatchFields &fields)
{
  std::string bytes;
  for (PatchState state : fields.state)
    bytes.push_back(static_cast<char>(state));
  eachField(fields, [&](const Eigen::VectorXd &field) {
    const std::size_t begin = bytes.size(), size = sizeof(double) * field.size();
    bytes.resize(begin + size);
    std::memcpy(&bytes[begin], field.data(), size);
  });
  return bytes;
}

std::optional<PatchFields> patchFieldsFrom(const std::string &bytes, int cells)
{
  const auto count = static_cast<std::size_t>(cells);
  if (bytes.size() != count * (1 + fieldsOfPoint * sizeof(double)))
    return std::nullopt;
  PatchFields fields;
  for (std::size_t k = 0; k < count; ++k)
    fields.state.push_back(static_cast<PatchState>(bytes[k]));
  std::size_t begin = count;
  eachField(fields, [&](Eigen::VectorXd &field) {
    field.resize(cells);
    std::memcpy(field.data(), &bytes[begin], count * sizeof(double));
    begin += count * sizeof(double);
  });
  return fields;
}

} // namespace wheelrail
