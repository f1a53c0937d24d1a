// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/program_files.h"
#include "base/quantity.h"
#include "creep/line/curve_journal.h"
#include "creep/line/static_contact.h"
#include "creep/patch/moving_patch.h"
#include "creep/patch/patch_journal.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

using namespace wheelrail;

namespace {

/// The files that have a column, as the page says it; empty: none.
template<class Point>
std::string filesOf(const Column<Point> &column)
{
  using C = Column<Point>;
  const std::pair<Written C::*, const char *> files[] = {{&C::creep, "creep.csv"},
                                                         {&C::band, "creep_band.csv"},
                                                         {&C::still, "static.csv"},
                                                         {&C::series, "series.csv"},
                                                         {&C::moving, "creep.csv of mode moving"},
                                                         {&C::wear, "creep.csv with wear.law"}};
  std::string text;
  for (const auto &[file, name] : files)
    if ((column.*file).digits > 0)
      text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

/// The rows of the page for a table of columns.
template<class Point>
std::string pageRows(const std::vector<Column<Point>> &table)
{
  std::string text;
  for (const Column<Point> &column : table)
    if (const std::string files = filesOf(column); !files.empty())
      text +=
          fmt::format("| `{}` | {} | {} | {} |\n", column.name,
                      column.unit == std::string("1") ? "" : column.unit, column.meaning, files);
  return text;
}

template<class Point>
void expectNamesOnce(const std::vector<Column<Point>> &table)
{
  std::set<std::string> names;
  for (const Column<Point> &column : table)
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
}

/// A point whose values all differ.
template<class Point>
Point numbered(const std::vector<Column<Point>> &table)
{
  Point point;
  double value = 1.0;
  for (const Column<Point> &column : table)
    if (column.value.set)
      column.value.set(point, value++);
  point.failure = "why";
  point.use.ranges = {{1.0, 2.0}, {3.0, 4.0}};
  return point;
}

/// Every value, by its own getter.
template<class Point>
std::vector<double> valuesOf(const std::vector<Column<Point>> &table, const Point &point)
{
  std::vector<double> values;
  for (const Column<Point> &column : table)
    values.push_back(column.value.get(point));
  return values;
}

/// The journal's columns the other way round: values go by name.
nlohmann::json turnedAround(nlohmann::json json)
{
  std::reverse(json["columns"].begin(), json["columns"].end());
  for (auto &row : json["rows"])
    std::reverse(row.begin(), row.end());
  return json;
}

} // namespace

TEST(ResultColumns, standOnThePage)
{
  const std::string page = readInputFile(std::string(PROJECT_SOURCE) + "/doc/wr_creep.md");
  std::string table = "| column | unit | meaning | where |\n|---|---|---|---|\n";
  for (const std::string &rows :
       {pageRows(curveColumns()), pageRows(staticColumns()), pageRows(patchColumns()),
        pageRows(
            std::vector<Column<PatchStep>>(seriesColumns().begin(), seriesColumns().begin() + 3))})
    EXPECT_NE(page.find(table + rows + "\n"), std::string::npos) << table << rows;
}

TEST(ResultColumns, haveNamesOfTheirOwn)
{
  expectNamesOnce(curveColumns());
  expectNamesOnce(staticColumns());
  expectNamesOnce(patchColumns());
  expectNamesOnce(seriesColumns());
}

TEST(ResultColumns, goThroughAJournalByName)
{
  const CurvePoint line = numbered(curveColumns());
  const PatchPoint patch = numbered(patchColumns());
  const nlohmann::json lines = turnedAround(curvePointsJson({line}));
  const nlohmann::json patches = turnedAround(patchPointsJson({patch}));
  EXPECT_EQ(valuesOf(curveColumns(), curvePointsFrom(lines).front()),
            valuesOf(curveColumns(), line));
  EXPECT_EQ(valuesOf(patchColumns(), patchPointsFrom(patches).front()),
            valuesOf(patchColumns(), patch));
  EXPECT_EQ(curvePointsFrom(lines).front().failure, "why");
  EXPECT_EQ(patchPointsFrom(patches).front().use.ranges.back(), (Range{3.0, 4.0}));
}

TEST(ResultColumns, ofAJournalThatLacksOneAreRefused)
{
  nlohmann::json json = curvePointsJson({CurvePoint()});
  json["columns"][0] = "another";
  EXPECT_THROW(curvePointsFrom(json), nlohmann::json::exception);
}

TEST(ResultColumns, sayTheirUnits)
{
  const auto columns = columnsOf(staticColumns(), &Column<StaticPoint>::still);
  EXPECT_EQ(unitsOf(columns), "traction: N/mm; stick_length, stick_centre: mm; others: 1");
  StaticPoint point;
  point.forceRatio = 0.5;
  point.traction = 2e6;
  point.stickLength = 0.0015;
  EXPECT_EQ(rowOf(columns, point), "0.5,0,2000,0,1.5,0\n");
}

namespace {

/// A value in the column's unit is `scale` times as many SI units.
template<class Point>
void expectSiUnits(const std::vector<Column<Point>> &table)
{
  for (const Column<Point> &column : table) {
    const std::string si = siUnit(column.unit);
    if (si == "1")
      EXPECT_EQ(column.scale, 1.0) << column.name;
    else
      EXPECT_NEAR(parseQuantity(fmt::format("1 {}", column.unit), si) / column.scale, 1.0, 1e-12)
          << column.name;
  }
}

} // namespace

TEST(ResultColumns, SiUnitsAreThoseOfTheirScales)
{
  expectSiUnits(patchColumns());
  expectSiUnits(seriesColumns());
  expectSiUnits(curveColumns());
  expectSiUnits(staticColumns());
  EXPECT_EQ(siUnit("N mm"), "N m");
  EXPECT_EQ(siUnit("1/mm"), "1/m");
  EXPECT_EQ(siUnit("m"), "m");
  EXPECT_EQ(siUnit("m/s"), "m/s");
}
