// SPDX-License-Identifier: GPL-2.0-or-later
#include "patch_cases.h"

#include "contact/convolution.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

namespace {
using mcawr::pi;
}

TEST(PatchHalfSpace, OneCell)
{
  // (1 - nu)/(pi G) 4 asinh 1, and the same times (2 - nu)/(2 (1 - nu)): exact
  PatchHalfSpace space({1, 1, 1.0, 1.0}, {1.0, 0.28});
  const Vector one = Vector::Ones(1);
  EXPECT_NEAR(space.displacement(one)[0], 0.80798379, 0.5e-8);
  EXPECT_NEAR(space.displacement(TangentialField{one, Vector::Zero(1)}).x[0], 0.96509175, 0.5e-8);
  EXPECT_NEAR(space.displacement(one)[0], 0.72 / pi * 4.0 * std::asinh(1.0), 1e-15);
}

TEST(PatchHalfSpace, ProductsAreSumsOverCells)
{
  const CellGrid grid{13, 6, 1.0, 1.7};
  const ElasticPair pair{2.0, 0.35};
  PatchHalfSpace space(grid, pair);
  const int n = grid.cells();
  Vector p(n), qx(n), qy(n);
  for (int i = 0; i < n; ++i)
    p[i] = std::sin(3.0 * i), qx[i] = std::cos(2.0 * i), qy[i] = std::sin(5.0 * i + 1.0);
  const Vector u = space.displacement(p);
  const TangentialField t = space.displacement(TangentialField{qx, qy});
  for (int i = 0; i < n; ++i) {
    double sum = 0.0, sumX = 0.0, sumY = 0.0;
    for (int j = 0; j < n; ++j) {
      const double x = (i % grid.nx - j % grid.nx) * grid.dx;
      const double y = (i / grid.nx - j / grid.nx) * grid.dy;
      const CellInfluence k = cellInfluence(pair, cellIntegrals(x, y, grid.dx, grid.dy));
      // (2 - nu)/(1 - nu) Kzz is the trace of the tangential influence
      EXPECT_NEAR(k.xx + k.yy, (2.0 - pair.nu) / (1.0 - pair.nu) * k.zz, 1e-15);
      sum += k.zz * p[j];
      sumX += k.xx * qx[j] + k.xy * qy[j];
      sumY += k.xy * qx[j] + k.yy * qy[j];
    }
    EXPECT_NEAR(u[i], sum, 1e-14);
    EXPECT_NEAR(t.x[i], sumX, 1e-14);
    EXPECT_NEAR(t.y[i], sumY, 1e-14);
  }
}

TEST(PatchHalfSpace, FarCellsHaveTheInfluenceOfTheirParts)
{
  // Sixteen parts of a cell, each by the corners' formula, against the quadrature of the whole
  for (const double x : {19.9, 20.1, 100.0, 499.0, 501.0, 2000.0}) {
    CellIntegrals sum{0.0, 0.0, 0.0};
    const int parts = 256;
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        // the far parts' own size is so small that the midpoint is as good as exact
        const double u = x + (i + 0.5) / parts - 0.5, v = 7.0 + (j + 0.5) / parts - 0.5;
        const double density = 1.0 / (std::pow(std::hypot(u, v), 3) * parts * parts);
        sum.yy += density * v * v;
        sum.xx += density * u * u;
        sum.xy += density * u * v;
      }
    const CellIntegrals whole = cellIntegrals(x, 7.0, 1.0, 1.0);
    const double r = std::hypot(x, 7.0); // midpoints: 1/(12 parts^2 r^2) and less
    EXPECT_NEAR(whole.yy * r, sum.yy * r, 1e-8);
    EXPECT_NEAR(whole.xx * r, sum.xx * r, 1e-8);
    EXPECT_NEAR(whole.xy * r, sum.xy * r, 1e-8);
  }
  // Both rules agree where one takes over from the other
  for (const double place : {20.0, 500.0}) {
    const CellIntegrals a = cellIntegrals(place * (1.0 - 1e-13), 0.0, 1.0, 1.0);
    const CellIntegrals b = cellIntegrals(place * (1.0 + 1e-13), 0.0, 1.0, 1.0);
    EXPECT_NEAR(a.xx / b.xx, 1.0, 1e-11);
  }
}

TEST(PatchHalfSpace, NuZeroHasOneCompliance)
{
  PatchHalfSpace space({20, 11, 1.0, 1.0}, {1.0, 0.0});
  Vector q(220);
  for (int i = 0; i < 220; ++i)
    q[i] = std::sin(1.0 + i * i);
  const TangentialField u = space.displacement(TangentialField{q, Vector::Zero(220)});
  EXPECT_LT((u.x - space.displacement(q)).norm(), 1e-14 * u.x.norm());
  EXPECT_LT(u.y.norm(), 1e-14 * u.x.norm());
}

TEST(PatchHalfSpace, EstimateIsSymmetricDefiniteAndNearTheInverse)
{
  const CellGrid grid{40, 30, 0.1, 0.15};
  PatchHalfSpace space(grid, {1.0, 0.4});
  const int n = grid.cells();
  const auto wave = [&](double kx, double ky) {
    Vector v(n);
    for (int i = 0; i < n; ++i)
      v[i] = std::sin(kx * (i % grid.nx) + ky * (i / grid.nx));
    return v;
  };
  const TangentialField a{wave(0.7, 0.4), wave(0.2, 1.1)}, b{wave(1.9, 0.3), wave(2.9, 2.0)};
  const auto dot = [](const TangentialField &u, const TangentialField &v) {
    return u.x.dot(v.x) + u.y.dot(v.y);
  };
  const double ab = dot(a, space.tractionEstimate(b)), ba = dot(b, space.tractionEstimate(a));
  EXPECT_NEAR(ab, ba, 1e-12 * dot(a, space.tractionEstimate(a)));
  EXPECT_GT(dot(a, space.tractionEstimate(a)), 0.0);
  // Inside, away from the borders, the estimate of a wave's displacement is the wave
  const TangentialField back = space.tractionEstimate(space.displacement(b));
  double worst = 0.0;
  for (int iy = 10; iy < 20; ++iy)
    for (int ix = 12; ix < 28; ++ix) {
      const int i = grid.index(ix, iy);
      worst = std::max({worst, std::abs(back.x[i] - b.x[i]), std::abs(back.y[i] - b.y[i])});
    }
  EXPECT_LT(worst, 0.1);
}

TEST(PatchHalfSpace, RepeatsToTheLastBit)
{
  const PatchGrid grid = centredGrid(37, 53, 1.0, 1.0);
  const Vector q = waves(grid, 1.0, 0.1, 1.0, 3);
  const TangentialField traction{q, 2.0 * q};
  const auto once = [&] { return PatchHalfSpace(grid, {1.0, 0.3}).displacement(traction); };
  const TangentialField a = once(), b = once();
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
}

TEST(PatchHalfSpace, QuickProductsAreOffByTheirPrecision)
{
  // an odd number of rows, too: they are transformed in pairs
  for (const CellGrid &grid : {CellGrid{47, 65, 0.1, 0.15}, CellGrid{64, 40, 1.0, 1.0}}) {
    PatchHalfSpace space(grid, {1.0, 0.3});
    QuickProducts *quick = space.quick();
    ASSERT_TRUE(quick);
    EXPECT_EQ(space.quick(), quick);
    Vector p(grid.cells());
    QuickProducts::Field result(grid.cells());
    for (int i = 0; i < grid.cells(); ++i)
      p[i] = std::sin(3.0 * i) + (i % 7 == 0);
    const Vector u = space.displacement(p), back = space.tractionEstimate(p);
    quick->displacement(p.cast<float>(), result);
    EXPECT_LT((result.cast<double>() - u).cwiseAbs().maxCoeff(), 1e-6 * u.cwiseAbs().maxCoeff());
    // a transform of another length repeats the cells elsewhere: near, but not the same
    quick->tractionEstimate(p.cast<float>(), result);
    EXPECT_LT((result.cast<double>() - back).norm(), 0.1 * back.norm());
  }
  EXPECT_FALSE(PatchHalfSpace({20, 20, 1.0, 1.0}, {1.0, 0.3}).quick());
}

TEST(PatchHalfSpace, CoarserCellsTakeTheFinerOnesInfluence)
{
  PatchHalfSpace fine({64, 72, 0.5, 0.7}, {1.0, 0.3}), alone({32, 36, 1.0, 1.4}, {1.0, 0.3});
  HalfSpace *coarse = fine.coarser();
  ASSERT_TRUE(coarse);
  const Vector p = Vector::LinSpaced(32 * 36, 0.0, 1.0);
  const Vector u = coarse->displacement(p), same = alone.displacement(p);
  EXPECT_LT((u - same).norm(), 1e-13 * same.norm());
}

TEST(PlaneTransform, LengthsAreFastAndLongEnough)
{
  EXPECT_EQ(fastPlaneSize(90, 80).x, 98);
  EXPECT_EQ(fastPlaneSize(90, 80).y, 80);
  EXPECT_EQ(fastPlaneSize(264, 264).x, 280);
  EXPECT_EQ(fastPlaneSize(264, 264).y, 280); // 270 has three factors 3
  for (int n = 1; n < 600; ++n) {
    const int y = fastPlaneSize(1, n).y;
    EXPECT_GE(y, n);
    EXPECT_LT(y, 2 * n + 2);
    EXPECT_EQ(y, fastTransformSize(y));
  }
}

TEST(PatchGrid, ShiftsAndBoxes)
{
  const PatchGrid grid = gridFrom(4, 3, 0.5, -1.0, 0.0);
  const Vector field = sampled(grid, [](double x, double y) { return x + 10.0 * y; });
  const Vector moved = shifted(grid, field, 1, -1, 7.0);
  EXPECT_EQ(moved[grid.index(0, 1)], field[grid.index(1, 0)]);
  EXPECT_EQ(moved[grid.index(3, 1)], 7.0);
  EXPECT_EQ(moved[grid.index(0, 0)], 7.0);
  EXPECT_EQ(shifted(grid, field, 9), Vector::Zero(12));
  Vector mask = Vector::Zero(12);
  mask[grid.index(1, 1)] = mask[grid.index(2, 2)] = 1.0;
  const SubGrid box = boundingBox(grid, mask, 1);
  EXPECT_EQ(box.firstX, 1);
  EXPECT_EQ(box.firstY, 1);
  EXPECT_EQ(box.grid.nx, 3);
  EXPECT_EQ(box.grid.ny, 2);
  EXPECT_DOUBLE_EQ(box.grid.x(0), grid.x(1));
}
