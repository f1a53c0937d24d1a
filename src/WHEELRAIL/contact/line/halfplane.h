#ifndef WHEELRAIL_CONTACT_LINE_HALFPLANE_H
#define WHEELRAIL_CONTACT_LINE_HALFPLANE_H

#include "contact/line/convolution.h"

namespace wheelrail {

/// Are the n cells alone on the line, or one period of it?
enum class Boundary { Free, Periodic };

/// Two elastic half-planes in contact along a line of n equal cells, each loaded uniformly.
///
/// Everything here is dimensionless, so that nothing depends on a unit system: stresses are in
/// units of E* (1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2), displacements and lengths in cells. The
/// same operators serve normal pressure and tangential traction: for equal materials the two
/// problems are uncoupled and have one kernel (Johnson, Contact Mechanics, ch. 2).
///
///   u(x) = -(2/pi) integral q(s) ln|x - s| ds  (+ a constant that is free in two dimensions)
///
/// Free: zero-padded FFT convolution with the exact integral of the kernel over a cell.
/// Periodic: the exact spectrum of cells repeated with the period; the mean of u is set to zero.
/// Products cost two FFTs. An object has one work buffer: use one object per thread.
class HalfPlane {
 public:
  using Vector = Eigen::VectorXd;

  /// @param cells n >= 1
  HalfPlane(int cells, Boundary boundary);

  int cells() const { return line.cells(); }
  Boundary boundary() const { return kind; }

  /// u = A q: displacement at the cell centres. Symmetric; positive definite up to the constant.
  Vector displacement(const Vector &q);

  /// u_i - u_(i+1): by how much a particle's displacement grows while it moves one cell towards
  /// smaller x. Taken as -u' half-way, with the cells' loads at their centres: on this staggered
  /// grid the Hilbert transform is orthogonal to the last bit and the traction of a stick zone
  /// has its exact integral (as 1/4-3/4 points give the lift of a plate). Free boundary only.
  Vector stretch(const Vector &q);

  /// Transpose of `stretch`; on an unbounded line stretch(stretchTransposed(q)) = 4 q.
  Vector stretchTransposed(const Vector &q);

  /// Logarithm of the weight prod sqrt|(right_j - x)/(x - left_j)| at the cell centres, of
  /// intervals that begin or end at faces between cells: `charge` is +1/2 at the face left of a
  /// cell where an interval has ended, -1/2 where one begins. Free boundary only.
  Vector edgeLogarithm(const Vector &charge);

  /// Approximate inverse of `displacement` (spectrally |k|/2), symmetric positive definite:
  /// a preconditioner for conjugate gradients on any part of the cells.
  Vector tractionEstimate(const Vector &u);

 private:
  using Spectrum = Convolution::Spectrum;
  /// The product; the kernel's spectrum is made when it is first needed.
  Vector multiply(const Vector &x, Spectrum &spectrum, double (*kernel)(int));
  void fillPeriodicSpectra();

  Boundary kind;
  Convolution line;
  Spectrum compliance, stretching, stretchingTransposed, stiffness, faces;
};

/// (2/pi) times minus the integral of ln|x| over the cell that is centred m cells away, in units
/// where the cell is 1: the influence of one loaded cell. Exact to rounding for |m| up to 1e15.
double cellInfluence(double m);

} // namespace wheelrail
#endif
