// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_INFLUENCE_TABLE_H
#define WHEELRAIL_PATCH_INFLUENCE_TABLE_H

#include "contact/half_space.h"
#include "contact/patch/elasticity/cell_influence.h"
#include "contact/patch/elasticity/plane_transform.h"

#include <vector>

namespace wheelrail {

/// Influence of a cell at all distances of whole cells within a grid. Lengths are in units of a
/// cell's along x, so that one table serves grids of all sizes whose cells have one shape: coarser
/// ones, and boxes of cells.
class InfluenceTable {
 public:
  explicit InfluenceTable(const CellGrid &grid);

  /// \param ix, iy cells between the two, 0 .. one less than those of the grid
  const CellIntegrals &at(int ix, int iy) const { return values_[std::size_t(ix) * ny_ + iy]; }

 private:
  int ny_;
  std::vector<CellIntegrals> values_;
};

/// Spectrum of the normal influence (1 - nu)/(pi G) int 1/r over a cell, for `PlaneTransform`s of
/// the sizes: length per pressure, the factor 1/(sizeX sizeY) included.
Quarter normalSpectrum(const InfluenceTable &table, const CellGrid &grid, const ElasticPair &pair,
                       int sizeX, int sizeY);

/// A symbol that multiplies the two components of a tangential field, wave by wave, by the matrix
/// {{xx, xy}, {xy, yy}}; xy is odd in both directions. Factors 1/(sizeX sizeY) are included.
template<class Real>
struct SymmetricSymbolOf {
  std::vector<Real> xx, yy, xy; ///< as of `Quarter`
};
using SymmetricSymbol = SymmetricSymbolOf<double>;

/// Displacements of tractions, the layer's included: length per traction.
SymmetricSymbol tangentialSpectrum(const InfluenceTable &table, const CellGrid &grid,
                                   const ElasticPair &pair, int sizeX, int sizeY);

/// Spectra of the integrals, by which they are multiplied where the cells repeat with the
/// transform's period.
class PeriodicInfluence {
 public:
  /// \param sizeX, sizeY cells of the period
  PeriodicInfluence(const CellGrid &grid, int sizeX, int sizeY);
  /// Integrals of the wave (kx, ky), 0 .. half the sizes; the mean is a wave of twice the box.
  CellIntegrals at(int kx, int ky) const;
  /// yy + xx of it.
  double normalAt(int kx, int ky) const;

 private:
  static constexpr int aliases = 1;
  /// A wave number and its aliases, with the transform of a cell's load along one direction.
  struct Axis {
    double k[2 * aliases + 1], cell[2 * aliases + 1];
  };
  static std::vector<Axis> axes(int size, double length);

  double longest_;
  std::vector<Axis> x_, y_;
};

/// Inverse of the normal influence on cells that repeat, (pi G)/((1 - nu) (yy + xx)), with the
/// factor 1/(sizeX sizeY).
Quarter normalStiffness(const CellGrid &grid, const ElasticPair &pair, int sizeX, int sizeY);

/// The inverse of the tangential one on cells that repeat, the layer included.
SymmetricSymbol tangentialStiffness(const CellGrid &grid, const ElasticPair &pair, int sizeX,
                                    int sizeY);

/// The product of both components with a symbol.
template<class Real>
void multiplyBySymmetric(PlaneTransformOf<Real> &transform, const double *const *from,
                         double *const *to, const SymmetricSymbolOf<Real> &symbol)
{
  using Complex = std::complex<Real>;
  const int sizeY = transform.sizeY(), countY = sizeY / 2 + 1;
  transform.multiply(from, to, [&](int kx, Complex *const *column) {
    const std::size_t at = std::size_t(kx) * countY;
    const Real *xx = &symbol.xx[at], *yy = &symbol.yy[at], *xy = &symbol.xy[at];
    Complex *first = column[0], *second = column[1];
    forFrequencies(sizeY, [&](int ky, int bin, double sign) {
      const Complex x = first[ky], y = second[ky];
      const Real cross = static_cast<Real>(sign) * xy[bin];
      first[ky] = xx[bin] * x + cross * y;
      second[ky] = cross * x + yy[bin] * y;
    });
  });
}

} // namespace wheelrail
#endif
