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

/// Spectra of the integrals, by which they are multiplied where the cells repeat with the
/// transform's period.
class PeriodicInfluence {
 public:
  /// \param sizeX, sizeY cells of the period
  PeriodicInfluence(const CellGrid &grid, int sizeX, int sizeY);
  /// Of the wave (kx, ky), 0 .. half the sizes; the mean counts as a wave of twice the box.
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

} // namespace wheelrail
#endif
