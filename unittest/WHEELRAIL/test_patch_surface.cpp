// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "contact/patch/solvers/patch_temperature.h"
#include "contact/patch/surfaces/patch_surface.h"
#include "patch_cases.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {
FractalPatch exampleSurface()
{
  FractalPatch s;
  s.rmsSlope = 0.05;
  s.wavelengthMin = 0.25;
  s.wavelengthMax = 2.0;
  s.periodX = 4.0;
  s.periodY = 3.0;
  s.seed = 7;
  return s;
}
} // namespace

TEST(PatchSurface, HasTheSlopeAndHeightAskedFor)
{
  const PatchGrid grid = centredGrid(256, 192, 4.0, 3.0); // one period
  for (const double stretch : {1.0, 4.0}) {
    FractalPatch s = exampleSurface();
    s.stretch = stretch;
    s.wavelengthMax = 1.5;
    const FractalHeights heights(s);
    const Vector z = heights.sampled(grid);
    EXPECT_NEAR(z.mean(), 0.0, 1e-14);
    EXPECT_NEAR(std::sqrt(z.squaredNorm() / grid.cells()), heights.rmsHeight(), 1e-12);
    double along = 0.0, across = 0.0; // central differences, periodic
    for (int iy = 0; iy < grid.ny; ++iy)
      for (int ix = 0; ix < grid.nx; ++ix) {
        const auto at = [&](int jx, int jy) {
          return z[grid.index((jx + grid.nx) % grid.nx, (jy + grid.ny) % grid.ny)];
        };
        along += std::pow((at(ix + 1, iy) - at(ix - 1, iy)) / (2.0 * grid.dx), 2);
        across += std::pow((at(ix, iy + 1) - at(ix, iy - 1)) / (2.0 * grid.dy), 2);
      }
    EXPECT_NEAR(std::sqrt((along + across) / grid.cells()), 0.05, 0.05 * 0.06);
    // features `stretch` times longer along x
    EXPECT_NEAR(std::sqrt(across / along), stretch, 0.15 * stretch);
    s.rmsSlope = 0.0;
    s.rmsHeight = 0.01;
    EXPECT_NEAR(FractalHeights(s).rmsHeight(), 0.01, 1e-15);
  }
}

TEST(PatchSurface, EveryGridSeesTheSameSurface)
{
  const FractalHeights heights(exampleSurface());
  const PatchGrid coarse = centredGrid(64, 48, 4.0, 3.0), fine = centredGrid(192, 144, 4.0, 3.0);
  const Vector a = heights.sampled(coarse), b = heights.sampled(fine);
  for (int iy = 0; iy < coarse.ny; ++iy)
    for (int ix = 0; ix < coarse.nx; ++ix)
      ASSERT_NEAR(a[coarse.index(ix, iy)], b[fine.index(3 * ix + 1, 3 * iy + 1)], 1e-13);
  // A finer cut-off adds waves, in proportion; the same seed repeats, another one does not
  const Vector moved = heights.sampled(coarse, 5.0 * coarse.dx);
  EXPECT_LT((shifted(coarse, a, 5) - moved).head(50).norm(), 1e-12);
  FractalPatch other = exampleSurface();
  other.seed = 8;
  EXPECT_GT((FractalHeights(other).sampled(coarse) - a).norm(), 0.5 * a.norm());
  EXPECT_EQ(FractalHeights(exampleSurface()).sampled(coarse), a);
}

TEST(PatchSurface, RefusesWhatCannotBe)
{
  FractalPatch s = exampleSurface();
  EXPECT_THROW(FractalHeights(s).sampled(centredGrid(40, 48, 4.0, 3.0)), Error);
  s.rmsHeight = 1.0;
  EXPECT_THROW(FractalHeights{s}, Error);
  s.rmsHeight = 0.0;
  s.wavelengthMin = 7.0;
  s.wavelengthMax = 8.0;
  EXPECT_THROW(FractalHeights{s}, Error);
}

TEST(PatchTemperature, RowsAreLineContacts)
{
  // Full sliding on a Hertzian ellipse: row y is a line contact of half-width a sqrt(1 - y^2/b^2)
  // and peak pressure p0 sqrt(1 - y^2/b^2); its mean temperature is Eq. 11's
  const double a = 6e-3, b = 10e-3, p0 = 1e9, mu = 0.3, speed = 20.0, slide = 0.2;
  const ThermalMaterial steel{50.0, 7800.0, 450.0};
  const PatchGrid grid = centredGrid(400, 20, 2.2 * a, 2.0 * b);
  const Vector heat = sampled(grid, [&](double x, double y) {
    const double inside = 1.0 - x * x / (a * a) - y * y / (b * b);
    return inside > 0.0 ? mu * p0 * std::sqrt(inside) * slide : 0.0;
  });
  PatchFlashTemperature flash(grid, grid.dx, speed, steel);
  const Vector theta = flash.rise(heat);
  PatchTravellingHeat travelling(grid, grid.dx, speed, steel);
  for (int step = 0; step < grid.nx; ++step)
    travelling.step(heat);
  EXPECT_LT((travelling.rise() - theta).norm(), 1e-10 * theta.norm());
  for (int iy = 0; iy < grid.ny; ++iy) {
    const double width = std::sqrt(1.0 - std::pow(grid.y(iy) / b, 2));
    double sum = 0.0;
    int cells = 0;
    for (int ix = 0; ix < grid.nx; ++ix)
      if (heat[grid.index(ix, iy)] > 0.0)
        sum += theta[grid.index(ix, iy)], ++cells;
    const double exact = meanTemperatureRise(mu * slide, width * p0, width * a, speed, steel);
    EXPECT_NEAR(sum / cells, exact, 0.01 * exact);
  }
  // The hottest place is in the middle row, a line contact of N' = pi a p0/2
  const double hottest =
      maximumOverMeanTemperature() * meanTemperatureRise(mu * slide, p0, a, speed, steel);
  EXPECT_NEAR(theta.maxCoeff(), hottest, 0.003 * hottest);
}
