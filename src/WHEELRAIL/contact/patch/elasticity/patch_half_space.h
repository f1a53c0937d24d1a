// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_HALF_SPACE_H
#define WHEELRAIL_PATCH_HALF_SPACE_H

#include "contact/patch/elasticity/grid.h"
#include "contact/patch/elasticity/influence_table.h"
#include "contact/patch/elasticity/plane_transform.h"
#include "contact/patch/elasticity/quick_half_space.h"
#include "contact/patch/elasticity/tangential_field.h"

#include <array>
#include <memory>
#include <optional>

namespace wheelrail {

/// Two elastic half-spaces in contact on a grid of cells that are loaded uniformly each:
/// displacement differences at the cells' centres, exact but for rounding (zero-padded FFT
/// convolution with the closed integrals of the influence over a cell). Displacements have the
/// grid's unit of length, tractions that of G.
///
/// Spectra and transforms are made when they are first needed: at 1024 x 1024 cells they take 110
/// MB for pressures and 135 MB for tractions. One object has one work buffer: use one per thread.
/// A product with pressures takes one transform forth and back, one with tractions two, on a grid
/// of twice the cells each way.
class PatchHalfSpace final : public HalfSpace {
 public:
  /// \param grid cells of any shape; ny = 1 is a row of cells, not a plane problem
  /// \param pair G > 0 and nu of `combinedPair`; K is `PatchCoupling`'s
  PatchHalfSpace(const CellGrid &grid, const ElasticPair &pair);

  const CellGrid &grid() const override { return cellGrid_; }
  /// As given to the constructor.
  const ElasticPair &elasticity() const { return pair_; }

  /// Normal displacement (both bodies' compression) of a pressure. Symmetric, positive definite.
  Vector displacement(const Vector &pressure) override;
  /// Tangential displacement difference of tractions: that of a particle of the wheel along the
  /// traction on it, with what the layer of `ElasticPair` gives way. Symmetric, definite; by
  /// Poisson's ratio the components influence each other.
  TangentialField displacement(const TangentialField &traction);

  /// Approximate inverses, by the symbol of the unbounded half-space: preconditioners, symmetric
  /// and positive definite. With k the wave vector, G |k|/(2 (1 - nu)) for the normal and
  /// (G |k|/2) [k k/(k^2 (1 - nu)) + (1 - k k/k^2)] for the tangential problem.
  Vector tractionEstimate(const Vector &displacement) override;
  TangentialField tractionEstimate(const TangentialField &displacement);

  /// Approximate inverse of D + A - A moved by a cell, D > 0 a compliance like
  /// `tangentialCompliance()`: traction of a surface in steady rolling that gives way by D on top
  /// of the half-spaces, as cells do that slip.
  TangentialField softenedEstimate(const TangentialField &displacement, double D);

  /// Displacement of a punch under the load, a square as large as all cells.
  double displacementScale(double pressureSum) const override;
  /// Null where the longer side has fewer than 64 cells, or a number of cells (other than 1) is
  /// odd.
  HalfSpace *coarser() override;
  /// In single precision; null below 1024 cells.
  QuickProducts *quick() override;
  /// Products of tractions in single precision.
  QuickTractions &quickTractions();

  /// Displacement of a cell along x or y, whichever is larger, under its own unit traction: a scale
  /// of displacement over traction. Length per unit of traction.
  double tangentialCompliance() const;

 private:
  PatchHalfSpace(const CellGrid &grid, const ElasticPair &pair,
                 std::shared_ptr<const InfluenceTable> influence);

  const InfluenceTable &influence();
  const SymmetricSymbol &stiffnessOf(const PlaneTransform &transform);

  CellGrid cellGrid_;
  ElasticPair pair_;
  std::shared_ptr<const InfluenceTable> influence_; ///< this and what follows when first needed
  std::unique_ptr<HalfSpace> coarser_;
  std::unique_ptr<QuickProducts> quick_;
  std::unique_ptr<QuickTractions> quickTractions_;
  PlaneTransform &padded(int fields);
  PlaneTransform &wrapping(int fields);

  std::array<std::optional<PlaneTransform>, 2> padded_;   ///< of one and of two fields
  std::array<std::optional<PlaneTransform>, 2> wrapping_; ///< a preconditioner may wrap around
  Quarter zz_;                                            ///< spectrum for pressures
  Quarter stiffnessZZ_;
  SymmetricSymbol compliance_, stiffness_; ///< for tractions
};

} // namespace wheelrail
#endif
