// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/surfaces/height_map_steps.h"

#include "base/errors.h"
#include "base/si.h"
#include "shared/pi.h"

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {

namespace {

using Vector = Eigen::VectorXd;
/// Column iy holds the points along x at one y.
using Raster = Eigen::MatrixXd;

using mcawr::pi;

Eigen::Map<const Raster> rasterOf(const HeightMap &map)
{
  return {map.height.data(), map.nx, map.ny};
}

HeightMap withHeights(const HeightMap &map, const Raster &heights)
{
  HeightMap result = map;
  result.height = Eigen::Map<const Vector>(heights.data(), heights.size());
  return result;
}

[[noreturn]] void refuse(const std::string &problem)
{
  throw Error(ExitCode::BadInput, "height map: " + problem);
}

void needAllMeasured(const HeightMap &map, const char *what)
{
  if (const int holes = map.unmeasured())
    refuse(fmt::format("{} of {} points are not measured; {} needs all, fill them first", holes,
                       map.height.size(), what));
}

/// Mean square of the differences between neighbours, over those that were both measured.
double meanSquareDifference(const Raster &first, const Raster &second)
{
  double sum = 0.0;
  long count = 0;
  for (Eigen::Index k = 0; k < first.size(); ++k) {
    const double difference = second.data()[k] - first.data()[k];
    if (std::isnan(difference))
      continue;
    sum += difference * difference;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

} // namespace

HeightMapStatistics heightMapStatistics(const std::string &step, const HeightMap &map,
                                        double cutoff)
{
  HeightMapStatistics result;
  result.step = step;
  result.unmeasured = map.unmeasured();
  const auto z = rasterOf(map);
  const auto measured = static_cast<double>(z.size() - result.unmeasured);
  double sum = 0.0;
  for (const double h : map.height)
    sum += std::isnan(h) ? 0.0 : h;
  const double mean = measured > 0.0 ? sum / measured : 0.0;
  double squares = 0.0;
  for (const double h : map.height)
    squares += std::isnan(h) ? 0.0 : (h - mean) * (h - mean);
  result.rmsHeight = measured > 0.0 ? std::sqrt(squares / measured) : 0.0;
  result.rmsSlopeX =
      std::sqrt(meanSquareDifference(z.topRows(map.nx - 1), z.bottomRows(map.nx - 1))) / map.dx;
  result.rmsSlopeY =
      std::sqrt(meanSquareDifference(z.leftCols(map.ny - 1), z.rightCols(map.ny - 1))) / map.dy;
  result.shortestWavelength = std::max(cutoff, 2.0 * std::max(map.dx, map.dy));
  return result;
}

HeightMap turned(const HeightMap &map)
{
  HeightMap result{map.ny, map.nx, map.dy, map.dx, Vector(map.height.size())};
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix) // (x, y) -> (-y, x)
      result.height[result.index(map.ny - 1 - iy, ix)] = map.height[map.index(ix, iy)];
  return result;
}

namespace {

constexpr int mostTerms = 6;
using Terms = Eigen::Matrix<double, mostTerms, 1>;

int termsOf(Form form)
{
  switch (form) {
  case Form::None:
    return 0;
  case Form::Mean:
    return 1;
  case Form::Plane:
    return 3;
  case Form::SecondOrder:
    break;
  }
  return mostTerms;
}

/// Legendre's polynomials on the map, orthogonal where every point was measured.
Terms termsAt(const HeightMap &map, int ix, int iy)
{
  const double u = 2.0 * ix / (map.nx - 1) - 1.0, v = 2.0 * iy / (map.ny - 1) - 1.0;
  Terms terms;
  terms << 1.0, u, v, 1.5 * u * u - 0.5, u * v, 1.5 * v * v - 0.5;
  return terms;
}

} // namespace

HeightMap withoutForm(const HeightMap &map, Form form)
{
  const int n = termsOf(form);
  if (n == 0)
    return map;
  // Normal equations: with Legendre's polynomials they are nearly diagonal unless large parts are
  // not measured, and the pivots tell where the measured points do not determine the form.
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Vector right = Vector::Zero(n);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix) {
      const double h = map.height[map.index(ix, iy)];
      if (std::isnan(h))
        continue;
      const Vector terms = termsAt(map, ix, iy).head(n);
      normal.noalias() += terms * terms.transpose();
      right += h * terms;
    }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(normal);
  solver.setThreshold(1e-10); // of the largest pivot
  if (solver.rank() < n)
    refuse(fmt::format("{} measured points do not determine a form of {} terms",
                       map.height.size() - map.unmeasured(), n));
  const Vector c = solver.solve(right);
  HeightMap result = map;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      result.height[map.index(ix, iy)] -= c.dot(termsAt(map, ix, iy).head(n));
  return result;
}

namespace {

/// The equation of each unmeasured point: sum of weight (h - h of the neighbour) = 0.
struct Membrane {
  Eigen::SparseMatrix<double> matrix;
  Vector right;
  std::vector<int> point; ///< of each unknown
};

Membrane membraneOf(const HeightMap &map)
{
  Membrane result;
  std::vector<int> unknown(map.height.size(), -1);
  for (int k = 0; k < map.height.size(); ++k)
    if (std::isnan(map.height[k])) {
      unknown[k] = static_cast<int>(result.point.size());
      result.point.push_back(k);
    }
  const double perX = map.dy / map.dx, perY = map.dx / map.dy; // 1/dx^2, 1/dy^2, scaled
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(5 * result.point.size());
  result.right = Vector::Zero(static_cast<Eigen::Index>(result.point.size()));
  for (int row = 0; row < static_cast<int>(result.point.size()); ++row) {
    const int ix = result.point[row] % map.nx, iy = result.point[row] / map.nx;
    double diagonal = 0.0;
    const auto join = [&](int jx, int jy, double weight) {
      if (jx < 0 || jx >= map.nx || jy < 0 || jy >= map.ny)
        return; // zero slope at the border
      const int other = map.index(jx, jy);
      diagonal += weight;
      if (unknown[other] >= 0)
        entries.emplace_back(row, unknown[other], -weight);
      else
        result.right[row] += weight * map.height[other];
    };
    join(ix - 1, iy, perX);
    join(ix + 1, iy, perX);
    join(ix, iy - 1, perY);
    join(ix, iy + 1, perY);
    entries.emplace_back(row, row, diagonal);
  }
  result.matrix.resize(result.right.size(), result.right.size());
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace

HeightMap filled(const HeightMap &map)
{
  const int holes = map.unmeasured();
  if (holes == 0)
    return map;
  if (2L * holes > map.height.size())
    refuse(fmt::format("{} of {} points are not measured; at most half can be filled", holes,
                       map.height.size()));
  double mean = 0.0; // taken off, so that the tolerance is relative to the roughness
  for (const double h : map.height)
    mean += std::isnan(h) ? 0.0 : h;
  mean /= static_cast<double>(map.height.size() - holes);
  HeightMap result = map;
  result.height.array() -= mean;
  const Membrane membrane = membraneOf(result);
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                           Eigen::IncompleteCholesky<double>>
      solver(membrane.matrix);
  solver.setTolerance(1e-10);
  const Vector heights = solver.solve(membrane.right);
  if (solver.info() != Eigen::Success)
    throw Error(ExitCode::NotConverged, "height map: the holes could not be filled");
  for (std::size_t k = 0; k < membrane.point.size(); ++k)
    result.height[membrane.point[k]] = heights[static_cast<Eigen::Index>(k)];
  result.height.array() += mean;
  return result;
}

namespace {

/// Weights of the Gaussian filter at 0, 1, .. points, as far as they count.
Vector gaussianWeights(double cutoff, double spacing)
{
  const double alpha = std::sqrt(std::log(2.0) / pi); // ISO 16610-61
  const double width = alpha * cutoff / spacing;
  const int reach = static_cast<int>(std::ceil(2.0 * width)); // the weight is 3e-6 there
  Vector weight(reach + 1);
  for (int m = 0; m <= reach; ++m)
    weight[m] = std::exp(-pi * std::pow(m / width, 2));
  return weight;
}

/// Filtered along the columns' index: the weights are a product, so are their sums at a border.
Raster filteredAcross(const Raster &z, const Vector &weight)
{
  const int n = static_cast<int>(z.cols()), reach = static_cast<int>(weight.size()) - 1;
  Raster smooth = Raster::Zero(z.rows(), z.cols());
  for (int i = 0; i < n; ++i) {
    double weights = 0.0;
    for (int j = std::max(0, i - reach); j <= std::min(n - 1, i + reach); ++j) {
      smooth.col(i) += weight[std::abs(i - j)] * z.col(j);
      weights += weight[std::abs(i - j)];
    }
    smooth.col(i) /= weights;
  }
  return smooth;
}

} // namespace

HeightMap lowPassed(const HeightMap &map, double cutoff)
{
  needAllMeasured(map, "the low-pass filter");
  const double least = 2.0 * std::max(map.dx, map.dy), most = std::min(map.width(), map.depth());
  if (!(cutoff >= least && cutoff <= most))
    refuse(fmt::format("a cut-off of {:g} mm must lie between two points, {:g} mm, and the smaller "
                       "side of the map, {:g} mm",
                       cutoff / mm, least / mm, most / mm));
  const Raster alongY = filteredAcross(rasterOf(map), gaussianWeights(cutoff, map.dy));
  const Raster alongX =
      filteredAcross(alongY.transpose(), gaussianWeights(cutoff, map.dx)).transpose();
  return withHeights(map, alongX);
}

namespace {

/// Weights of neighbouring points, from `first` on, in the mean over a cell.
struct CellWeights {
  int first = 0;
  std::vector<double> weight;
};

/// Mean, over each cell, of the straight lines between points at 0, 1, .. points - 1.
/// \param begin, step borders of the cells, in points
std::vector<CellWeights> meansOverCells(int points, double begin, double step, int cells)
{
  std::vector<CellWeights> result(cells);
  for (int i = 0; i < cells; ++i) {
    const double left = std::clamp(begin + i * step, 0.0, points - 1.0);
    const double right = std::clamp(begin + (i + 1) * step, 0.0, points - 1.0);
    CellWeights &cell = result[i];
    cell.first = std::min(static_cast<int>(left), points - 2);
    const int last = std::clamp(static_cast<int>(std::ceil(right)), cell.first + 1, points - 1);
    cell.weight.assign(last - cell.first + 1, 0.0);
    for (int k = cell.first; k < last; ++k) { // the line from point k to k + 1
      const double a = std::max(left, static_cast<double>(k)) - k;
      const double b = std::min(right, k + 1.0) - k;
      if (b <= a)
        continue;
      const double rising = 0.5 * (b * b - a * a) / (right - left);
      cell.weight[k - cell.first] += (b - a) / (right - left) - rising;
      cell.weight[k + 1 - cell.first] += rising;
    }
  }
  return result;
}

/// Where the cells of one direction begin, in points; checks that they lie on the map.
double beginningOf(int points, double spacing, double border, double step, int cells,
                   const char *direction)
{
  const double begin = border / spacing + 0.5 * (points - 1), end = begin + cells * step / spacing;
  const double tolerance = 1e-9 * points; // of rounding
  if (begin < -tolerance || end > points - 1 + tolerance)
    refuse(fmt::format("it reaches from {:g} to {:g} mm along {}, the cells from {:g} to {:g} mm",
                       -0.5 * (points - 1) * spacing / mm, 0.5 * (points - 1) * spacing / mm,
                       direction, border / mm, (border + cells * step) / mm));
  return begin;
}

} // namespace

// The bilinear surface is a product of straight lines in x and in y, and so is its mean over a
// cell: weights of each direction by itself, first across the rows, then along them.
Vector resampled(const HeightMap &map, const PatchGrid &grid, double lengthUnit, double shiftX,
                 double shiftY)
{
  needAllMeasured(map, "resampling");
  const double stepX = grid.dx * lengthUnit, stepY = grid.dy * lengthUnit;
  const double beginX =
      beginningOf(map.nx, map.dx, (grid.left - shiftX) * lengthUnit, stepX, grid.nx, "x");
  const double beginY =
      beginningOf(map.ny, map.dy, (grid.bottom - shiftY) * lengthUnit, stepY, grid.ny, "y");
  const auto z = rasterOf(map);
  const auto alongX = meansOverCells(map.nx, beginX, stepX / map.dx, grid.nx);
  const auto alongY = meansOverCells(map.ny, beginY, stepY / map.dy, grid.ny);

  Vector result(grid.cells());
  Vector row(map.nx); // mean over the cells' y, at the map's points along x
  for (int iy = 0; iy < grid.ny; ++iy) {
    row.setZero();
    for (std::size_t k = 0; k < alongY[iy].weight.size(); ++k)
      row += alongY[iy].weight[k] * z.col(alongY[iy].first + static_cast<int>(k));
    for (int ix = 0; ix < grid.nx; ++ix) {
      double sum = 0.0;
      for (std::size_t k = 0; k < alongX[ix].weight.size(); ++k)
        sum += alongX[ix].weight[k] * row[alongX[ix].first + static_cast<int>(k)];
      result[grid.index(ix, iy)] = sum / lengthUnit;
    }
  }
  return result;
}

PatchGrid coveredGrid(const HeightMap &map, double dx, double dy, double lengthUnit)
{
  const double slack = 1.0 + 1e-12;
  const double nx = std::floor(map.width() / (dx * lengthUnit) * slack);
  const double ny = std::floor(map.depth() / (dy * lengthUnit) * slack);
  if (!(nx >= 1.0 && ny >= 1.0 && nx * ny < std::numeric_limits<int>::max()))
    refuse(fmt::format("a map of {:g} x {:g} mm cannot be cut into cells of {:g} x {:g} um",
                       map.width() / mm, map.depth() / mm, dx * lengthUnit / um,
                       dy * lengthUnit / um));
  return centredGrid(static_cast<int>(nx), static_cast<int>(ny), nx * dx, ny * dy);
}

} // namespace wheelrail
