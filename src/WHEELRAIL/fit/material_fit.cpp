// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/material_fit.h"

#include "base/errors.h"
#include "base/si.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace wheelrail {

namespace {

/// Pressures of plans are rounded: p/sigma_0 and temperatures that agree so far are one place.
constexpr double samePlace = 0.01;

/// One value of the table, and where it comes from.
struct Place {
  double temperature, ratio, speed;
  double mu, error;
  const FrictionRun *run;
};

bool close(double x, double y)
{
  return std::abs(x - y) <= samePlace * y;
}

bool besideEachOther(const Place &one, const Place &other)
{
  return one.temperature == other.temperature && close(one.ratio, other.ratio);
}

/// Temperatures that are close become the lowest of them: a table has one row for them.
void mergeTemperatures(std::vector<Place> &places)
{
  std::sort(places.begin(), places.end(),
            [](const Place &p, const Place &q) { return p.temperature < q.temperature; });
  for (std::size_t i = 1; i < places.size(); ++i)
    if (close(places[i].temperature, places[i - 1].temperature))
      places[i].temperature = places[i - 1].temperature;
}

std::vector<Place> placesOf(const std::vector<FitCondition> &conditions,
                            const std::vector<FrictionRun> &runs)
{
  std::vector<Place> places;
  for (const FitCondition &condition : conditions) {
    const FrictionRun &run = runs[condition.runs.front()];
    places.push_back({run.temperature, condition.mean.kappa2 / condition.mean.kappa3,
                      std::abs(run.head.velocity), condition.mean.mu, condition.mean.muSe, &run});
  }
  mergeTemperatures(places);
  std::sort(places.begin(), places.end(), [](const Place &p, const Place &q) {
    return p.temperature < q.temperature || (p.temperature == q.temperature && p.ratio < q.ratio);
  });
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (besideEachOther(places[i], places[j]) && close(places[i].speed, places[j].speed))
        throw Error(ExitCode::NotConverged,
                    fmt::format("two conditions of p/sigma_0 {:.3g}, {:g} K and {:g} m/s, such as "
                                "{} and {}: a table has one",
                                places[i].ratio, places[i].temperature, places[i].speed,
                                places[j].run->file, places[i].run->file));
  return places;
}

/// The speed of most places; of equally many the largest.
double commonSpeed(const std::vector<Place> &places)
{
  std::map<double, int> count;
  for (const Place &place : places)
    ++count[place.speed];
  return std::max_element(count.begin(), count.end(),
                          [](const auto &p, const auto &q) {
                            return p.second <= q.second &&
                                   (p.second < q.second || p.first < q.first);
                          })
      ->first;
}

/// The slope of straight lines that share it, each with a level of its own: weighted least squares.
class CommonSlope {
 public:
  /// The points of one line: x, y and the variance of y.
  void addLine(const std::vector<std::array<double, 3>> &points)
  {
    double sum = 0.0, x = 0.0, y = 0.0;
    for (const auto &point : points) {
      sum += weight(point);
      x += weight(point) * point[0];
      y += weight(point) * point[1];
    }
    for (const auto &point : points) {
      const double dx = point[0] - x / sum, dy = point[1] - y / sum;
      xx_ += weight(point) * dx * dx;
      xy_ += weight(point) * dx * dy;
      yy_ += weight(point) * dy * dy;
    }
    freedom_ += static_cast<int>(points.size()) - 1;
  }
  double slope() const { return xy_ / xx_; }
  /// Larger where the points are further from the lines than their errors.
  double slopeSe() const
  {
    const double rest = std::max(0.0, yy_ - xy_ * xy_ / xx_);
    return std::sqrt((freedom_ > 0 ? std::max(1.0, rest / freedom_) : 1.0) / xx_);
  }

 private:
  static double weight(const std::array<double, 3> &point)
  {
    return point[2] > 0.0 ? 1.0 / point[2] : 1.0;
  }
  double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
  int freedom_ = -1;
};

/// ln mu against ln of the speed: at each p/sigma_0 a slope, whatever the temperature.
void fitSpeed(MuTable &table, const std::vector<Place> &places)
{
  std::map<double, CommonSlope> slopes; // by p/sigma_0
  for (const Place &place : places)
    if (place.speed == 0.0)
      throw Error(ExitCode::NotConverged,
                  fmt::format("{}: does not slide, 0 m/s: a table cannot hold it, its values go "
                              "with a power of the speed",
                              place.run->file));
  const auto isCommon = [&](const Place &place) {
    return close(place.speed, table.speed.reference);
  };
  for (const Place &place : places) {
    if (!isCommon(place)) {
      Range &range = table.speed.range;
      range = {std::min(range[0], place.speed), std::max(range[1], place.speed)};
      if (std::none_of(places.begin(), places.end(), [&](const Place &other) {
            return besideEachOther(place, other) && isCommon(other);
          }))
        throw Error(ExitCode::NotConverged,
                    fmt::format("{}: no condition of {:g} m/s has its pressure and temperature: a "
                                "table cannot hold it",
                                place.run->file, table.speed.reference));
      continue;
    }
    std::vector<std::array<double, 3>> line;
    for (const Place &other : places)
      if (besideEachOther(place, other))
        line.push_back({std::log(other.speed / table.speed.reference), std::log(other.mu),
                        std::pow(other.error / other.mu, 2)});
    if (line.size() < 2)
      continue;
    const auto known = std::find_if(slopes.begin(), slopes.end(), [&](const auto &slope) {
      return close(place.ratio, slope.first);
    });
    (known == slopes.end() ? slopes[place.ratio] : known->second).addLine(line);
  }
  for (const auto &[ratio, slope] : slopes) {
    table.speed.ratio.push_back(ratio);
    table.speed.exponent.push_back(slope.slope());
    table.speed.exponentSe.push_back(slope.slopeSe());
  }
}

} // namespace

void placeInMaterial(std::vector<FrictionRun> &runs, const SofteningMaterial &material)
{
  for (FrictionRun &run : runs) {
    run.temperature = material.temperatureOf(run.head.strength * MPa, run.youngsModulus() * MPa);
    if (!std::isfinite(run.temperature))
      throw badInput(run.file, 0, "material",
                     fmt::format("strength {:g} and youngs_modulus {:g} MPa are those of {} at no "
                                 "temperature",
                                 run.head.strength, run.youngsModulus(), material.name));
  }
}

MuTable tableOf(const std::vector<FitCondition> &conditions, const std::vector<FrictionRun> &runs)
{
  const std::vector<Place> places = placesOf(conditions, runs);
  MuTable table;
  table.speed.reference = commonSpeed(places);
  table.speed.range = {table.speed.reference, table.speed.reference};
  for (const Place &place : places) {
    if (!close(place.speed, table.speed.reference))
      continue;
    if (table.rows.empty() || place.temperature != table.rows.back().temperature)
      table.rows.push_back({place.temperature, {}, {}, {}});
    MuTable::Row &row = table.rows.back();
    row.ratio.push_back(place.ratio);
    row.mu.push_back(place.mu);
    row.muSe.push_back(place.error);
  }
  fitSpeed(table, places);
  return table;
}

} // namespace wheelrail
