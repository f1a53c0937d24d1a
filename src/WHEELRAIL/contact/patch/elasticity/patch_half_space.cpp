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
//
// Influence at a distance of whole cells is even in x and y (xy: odd in both), so a quarter of the
// plane holds all of it, and cosine (sine) transforms give the quarter of its spectrum.
void PatchHalfSpace::fillSpectra()
{
  const auto [sizeX, sizeY] = fastPlaneSize(2 * cellGrid_.nx, 2 * cellGrid_.ny);
  const int countX = sizeX / 2 + 1, countY = sizeY / 2 + 1;
  for (Quarter *quarter : {&yy_, &xx_, &xy_})
    quarter->assign(std::size_t(countX) * countY, 0.0);
  for (int ix = 0; ix < cellGrid_.nx; ++ix)
    for (int iy = 0; iy < cellGrid_.ny; ++iy) {
      const std::size_t at = std::size_t(ix) * countY + iy;
      const CellIntegrals &cell = influence().at(ix, iy);
      yy_[at] = cell.yy;
      xx_[at] = cell.xx;
      xy_[at] = cell.xy;
    }
  quarterTransform(yy_, countX, countY, false, false);
  quarterTransform(xx_, countX, countY, false, false);
  quarterTransform(xy_, countX, countY, true, true);
  const double scale = cellGrid_.dx / (pi * pair_.G * sizeX * sizeY);
  for (std::size_t i = 0; i < yy_.size(); ++i) {
    yy_[i] *= scale;
    xx_[i] *= scale;
    xy_[i] *= -scale; // odd in both directions: the product of two factors -i
  }
}

// An approximate inverse. On cells that repeat with the box a wave of tractions gives a wave of
// displacements: normal ones are multiplied by a number, tangential ones by a symmetric 2 x 2
// matrix. The inverse of these, wave by wave, is the inverse of the repeated contact. It differs
// from that of the real one by the copies' influence, which is smooth, so that it serves as a
// preconditioner, and needs transforms of the box itself, a quarter of the size.
void PatchHalfSpace::fillEstimates()
{
  const auto [sizeX, sizeY] = fastPlaneSize(cellGrid_.nx, cellGrid_.ny);
  const int countX = sizeX / 2 + 1, countY = sizeY / 2 + 1;
  for (Quarter *quarter : {&stiffnessXX_, &stiffnessYY_, &stiffnessXY_})
    quarter->resize(std::size_t(countX) * countY);
  const PeriodicInfluence influence(cellGrid_, sizeX, sizeY);
  const double scale = pi * pair_.G / (double(sizeX) * sizeY), less = 1.0 - pair_.nu;
  for (int kx = 0; kx < countX; ++kx)
    for (int ky = 0; ky < countY; ++ky) {
      const std::size_t at = std::size_t(kx) * countY + ky;
      CellIntegrals cell = influence.at(kx, ky);
      // at the highest frequency +k and -k are the same: the odd part vanishes
      if (2 * kx == sizeX || 2 * ky == sizeY)
        cell.xy = 0.0;
      const double soft = pi * pair_.G * pair_.layer; // the same for all waves
      const double a = less * cell.yy + cell.xx + soft, b = cell.yy + less * cell.xx + soft;
      const double c = pair_.nu * cell.xy, determinant = a * b - c * c;
      // the matrix {{a, c}, {c, b}} multiplies a wave's tractions, (a b - c^2)^-1 {{b, -c}, {-c,
      // a}} its displacements
      stiffnessXX_[at] = scale * b / determinant;
      stiffnessYY_[at] = scale * a / determinant;
      stiffnessXY_[at] = -scale * c / determinant;
    }
}

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
  if (yy_.empty())
    fillSpectra();
  TangentialField result = traction;
  double *fields[] = {result.x.data(), result.y.data()};
  PlaneTransform &transform = padded(2);
  const int sizeY = transform.sizeY(), countY = sizeY / 2 + 1;
  const double less = 1.0 - pair_.nu;
  const double soft = pair_.layer / (double(transform.sizeX()) * sizeY);
  transform.multiply(fields, [&](int kx, Complex *const *column) {
    const std::size_t at = std::size_t(kx) * countY;
    const double *a = &yy_[at], *b = &xx_[at], *c = &xy_[at];
    forFrequencies(sizeY, [&](int ky, int bin, double sign) {
      const Complex x = column[0][ky], y = column[1][ky];
      const double cross = sign * pair_.nu * c[bin];
      column[0][ky] = (less * a[bin] + b[bin] + soft) * x + cross * y;
      column[1][ky] = cross * x + (a[bin] + less * b[bin] + soft) * y;
    });
  });
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

TangentialField PatchHalfSpace::tractionEstimate(const TangentialField &displacement)
{
  if (stiffnessXX_.empty())
    fillEstimates();
  TangentialField result = displacement;
  double *fields[] = {result.x.data(), result.y.data()};
  PlaneTransform &transform = wrapping(2);
  const int sizeY = transform.sizeY(), countY = sizeY / 2 + 1;
  transform.multiply(fields, [&](int kx, Complex *const *column) {
    const std::size_t at = std::size_t(kx) * countY;
    forFrequencies(sizeY, [&](int ky, int bin, double sign) {
      const Complex x = column[0][ky], y = column[1][ky];
      const double cross = sign * stiffnessXY_[at + bin];
      column[0][ky] = stiffnessXX_[at + bin] * x + cross * y;
      column[1][ky] = cross * x + stiffnessYY_[at + bin] * y;
    });
  });
  return result;
}

// A slipping cell's equation is that of a surface under a layer that gives way by D. What counts is
// the displacement less that of a cell upstream: a wave's factor 1 - exp(i kx dx). Both are
// diagonal in waves, too, and so is the inverse of their sum.
TangentialField PatchHalfSpace::softenedEstimate(const TangentialField &displacement, double D)
{
  if (stiffnessXX_.empty())
    fillEstimates();
  TangentialField result = displacement;
  double *fields[] = {result.x.data(), result.y.data()};
  PlaneTransform &transform = wrapping(2);
  const int sizeX = transform.sizeX(), sizeY = transform.sizeY();
  const int countY = sizeY / 2 + 1;
  const double bins = double(sizeX) * sizeY; // the stiffnesses contain 1/bins
  transform.multiply(fields, [&](int kx, Complex *const *column) {
    const std::size_t at = std::size_t(kx) * countY;
    const Complex ahead = 1.0 - std::polar(1.0, 2.0 * pi * kx / sizeX);
    forFrequencies(sizeY, [&](int ky, int bin, double sign) {
      // K (D K + ahead)^-1 with the stiffness K = A^-1
      const double xx = stiffnessXX_[at + bin], yy = stiffnessYY_[at + bin];
      const double xy = sign * stiffnessXY_[at + bin], soft = D * bins;
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
