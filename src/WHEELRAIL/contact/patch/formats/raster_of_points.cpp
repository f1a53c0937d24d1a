// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/formats/raster_of_points.h"

#include "base/errors.h"
#include "base/si.h"
#include "contact/patch/formats/map_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {

namespace {

constexpr double same = 1e-2; ///< of a distance: places that close are one

/// Places along one direction: the first, how many, how far from each other.
struct Line {
  double first = 0.0, spacing = 0.0;
  long count = 0;

  /// Nearest place. \return -1 where a value is not at one
  long placeOf(double value) const
  {
    const double place = (value - first) / spacing, nearest = std::round(place);
    return std::abs(place - nearest) <= same ? static_cast<long>(nearest) : -1;
  }
};

/// The distance is that of neighbours; what is nearer than a hundredth of the mean distance of as
/// many places as there are points along a side is rounding.
Line lineOf(const std::string &path, const char *name, std::vector<double> values)
{
  const double side = std::sqrt(double(values.size()));
  std::sort(values.begin(), values.end());
  const double range = values.back() - values.front(), least = same * range / side;
  Line line{values.front(), std::numeric_limits<double>::infinity(), 1};
  for (std::size_t k = 1; k < values.size(); ++k)
    if (const double gap = values[k] - values[k - 1]; gap > least)
      line.spacing = std::min(line.spacing, gap);
  if (!std::isfinite(line.spacing))
    throw badInput(path, 0, name, "all points have one value; a map has two directions");
  const double steps = std::round(range / line.spacing);
  if (steps > double(mostMapPoints))
    throw badInput(path, 0, name,
                   fmt::format("{:g} places; at most {} are allowed", steps, mostMapPoints));
  line.count = static_cast<long>(steps) + 1;
  line.spacing = range / steps; // of all of them, not of the nearest two
  return line;
}

} // namespace

HeightMap rasterOfPoints(const std::string &path, const std::vector<double> &points)
{
  std::vector<double> along[2];
  for (std::size_t k = 0; k + 2 < points.size(); k += 3)
    for (int axis : {0, 1})
      along[axis].push_back(points[k + axis]);
  if (along[0].empty())
    throw badInput(path, 0, "", "no points");
  const Line x = lineOf(path, "x", std::move(along[0])), y = lineOf(path, "y", std::move(along[1]));
  checkMapSize(path, 0, "x, y", x.count, y.count);
  if (2 * points.size() / 3 < static_cast<std::size_t>(x.count * y.count))
    throw badInput(
        path, 0, "x, y",
        fmt::format("{} points for {} x {} places, {:.6g} x {:.6g} um apart: they are not "
                    "on a raster; interpolate them onto one first",
                    points.size() / 3, x.count, y.count, x.spacing / um, y.spacing / um));
  HeightMap map{
      static_cast<int>(x.count), static_cast<int>(y.count), x.spacing, y.spacing,
      Eigen::VectorXd::Constant(x.count * y.count, std::numeric_limits<double>::quiet_NaN())};
  std::vector<char> taken(static_cast<std::size_t>(x.count * y.count), 0);
  for (std::size_t k = 0; k + 2 < points.size(); k += 3) {
    const long ix = x.placeOf(points[k]), iy = y.placeOf(points[k + 1]);
    if (ix < 0 || iy < 0)
      throw badInput(path, 0, "x, y",
                     fmt::format("point {} at ({:.6g}, {:.6g}) um is not on a raster of {:.6g} x "
                                 "{:.6g} um; interpolate the points onto one first",
                                 k / 3 + 1, points[k] / um, points[k + 1] / um, x.spacing / um,
                                 y.spacing / um));
    const std::size_t at = static_cast<std::size_t>(ix + x.count * iy);
    if (taken[at]++)
      throw badInput(
          path, 0, "x, y",
          fmt::format("two points at ({:.6g}, {:.6g}) um", points[k] / um, points[k + 1] / um));
    map.height[static_cast<Eigen::Index>(at)] = points[k + 2];
  }
  return map;
}

} // namespace wheelrail
