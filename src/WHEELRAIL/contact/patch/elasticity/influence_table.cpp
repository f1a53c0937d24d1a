// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/influence_table.h"

#include "shared/pi.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {

using mcawr::pi;

InfluenceTable::InfluenceTable(const CellGrid &grid) : ny_(grid.ny)
{
  const double ratio = grid.dy / grid.dx;
  values_.reserve(grid.cells());
  for (int ix = 0; ix < grid.nx; ++ix)
    for (int iy = 0; iy < grid.ny; ++iy)
      values_.push_back(cellIntegrals(ix, iy * ratio, 1.0, ratio));
}

Quarter normalSpectrum(const InfluenceTable &table, const CellGrid &grid, const ElasticPair &pair,
                       int sizeX, int sizeY)
{
  const int countX = sizeX / 2 + 1, countY = sizeY / 2 + 1;
  const double scale = grid.dx * (1.0 - pair.nu) / (pi * pair.G * sizeX * sizeY);
  Quarter spectrum(std::size_t(countX) * countY, 0.0);
  for (int ix = 0; ix < grid.nx; ++ix)
    for (int iy = 0; iy < grid.ny; ++iy) {
      const CellIntegrals &cell = table.at(ix, iy);
      spectrum[std::size_t(ix) * countY + iy] = scale * (cell.yy + cell.xx);
    }
  quarterTransform(spectrum, countX, countY, false, false);
  return spectrum;
}

// Influence at a distance of whole cells is even in x and y (xy: odd in both), so a quarter of the
// plane holds all of it, and cosine (sine) transforms give the quarter of its spectrum.
SymmetricSymbol tangentialSpectrum(const InfluenceTable &table, const CellGrid &grid,
                                   const ElasticPair &pair, int sizeX, int sizeY)
{
  const int countX = sizeX / 2 + 1, countY = sizeY / 2 + 1;
  const std::size_t bins = std::size_t(countX) * countY;
  SymmetricSymbol symbol{Quarter(bins, 0.0), Quarter(bins, 0.0), Quarter(bins, 0.0)};
  const double scale = grid.dx / (pi * pair.G * sizeX * sizeY), less = 1.0 - pair.nu;
  for (int ix = 0; ix < grid.nx; ++ix)
    for (int iy = 0; iy < grid.ny; ++iy) {
      const std::size_t at = std::size_t(ix) * countY + iy;
      const CellIntegrals &cell = table.at(ix, iy);
      symbol.xx[at] = scale * (less * cell.yy + cell.xx);
      symbol.yy[at] = scale * (cell.yy + less * cell.xx);
      symbol.xy[at] = -scale * pair.nu * cell.xy; // odd in both: the product of two factors -i
    }
  quarterTransform(symbol.xx, countX, countY, false, false);
  quarterTransform(symbol.yy, countX, countY, false, false);
  quarterTransform(symbol.xy, countX, countY, true, true);
  const double soft = pair.layer / (double(sizeX) * sizeY);
  for (std::size_t i = 0; i < bins; ++i) {
    symbol.xx[i] += soft;
    symbol.yy[i] += soft;
  }
  return symbol;
}

PeriodicInfluence::PeriodicInfluence(const CellGrid &grid, int sizeX, int sizeY)
    : longest_(std::max(sizeX * grid.dx, sizeY * grid.dy)), x_(axes(sizeX, grid.dx)),
      y_(axes(sizeY, grid.dy))
{
}

std::vector<PeriodicInfluence::Axis> PeriodicInfluence::axes(int size, double length)
{
  std::vector<Axis> result(size / 2 + 1);
  for (int i = 0; i <= size / 2; ++i)
    for (int m = -aliases; m <= aliases; ++m) {
      const double k = 2.0 * pi * (double(i) / size + m) / length, half = 0.5 * k * length;
      result[i].k[m + aliases] = k;
      result[i].cell[m + aliases] = half == 0.0 ? 1.0 : std::sin(half) / half;
    }
  return result;
}

// Those of the unbounded plane summed over aliases. Each falls as |k|^-3, so that the nearest few
// are enough.
CellIntegrals PeriodicInfluence::at(int kx, int ky) const
{
  if (kx == 0 && ky == 0)
    return {longest_, longest_, 0.0};
  CellIntegrals sum{0.0, 0.0, 0.0};
  const Axis &x = x_[kx], &y = y_[ky];
  for (int m = 0; m <= 2 * aliases; ++m)
    for (int n = 0; n <= 2 * aliases; ++n) {
      const double u = x.k[m], v = y.k[n], k2 = u * u + v * v;
      const double factor = 2.0 * pi * x.cell[m] * y.cell[n] / (k2 * std::sqrt(k2));
      sum.yy += factor * u * u;
      sum.xx += factor * v * v;
      sum.xy -= factor * u * v;
    }
  return sum;
}

double PeriodicInfluence::normalAt(int kx, int ky) const
{
  if (kx == 0 && ky == 0)
    return 2.0 * longest_;
  double sum = 0.0;
  const Axis &x = x_[kx], &y = y_[ky];
  for (int m = 0; m <= 2 * aliases; ++m)
    for (int n = 0; n <= 2 * aliases; ++n)
      sum += x.cell[m] * y.cell[n] / std::sqrt(x.k[m] * x.k[m] + y.k[n] * y.k[n]);
  return 2.0 * pi * sum;
}

Quarter normalStiffness(const CellGrid &grid, const ElasticPair &pair, int sizeX, int sizeY)
{
  const int countX = sizeX / 2 + 1, countY = sizeY / 2 + 1;
  const double scale = pi * pair.G / ((1.0 - pair.nu) * sizeX * sizeY);
  const PeriodicInfluence influence(grid, sizeX, sizeY);
  Quarter stiffness(std::size_t(countX) * countY);
  for (int kx = 0; kx < countX; ++kx)
    for (int ky = 0; ky < countY; ++ky)
      stiffness[std::size_t(kx) * countY + ky] = scale / influence.normalAt(kx, ky);
  return stiffness;
}

// An approximate inverse. On cells that repeat with the box a wave of tractions gives a wave of
// displacements: normal ones are multiplied by a number, tangential ones by a symmetric 2 x 2
// matrix. The inverse of these, wave by wave, is the inverse of the repeated contact. It differs
// from that of the real one by the copies' influence, which is smooth, so that it serves as a
// preconditioner, and needs transforms of the box itself, a quarter of the size.
SymmetricSymbol tangentialStiffness(const CellGrid &grid, const ElasticPair &pair, int sizeX,
                                    int sizeY)
{
  const int countX = sizeX / 2 + 1, countY = sizeY / 2 + 1;
  const std::size_t bins = std::size_t(countX) * countY;
  SymmetricSymbol symbol{Quarter(bins), Quarter(bins), Quarter(bins)};
  const PeriodicInfluence influence(grid, sizeX, sizeY);
  const double scale = pi * pair.G / (double(sizeX) * sizeY), less = 1.0 - pair.nu;
  const double soft = pi * pair.G * pair.layer; // the same for all waves
  for (int kx = 0; kx < countX; ++kx)
    for (int ky = 0; ky < countY; ++ky) {
      const std::size_t at = std::size_t(kx) * countY + ky;
      CellIntegrals cell = influence.at(kx, ky);
      // at the highest frequency +k and -k are the same: the odd part vanishes
      if (2 * kx == sizeX || 2 * ky == sizeY)
        cell.xy = 0.0;
      const double a = less * cell.yy + cell.xx + soft, b = cell.yy + less * cell.xx + soft;
      const double c = pair.nu * cell.xy, determinant = a * b - c * c;
      // the matrix {{a, c}, {c, b}} multiplies a wave's tractions, (a b - c^2)^-1 {{b, -c}, {-c,
      // a}} its displacements
      symbol.xx[at] = scale * b / determinant;
      symbol.yy[at] = scale * a / determinant;
      symbol.xy[at] = -scale * c / determinant;
    }
  return symbol;
}

} // namespace wheelrail
