// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/line/halfplane.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {
using mcawr::pi;

Vector bumpy(int n)
{
  Vector q(n);
  for (int i = 0; i < n; ++i)
    q[i] = std::sin(0.7 * i) + 0.3 * std::cos(2.9 * i) + 0.1 * (i % 5);
  return q;
}

/// Antiderivative of ln|x|.
double integralOfLog(double x)
{
  return x == 0.0 ? 0.0 : x * std::log(std::abs(x)) - x;
}
} // namespace

TEST(HalfPlane, CellInfluenceIsTheIntegralOfTheLogarithm)
{
  for (int m : {0, 1, 2, 7, 100, 3000}) {
    const double exact = -2.0 / pi * (integralOfLog(m + 0.5) - integralOfLog(m - 0.5));
    EXPECT_NEAR(cellInfluence(m), exact, 1e-11) << m;
    EXPECT_EQ(cellInfluence(m), cellInfluence(-m));
  }
  // Far away the difference of neighbours is 1/m; no cancellation may spoil it.
  EXPECT_NEAR((cellInfluence(1e9) - cellInfluence(1e9 + 1)) * 1e9, 2.0 / pi, 1e-5);
}

TEST(HalfPlane, ProductsEqualDenseMatrices)
{
  for (int n : {1, 2, 17, 64, 101}) {
    HalfPlane plane(n, Boundary::Free);
    const Vector q = bumpy(n);
    Vector u = Vector::Zero(n), s = Vector::Zero(n), t = Vector::Zero(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        u[i] += cellInfluence(i - j) * q[j];
        s[i] += 2.0 / (pi * (i - j + 0.5)) * q[j];
        t[i] += 2.0 / (pi * (j - i + 0.5)) * q[j];
      }
    EXPECT_LT((plane.displacement(q) - u).norm(), 1e-12 * (1.0 + u.norm())) << n;
    EXPECT_LT((plane.stretch(q) - s).norm(), 1e-12 * (1.0 + s.norm())) << n;
    EXPECT_LT((plane.stretchTransposed(q) - t).norm(), 1e-12 * (1.0 + t.norm())) << n;
  }
}

TEST(HalfPlane, StretchIsTheFallOfDisplacement)
{
  // For a smooth load, u_i - u_(i+1) from the displacements and from the staggered kernel differ
  // by the square of the cell size.
  const int n = 400;
  HalfPlane plane(n, Boundary::Free);
  Vector q(n);
  for (int i = 0; i < n; ++i)
    q[i] = std::exp(-std::pow((i - 200.0) / 40.0, 2));
  const Vector u = plane.displacement(q), s = plane.stretch(q);
  for (int i = 0; i + 1 < n; ++i)
    EXPECT_NEAR(u[i] - u[i + 1], s[i], 2e-4);
}

TEST(HalfPlane, PeriodicWaveHasItsExactAmplitude)
{
  // p = cos(kx) on a half-plane: u = 2 cos(kx)/(E* k) (Johnson, sec. 13.2); the load comes in steps
  const int n = 512;
  HalfPlane plane(n, Boundary::Periodic);
  for (int wave : {1, 2, 5}) {
    Vector p(n), exact(n);
    const double k = 2.0 * pi * wave / n;
    for (int i = 0; i < n; ++i) {
      p[i] = std::cos(k * i) * 0.5 * k / std::sin(0.5 * k); // the steps' fundamental is cos
      exact[i] = 2.0 / k * std::cos(k * i);
    }
    EXPECT_LT((plane.displacement(p) - exact).cwiseAbs().maxCoeff(), 2e-4 * exact.maxCoeff());
  }
}

TEST(HalfPlane, PeriodicEqualsManyCopies)
{
  const int n = 16, copies = 4001;
  HalfPlane plane(n, Boundary::Periodic);
  Vector q = bumpy(n);
  q.array() -= q.mean();
  Vector u = Vector::Zero(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int c = -copies / 2; c <= copies / 2; ++c)
        u[i] += cellInfluence(i - j + c * n) * q[j];
  u.array() -= u.mean();
  EXPECT_LT((plane.displacement(q) - u).cwiseAbs().maxCoeff(), 1e-4 * u.cwiseAbs().maxCoeff());
}

TEST(HalfPlane, PreconditionerIsSymmetricAndPositive)
{
  HalfPlane plane(60, Boundary::Free);
  const Vector a = bumpy(60), b = a.reverse().array().square();
  const double ab = a.dot(plane.tractionEstimate(b)), ba = b.dot(plane.tractionEstimate(a));
  EXPECT_NEAR(ab, ba, 1e-10 * std::abs(ab));
  EXPECT_GT(a.dot(plane.tractionEstimate(a)), 0.0);
  EXPECT_GT(Vector::Ones(60).dot(plane.tractionEstimate(Vector::Ones(60))), 0.0);
}

TEST(HalfPlane, IsAHalfSpaceOfALine)
{
  // the unit of length is free
  HalfPlane cells(600, Boundary::Free), plane(600, Boundary::Free, 0.25);
  HalfSpace &space = plane;
  EXPECT_EQ(space.grid().nx, 600);
  EXPECT_EQ(space.grid().ny, 1);
  const Vector q = bumpy(600);
  const Vector u = cells.displacement(q);
  EXPECT_LT((space.displacement(q) - 0.25 * u).norm(), 1e-14 * u.norm());
}

TEST(HalfPlane, CoarserGridHasTheSameUnits)
{
  HalfPlane plane(512, Boundary::Free, 0.5);
  const auto coarse = plane.coarser();
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->grid().nx, 256);
  EXPECT_EQ(coarse->grid().dx, 1.0);
  // a smooth pressure bends both the same, but for the constant that is free in two dimensions
  Vector q(512);
  for (int i = 0; i < 512; ++i)
    q[i] = std::exp(-std::pow((i - 255.5) / 60.0, 2));
  const Vector coarseU = coarse->displacement(coarseMean(plane.grid(), coarse->grid(), q));
  const Vector u = coarseMean(plane.grid(), coarse->grid(), plane.displacement(q));
  const Vector difference = (u - coarseU).array() - (u - coarseU).mean();
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-3 * (u.maxCoeff() - u.minCoeff()));
  EXPECT_FALSE(HalfPlane(255, Boundary::Free).coarser());
  EXPECT_FALSE(HalfPlane(301, Boundary::Free).coarser());
}

TEST(CellGrid, CoarseAndFineFieldsOfAPatch)
{
  const CellGrid fine{4, 2, 1.0, 1.0}, coarse{2, 1, 2.0, 2.0};
  Vector values(8);
  values << 1, 2, 3, 4, 5, 6, 7, 8;
  const Vector mean = coarseMean(fine, coarse, values);
  EXPECT_EQ(mean[0], 3.5);
  EXPECT_EQ(mean[1], 5.5);
  const Vector back = refinedField(fine, coarse, mean);
  EXPECT_EQ(back[fine.index(1, 1)], 3.5);
  EXPECT_EQ(back[fine.index(2, 0)], 5.5);
}

TEST(HalfPlane, FastSizesHaveSmallFactors)
{
  EXPECT_EQ(fastTransformSize(2), 2);
  EXPECT_EQ(fastTransformSize(2048), 2048);
  EXPECT_EQ(fastTransformSize(2049), 2058); // 2 * 3 * 7^3
}
