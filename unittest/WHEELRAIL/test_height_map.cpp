// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/random_number.h"
#include "contact/patch/surfaces/height_map_steps.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace wheelrail;

namespace {

using mcawr::pi;
const double unmeasuredHeight = std::numeric_limits<double>::quiet_NaN();

template<class Function>
HeightMap mapOf(int nx, int ny, double dx, double dy, const Function &height)
{
  HeightMap map{nx, ny, dx, dy, Eigen::VectorXd(nx * ny)};
  for (int iy = 0; iy < ny; ++iy)
    for (int ix = 0; ix < nx; ++ix)
      map.height[map.index(ix, iy)] = height(ix * dx, iy * dy);
  return map;
}

HeightMap noise(int nx, int ny, double dx, double dy)
{
  std::uint64_t k = 0;
  return mapOf(nx, ny, dx, dy, [&](double, double) { return 1e-6 * uniformNumber(3, k++); });
}

} // namespace

TEST(HeightMap, StatisticsOfAWave)
{
  const double wave = 64e-6, amplitude = 1e-6;
  HeightMap map = mapOf(641, 65, 1e-6, 2e-6, [&](double x, double) {
    return 5e-6 + amplitude * std::sin(2.0 * pi * x / wave);
  });
  map.height[map.index(100, 20)] = unmeasuredHeight;
  const HeightMapStatistics s = heightMapStatistics("rail: as read", map);
  EXPECT_EQ(s.step, "rail: as read");
  EXPECT_EQ(s.unmeasured, 1);
  EXPECT_NEAR(s.rmsHeight, amplitude / std::sqrt(2.0), 2e-3 * amplitude);
  EXPECT_NEAR(s.rmsSlopeX, std::sqrt(2.0) * pi * amplitude / wave, 2e-3 * s.rmsSlopeX);
  EXPECT_NEAR(s.rmsSlopeY, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(s.shortestWavelength, 4e-6);
  EXPECT_DOUBLE_EQ(heightMapStatistics("", map, 1e-5).shortestWavelength, 1e-5);
}

TEST(HeightMap, ATurnPutsXAlongY)
{
  const HeightMap map = mapOf(5, 4, 1e-6, 2e-6, [](double x, double y) { return x + 100.0 * y; });
  const HeightMap turnedMap = turned(map);
  EXPECT_EQ(turnedMap.nx, 4);
  EXPECT_EQ(turnedMap.ny, 5);
  EXPECT_DOUBLE_EQ(turnedMap.dx, 2e-6);
  // along y of the turned map the height grows as it did along x, along x it falls as along -y
  const auto at = [&](int ix, int iy) { return turnedMap.height[turnedMap.index(ix, iy)]; };
  EXPECT_NEAR(at(0, 1) - at(0, 0), 1e-6, 1e-18);
  EXPECT_NEAR(at(1, 0) - at(0, 0), -200e-6, 1e-18);
  EXPECT_EQ(turned(turned(turnedMap)).height, turned(map).height.reverse());
  EXPECT_EQ(turned(turned(turned(turnedMap))).height, map.height);
  EXPECT_EQ(mirrored(mirrored(map)).height, map.height);
  EXPECT_EQ(mirrored(map).height[0], map.height[map.index(0, 3)]);
}

TEST(HeightMap, FormsAreTakenOffExactly)
{
  const HeightMap rough = noise(40, 30, 1e-6, 2e-6);
  for (const Form form : {Form::Mean, Form::Plane, Form::SecondOrder}) {
    HeightMap map = mapOf(40, 30, 1e-6, 2e-6, [&](double x, double y) {
      double z = 3e-3;
      if (form != Form::Mean)
        z += 0.1 * x - 0.3 * y;
      if (form == Form::SecondOrder)
        z += 1e3 * x * x - 2e3 * x * y + 5e2 * y * y;
      return z;
    });
    map.height[map.index(7, 11)] = map.height[0] = unmeasuredHeight; // leaves the others alone
    const HeightMap flat = withoutForm(map, form);
    EXPECT_TRUE(std::isnan(flat.height[0]));
    for (const double z : flat.height) {
      if (!std::isnan(z)) {
        EXPECT_NEAR(z, 0.0, 1e-15);
      }
    }
    // what the form does not hold stays: the residual of residuals is itself
    map.height += rough.height;
    const HeightMap once = withoutForm(map, form), twice = withoutForm(once, form);
    EXPECT_NEAR((once.height - twice.height).tail(1000).cwiseAbs().maxCoeff(), 0.0,
                1e-15); // rounding: 1e-13 of the form, 1e-9 of the roughness
  }
  EXPECT_EQ(withoutForm(rough, Form::None).height, rough.height);
}

TEST(HeightMap, AFormNeedsPointsThatDetermineIt)
{
  const HeightMap line = mapOf(8, 8, 1e-6, 1e-6, [](double x, double y) {
    return y == 0.0 ? x : unmeasuredHeight; // one row measured
  });
  EXPECT_NO_THROW(withoutForm(line, Form::Mean));
  EXPECT_THROW(withoutForm(line, Form::Plane), Error);
}

TEST(HeightMap, HolesInAPlaneAreFilledByThePlane)
{
  const auto plane = [](double x, double y) { return 2e-6 + 0.1 * x - 0.2 * y; };
  const HeightMap whole = mapOf(30, 24, 1e-6, 3e-6, plane);
  HeightMap map = whole;
  for (int iy = 5; iy < 15; ++iy)
    for (int ix = 8; ix < 22; ++ix)
      map.height[map.index(ix, iy)] = unmeasuredHeight;
  map.height[map.index(2, 2)] = unmeasuredHeight;
  ASSERT_EQ(map.unmeasured(), 141);
  const HeightMap result = filled(map);
  EXPECT_EQ(result.unmeasured(), 0);
  EXPECT_LT((result.height - whole.height).cwiseAbs().maxCoeff(), 1e-9 * 15e-6);
}

TEST(HeightMap, FillingMakesNoNewExtremes)
{
  HeightMap map = noise(50, 40, 1e-6, 1e-6);
  const double low = map.height.minCoeff(), high = map.height.maxCoeff();
  for (int k = 0; k < 900; ++k) // holes of all shapes, also at the border
    map.height[static_cast<int>(2000.0 * uniformNumber(9, k))] = unmeasuredHeight;
  for (int iy = 0; iy < 10; ++iy)
    map.height.segment(map.index(0, iy), 12).setConstant(unmeasuredHeight);
  const HeightMap result = filled(map);
  EXPECT_EQ(result.unmeasured(), 0);
  EXPECT_GE(result.height.minCoeff(), low - 1e-15);
  EXPECT_LE(result.height.maxCoeff(), high + 1e-15);
  for (int k = 0; k < map.height.size(); ++k) {
    if (!std::isnan(map.height[k])) {
      EXPECT_NEAR(result.height[k], map.height[k], 1e-18);
    }
  }
}

TEST(HeightMap, MoreHolesThanPointsAreRefused)
{
  HeightMap map = noise(10, 10, 1e-6, 1e-6);
  map.height.head(51).setConstant(unmeasuredHeight);
  EXPECT_THROW(filled(map), Error);
  map.height[0] = 0.0;
  EXPECT_NO_THROW(filled(map));
}

/// Half of a wave is left at the cut-off, whatever its direction; elsewhere ISO 16610-61's
/// exp(-pi (alpha cutoff/wavelength)^2).
TEST(HeightMap, TheFilterTransmitsAsTheStandardSays)
{
  const int n = 301;
  const double dx = 1e-6, dy = 1.5e-6, cutoff = 40e-6;
  for (const double angle : {0.0, 0.5, 1.2})
    for (const double wavelength : {25e-6, 40e-6, 80e-6}) {
      const double kx = 2.0 * pi / wavelength * std::cos(angle);
      const double ky = 2.0 * pi / wavelength * std::sin(angle);
      const HeightMap map = mapOf(n, n, dx, dy, [&](double x, double y) {
        return std::cos(kx * (x - 150.0 * dx) + ky * (y - 150.0 * dy));
      });
      const double left = lowPassed(map, cutoff).height[map.index(150, 150)];
      const double expected = std::exp(-std::log(2.0) * std::pow(cutoff / wavelength, 2));
      EXPECT_NEAR(left, expected, 2e-5) << angle << ' ' << wavelength; // weights end at 3e-6
    }
}

TEST(HeightMap, TheFilterKeepsAConstantUpToTheBorder)
{
  const HeightMap map = mapOf(30, 20, 1e-6, 1e-6, [](double, double) { return 4e-6; });
  EXPECT_LT((lowPassed(map, 8e-6).height.array() - 4e-6).abs().maxCoeff(), 1e-20);
}

TEST(HeightMap, CutOffsOutsideOfTheMapAreRefused)
{
  HeightMap map = noise(30, 20, 1e-6, 1e-6);
  EXPECT_THROW(lowPassed(map, 1.9e-6), Error);
  EXPECT_THROW(lowPassed(map, 20e-6), Error);
  EXPECT_THROW(lowPassed(map, unmeasuredHeight), Error);
  map.height[3] = unmeasuredHeight;
  EXPECT_THROW(lowPassed(map, 8e-6), Error);
}

TEST(HeightMap, MeansOverCellsOfAPlaneAreItsHeightsAtTheCentres)
{
  const HeightMap map = mapOf(41, 31, 1e-6, 2e-6, [](double x, double y) {
    return 0.1 * (x - 20e-6) - 0.2 * (y - 30e-6); // 0 in the middle
  });
  const double mm = 1e-3;
  for (const int cells : {3, 16, 100}) { // larger and smaller than the map's spacing
    const PatchGrid grid = centredGrid(cells, cells + 1, 0.04, 0.05);
    const Eigen::VectorXd z = resampled(map, grid, mm);
    for (int iy = 0; iy < grid.ny; ++iy)
      for (int ix = 0; ix < grid.nx; ++ix)
        EXPECT_NEAR(z[grid.index(ix, iy)], 0.1 * grid.x(ix) - 0.2 * grid.y(iy), 1e-15);
    const Eigen::VectorXd moved = resampled(map, centredGrid(cells, cells, 0.03, 0.03), mm, 2e-3);
    EXPECT_NEAR(moved.mean(), -0.1 * 2e-3, 1e-15); // the map's middle lies at x = 2 um
  }
}

/// The volume over the cells is that of the bilinear surface, whatever the cells.
TEST(HeightMap, MeansOverCellsKeepTheVolume)
{
  const HeightMap map = noise(23, 17, 1e-6, 2e-6);
  double volume = 0.0; // of the bilinear surface over the whole map
  for (int iy = 0; iy + 1 < map.ny; ++iy)
    for (int ix = 0; ix + 1 < map.nx; ++ix)
      volume += 0.25 * map.dx * map.dy *
                (map.height[map.index(ix, iy)] + map.height[map.index(ix + 1, iy)] +
                 map.height[map.index(ix, iy + 1)] + map.height[map.index(ix + 1, iy + 1)]);
  for (const int cells : {1, 7, 22, 90}) {
    const PatchGrid grid = centredGrid(cells, 2 * cells, map.width(), map.depth());
    EXPECT_NEAR(resampled(map, grid, 1.0).sum() * grid.cellArea(), volume, 1e-12 * volume);
  }
}

TEST(HeightMap, CellsBeyondTheMapAreRefused)
{
  const HeightMap map = noise(11, 11, 1e-6, 1e-6);
  EXPECT_NO_THROW(resampled(map, centredGrid(5, 5, 10e-6, 10e-6), 1.0));
  EXPECT_THROW(resampled(map, centredGrid(5, 5, 10.1e-6, 10e-6), 1.0), Error);
  EXPECT_THROW(resampled(map, centredGrid(5, 5, 10e-6, 10e-6), 1.0, 0.0, 1e-7), Error);
  const PatchGrid grid = coveredGrid(map, 3e-3, 2e-3, 1e-3); // um cells in a grid of mm
  EXPECT_EQ(grid.nx, 3);
  EXPECT_EQ(grid.ny, 5);
  EXPECT_DOUBLE_EQ(grid.left, -4.5e-3);
  EXPECT_NO_THROW(resampled(map, grid, 1e-3));
  EXPECT_THROW(coveredGrid(map, 11e-3, 1e-3, 1e-3), Error);
  EXPECT_THROW(coveredGrid(map, 1e-9, 1e-9, 1e-3), Error);
}
