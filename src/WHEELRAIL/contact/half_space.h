// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_HALF_SPACE_H
#define WHEELRAIL_CONTACT_HALF_SPACE_H

#include <Eigen/Core>

#include <memory>

namespace wheelrail {

/// nx x ny equal cells in the plane of contact; ny = 1 for a line contact. x is the rolling
/// direction: material enters at the largest x and travels towards smaller x.
///
/// A field over the cells is a vector of `cells()` values with x running fastest: cell (ix, iy),
/// counted from 0 at the smallest x and y, has the index ix + nx iy.
struct CellGrid {
  int nx = 1, ny = 1;        ///< >= 1
  double dx = 1.0, dy = 1.0; ///< size of a cell, > 0, in the half-space's unit of length
  int cells() const { return nx * ny; }
  int index(int ix, int iy) const { return ix + nx * iy; }
};

/// Displacement and traction estimate of a `HalfSpace`, into vectors that are there. One object for
/// each thread. \tparam Real float or double
template<class Real>
class ProductsOf {
 public:
  using Field = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  virtual ~ProductsOf() = default;
  /// As the functions of `HalfSpace`; the result must have its size.
  virtual void displacement(const Field &pressure, Field &result) = 0;
  virtual void tractionEstimate(const Field &displacement, Field &result) = 0;

 protected:
  ProductsOf() = default;
  ProductsOf(const ProductsOf &) = default;
  ProductsOf &operator=(const ProductsOf &) = default;
  ProductsOf(ProductsOf &&) noexcept = default;
  ProductsOf &operator=(ProductsOf &&) noexcept = default;
};
using QuickProducts = ProductsOf<float>;

/// Two elastic half-spaces that touch in a plane, seen through the cells of a grid, each of which
/// is loaded uniformly: what the normal contact (`solveNormalContact`) needs to know of elasticity.
///
/// Implemented by the line contact's `HalfPlane` (ny = 1, plane strain) and by `PatchHalfSpace` for
/// surfaces of two dimensions; one solver serves both. Tangential tractions are not here: along a
/// line they have the kernel of the pressure, and on a patch `PatchHalfSpace` has products of its
/// own, which the rolling contact of that room knows.
///
/// *Units.* Any consistent set: displacements have the unit of `grid().dx`, tractions that of the
/// elastic modulus which the implementation was given. `HalfPlane` takes E* as the unit of stress,
/// so that its tractions are dimensionless. A solver may not rely on any of them.
///
/// *Displacements* are differences between the two bodies, positive where the surfaces move apart
/// under pressure. Of unlike bodies pressure causes a tangential displacement, too, and tangential
/// traction a normal one; that is no part of this class (on a patch: `PatchCoupling`).
///
/// *Shape.* Every vector has `grid().cells()` values; other sizes are a programming error.
///
/// *Threads.* Products use work buffers of the object: one object for each thread.
class HalfSpace {
 public:
  using Vector = Eigen::VectorXd;

  virtual ~HalfSpace() = default;

  virtual const CellGrid &grid() const = 0;
  int cells() const { return grid().cells(); }

  /// Normal displacement u = A p at the cell centres. A is symmetric and positive definite; on a
  /// line up to the constant that is free in two dimensions.
  virtual Vector displacement(const Vector &pressure) = 0;

  /// Approximate inverse of `displacement`, symmetric and positive definite: the preconditioner
  /// for conjugate gradients on any part of the cells. The nearer it is to the true inverse
  /// (spectrally |k| times a stiffness), the fewer products a solver needs.
  virtual Vector tractionEstimate(const Vector &displacement) = 0;

  /// A displacement that tolerances can be measured against: its order of magnitude under
  /// pressures whose sum over the cells is `pressureSum` > 0. Must not depend on the unit system.
  virtual double displacementScale(double pressureSum) const = 0;

  /// This half-space on cells that are twice as long in every direction with more than one
  /// cell, in the same units: where solvers find their start. Null where the grid is small enough
  /// to start on, or does not halve. Owned by this object, which makes it once.
  virtual HalfSpace *coarser() = 0;

  /// Products that are quicker and off by up to 1e-6 of their largest value: what a solver looks
  /// for corrections with. Null: there is nothing quicker.
  /// Owned by this object, which makes them once.
  virtual QuickProducts *quick() { return nullptr; }

 protected:
  HalfSpace() = default;
  HalfSpace(const HalfSpace &) = default;
  HalfSpace &operator=(const HalfSpace &) = default;
  HalfSpace(HalfSpace &&) = default;
  HalfSpace &operator=(HalfSpace &&) = default;
};

/// Means over the cells that each coarse cell covers; `fine` has a whole number of cells for each
/// coarse one in both directions.
Eigen::VectorXd coarseMean(const CellGrid &fine, const CellGrid &coarse,
                           const Eigen::VectorXd &values);

/// Every fine cell gets its coarse cell's value.
Eigen::VectorXd refinedField(const CellGrid &fine, const CellGrid &coarse,
                             const Eigen::VectorXd &values);

} // namespace wheelrail
#endif
