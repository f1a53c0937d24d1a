// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_COLUMNS_H
#define WHEELRAIL_CREEP_SWEEP_COLUMNS_H

#include "base/unit_groups.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Results as tables: each quantity of a point is one row of a table of columns. Heads, cells and
/// units of CSV files, lists of JSON, journals and the check of the page follow from the table.
namespace wheelrail {

/// How the value of a column is taken from a point, and put back into it.
template<class Point>
struct Access {
  std::function<double(const Point &)> get; ///< SI
  /// Empty where the value follows from others: journals leave it out.
  std::function<void(Point &, double)> set;
  bool whole = false; ///< a whole number
};

/// A value that stands in the point: Kept<&PatchPoint::creepage, &Creepage::xi>. Whole numbers go
/// through a double, which keeps them up to 2^53.
template<auto... Path>
struct Kept {
  template<class Point>
  operator Access<Point>() const // NOLINT(google-explicit-constructor): a row
  {
    using Value = std::decay_t<decltype((std::declval<Point &>().*....*Path))>;
    return {[](const Point &point) { return static_cast<double>((point.*....*Path)); },
            [](Point &point, double value) { (point.*....*Path) = static_cast<Value>(value); },
            std::is_integral_v<Value>};
  }
};
template<auto... Path>
inline constexpr Kept<Path...> kept{};

/// A value that follows from others of the point.
/// \param get function of a point, SI
template<class Point>
Access<Point> derived(double (*get)(const Point &))
{
  return {get, {}, false};
}

/// Whether and how a file has a column.
struct Written {
  int digits = 0;     ///< significant ones; 0: the file does not have it
  bool leads = false; ///< before the columns that do not lead
};
constexpr Written nowhere{};
constexpr int wholeDigits = 17; ///< all that a whole number may have
constexpr Written leading(int digits)
{
  return {digits, true};
}
constexpr Written following(int digits)
{
  return {digits, false};
}

/// One quantity of a point.
template<class Point>
struct Column {
  std::string name;    ///< in heads, JSON and journals
  const char *unit;    ///< as files say it; "1": pure number
  double scale;        ///< that unit in SI
  const char *meaning; ///< as the page says it
  Access<Point> value; ///< SI
  Written creep = {};  ///< in creep.csv
  Written band = {};   ///< in creep_band.csv
  Written still = {};  ///< in static.csv
  Written series = {}; ///< in series.csv
  Written moving = {}; ///< in creep.csv after the others, where the contact moves
  Written stages = {}; ///< in series.csv, where the contact does not roll
  Written wear = {};   ///< in creep.csv after the others, where wear is asked for
};

/// A column of the points that a type is derived from.
template<class Point, class Base>
Column<Point> columnOf(const Column<Base> &c)
{
  return {c.name,   c.unit, c.scale, c.meaning, {c.value.get, c.value.set, c.value.whole},
          c.creep,  c.band, c.still, c.series,  c.moving,
          c.stages, c.wear};
}

/// Appends the columns of a base to a table.
template<class Point, class Base>
void append(std::vector<Column<Point>> &table, const std::vector<Column<Base>> &columns)
{
  for (const Column<Base> &column : columns)
    table.push_back(columnOf<Point>(column));
}

/// A row of a point's own, and the name of the row that it stands behind; "": before all others.
template<class Point>
struct PlacedColumn {
  std::string behind;
  Column<Point> column;
};

/// The table of a base, with the rows that its derived type adds.
/// \throws std::out_of_range for a place that neither table has
template<class Point, class Base>
std::vector<Column<Point>> extended(const std::vector<Column<Base>> &base,
                                    const std::vector<PlacedColumn<Point>> &own)
{
  std::vector<Column<Point>> table;
  append(table, base);
  for (const auto &[behind, column] : own) {
    auto place = table.begin();
    while (!behind.empty() && place != table.end() && place->name != behind)
      ++place;
    if (place == table.end())
      throw std::out_of_range("extended: no column " + behind);
    table.insert(behind.empty() ? place : place + 1, column);
  }
  return table;
}

/// A column as one file has it.
template<class Point>
struct FileColumn {
  Column<Point> column;
  int digits;

  /// In the column's unit.
  double valueOf(const Point &point) const { return column.value.get(point) / column.scale; }
};
template<class Point>
using FileColumns = std::vector<FileColumn<Point>>;

/// The columns of a file, those that lead first, else in the order of the table.
/// \param file &Column<Point>::creep, for example
template<class Point>
FileColumns<Point> columnsOf(const std::vector<Column<Point>> &table, Written Column<Point>::*file)
{
  FileColumns<Point> columns;
  for (const bool leads : {true, false})
    for (const Column<Point> &column : table)
      if ((column.*file).digits > 0 && (column.*file).leads == leads)
        columns.push_back({column, (column.*file).digits});
  return columns;
}

/// Columns by their names, in the order of the names.
/// \param digits significant ones of each
/// \throws std::out_of_range for a name that the table does not have
template<class Point>
FileColumns<Point> columnsNamed(const std::vector<Column<Point>> &table,
                                const std::vector<std::string> &names, int digits)
{
  FileColumns<Point> columns;
  for (const std::string &name : names) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Column<Point> &column) {
      return column.name == name;
    });
    if (found == table.end())
      throw std::out_of_range("columnsNamed: no column " + name);
    columns.push_back({*found, digits});
  }
  return columns;
}

/// The columns of a file with their units.
template<class Point>
std::vector<NamedUnit> namedUnits(const FileColumns<Point> &columns)
{
  std::vector<NamedUnit> units;
  for (const FileColumn<Point> &one : columns)
    units.push_back({one.column.name, one.column.unit});
  return units;
}

/// "speed: m/s; traction: N/mm; others: 1": the units of a file, each with its columns.
template<class Point>
std::string unitsOf(const FileColumns<Point> &columns)
{
  return unitsText(namedUnits(columns));
}

/// "speed,creep\n"
template<class Point>
std::string headOf(const FileColumns<Point> &columns)
{
  std::string text;
  for (const FileColumn<Point> &one : columns)
    text += (text.empty() ? "" : ",") + one.column.name;
  return text + "\n";
}

/// "20,0.001\n"
template<class Point>
std::string rowOf(const FileColumns<Point> &columns, const Point &point)
{
  std::string text;
  for (const FileColumn<Point> &one : columns)
    text += fmt::format("{}{:.{}g}", text.empty() ? "" : ",", one.valueOf(point), one.digits);
  return text + "\n";
}

/// A CSV file: units, head, a row for each point that converged.
template<class Point>
std::string csvOf(const FileColumns<Point> &columns, const std::vector<Point> &points)
{
  std::string text = "# " + unitsOf(columns) + "\n" + headOf(columns);
  for (const Point &point : points)
    if (point.converged())
      text += rowOf(columns, point);
  return text;
}

/// The value of a column for a JSON file: in the column's unit, a whole number as such.
template<class Json, class Point>
Json jsonValue(const FileColumn<Point> &one, const Point &point)
{
  const double value = one.valueOf(point);
  return one.column.value.whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

/// "traction_N_per_mm": name and unit, for a JSON object whose units are said nowhere else.
template<class Point>
std::string keyWithUnit(const Column<Point> &column)
{
  std::string unit = column.unit;
  if (unit == "1")
    return column.name;
  if (const auto slash = unit.find('/'); slash != std::string::npos)
    unit.replace(slash, 1, "_per_");
  return column.name + "_" + unit;
}

/// Points for a journal, to the last bit: the names of the columns, and a list of values for each
/// point; values that follow from others are left out.
template<class Point>
nlohmann::json journalRows(const std::vector<Column<Point>> &table,
                           const std::vector<Point> &points)
{
  nlohmann::json json = {{"columns", nlohmann::json::array()}, {"rows", nlohmann::json::array()}};
  for (const Column<Point> &column : table)
    if (column.value.set)
      json["columns"].push_back(column.name);
  for (const Point &point : points) {
    nlohmann::json row = nlohmann::json::array();
    for (const Column<Point> &column : table)
      if (column.value.set)
        row.push_back(column.value.get(point));
    json["rows"].push_back(row);
  }
  return json;
}

/// The way back: every value goes where its name says.
/// \return points that equal the written ones to the last bit
/// \throws nlohmann::json::exception for JSON of another kind, or where a column is missing
template<class Point>
std::vector<Point> pointsFrom(const std::vector<Column<Point>> &table, const nlohmann::json &json)
{
  std::vector<Point> points(json.at("rows").size());
  const auto names = json.at("columns").get<std::vector<std::string>>();
  for (const Column<Point> &column : table) {
    if (!column.value.set)
      continue;
    // past the end where it is missing: at() below throws
    const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), column.name) -
                                                names.begin());
    for (std::size_t k = 0; k < points.size(); ++k)
      column.value.set(points[k], json.at("rows").at(k).at(place).template get<double>());
  }
  return points;
}

} // namespace wheelrail
#endif
