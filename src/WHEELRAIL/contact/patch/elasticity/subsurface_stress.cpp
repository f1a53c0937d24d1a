// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/subsurface_stress.h"

#include <cmath>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;
using Complex = PlaneTransform::Complex;

constexpr int loads = 3; ///< pressure, traction along x, along y

/// Is the influence odd in x, in y? The pressure's is odd where a component has that direction
/// once; a traction along a direction adds one.
bool isOdd(int component, int load, int direction)
{
  constexpr bool once[stressComponents][2] = {{false, false}, {false, false}, {false, false},
                                              {true, true},   {false, true},  {true, false}};
  return once[component][direction] != (load == direction + 1);
}

/// A traction along y is one along x with both axes exchanged.
constexpr int exchanged[stressComponents] = {StressYY, StressXX, StressZZ,
                                             StressXY, StressZX, StressYZ};

} // namespace

SubsurfaceStress::SubsurfaceStress(const PatchGrid &grid, double nu)
    : grid_(grid), nu_(nu), transform_(paddedTransform(grid.nx, grid.ny, stressComponents))
{
}

void SubsurfaceStress::fillSpectra(double depth)
{
  const int sizeX = transform_.sizeX(), sizeY = transform_.sizeY();
  const int countX = sizeX / 2 + 1, countY = sizeY / 2 + 1;
  const double scale = 1.0 / (double(sizeX) * sizeY);
  for (auto &ofLoad : spectra_)
    for (Quarter &quarter : ofLoad)
      quarter.assign(std::size_t(countX) * countY, 0.0);
  for (int ix = 0; ix < grid_.nx; ++ix)
    for (int iy = 0; iy < grid_.ny; ++iy) {
      const std::size_t at = std::size_t(ix) * countY + iy;
      const double x = ix * grid_.dx, y = iy * grid_.dy;
      const CellStress cell = cellStress(x, y, depth, grid_.dx, grid_.dy, nu_);
      const CellStress turned = cellStress(y, x, depth, grid_.dy, grid_.dx, nu_);
      for (int n = 0; n < stressComponents; ++n) {
        spectra_[0][n][at] = scale * cell.pressure[n];
        spectra_[1][n][at] = scale * cell.alongX[n];
        spectra_[2][n][at] = scale * turned.alongX[exchanged[n]];
      }
    }
  for (int load = 0; load < loads; ++load)
    for (int n = 0; n < stressComponents; ++n)
      quarterTransform(spectra_[load][n], countX, countY, isOdd(n, load, 0), isOdd(n, load, 1));
}

StressField SubsurfaceStress::at(double depth, const Vector &pressure,
                                 const TangentialField &traction)
{
  fillSpectra(depth);
  StressField stress;
  stress[0] = pressure;
  stress[1] = traction.x;
  stress[2] = traction.y;
  double *fields[stressComponents];
  for (int n = 0; n < stressComponents; ++n) {
    if (n >= loads)
      stress[n] = Vector::Zero(grid_.cells());
    fields[n] = stress[n].data();
  }
  const int sizeY = transform_.sizeY(), countY = sizeY / 2 + 1;
  transform_.multiply(fields, [&](int kx, Complex *const *column) {
    const std::size_t from = std::size_t(kx) * countY;
    forFrequencies(sizeY, [&](int ky, int bin, double sign) {
      const Complex given[loads] = {column[0][ky], column[1][ky], column[2][ky]};
      for (int n = 0; n < stressComponents; ++n) {
        Complex sum = 0.0;
        for (int load = 0; load < loads; ++load) {
          Complex factor = spectra_[load][n][from + bin];
          if (isOdd(n, load, 0)) // a factor -i for each odd direction
            factor *= Complex(0.0, -1.0);
          if (isOdd(n, load, 1))
            factor *= Complex(0.0, -sign);
          sum += factor * given[load];
        }
        column[n][ky] = sum;
      }
    });
  });
  return stress;
}

StressPeaks stressPeaks(const PatchGrid &grid, const StressField &stress)
{
  StressPeaks peaks;
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      StressTensor here;
      for (int n = 0; n < stressComponents; ++n)
        here[n] = stress[n][grid.index(ix, iy)];
      const auto take = [&](StressPeak &peak, double value) {
        if (value > peak.value)
          peak = {value, grid.x(ix), grid.y(iy)};
      };
      take(peaks.vonMises, vonMises(here));
      take(peaks.maximumShear, maximumShear(here));
      take(peaks.orthogonalShear, std::abs(here[StressZX]));
    }
  return peaks;
}

} // namespace wheelrail
