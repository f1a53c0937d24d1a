// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/patch_coupling.h"

#include "base/errors.h"
#include "shared/pi.h"

#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;
using Complex = PlaneTransform::Complex;

using mcawr::pi;
constexpr int mostTurns = 100; ///< each leaves about mu K of the error
constexpr Complex minusI(0.0, -1.0);

} // namespace

PatchCoupling::PatchCoupling(const CellGrid &grid, const ElasticPair &pair)
    : grid_(grid), strength_(pair.K / (pi * pair.G))
{
}

// Both directions are products with the influences x/r^2 and y/r^2, integrated over a cell. One is
// odd in x and even in y, the other one the other way round. So their spectra are -i times real
// numbers, sine transforms along the odd direction, of which a quarter is kept. Frequencies along x
// are those from 0 on, since the fields are real; along y `forFrequencies` gives the sign of the
// odd ones.
void PatchCoupling::fillSpectra()
{
  transform_.emplace(paddedTransform(grid_.nx, grid_.ny, 2));
  const int sizeX = transform_->sizeX(), sizeY = transform_->sizeY();
  const int countX = sizeX / 2 + 1, countY = sizeY / 2 + 1;
  for (Quarter *quarter : {&x_, &y_})
    quarter->assign(std::size_t(countX) * countY, 0.0);
  const double scale = strength_ / (double(sizeX) * sizeY);
  for (int ix = 0; ix < grid_.nx; ++ix)
    for (int iy = 0; iy < grid_.ny; ++iy) {
      const CouplingIntegrals cell =
          couplingIntegrals(ix * grid_.dx, iy * grid_.dy, grid_.dx, grid_.dy);
      x_[std::size_t(ix) * countY + iy] = scale * cell.x;
      y_[std::size_t(ix) * countY + iy] = scale * cell.y;
    }
  quarterTransform(x_, countX, countY, true, false);
  quarterTransform(y_, countX, countY, false, true);
}

TangentialField PatchCoupling::tangential(const Vector &pressure)
{
  if (!any())
    return {};
  if (!transform_)
    fillSpectra();
  // towards the load: where x > 0 the softer wheel moves to smaller x
  TangentialField result{pressure, Vector::Zero(pressure.size())};
  double *fields[] = {result.x.data(), result.y.data()};
  const int sizeY = transform_->sizeY(), countY = sizeY / 2 + 1;
  transform_->multiply(fields, [&](int kx, Complex *const *column) {
    const double *a = &x_[std::size_t(kx) * countY], *b = &y_[std::size_t(kx) * countY];
    forFrequencies(sizeY, [&](int ky, int bin, double sign) {
      const Complex p = minusI * column[0][ky];
      column[0][ky] = -a[bin] * p;
      column[1][ky] = -sign * b[bin] * p;
    });
  });
  return result;
}

Vector PatchCoupling::normal(const TangentialField &traction)
{
  if (!any())
    return {};
  if (!transform_)
    fillSpectra();
  TangentialField result = traction;
  double *fields[] = {result.x.data(), result.y.data()};
  const int sizeY = transform_->sizeY(), countY = sizeY / 2 + 1;
  transform_->multiply(fields, [&](int kx, Complex *const *column) {
    const double *a = &x_[std::size_t(kx) * countY], *b = &y_[std::size_t(kx) * countY];
    forFrequencies(sizeY, [&](int ky, int bin, double sign) {
      column[0][ky] = minusI * (a[bin] * column[0][ky] + sign * b[bin] * column[1][ky]);
      column[1][ky] = 0.0;
    });
  });
  return result.x;
}

bool PatchCoupling::settled(const Vector &before, const Vector &after)
{
  return (after - before).norm() <= tolerance * after.norm();
}

void PatchCoupling::checkTurns(int turns)
{
  if (turns >= mostTurns)
    throw Error(ExitCode::NotConverged,
                fmt::format("unlike bodies: pressure and traction do not settle after {} turns; "
                            "less friction or less unlike bodies are needed",
                            turns));
}

} // namespace wheelrail
