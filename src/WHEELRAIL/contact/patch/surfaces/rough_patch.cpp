// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/surfaces/rough_patch.h"

#include "base/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr int points = 6; ///< of the interpolation

/// Where the way ends in a row of cells: the whole part, and weights of the cells from
/// whole - 2 to whole + 3.
struct Place {
  long whole;
  std::array<double, points> weight;
};

Place placeOf(double cells)
{
  constexpr double rounding = 1e-9; // of a cell: whole steps stay whole
  Place place{static_cast<long>(std::floor(cells + rounding)), {}};
  const double part = cells - static_cast<double>(place.whole);
  if (part <= rounding) {
    place.weight[2] = 1.0;
    return place;
  }
  for (int i = 0; i < points; ++i) {
    place.weight[i] = 1.0;
    for (int j = 0; j < points; ++j)
      if (j != i)
        place.weight[i] *= (part - (j - 2)) / (i - j);
  }
  return place;
}

long wrapped(long i, long n)
{
  return ((i % n) + n) % n;
}

/// The cells of an interpolation, in a map that repeats: a place's weights belong to them.
/// \param first cell of the map at part 0 of the place
std::array<long, points> cellsOf(const Place &place, long first, long n)
{
  std::array<long, points> cells{};
  for (int k = 0; k < points; ++k) {
    const long i = first + place.whole + k - 2;
    cells[k] = i >= 0 && i < n ? i : wrapped(i, n); // mostly inside: divisions are slow
  }
  return cells;
}

/// Are the first and the last cell that a window of n cells takes inside of the map?
void checkInside(const Place &place, int first, int n, int size, const char *direction)
{
  const bool exact = place.weight[2] == 1.0;
  const long low = first + place.whole - (exact ? 0 : 2), high = low + n - 1 + (exact ? 0 : 5);
  if (low < 0 || high >= size)
    throw Error(ExitCode::BadInput,
                fmt::format("roughness: the measured map ends {}: cells {} to {} are needed after "
                            "the way that is rolled, there are {}; fewer moving.passes, or a "
                            "larger map",
                            direction, low, high, size));
}

/// A map whose points are the cells' centres. \throws Error (BadInput) where they are not
RoughMap pointwiseMap(const std::string &path, const HeightMap &given, const PatchGrid &box,
                      double travel)
{
  constexpr double rounding = 1e-6; // of a spacing that was written with a few digits
  if (std::abs(given.dx - box.dx) > rounding * box.dx ||
      std::abs(given.dy - box.dy) > rounding * box.dy)
    throw badInput(path, 0, "",
                   fmt::format("roughness.sampling: points {:.7g} x {:.7g} mm apart are no centres "
                               "of cells of {:.7g} x {:.7g} mm",
                               given.dx * 1e3, given.dy * 1e3, box.dx * 1e3, box.dy * 1e3));
  const int moreX = given.nx - box.nx, moreY = given.ny - box.ny;
  if (moreX < 0 || moreY < 0 || (travel == 0.0 && moreX % 2 != 0) || moreY % 2 != 0)
    throw badInput(path, 0, "",
                   fmt::format("roughness.sampling: {} x {} points; as many as the box has cells, "
                               "{} x {}, or an even number more are expected",
                               given.nx, given.ny, box.nx, box.ny));
  RoughMap map;
  map.nx = given.nx;
  map.ny = given.ny;
  map.firstX = travel > 0.0 ? std::clamp(moreX, 0, points / 2 + box.nx / 50) : moreX / 2;
  map.firstY = moreY / 2;
  map.height = given.height;
  return map;
}

/// One measured map, from the file to cells of the box's size.
RoughMap measuredMap(const std::string &path, const HeightMapPreparation &preparation,
                     const std::string &name, const PatchGrid &box, double travel,
                     RoughPatch &patch)
{
  const PreparedHeightMap prepared = prepareHeightMap(path, preparation, name);
  patch.remarks.insert(patch.remarks.end(), prepared.remarks.begin(), prepared.remarks.end());
  for (const HeightMapStatistics &step : prepared.statistics) {
    patch.statistics.push_back(step);
    if (&step == &prepared.statistics.front() && step.unmeasured > 0)
      patch.remarks.push_back(fmt::format("roughness.unmeasured: {}: {} of {} points had no height "
                                          "and were filled",
                                          path, step.unmeasured,
                                          prepared.map.nx * prepared.map.ny));
  }
  RoughMap map;
  if (preparation.pointwise) {
    map = pointwiseMap(path, prepared.map, box, travel);
    map.periodic = false;
    return map;
  }
  map.periodic = false;
  // what stands still needs the middle only; what travels, all there is, from its beginning on
  PatchGrid cells = box;
  if (travel > 0.0)
    cells = coveredGrid(prepared.map, box.dx, box.dy, 1.0);
  if (cells.nx < box.nx || cells.ny < box.ny)
    cells = box; // the message is that of `resampled`
  map.nx = cells.nx;
  map.ny = cells.ny;
  // room at the border that goes out first: for the interpolation, and for what spin turns back
  if (travel > 0.0)
    map.firstX = std::clamp(cells.nx - box.nx, 0, points / 2 + box.nx / 50);
  map.firstY = (cells.ny - box.ny) / 2;
  try {
    map.height = resampled(prepared.map, cells, 1.0);
  } catch (const Error &error) {
    throw Error(error.code(), fmt::format("{}: {}", path, error.what()));
  }
  HeightMap sampledMap{map.nx, map.ny, box.dx, box.dy, map.height};
  patch.statistics.push_back(
      heightMapStatistics(name + ": on the cells", sampledMap, preparation.cutoff));
  return map;
}

/// Root mean squares of a periodic map, slopes between neighbours.
HeightMapStatistics statisticsOf(const RoughMap &a, const RoughMap &b, const PatchGrid &box,
                                 double shortest)
{
  HeightMap sum{a.nx, a.ny, box.dx, box.dy, a.height + b.height};
  return heightMapStatistics("generated", sum, shortest);
}

/// Number that the surface of a body is made from.
std::uint64_t seedOfBody(std::uint64_t seed, int body)
{
  constexpr std::uint64_t apart = 0x9E3779B97F4A7C15; // far from any seed that a person takes
  return seed + static_cast<std::uint64_t>(body) * apart;
}

RoughPatch fractalPatch(const RoughPatchSpecification &specification, std::uint64_t seed,
                        const PatchGrid &box, double travel)
{
  const double boxX = box.nx * box.dx;
  const int boxes =
      specification.boxes > 0 ? specification.boxes : 1 + static_cast<int>(travel / boxX);
  FractalPatch fractal = specification.fractal;
  // `FractalHeights` counts all waves before it looks at the cells: no more than they could carry
  const double root = std::sqrt(fractal.stretch);
  if (fractal.wavelengthMin * root < box.dx || fractal.wavelengthMin < box.dy * root)
    throw Error(ExitCode::BadInput,
                fmt::format("cells: those of {:.4g} x {:.4g} mm cannot carry waves of {:.4g} mm "
                            "(roughness.wavelength_min); four cells a wave are needed, eight are "
                            "better",
                            box.dx * 1e3, box.dy * 1e3, fractal.wavelengthMin * 1e3));
  fractal.periodX = boxes * boxX;
  fractal.periodY = box.ny * box.dy;
  fractal.rmsSlope /= std::sqrt(2.0);
  fractal.rmsHeight /= std::sqrt(2.0);
  PatchGrid cells = box;
  cells.nx *= boxes;
  RoughPatch patch;
  patch.number = seed;
  for (int body : {0, 1}) {
    fractal.seed = seedOfBody(seed, body);
    RoughMap &map = body == 0 ? patch.wheel : patch.rail;
    map.nx = cells.nx;
    map.ny = cells.ny;
    map.height = FractalHeights(fractal).sampled(cells);
  }
  patch.shortestWave = fractal.wavelengthMin * std::min(root, 1.0 / root);
  patch.statistics.push_back(statisticsOf(patch.wheel, patch.rail, box, patch.shortestWave));
  for (const auto &[wave, cell, direction] :
       {std::tuple{fractal.wavelengthMin * root, box.dx, "along x"},
        {fractal.wavelengthMin / root, box.dy, "along y"}})
    if (wave < advisedCellsPerWave * cell)
      patch.remarks.push_back(
          fmt::format("cells: waves of {:.4g} mm have {:.3g} cells {}; {:g} are advised",
                      wave * 1e3, wave / cell, direction, advisedCellsPerWave));
  return patch;
}

RoughPatch measuredPatch(const RoughPatchSpecification &specification, std::size_t index,
                         const PatchGrid &box, double travel)
{
  RoughPatch patch;
  patch.number = index + 1;
  if (!specification.rail.empty())
    patch.rail =
        measuredMap(specification.rail[index], specification.railMap, "rail", box, travel, patch);
  if (!specification.wheel.empty())
    patch.wheel = measuredMap(specification.wheel[index], specification.wheelMap, "wheel", box,
                              travel, patch);
  patch.shortestWave = std::max(specification.railMap.cutoff, specification.wheelMap.cutoff);
  if (patch.shortestWave > 0.0 &&
      patch.shortestWave < advisedCellsPerWave * std::max(box.dx, box.dy))
    patch.remarks.push_back(
        fmt::format("roughness.cutoff: waves of {:.4g} mm have {:.3g} cells; {:g} are advised",
                    patch.shortestWave * 1e3, patch.shortestWave / std::max(box.dx, box.dy),
                    advisedCellsPerWave));
  if (patch.shortestWave == 0.0)
    patch.remarks.emplace_back("roughness.cutoff: not given; waves of the measured maps that are "
                               "shorter than 8 cells are not resolved");
  return patch;
}

} // namespace

RoughPatch prepareRoughPatch(const RoughPatchSpecification &specification, std::size_t index,
                             const PatchGrid &box, double travel)
{
  switch (specification.kind) {
  case RoughnessKind::Fractal:
    return fractalPatch(specification, specification.seeds[index], box, travel);
  case RoughnessKind::Measured:
    return measuredPatch(specification, index, box, travel);
  default:
    return {};
  }
}

// Whole steps copy, without a weight for any neighbour: surfaces that travel by cells stay the same
// to the last bit, and a map that just covers the way will do.
Vector RoughMap::straightWindow(const PatchGrid &box, const Travel &travel) const
{
  const Place px = placeOf(travel.x / box.dx), py = placeOf(travel.y / box.dy);
  if (!periodic) {
    checkInside(px, firstX, box.nx, nx, "along the rolling direction");
    checkInside(py, firstY, box.ny, ny, "across the rolling direction");
  }
  // along x first, on the rows that are needed, then along y
  const int rows = box.ny + points - 1;
  std::vector<double> row(static_cast<std::size_t>(rows) * box.nx, 0.0);
  for (int r = 0; r < rows; ++r) {
    const bool needed = py.weight[2] != 1.0 || (r >= 2 && r < box.ny + 2);
    if (!needed)
      continue;
    const double *source = height.data() + wrapped(firstY + py.whole + r - 2, ny) * nx;
    double *target = row.data() + static_cast<std::size_t>(r) * box.nx;
    for (int k = 0; k < points; ++k) {
      if (px.weight[k] == 0.0)
        continue;
      long from = wrapped(firstX + px.whole + k - 2, nx);
      for (int ix = 0; ix < box.nx; ++ix) {
        target[ix] += px.weight[k] * source[from];
        if (++from == nx)
          from = 0;
      }
    }
  }
  Vector result = Vector::Zero(box.cells());
  for (int iy = 0; iy < box.ny; ++iy)
    for (int k = 0; k < points; ++k)
      if (py.weight[k] != 0.0)
        for (int ix = 0; ix < box.nx; ++ix)
          result[box.index(ix, iy)] +=
              py.weight[k] * row[static_cast<std::size_t>(iy + k) * box.nx + ix];
  return result;
}

Vector RoughMap::turnedWindow(const PatchGrid &box, const Travel &travel) const
{
  Vector result(box.cells());
  for (int ix = 0; ix < box.nx; ++ix) {
    const Place across = placeOf((travel.y - travel.aside[ix]) / box.dy);
    for (int iy = 0; iy < box.ny; ++iy) {
      const Place along = placeOf((travel.x + box.y(iy) * travel.turn[ix]) / box.dx);
      if (!periodic) {
        checkInside(along, firstX + ix, 1, nx, "along the rolling direction");
        checkInside(across, firstY + iy, 1, ny, "across the rolling direction");
      }
      const std::array<long, points> columns = cellsOf(along, firstX + ix, nx);
      const std::array<long, points> rows = cellsOf(across, firstY + iy, ny);
      double sum = 0.0;
      for (int k = 0; k < points; ++k) {
        const double *row = height.data() + rows[k] * nx;
        double inRow = 0.0;
        for (int j = 0; j < points; ++j)
          inRow += along.weight[j] * row[columns[j]];
        sum += across.weight[k] * inRow;
      }
      result[box.index(ix, iy)] = sum;
    }
  }
  return result;
}

Vector RoughMap::window(const PatchGrid &box, const Travel &travel) const
{
  return travel.turn.size() == 0 ? straightWindow(box, travel) : turnedWindow(box, travel);
}

// The material of a column was in the next one before the step; half of the step on either side of
// the border between them.
void Travel::roll(const PatchGrid &box, double wayX, double wayY, double turning)
{
  x += wayX;
  y += wayY;
  if (turn.size() == 0 && turning == 0.0)
    return;
  if (turn.size() == 0)
    turn = aside = Vector::Zero(box.nx);
  const double angle = turning * box.dx;
  for (int ix = 0; ix + 1 < box.nx; ++ix) {
    turn[ix] = turn[ix + 1] + angle;
    aside[ix] = aside[ix + 1] + angle * (box.x(ix) + 0.5 * box.dx);
  }
  turn[box.nx - 1] = aside[box.nx - 1] = 0.0;
}

std::size_t RoughPatchSpecification::surfaces() const
{
  return std::max({std::size_t{1}, seeds.size(), rail.size(), wheel.size()});
}

} // namespace wheelrail
