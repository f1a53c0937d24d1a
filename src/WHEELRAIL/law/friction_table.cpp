// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/friction_table.h"

#include "base/column_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <utility>

namespace wheelrail {

namespace {

enum Column { Pressure, Speed, Mu };

/// The share of the way from one grid point to the next, and the first of the two.
struct Place {
  std::size_t first, next;
  double share;
};
Place placeIn(const std::vector<double> &grid, double x)
{
  if (!(x > grid.front()))
    return {0, 0, 0.0};
  if (x >= grid.back())
    return {grid.size() - 1, grid.size() - 1, 0.0};
  const auto next =
      static_cast<std::size_t>(std::upper_bound(grid.begin(), grid.end(), x) - grid.begin());
  return {next - 1, next, (x - grid[next - 1]) / (grid[next] - grid[next - 1])};
}

} // namespace

double FrictionTable::operator()(double p, double v) const
{
  const Place i = placeIn(pressure, p), j = placeIn(speed, v);
  const auto at = [&](std::size_t row, std::size_t column) {
    return mu(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
  };
  const double low = at(i.first, j.first) + j.share * (at(i.first, j.next) - at(i.first, j.first));
  const double high = at(i.next, j.first) + j.share * (at(i.next, j.next) - at(i.next, j.first));
  return low + i.share * (high - low);
}

FrictionTable readFrictionTable(const std::string &path)
{
  const ColumnFile file(path, {{"pressure", "Pa", true, true, 1e15},
                               {"speed", "m/s", true, true, 1e4},
                               {"mu", "", false, false, 10.0}});
  std::set<double> pressures, speeds;
  std::map<std::pair<double, double>, double> mu; // by pressure and speed
  for (const auto &[line, values] : file.rows) {
    pressures.insert(values[Pressure]);
    speeds.insert(values[Speed]);
    if (!mu.insert({{values[Pressure], values[Speed]}, values[Mu]}).second)
      file.fail(line, "", "this pressure and speed stand twice");
  }
  FrictionTable table;
  table.pressure.assign(pressures.begin(), pressures.end());
  table.speed.assign(speeds.begin(), speeds.end());
  table.mu.resize(static_cast<Eigen::Index>(pressures.size()),
                  static_cast<Eigen::Index>(speeds.size()));
  for (std::size_t i = 0; i < table.pressure.size(); ++i)
    for (std::size_t j = 0; j < table.speed.size(); ++j) {
      const auto found = mu.find({table.pressure[i], table.speed[j]});
      if (found == mu.end())
        file.fail(0, "",
                  fmt::format("has no mu at a pressure of {} and a speed of {}; every pressure "
                              "needs every speed",
                              file.asWritten(Pressure, table.pressure[i]),
                              file.asWritten(Speed, table.speed[j])));
      table.mu(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = found->second;
    }
  return table;
}

} // namespace wheelrail
