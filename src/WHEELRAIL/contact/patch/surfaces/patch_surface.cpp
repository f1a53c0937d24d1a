// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/surfaces/patch_surface.h"

#include "base/errors.h"
#include "base/random_number.h"
#include "shared/pi.h"

#include <cmath>
#include <complex>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Complex = std::complex<double>;

using mcawr::pi;
constexpr double fewestCellsPerWave = 4.0;

/// Number of a wave, equal for that wave in any surface, whatever the highest.
std::uint64_t waveNumber(int m, int n)
{
  constexpr std::int64_t offset = 1 << 24;
  return (static_cast<std::uint64_t>(m + offset) << 32) | static_cast<std::uint64_t>(n + offset);
}

/// exp(i k x) for the wave numbers unit*(first + column) at the places of the rows.
template<class Place>
Eigen::MatrixXcd phases(int rows, const Place &place, double unit, int first, int columns)
{
  Eigen::MatrixXcd e(rows, columns);
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i)
      e(i, j) = std::polar(1.0, unit * (first + j) * place(i));
  return e;
}

} // namespace

FractalHeights::FractalHeights(const FractalPatch &s)
    : unitX_(2.0 * pi / s.periodX), unitY_(2.0 * pi / s.periodY)
{
  if ((s.rmsSlope > 0.0) == (s.rmsHeight > 0.0))
    throw Error(ExitCode::BadInput, fmt::format("roughness: one of rms_slope ({}) and rms_height "
                                                "({}) must be > 0, the other left out",
                                                s.rmsSlope, s.rmsHeight));
  const double alongX = std::sqrt(s.stretch), alongY = 1.0 / alongX;
  const double lowest = 2.0 * pi / s.wavelengthMax, highest = 2.0 * pi / s.wavelengthMin;
  highestX_ = static_cast<int>(highest / (alongX * unitX_) * (1.0 + 1e-12));
  highestY_ = static_cast<int>(highest / (alongY * unitY_) * (1.0 + 1e-12));
  amplitude_ = Eigen::MatrixXcd::Zero(2 * highestX_ + 1, highestY_ + 1);
  double squares = 0.0, slopes = 0.0;
  for (int n = 0; n <= highestY_; ++n)
    for (int m = n == 0 ? 1 : -highestX_; m <= highestX_; ++m) {
      const double kx = m * unitX_, ky = n * unitY_;
      const double k = std::hypot(alongX * kx, alongY * ky); // of the surface before stretching
      if (k < lowest * (1.0 - 1e-12) || k > highest * (1.0 + 1e-12))
        continue;
      const double size = std::pow(k / lowest, -(s.hurst + 1.0));
      amplitude_(m + highestX_, n) =
          std::polar(size, 2.0 * pi * uniformNumber(s.seed, waveNumber(m, n)));
      squares += 0.5 * size * size;
      slopes += 0.5 * size * size * (kx * kx + ky * ky);
      ++waves_;
    }
  if (waves_ == 0)
    throw Error(ExitCode::BadInput,
                fmt::format("roughness: no wave between wavelength_min and wavelength_max, {:.4g} "
                            "and {:.4g} mm, has a whole number of periods in {:.4g} x {:.4g} mm",
                            s.wavelengthMin * 1e3, s.wavelengthMax * 1e3, s.periodX * 1e3,
                            s.periodY * 1e3));
  const double scale =
      s.rmsSlope > 0.0 ? s.rmsSlope / std::sqrt(slopes) : s.rmsHeight / std::sqrt(squares);
  amplitude_ *= scale;
  rmsHeight_ = scale * std::sqrt(squares);
  rmsSlope_ = scale * std::sqrt(slopes);
}

Eigen::VectorXd FractalHeights::sampled(const PatchGrid &grid, double travelled) const
{
  const double shortestX = 2.0 * pi / (unitX_ * std::max(1, highestX_));
  const double shortestY = 2.0 * pi / (unitY_ * std::max(1, highestY_));
  if (fewestCellsPerWave * grid.dx > shortestX * (1.0 + 1e-9) ||
      fewestCellsPerWave * grid.dy > shortestY * (1.0 + 1e-9))
    throw Error(
        ExitCode::BadInput,
        fmt::format("cells: those of {:.4g} x {:.4g} mm cannot carry waves of {:.4g} mm along x "
                    "and {:.4g} mm along y; four cells a wave are needed, eight are better",
                    grid.dx * 1e3, grid.dy * 1e3, shortestX * 1e3, shortestY * 1e3));
  // Sum over waves of Re[c exp(i kx x) exp(i ky y)]: two products of matrices
  const Eigen::MatrixXcd ex = phases(
      grid.nx, [&](int ix) { return grid.x(ix) + travelled; }, unitX_, -highestX_,
      2 * highestX_ + 1);
  const Eigen::MatrixXcd ey = phases(
      grid.ny, [&](int iy) { return grid.y(iy); }, unitY_, 0, highestY_ + 1);
  const Eigen::MatrixXcd rows = ex * amplitude_;
  const Eigen::MatrixXd height =
      rows.real() * ey.real().transpose() - rows.imag() * ey.imag().transpose();
  return Eigen::Map<const Eigen::VectorXd>(height.data(), grid.cells());
}

} // namespace wheelrail
