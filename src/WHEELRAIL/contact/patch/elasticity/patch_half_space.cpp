// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/patch_half_space.h"

#include "contact/patch/elasticity/quick_half_space.h"
#include "shared/pi.h"

#include <cmath>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;
using Complex = PlaneTransform::Complex;

constexpr int coarsestGrid = 32;       ///< cells of the longer side
constexpr int fewestQuickCells = 1024; ///< fewer gain nothing by single precision

using mcawr::pi;

} // namespace

PatchHalfSpace::PatchHalfSpace(const CellGrid &grid, const ElasticPair &elasticPair)
    : cellGrid_(grid), pair_(elasticPair)
{
}

PatchHalfSpace::PatchHalfSpace(const CellGrid &grid, const ElasticPair &elasticPair,
                               std::shared_ptr<const InfluenceTable> influence)
    : cellGrid_(grid), pair_(elasticPair), influence_(std::move(influence))
{
}

const InfluenceTable &PatchHalfSpace::influence()
{
  if (!influence_)
    influence_ = std::make_shared<InfluenceTable>(cellGrid_);
  return *influence_;
}

PlaneTransform &PatchHalfSpace::padded(int fields)
{
  std::optional<PlaneTransform> &transform = padded_[fields - 1];
  if (!transform)
    transform.emplace(paddedTransform(cellGrid_.nx, cellGrid_.ny, fields));
  return *transform;
}

PlaneTransform &PatchHalfSpace::wrapping(int fields)
{
  std::optional<PlaneTransform> &transform = wrapping_[fields - 1];
  if (!transform) {
    const PlaneSize size = fastPlaneSize(cellGrid_.nx, cellGrid_.ny);
    transform.emplace(cellGrid_.nx, cellGrid_.ny, size.x, size.y, fields);
  }
  return *transform;
}

// How displacements are computed. The displacement of a cell is the sum over all cells of traction
// times influence, and the influence depends on the distance of the two cells only: a convolution,
// which Fourier transforms make a product. A transform is cyclic, as if the cells repeated; with
// twice the cells each way, the added ones without traction, the copies lie too far away to reach
// into the cells that count. So the sum is exact but for rounding, and its cost that of transforms.
Vector PatchHalfSpace::displacement(const Vector &pressure)
{
  PlaneTransform &transform = padded(1);
  const int sizeY = transform.sizeY(), countY = sizeY / 2 + 1;
  if (zz_.empty())
    zz_ = normalSpectrum(influence(), cellGrid_, pair_, transform.sizeX(), sizeY);
  Vector result = pressure;
  double *field = result.data();
  transform.multiply(&field, [&](int kx, Complex *const *column) {
    const double *s = &zz_[std::size_t(kx) * countY];
    forFrequencies(sizeY, [&](int ky, int bin, double) { column[0][ky] *= s[bin]; });
  });
  return result;
}

TangentialField PatchHalfSpace::displacement(const TangentialField &traction)
{
  TangentialField result = traction;
  double *fields[] = {result.x.data(), result.y.data()};
  PlaneTransform &transform = padded(2);
  if (compliance_.xx.empty())
    compliance_ =
        tangentialSpectrum(influence(), cellGrid_, pair_, transform.sizeX(), transform.sizeY());
  multiplyBySymmetric(transform, fields, fields, compliance_);
  return result;
}

Vector PatchHalfSpace::tractionEstimate(const Vector &displacement)
{
  PlaneTransform &transform = wrapping(1);
  const int sizeY = transform.sizeY(), countY = sizeY / 2 + 1;
  if (stiffnessZZ_.empty())
    stiffnessZZ_ = normalStiffness(cellGrid_, pair_, transform.sizeX(), sizeY);
  Vector result = displacement;
  double *field = result.data();
  transform.multiply(&field, [&](int kx, Complex *const *column) {
    const double *s = &stiffnessZZ_[std::size_t(kx) * countY];
    forFrequencies(sizeY, [&](int ky, int bin, double) { column[0][ky] *= s[bin]; });
  });
  return result;
}

const SymmetricSymbol &PatchHalfSpace::stiffnessOf(const PlaneTransform &transform)
{
  if (stiffness_.xx.empty())
    stiffness_ = tangentialStiffness(cellGrid_, pair_, transform.sizeX(), transform.sizeY());
  return stiffness_;
}

TangentialField PatchHalfSpace::tractionEstimate(const TangentialField &displacement)
{
  TangentialField result = displacement;
  double *fields[] = {result.x.data(), result.y.data()};
  PlaneTransform &transform = wrapping(2);
  multiplyBySymmetric(transform, fields, fields, stiffnessOf(transform));
  return result;
}

QuickTractions &PatchHalfSpace::quickTractions()
{
  if (!quickTractions_)
    quickTractions_ = std::make_unique<QuickTractions>(cellGrid_, pair_, influence());
  return *quickTractions_;
}

// A slipping cell's equation is that of a surface under a layer that gives way by D. What counts is
// the displacement less that of a cell upstream: a wave's factor 1 - exp(i kx dx). Both are
// diagonal in waves, too, and so is the inverse of their sum.
TangentialField PatchHalfSpace::softenedEstimate(const TangentialField &displacement, double D)
{
  TangentialField result = displacement;
  double *fields[] = {result.x.data(), result.y.data()};
  PlaneTransform &transform = wrapping(2);
  const int sizeX = transform.sizeX(), sizeY = transform.sizeY();
  const int countY = sizeY / 2 + 1;
  const SymmetricSymbol &K = stiffnessOf(transform);
  const double bins = double(sizeX) * sizeY; // the stiffnesses contain 1/bins
  transform.multiply(fields, [&](int kx, Complex *const *column) {
    const std::size_t at = std::size_t(kx) * countY;
    const Complex ahead = 1.0 - std::polar(1.0, 2.0 * pi * kx / sizeX);
    forFrequencies(sizeY, [&](int ky, int bin, double sign) {
      // K (D K + ahead)^-1 with the stiffness K = A^-1
      const double xx = K.xx[at + bin], yy = K.yy[at + bin];
      const double xy = sign * K.xy[at + bin], soft = D * bins;
      const Complex a = soft * xx + ahead, b = soft * yy + ahead;
      const double c = soft * xy;
      const Complex determinant = a * b - c * c;
      const Complex scale = std::conj(determinant) / std::norm(determinant);
      const Complex x = column[0][ky], y = column[1][ky];
      const Complex u = scale * (b * x - c * y), v = scale * (a * y - c * x);
      column[0][ky] = xx * u + xy * v;
      column[1][ky] = xy * u + yy * v;
    });
  });
  return result;
}

// As of a force on a square of all cells' area, (1 - nu) F/(pi G side); only the size counts.
double PatchHalfSpace::displacementScale(double pressureSum) const
{
  const double area = cellGrid_.dx * cellGrid_.dy;
  const double side = std::sqrt(area * cells());
  return pressureSum * area * (1.0 - pair_.nu) / (pi * pair_.G * side);
}

HalfSpace *PatchHalfSpace::coarser()
{
  const auto halves = [](int n) { return n == 1 || n % 2 == 0; };
  const CellGrid &g = cellGrid_;
  if (std::max(g.nx, g.ny) < 2 * coarsestGrid || !halves(g.nx) || !halves(g.ny))
    return nullptr;
  if (coarser_)
    return coarser_.get();
  const bool alongX = g.nx > 1, alongY = g.ny > 1;
  const CellGrid grid{alongX ? g.nx / 2 : 1, alongY ? g.ny / 2 : 1, alongX ? 2.0 * g.dx : g.dx,
                      alongY ? 2.0 * g.dy : g.dy};
  if (alongX && alongY) { // cells of the same shape
    influence();
    coarser_.reset(new PatchHalfSpace(grid, pair_, influence_));
  } else {
    coarser_ = std::make_unique<PatchHalfSpace>(grid, pair_);
  }
  return coarser_.get();
}

QuickProducts *PatchHalfSpace::quick()
{
  if (!quick_ && cells() >= fewestQuickCells)
    quick_ = std::make_unique<QuickHalfSpace>(cellGrid_, pair_, influence());
  return quick_.get();
}

double PatchHalfSpace::tangentialCompliance() const
{
  const CellInfluence own =
      cellInfluence(pair_, cellIntegrals(0.0, 0.0, cellGrid_.dx, cellGrid_.dy));
  return std::max(own.xx, own.yy) + pair_.layer;
}

} // namespace wheelrail
