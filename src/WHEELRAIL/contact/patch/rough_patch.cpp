// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/rough_patch.h"

#include "base/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

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

} // namespace

Vector RoughMap::window(const PatchGrid &box, const Travel &travel) const
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

std::size_t RoughPatchSpecification::surfaces() const
{
  return std::max({std::size_t{1}, seeds.size(), rail.size(), wheel.size()});
}

} // namespace wheelrail
