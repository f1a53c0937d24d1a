// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/friction_table.h"

#include "base/errors.h"
#include "base/number_rows.h"
#include "base/quantity.h"
#include "base/text_lines.h"
#include "shared/nearest_word.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <set>
#include <stdexcept>

namespace wheelrail {

namespace {

enum Column { Pressure, Speed, Mu, Columns };
const std::vector<std::string> columnNames = {"pressure", "speed", "mu"};
constexpr std::array<double, Columns> largest = {1e15, 1e4, 10.0}; // Pa, m/s

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

/// A table while it is read.
class TableFile {
 public:
  explicit TableFile(std::string path) : path_(std::move(path)), rows_(path_)
  {
    const std::string text = readTextFile(path_);
    LineReader lines(text);
    for (std::string_view raw; lines.next(raw);) {
      line_ = lines.number();
      const std::string_view line = trimmedView(raw);
      if (line.empty())
        continue;
      if (line[0] == '#')
        readUnit(line);
      else if (place_.empty())
        readNames(rows_.cells(line_, raw));
      else
        readRow(rows_.cells(line_, raw));
    }
    line_ = 0;
    if (mu_.empty())
      fail("", "holds no row of numbers");
  }

  FrictionTable table() const
  {
    std::set<double> pressures, speeds;
    for (const auto &[pair, mu] : mu_) {
      pressures.insert(pair[Pressure]);
      speeds.insert(pair[Speed]);
    }
    FrictionTable table;
    table.pressure.assign(pressures.begin(), pressures.end());
    table.speed.assign(speeds.begin(), speeds.end());
    table.mu.resize(static_cast<Eigen::Index>(pressures.size()),
                    static_cast<Eigen::Index>(speeds.size()));
    for (std::size_t i = 0; i < table.pressure.size(); ++i)
      for (std::size_t j = 0; j < table.speed.size(); ++j) {
        const auto found = mu_.find({table.pressure[i], table.speed[j]});
        if (found == mu_.end())
          fail("", fmt::format("has no mu at a pressure of {:g} {} and a speed of {:g} {}; every "
                               "pressure needs every speed",
                               table.pressure[i] / factor_[Pressure], unit_[Pressure],
                               table.speed[j] / factor_[Speed], unit_[Speed]));
        table.mu(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = found->second;
      }
    return table;
  }

 private:
  [[noreturn]] void fail(const std::string &keyword, const std::string &problem) const
  {
    throw badInput(path_, line_, keyword, problem);
  }

  /// "# pressure: MPa"; other comments are free text.
  void readUnit(std::string_view line)
  {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos)
      return;
    const std::string word(trimmedView(line.substr(1, colon - 1)));
    if (word != "pressure" && word != "speed")
      return;
    const int column = word == "speed" ? Speed : Pressure;
    if (!mu_.empty() || factor_[column] != 0.0)
      fail(word, "is given once, before the numbers");
    unit_[column] = trimmedView(line.substr(colon + 1));
    try {
      factor_[column] = parseQuantity("1 " + unit_[column], column == Speed ? "m/s" : "Pa");
    } catch (const std::invalid_argument &problem) {
      fail(word, problem.what());
    }
  }

  void readNames(const std::vector<std::string_view> &names)
  {
    for (const std::string_view name : names)
      if (std::find(columnNames.begin(), columnNames.end(), name) == columnNames.end())
        fail("", mcawr::unknownWord("column", std::string(name), columnNames));
    for (const std::string &name : columnNames) {
      if (std::count(names.begin(), names.end(), name) != 1)
        fail("", fmt::format("the column '{}' is needed, once: pressure,speed,mu", name));
      place_.push_back(
          static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
    }
    for (const int column : {Pressure, Speed})
      if (factor_[column] == 0.0)
        fail(columnNames[column],
             fmt::format("no line '# {}: UNIT' before the numbers", columnNames[column]));
  }

  void readRow(const std::vector<std::string_view> &cells)
  {
    if (cells.size() != Columns)
      fail("", fmt::format("{} cells; {} are expected{}", cells.size(), int(Columns),
                           rows_.decimalHint()));
    std::array<double, Columns> row{};
    for (int column = 0; column < Columns; ++column) {
      row[column] = rows_.number(line_, columnNames[column], cells[place_[column]]);
      row[column] *= column == Mu ? 1.0 : factor_[column];
      const bool low = column == Mu ? !(row[column] > 0.0) : row[column] < 0.0;
      if (low || row[column] > largest[column])
        fail(columnNames[column],
             fmt::format("'{}' is not allowed, must be {} and at most {:g}{}",
                         cells[place_[column]], column == Mu ? "> 0" : ">= 0", largest[column],
                         column == Mu      ? ""
                         : column == Speed ? " m/s"
                                           : " Pa"));
    }
    if (!mu_.insert({{row[Pressure], row[Speed]}, row[Mu]}).second)
      fail("", "this pressure and speed stand twice");
  }

  std::string path_;
  NumberRows rows_;
  int line_ = 0;
  std::array<double, 2> factor_ = {0.0, 0.0}; ///< SI units per unit of the file
  std::array<std::string, 2> unit_;
  std::vector<std::size_t> place_; ///< of each column in a row; empty: no line of names yet
  std::map<std::array<double, 2>, double> mu_; ///< by pressure and speed
};

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
  return TableFile(path).table();
}

} // namespace wheelrail
