// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_LINE_HALFPLANE_H
#define WHEELRAIL_CONTACT_LINE_HALFPLANE_H

#include "contact/convolution.h"
#include "contact/half_space.h"

namespace wheelrail {

/// Are the n cells alone on the line, or one period of it?
enum class Boundary { Free, Periodic };

/// Two elastic half-planes in contact along a line of n equal cells, each loaded uniformly: the
/// half-space of a line contact (plane strain; nothing changes along y).
///
/// Stresses are in units of E* (1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2), displacements in the
/// unit of the cell size; with the cell itself as that unit (the default) everything is
/// dimensionless. The same operators serve pressure and traction along x: for equal materials the
/// two problems are uncoupled and have one kernel (Johnson, Contact Mechanics, ch. 2).
///
///   u(x) = -(2/pi) integral q(s) ln|x - s| ds  (+ a constant that is free in two dimensions)
///
/// Free: zero-padded FFT convolution with the exact integral of the kernel over a cell.
/// Periodic: the exact spectrum of cells repeated with the period; the mean of u is set to zero.
/// Products cost two FFTs. An object has one work buffer: use one object per thread.
class HalfPlane : public HalfSpace {
 public:
  /// \param cells n >= 1
  /// \param cellSize > 0: unit of the displacements
  HalfPlane(int cells, Boundary boundary, double cellSize = 1.0);

  const CellGrid &grid() const override { return cellGrid_; }
  Boundary boundary() const { return boundary_; }

  Vector displacement(const Vector &q) override;
  Vector tractionEstimate(const Vector &u) override;
  /// Likewise with a layer on the half-plane: of the displacement A q + layer q.
  /// \param layer displacement per traction, >= 0
  Vector layeredEstimate(const Vector &u, double layer);
  /// The sum of the cells' pressures times their size: the load over E*.
  double displacementScale(double pressureSum) const override { return pressureSum * cellGrid_.dx; }
  /// Null below 256 cells and for an odd number.
  HalfSpace *coarser() override;

  /// u_i - u_(i+1): by how much a particle's displacement grows while it moves one cell towards
  /// smaller x, in units of the cell size. Taken as -u' half-way, with the cells' loads at their
  /// centres: on this staggered grid the Hilbert transform is orthogonal to the last bit and the
  /// traction of a stick zone has its exact integral (as 1/4-3/4 points give the lift of a plate).
  /// Free boundary only.
  Vector stretch(const Vector &q);

  /// Transpose of `stretch`; on an unbounded line stretch(stretchTransposed(q)) = 4 q.
  Vector stretchTransposed(const Vector &q);

  /// Logarithm of the weight prod sqrt|(right_j - x)/(x - left_j)| at the cell centres, of
  /// intervals that begin or end at faces between cells: `charge` is +1/2 at the face left of a
  /// cell where an interval has ended, -1/2 where one begins. Free boundary only.
  Vector edgeLogarithm(const Vector &charge);

 private:
  using Spectrum = Convolution::Spectrum;
  /// The product; the kernel's spectrum is made when it is first needed.
  Vector multiply(const Vector &x, Spectrum &spectrum, double (*kernel)(int));
  void fillPeriodicSpectra();

  Boundary boundary_;
  CellGrid cellGrid_;
  Convolution line_;
  std::unique_ptr<HalfSpace> coarser_;
  Spectrum compliance_, stretching_, stretchingTransposed_, stiffness_, faces_;
  Spectrum layered_; ///< of `layeredEstimate`, for `layer_`
  double layer_ = 0.0;
};

/// (2/pi) times minus the integral of ln|x| over the cell that is centred m cells away, in units
/// where the cell is 1: the influence of one loaded cell. Exact to rounding for |m| up to 1e15.
double cellInfluence(double m);

} // namespace wheelrail
#endif
