// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/subsurface_stress.h"
#include "patch_cases.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {

using mcawr::pi;

/// Stress of a unit force on a point of the surface, along z (Boussinesq) and along x (Cerruti); K.
/// L. Johnson, Contact Mechanics, Eqs. 3.19 and 3.75. The slow reference: other formulas than those
/// under test.
CellStress ofPoint(double x, double y, double z, double nu)
{
  const double R = std::sqrt(x * x + y * y + z * z), r2 = x * x + y * y, e = 1.0 - 2.0 * nu;
  const double R3 = R * R * R, R5 = R3 * R * R, s = R + z;
  const double a = 1.0 / (R * s * s), b = 1.0 / (R3 * s * s) + 2.0 / (R * R * s * s * s);
  CellStress stress{
      {e / r2 * ((1 - z / R) * (x * x - y * y) / r2 + z * y * y / R3) - 3 * z * x * x / R5,
       e / r2 * ((1 - z / R) * (y * y - x * x) / r2 + z * x * x / R3) - 3 * z * y * y / R5,
       -3 * z * z * z / R5,
       e / r2 * ((1 - z / R) * 2 * x * y / r2 - x * y * z / R3) - 3 * x * y * z / R5,
       -3 * y * z * z / R5, -3 * x * z * z / R5},
      {-3 * x * x * x / R5 + e * (x / R3 - 3 * x * a + x * x * x * b),
       -3 * x * y * y / R5 + e * (x / R3 - x * a + x * y * y * b), -3 * x * z * z / R5,
       -3 * x * x * y / R5 + e * (-y * a + x * x * y * b), -3 * x * y * z / R5,
       -3 * x * x * z / R5}};
  for (int n = 0; n < stressComponents; ++n) {
    stress.pressure[n] /= 2 * pi;
    stress.alongX[n] /= 2 * pi;
  }
  return stress;
}

/// Its integral over a cell, by the mean of many points.
CellStress ofPoints(double x, double y, double z, double dx, double dy, double nu)
{
  constexpr int points = 300;
  CellStress sum{};
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j) {
      const double u = ((i + 0.5) / points - 0.5) * dx, v = ((j + 0.5) / points - 0.5) * dy;
      const CellStress one = ofPoint(x - u, y - v, z, nu);
      for (int n = 0; n < stressComponents; ++n) {
        sum.pressure[n] += one.pressure[n] * dx * dy / (points * points);
        sum.alongX[n] += one.alongX[n] * dx * dy / (points * points);
      }
    }
  return sum;
}

/// Hertz's pressure on a circle of radius 1, p0 = 1, and mu times it along x.
struct HertzCircle {
  PatchGrid grid = centredGrid(81, 81, 2.2, 2.2);
  Vector pressure = sampled(
      grid, [](double x, double y) { return std::sqrt(std::max(0.0, 1.0 - x * x - y * y)); });
  StressPeaks peaks(double depth, double mu = 0.0)
  {
    SubsurfaceStress space(grid, 0.3);
    return stressPeaks(grid, space.at(depth, pressure, {mu * pressure, 0.0 * pressure}));
  }
};

} // namespace

TEST(Subsurface, OneLoadedCellIsTheSumOfPoints)
{
  for (const double nu : {0.0, 0.3, 0.5})
    for (const auto &[x, y, z] : std::vector<std::array<double, 3>>{{0.7, -0.3, 0.8},
                                                                    {2.0, 1.0, 0.5},
                                                                    {-1.3, 0.2, 0.4},
                                                                    {0.1, 0.05, 1.0},
                                                                    {0.0, -0.7, 0.3}}) {
      const CellStress exact = cellStress(x, y, z, 1.0, 0.8, nu);
      const CellStress slow = ofPoints(x, y, z, 1.0, 0.8, nu);
      for (int n = 0; n < stressComponents; ++n) { // the mean of points is of second order
        EXPECT_NEAR(exact.pressure[n], slow.pressure[n], 2e-5) << n << " at " << x << ", " << z;
        EXPECT_NEAR(exact.alongX[n], slow.alongX[n], 2e-5) << n << " at " << x << ", " << z;
      }
    }
}

// At the surface the stress is the load on it; far below, that of a force.
TEST(Subsurface, LimitsOfDepth)
{
  const CellStress shallow = cellStress(0.1, 0.1, 1e-9, 1.0, 1.0, 0.3);
  EXPECT_NEAR(shallow.pressure[StressZZ], -1.0, 1e-8);
  EXPECT_NEAR(shallow.alongX[StressZX], -1.0, 1e-8);
  const CellStress beside = cellStress(0.9, 0.1, 1e-9, 1.0, 1.0, 0.3);
  EXPECT_NEAR(beside.pressure[StressZZ], 0.0, 1e-8);
  EXPECT_NEAR(beside.alongX[StressZX], 0.0, 1e-8);
  const double deep = 200.0;
  EXPECT_NEAR(cellStress(0.0, 0.0, deep, 1.0, 1.0, 0.3).pressure[StressZZ] * deep * deep,
              -3.0 / (2.0 * pi), 1e-4);
}

TEST(Subsurface, FieldsAreSumsOverCells)
{
  const PatchGrid grid = patch_cases::gridFrom(9, 6, 0.7, -1.0, -2.0);
  const double nu = 0.28, depth = 0.6;
  const int n = grid.cells();
  Vector p(n), qx(n), qy(n);
  for (int i = 0; i < n; ++i)
    p[i] = std::sin(3.0 * i), qx[i] = std::cos(2.0 * i), qy[i] = std::sin(5.0 * i + 1.0);
  SubsurfaceStress space(grid, nu);
  const StressField stress = space.at(depth, p, {qx, qy});
  for (int i = 0; i < n; ++i) {
    StressTensor sum{};
    for (int j = 0; j < n; ++j) {
      const double x = grid.x(i % grid.nx) - grid.x(j % grid.nx);
      const double y = grid.y(i / grid.nx) - grid.y(j / grid.nx);
      const CellStress along = cellStress(x, y, depth, grid.dx, grid.dy, nu);
      const StressTensor across = cellStress(y, x, depth, grid.dy, grid.dx, nu).alongX;
      const int turned[] = {StressYY, StressXX, StressZZ, StressXY, StressZX, StressYZ};
      for (int c = 0; c < stressComponents; ++c)
        sum[c] += along.pressure[c] * p[j] + along.alongX[c] * qx[j] + across[turned[c]] * qy[j];
    }
    for (int c = 0; c < stressComponents; ++c)
      EXPECT_NEAR(stress[c][i], sum[c], 1e-13);
  }
}

// On the axis of a sphere (nu 0.3): zz = -1/(1 + z^2), xx = yy = -(1 + nu)(1 - z atan(1/z)) + 1/(2
// (1 + z^2)); the largest shear is 0.310 p0 at a depth of 0.481 a (Hertz; Johnson, Eq. 3.45).
TEST(Subsurface, HertzOnTheAxis)
{
  HertzCircle circle;
  SubsurfaceStress space(circle.grid, 0.3);
  const Vector none = Vector::Zero(circle.grid.cells());
  const int middle = circle.grid.index(40, 40);
  for (const double z : {0.1, 0.481, 1.0, 2.0}) {
    const StressField stress = space.at(z, circle.pressure, {none, none});
    const double zz = -1.0 / (1.0 + z * z);
    const double xx = -1.3 * (1.0 - z * std::atan(1.0 / z)) + 0.5 / (1.0 + z * z);
    EXPECT_NEAR(stress[StressZZ][middle], zz, 1e-3);
    EXPECT_NEAR(stress[StressXX][middle], xx, 1e-3);
    EXPECT_NEAR(stress[StressYY][middle], xx, 1e-3);
    EXPECT_NEAR(stress[StressZX][middle], 0.0, 1e-12);
  }
  double highest = 0.0, where = 0.0;
  for (double z = 0.4; z < 0.56; z += 0.01)
    if (const StressPeak peak = circle.peaks(z).maximumShear; peak.value > highest) {
      highest = peak.value;
      where = z;
    }
  EXPECT_NEAR(highest, 0.310, 1e-3);
  EXPECT_NEAR(where, 0.481, 0.011);
}

// A sphere that slides: friction of 0.3 brings the largest von Mises stress up to the surface (J.
// Hamilton, Proc. Instn. Mech. Engrs. 197C (1983) 53); the orthogonal shear without friction is
// 0.214 p0 at 0.35 a (the circle of Lundberg and Palmgren).
TEST(Subsurface, SlidingSphere)
{
  HertzCircle circle;
  EXPECT_NEAR(circle.peaks(0.35).orthogonalShear.value, 0.214, 2e-3);
  EXPECT_GT(circle.peaks(0.48).vonMises.value, 2.0 * circle.peaks(0.02).vonMises.value);
  EXPECT_GT(circle.peaks(0.02, 0.5).vonMises.value, circle.peaks(0.48, 0.5).vonMises.value);
  // the sign of the traction mirrors the field
  const StressPeak there = circle.peaks(0.3, 0.4).vonMises, back = circle.peaks(0.3, -0.4).vonMises;
  EXPECT_NEAR(there.value, back.value, 1e-12);
  EXPECT_NEAR(there.x, -back.x, 1e-12);
}

TEST(Subsurface, Invariants)
{
  EXPECT_NEAR(vonMises({0, 0, 0, 0, 0, 2.0}), 2.0 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(maximumShear({0, 0, 0, 0, 0, 2.0}), 2.0, 1e-14);
  EXPECT_NEAR(vonMises({5, 5, 5, 0, 0, 0}), 0.0, 1e-14);
  EXPECT_NEAR(maximumShear({1, -3, 0, 0, 0, 0}), 2.0, 1e-14);
}
