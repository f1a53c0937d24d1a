// SPDX-License-Identifier: GPL-2.0-or-later
// Rolling contact in three dimensions against closed formulas and against sums that hold on any
// grid: Hertz, full sliding under a law that depends on pressure, stiffness of rough patches.
#include "contact/patch/solvers/kalker.h"
#include "contact/patch/solvers/transient.h"
#include "law/forms/eq2.h"
#include "patch_cases.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

namespace {

using mcawr::pi;

/// The cells in contact, none of which may slip.
Vector stuck(const Vector &pressure)
{
  return (pressure.array() > 0.0)
      .select(Vector::Constant(pressure.size(), std::numeric_limits<double>::infinity()), 0.0);
}

/// Force over shift of cells that all move alike.
double shiftStiffness(const PatchGrid &grid, const ElasticPair &pair, const Vector &pressure,
                      bool alongY)
{
  TangentialProblem shift;
  shift.kind = TangentialProblem::Kind::Step;
  shift.distance = 1.0;
  shift.bound = stuck(pressure);
  (alongY ? shift.creepage.eta : shift.creepage.xi) = 1.0;
  TangentialOptions options;
  options.tolerance = 1e-10;
  const TangentialField q = TangentialSolver(grid, pair).solve(shift, options).traction;
  return -grid.cellArea() * (alongY ? q.y : q.x).sum();
}

/// Normal stiffness of the same cells. At nu = 0 tangential and normal influence are the same, so a
/// pair with G/(1 - nu) and nu = 0 has the tangential influence that is the normal one of the pair.
double normalStiffness(const PatchGrid &grid, const ElasticPair &pair, const Vector &pressure)
{
  return shiftStiffness(grid, {pair.G / (1.0 - pair.nu), 0.0}, pressure, false);
}

} // namespace

TEST(PatchExact, HertzianEllipseByItsEquations)
{
  // Johnson, Contact Mechanics, eqs. 4.28 to 4.32, with a < b and m = 1 - (a/b)^2:
  // [E/(1 - m) - K]/(K - E) = A/B, b^3 = 3 N E/(2 pi E* (1 - m)(A + B)), p0 = 3 N/(2 pi a b),
  // approach = 3 N K/(2 pi E* b)
  const double load = 106700.0, modulus = 82000.0 / 0.72;
  for (const double B : {1e-5, 2e-4, 7.9e-4}) {
    const double A = 8e-4;
    const HertzEllipse h = hertzEllipse(load, modulus, {A, B});
    const double m = 1.0 - std::pow(h.a / h.b, 2);
    const double K = std::comp_ellint_1(std::sqrt(m)), E = std::comp_ellint_2(std::sqrt(m));
    EXPECT_NEAR((E / (1.0 - m) - K) / (K - E), A / B, 1e-9 * A / B);
    const double cube = 3.0 * load * E / (2.0 * pi * modulus * (1.0 - m) * (A + B));
    EXPECT_NEAR(h.b, std::cbrt(cube), 1e-12 * h.b);
    EXPECT_NEAR(h.hertzPressure, 1.5 * load / (pi * h.a * h.b), 1e-12 * h.hertzPressure);
    EXPECT_NEAR(h.approach, 1.5 * load * K / (pi * modulus * h.b), 1e-12 * h.approach);
  }
}

TEST(PatchExact, FullSlidingUnderALawOfPressure)
{
  // Eq. 5 in each cell of a Hertzian ellipse, kappa2 = p E/sigma0^2 and k = c p0 E/sigma0^2:
  // Fx/N = mu0 + mu2 J3, J3 = integral of 3 s^2/(1 + k s) over s = p/p0 from 0 to 1
  //      = 3 [1/(2 k) - 1/k^2 + ln(1 + k)/k^3]
  const Eq2Scale steel{true, false, {1e9, 1250.0}, 206e9, 7800.0};
  const KappaLaw law = bucher2006();
  const Eq2Law friction(law.source, law, steel);
  const ElasticPair pair{82e9, 0.28};
  const struct {
    double peak, ratio;
  } cases[] = {{500e6, 0.42904433}, {1000e6, 0.39534653}};
  for (const auto &c : cases) {
    const double k = law.c * kappa2(c.peak, steel.modulus, steel.strength.cold);
    const double J3 = 3.0 * (0.5 / k - 1.0 / (k * k) + std::log1p(k) / (k * k * k));
    EXPECT_NEAR(law.mu0 + law.mu2 * J3, c.ratio, 0.5e-8);
    const double a = 6e-3, b = 9e-3;
    const HertzEllipse h =
        hertzEllipseOfAxes(c.peak * pi * a * b / 1.5, pair.G / (1.0 - pair.nu), a, b);
    double before = 1.0;
    for (const int n : {32, 64, 128}) {
      const PatchGrid grid = centredGrid(n, n, 2.2 * a, 2.2 * b);
      const Vector pressure = sampled(grid, [&](double x, double y) { return h.pressure(x, y); });
      const Vector mu = friction.mu({pressure, 0.0, Vector::Zero(grid.cells())});
      TangentialProblem problem;
      problem.bound = mu.cwiseProduct(pressure);
      problem.creepage.xi = 1.0; // some thousand times what the elastic slip is
      const TangentialResult sliding = TangentialSolver(grid, pair).solve(problem);
      EXPECT_EQ(sliding.stickCells(), 0);
      const double carried = pressure.sum() * grid.cellArea();
      const double error = std::abs(-patchSums(grid, sliding).forceX / carried - c.ratio);
      EXPECT_LT(error, 0.6 * before) << n;
      before = error;
    }
    EXPECT_LT(before, 1e-4);
  }
}

TEST(PatchExact, SlidingCellsCarryTheirBound)
{
  // Uniform mu: every cell of a rough contact has |q| = mu p, together mu N, whatever the creepages
  const Sphere sphere;
  const PatchGrid grid = centredGrid(48, 40, 3.4, 3.4);
  const HertzEllipse h = sphere.hertz();
  const Vector bound = sphere.mu * pressed(grid, sphere.pair, h.curvatures.A, h.curvatures.B,
                                           sphere.load, waves(grid, 0.02, 0.25, 1.0, 1))
                                       .pressure;
  TangentialProblem problem;
  problem.bound = bound;
  problem.creepage = {100.0 * sphere.creepUnit(), -80.0 * sphere.creepUnit(), 0.0};
  TangentialOptions options;
  options.tolerance = 1e-12;
  const TangentialResult sliding = TangentialSolver(grid, sphere.pair).solve(problem, options);
  EXPECT_EQ(sliding.stickCells(), 0);
  const Vector q =
      (sliding.traction.x.array().square() + sliding.traction.y.array().square()).sqrt();
  EXPECT_LT((q - bound).lpNorm<Eigen::Infinity>(), 1e-11 * bound.maxCoeff());
  EXPECT_NEAR(q.sum() * grid.cellArea(), sphere.mu * sphere.load, 1e-10 * sphere.mu * sphere.load);
}

TEST(PatchExact, StiffnessOfARoughPatch)
{
  // Mean tangential over normal compliance of any patch is nearly (2 - nu)/(2 (1 - nu)): a numpy
  // program finds it off by .09 % for a rough patch, this one by .2 %
  const ElasticPair pair{1.0, 0.3};
  const PatchGrid grid = centredGrid(96, 96, 3.4, 3.4);
  const HertzEllipse h = hertzEllipseOfAxes(0.01, pair.G / (1.0 - pair.nu), 1.0, 1.0);
  PatchHalfSpace space(grid, pair);
  NormalContactProblem problem;
  problem.profile = sampled(grid, [&](double x, double y) { return h.gap(x, y); }) +
                    waves(grid, 0.02, 0.25, 1.0, 1);
  problem.load = h.load / grid.cellArea();
  NormalContactOptions exact;
  exact.tolerance = 1e-12;
  const NormalContactResult normal = solveNormalContact(space, problem, exact);
  const double kz = normalStiffness(grid, pair, normal.pressure);
  const double kx = shiftStiffness(grid, pair, normal.pressure, false);
  const double ky = shiftStiffness(grid, pair, normal.pressure, true);
  EXPECT_NEAR(0.5 * (kz / kx + kz / ky), 1.7 / 1.4, 5e-3 * 1.7 / 1.4);
  // Incremental: so little more approach that no cell joins adds the force of a flat punch of the
  // cells in contact (Barber 2003); in one row of cells as in thousands
  exact.start = normal.pressure;
  problem.approach = normal.approach + 1e-7 * h.approach;
  const NormalContactResult closer = solveNormalContact(space, problem, exact);
  ASSERT_EQ(closer.contactCells(), normal.contactCells());
  const double more = (closer.pressure.sum() - normal.pressure.sum()) * grid.cellArea();
  EXPECT_NEAR(more / (1e-7 * h.approach), kz, 1e-4 * kz);
  // and the first of a shift is the tangential one's (at nu = 0: the same)
  TransientPatch patch(grid, pair);
  TransientPatch::Step step;
  step.cells = 0;
  step.bound = 0.3 * normal.pressure;
  step.creepage.xi = 1e-7 * h.approach;
  const double force = -patchSums(grid, patch.step(step)).forceX;
  EXPECT_NEAR(force / step.creepage.xi, kx, 1e-3 * kx);
}

TEST(PatchExact, SlopeOfALineInParts)
{
  // One row of long cells in three parts: pi G/(4 (1 - nu)) times the sum of their lengths,
  // which cells that count as a whole know to one in 400
  const ElasticPair pair{1.0, 0.3};
  const int n = 480;
  const PatchGrid grid{{n + 1, 1, 2.0 / n, 1e4}, -1.0, -5e3};
  Vector mask = Vector::Zero(n + 1);
  mask.segment(0, 120).setOnes();
  mask.segment(160, 200).setOnes();
  mask.segment(400, 80).setOnes();
  TangentialSolver solver(grid, pair);
  const CreepSensitivity s = creepSensitivity(solver, mask);
  const double length = 400.0 * grid.dx * 1e4;
  EXPECT_NEAR(s.xx, pi / 2.8 * length, pi / 2.8 * length / 400.0);
  EXPECT_NEAR(s.yy, pi / 4.0 * length, pi / 4.0 * length / 400.0);
}
