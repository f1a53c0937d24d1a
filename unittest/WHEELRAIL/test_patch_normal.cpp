// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "patch_cases.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

TEST(HertzEllipse, EllipticIntegrals)
{
  for (const double m : {0.0, 1e-12, 1e-3, 0.5, 0.99}) {
    const EllipticIntegrals e = ellipticIntegrals(m);
    EXPECT_NEAR(e.K, std::comp_ellint_1(std::sqrt(m)), 1e-14 * e.K);
    EXPECT_NEAR(e.E, std::comp_ellint_2(std::sqrt(m)), 1e-13 * e.K);
    EXPECT_NEAR(e.K - e.E, m * e.D, 1e-14 * e.K);
  }
  EXPECT_NEAR(ellipticIntegrals(1e-12).D, 0.25 * mcawr::pi, 1e-11);
}

TEST(HertzEllipse, AxesAndCurvaturesThereAndBack)
{
  for (const double ratio : {1e-3, 0.1, 0.5, 0.999999, 1.0, 3.0, 40.0})
    EXPECT_NEAR(axesRatio(curvatureRatio(ratio)), ratio, 1e-11 * ratio);
  EXPECT_DOUBLE_EQ(curvatureRatio(0.25) * curvatureRatio(4.0), 1.0);
  const HertzEllipse given = hertzEllipseOfAxes(82000.0, 1e5, 8.0, 4.0);
  const HertzEllipse back = hertzEllipse(82000.0, 1e5, given.curvatures);
  EXPECT_NEAR(back.a, 8.0, 1e-11);
  EXPECT_NEAR(back.b, 4.0, 1e-11);
  EXPECT_NEAR(back.approach, given.approach, 1e-12 * given.approach);
}

TEST(HertzEllipse, Sphere)
{
  // Johnson, sec. 4.2: a^3 = 3 N R/(4 E*), approach a^2/R
  const double load = 2.0, modulus = 3.0, radius = 5.0;
  const HertzEllipse h = hertzEllipse(load, modulus, gapOfRadii(radius, radius, INFINITY));
  const double a = std::cbrt(0.75 * load * radius / modulus);
  EXPECT_NEAR(h.a, a, 1e-14);
  EXPECT_NEAR(h.b, a, 1e-14);
  EXPECT_NEAR(h.approach, a * a / radius, 1e-14);
  EXPECT_NEAR(h.hertzPressure, 1.5 * load / (mcawr::pi * a * a), 1e-14);
}

TEST(PatchNormal, HertzianEllipse)
{
  const ElasticPair pair{1.0, 0.3};
  const HertzEllipse h = hertzEllipseOfAxes(0.01, 1.0 / 0.7, 1.0, 2.0);
  double before = 1.0;
  for (int n : {32, 64, 128}) {
    const PatchGrid grid = centredGrid(n, n, 3.0, 6.0);
    const NormalContactResult normal = pressed(grid, pair, h.curvatures.A, h.curvatures.B, h.load);
    const Vector exact = sampled(grid, [&](double x, double y) { return h.pressure(x, y); });
    const double error = (normal.pressure - exact).lpNorm<1>() / exact.lpNorm<1>();
    EXPECT_LT(error, 0.5 * before); // 9e-3, 3e-3, 1e-3: the edge is a line of cells
    EXPECT_NEAR(normal.approach, h.approach, 0.3 / n / n * 32 * h.approach);
    before = error;
  }
  EXPECT_LT(before, 2e-3);
}

TEST(PatchNormal, LoadAndApproachSayTheSame)
{
  const ElasticPair pair{1.0, 0.3};
  const HertzEllipse h = hertzEllipseOfAxes(0.01, 1.0 / 0.7, 1.0, 1.0);
  const PatchGrid grid = centredGrid(64, 48, 3.4, 3.4);
  for (const double hardness : {1e9, 1.5}) { // of p0
    PatchHalfSpace space(grid, pair);
    NormalContactProblem problem;
    problem.profile = sampled(grid, [&](double x, double y) { return h.gap(x, y); }) +
                      waves(grid, 0.01, 0.25, 1.0, 5);
    problem.load = h.load / grid.cellArea();
    problem.pressureLimit = hardness * h.hertzPressure;
    const NormalContactResult byLoad = solveNormalContact(space, problem);
    problem.approach = byLoad.approach;
    problem.load = 0.0;
    const NormalContactResult byApproach = solveNormalContact(space, problem);
    EXPECT_LT((byLoad.pressure - byApproach.pressure).norm(), 1e-6 * byLoad.pressure.norm());
    EXPECT_EQ(byLoad.contactCells(), byApproach.contactCells());
  }
  PatchHalfSpace space(grid, pair);
  NormalContactProblem apart;
  apart.profile = Vector::Constant(grid.cells(), 2.0);
  apart.approach = 1.0;
  const NormalContactResult result = solveNormalContact(space, apart);
  EXPECT_EQ(result.contactCells(), 0);
  EXPECT_EQ(result.gap[0], 1.0);
}

TEST(PatchNormal, ConditionsHoldOnRandomSurfaces)
{
  // p >= 0, p <= limit, gap >= 0, p gap = 0 inside the limit, sum p = load; smooth to very rough,
  // almost no load to full contact, with and without the limit, warm and cold
  const ElasticPair pair{1.0, 0.3};
  const HertzEllipse h = hertzEllipseOfAxes(0.01, 1.0 / 0.7, 1.0, 1.0);
  int number = 0;
  for (const double slope : {0.0, 0.003, 0.03, 0.3})
    for (const double share : {1e-4, 0.3, 3.0})
      for (const double hardness : {2.0, 20.0, 1e9}) {
        const PatchGrid grid = centredGrid(40 + number % 3, 48, 4.4, 4.4);
        PatchHalfSpace space(grid, pair);
        NormalContactProblem problem;
        problem.profile = sampled(grid, [&](double x, double y) { return h.gap(x, y); }) +
                          waves(grid, slope, 0.5, 2.0, static_cast<unsigned>(++number));
        problem.load = share * h.load / grid.cellArea();
        problem.pressureLimit = hardness * h.hertzPressure;
        const NormalContactResult result = solveNormalContact(space, problem);
        EXPECT_NEAR(result.pressure.sum(), problem.load, 1e-12 * problem.load);
        const Vector distance = problem.profile + space.displacement(result.pressure) -
                                Vector::Constant(grid.cells(), result.approach);
        const double scale = space.displacementScale(problem.load);
        for (int i = 0; i < grid.cells(); ++i) {
          ASSERT_GE(result.pressure[i], 0.0);
          ASSERT_LE(result.pressure[i], problem.pressureLimit);
          if (result.pressure[i] == 0.0) {
            ASSERT_GE(distance[i], -1e-6 * scale) << "case " << number;
          } else if (result.pressure[i] < problem.pressureLimit) {
            ASSERT_NEAR(distance[i], 0.0, 1e-6 * scale) << "case " << number;
          } else {
            ASSERT_LE(distance[i], 1e-6 * scale) << "case " << number;
          }
        }
        NormalContactOptions warm;
        warm.start = shifted(grid, result.pressure, 1);
        const NormalContactResult again = solveNormalContact(space, problem, warm);
        EXPECT_LT((again.pressure - result.pressure).norm(), 1e-6 * result.pressure.norm());
      }
}

namespace {
/// A patch without its quick products.
class ExactPatch : public HalfSpace {
 public:
  explicit ExactPatch(PatchHalfSpace &space) : space_(space) {}
  const CellGrid &grid() const override { return space_.grid(); }
  Vector displacement(const Vector &p) override { return space_.displacement(p); }
  Vector tractionEstimate(const Vector &u) override { return space_.tractionEstimate(u); }
  double displacementScale(double sum) const override { return space_.displacementScale(sum); }
  HalfSpace *coarser() override { return nullptr; }

 private:
  PatchHalfSpace &space_;
};
} // namespace

TEST(PatchNormal, SinglePrecisionLeavesNothingInTheResult)
{
  const ElasticPair pair{1.0, 0.3};
  const HertzEllipse h = hertzEllipseOfAxes(0.01, 1.0 / 0.7, 1.0, 1.0);
  const PatchGrid grid = centredGrid(80, 75, 3.4, 3.4);
  for (const double hardness : {1e9, 1.5}) { // of p0
    PatchHalfSpace space(grid, pair);
    ExactPatch exact(space);
    NormalContactProblem problem;
    problem.profile = sampled(grid, [&](double x, double y) { return h.gap(x, y); }) +
                      waves(grid, 0.01, 0.25, 1.0, 5);
    problem.load = h.load / grid.cellArea();
    problem.pressureLimit = hardness * h.hertzPressure;
    const NormalContactResult quick = solveNormalContact(space, problem);
    const NormalContactResult slow = solveNormalContact(exact, problem);
    EXPECT_LT((quick.pressure - slow.pressure).norm(), 3e-8 * slow.pressure.norm());
    EXPECT_NEAR(quick.approach, slow.approach, 1e-8 * slow.approach);
    EXPECT_EQ(quick.contactCells(), slow.contactCells());
    // the gap is that of the pressure, in double precision
    const Vector gap = problem.profile + space.displacement(quick.pressure) -
                       Vector::Constant(grid.cells(), quick.approach);
    for (int i = 0; i < grid.cells(); ++i)
      if (quick.pressure[i] == 0.0) {
        ASSERT_NEAR(quick.gap[i], gap[i], 1e-10 * quick.approach);
      }
  }
}

TEST(PatchNormal, AnyStartLeadsToTheSamePressure)
{
  // from all cells, from a few, from far beside: the set of cells changes by much between its steps
  const ElasticPair pair{1.0, 0.3};
  const HertzEllipse h = hertzEllipseOfAxes(0.01, 1.0 / 0.7, 1.0, 1.0);
  const PatchGrid grid = centredGrid(72, 64, 3.4, 3.4);
  PatchHalfSpace space(grid, pair);
  ASSERT_TRUE(space.quick());
  NormalContactProblem problem;
  problem.profile = sampled(grid, [&](double x, double y) { return h.gap(x, y); }) +
                    waves(grid, 0.01, 0.25, 1.0, 5);
  problem.load = h.load / grid.cellArea();
  const NormalContactResult cold = solveNormalContact(space, problem);
  Vector spike = Vector::Zero(grid.cells()), corner = spike;
  spike[grid.index(36, 32)] = 1.0;
  for (int iy = 0; iy < 20; ++iy)
    corner.segment(grid.index(0, iy), 20).setOnes();
  for (const Vector &start : {Vector(Vector::Ones(grid.cells())), spike, corner}) {
    NormalContactOptions options;
    options.start = start;
    const NormalContactResult result = solveNormalContact(space, problem, options);
    EXPECT_LT((result.pressure - cold.pressure).norm(), 3e-8 * cold.pressure.norm());
    EXPECT_NEAR(result.pressure.sum(), problem.load, 1e-12 * problem.load);
    EXPECT_NEAR(result.approach, cold.approach, 1e-8 * cold.approach);
  }
}
