// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/number_rows.h"
#include "base/text_lines.h"
#include "contact/patch/formats/height_map_formats.h"
#include "contact/patch/formats/map_text.h"
#include "contact/patch/formats/raster_of_points.h"

#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace wheelrail {

namespace {

struct MatrixHead {
  double heightUnit = 0.0, spacingX = 0.0, spacingY = 0.0; // m
  double width = 0.0, depth = 0.0;                         // m, of all columns and all rows
  double positionUnit = 0.0;   ///< m: the rows are x, y, height of one point each; 0: a matrix
  bool rowsUpwards = false;    ///< as a picture is written, from its top
  long columns = 0, rows = 0;  ///< stated; 0: not
  std::set<std::string> given; ///< keywords so far
};

/// "1,0 mm" is one number; in "1 mm, 2 mm" a unit stands before the comma.
void refuseDecimalComma(const std::string &path, int number, const std::string &keyword,
                        const std::string &value)
{
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto comma = value.find(',');
  if (comma != std::string::npos && comma > 0 && comma + 1 < value.size() &&
      isDigit(value[comma - 1]) && isDigit(value[comma + 1]))
    throw badInput(path, number, keyword,
                   fmt::format("'{}' has a decimal comma; a point is expected in the head", value));
}

/// "# keyword: value"; other comments are free text. Width, Height and Value units are those of
/// Gwyddion's export of text with a header.
void readHeadLine(const std::string &path, int number, std::string_view line, MatrixHead &head)
{
  const auto colon = line.find(':');
  if (colon == std::string_view::npos)
    return;
  const std::string keyword(trimmedView(line.substr(1, colon - 1)));
  const std::string value(trimmedView(line.substr(colon + 1)));
  for (const char *known :
       {"height", "spacing", "points", "rows", "position", "Width", "Height", "Value units"})
    if (keyword == known && !head.given.insert(keyword).second)
      throw badInput(path, number, keyword, "appears twice in the head");
  if (keyword == "spacing" || keyword == "Width" || keyword == "Height")
    refuseDecimalComma(path, number, keyword, value);
  if (keyword == "height" || keyword == "Value units")
    head.heightUnit = positiveLength(path, number, keyword, "1 " + value);
  if (keyword == "position")
    head.positionUnit = positiveLength(path, number, keyword, "1 " + value);
  if (keyword == "Width")
    head.width = positiveLength(path, number, keyword, value);
  if (keyword == "Height")
    head.depth = positiveLength(path, number, keyword, value);
  if (keyword == "spacing") {
    const auto comma = value.find(',');
    head.spacingX = positiveLength(path, number, keyword, value.substr(0, comma));
    head.spacingY = comma == std::string::npos
                        ? head.spacingX
                        : positiveLength(path, number, keyword, value.substr(comma + 1));
  }
  if (keyword == "points") {
    const auto comma = value.find(',');
    if (comma == std::string::npos)
      throw badInput(path, number, keyword,
                     fmt::format("'{}' must be two whole numbers, along x and y", value));
    const std::string_view columns = trimmedView(std::string_view(value).substr(0, comma));
    const std::string_view rows = trimmedView(std::string_view(value).substr(comma + 1));
    head.columns = wholeNumber(path, number, keyword, std::string(columns));
    head.rows = wholeNumber(path, number, keyword, std::string(rows));
    checkMapSize(path, number, keyword, head.columns, head.rows);
  }
  if (keyword == "rows") {
    if (value != "upwards" && value != "downwards")
      throw badInput(path, number, keyword,
                     fmt::format("'{}'; upwards and downwards are allowed", value));
    head.rowsUpwards = value == "upwards";
  }
}

void checkHead(const std::string &path, int number, const MatrixHead &head)
{
  if (head.heightUnit == 0.0)
    throw badInput(path, number, "height", "no line '# height: UNIT' before the numbers");
  if (head.positionUnit > 0.0)
    return;
  if (head.spacingX == 0.0 && !(head.width > 0.0 && head.depth > 0.0))
    throw badInput(path, number, "spacing", "no line '# spacing: NUMBER UNIT' before the numbers");
}

/// Rows of x, y and height; nan is a height only.
HeightMap pointsMap(const std::string &path, const MatrixHead &head, long columns, long rows,
                    std::vector<double> values)
{
  if (columns != 3)
    throw badInput(path, 0, "position",
                   fmt::format("{} columns; x, y and height are expected", columns));
  for (long k = 0; k < rows; ++k) {
    for (int axis : {0, 1}) {
      double &place = values[3 * k + axis];
      if (std::isnan(place))
        throw badInput(path, 0, "position", fmt::format("point {} has no place", k + 1));
      place *= head.positionUnit;
    }
    values[3 * k + 2] *= head.heightUnit;
  }
  return rasterOfPoints(path, values);
}

} // namespace

HeightMap parseMatrix(const std::string &path, const std::string &bytes, const HeightMapScale &)
{
  const std::string text = plainTextOf(path, bytes);
  LineReader lines(text);
  NumberRows row(path);
  MatrixHead head;
  std::vector<double> heights;
  long columns = 0, rows = 0;
  std::string_view raw;
  while (lines.next(raw)) {
    const std::string_view line = trimmedView(raw);
    if (line.empty())
      continue;
    if (line.front() == '#') {
      if (rows > 0)
        throw badInput(path, lines.number(), "", "the head must stand before the numbers");
      readHeadLine(path, lines.number(), line, head);
      continue;
    }
    const long found = row.append(lines.number(), raw, true, heights);
    if (rows == 0) {
      columns = found;
      checkHead(path, lines.number(), head);
    }
    if (found != columns)
      throw badInput(
          path, lines.number(), "",
          fmt::format("{} columns; the first row has {}{}", found, columns, row.decimalHint()));
    ++rows;
    if (rows * columns > mostMapPoints)
      checkMapSize(path, lines.number(), "", columns, rows);
  }
  if (rows == 0)
    checkHead(path, 0, head);
  if (head.positionUnit > 0.0)
    return pointsMap(path, head, columns, rows, std::move(heights));
  if (head.columns > 0 && (columns != head.columns || rows != head.rows))
    throw badInput(path, 0, "points",
                   fmt::format("{} x {} heights; the head states {} x {}{}", columns, rows,
                               head.columns, head.rows, row.decimalHint()));
  checkMapSize(path, 0, "", columns, rows);
  const double dx = head.spacingX > 0.0 ? head.spacingX : head.width / double(columns);
  const double dy = head.spacingX > 0.0 ? head.spacingY : head.depth / double(rows);
  HeightMap map{static_cast<int>(columns), static_cast<int>(rows), dx, dy,
                Eigen::Map<const Eigen::VectorXd>(heights.data(), columns * rows) *
                    head.heightUnit};
  return head.rowsUpwards ? map : mirrored(map);
}

} // namespace wheelrail
