// SPDX-License-Identifier: GPL-2.0-or-later
// Statements that hold exactly for rolling contact in three dimensions, and the error of the cells
// where they hold in the limit.
#include "base/errors.h"
#include "contact/patch/solvers/kalker.h"
#include "contact/patch/solvers/transient.h"
#include "patch_cases.h"
#include "shared/pi.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

namespace {

using mcawr::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

double relativeDifference(const TangentialField &a, const TangentialField &b)
{
  return std::hypot((a.x - b.x).norm(), (a.y - b.y).norm()) / std::hypot(b.x.norm(), b.y.norm());
}

/// A rough sphere's pressure on a box of 1.7 x 2a.
NormalContactResult roughSphere(const PatchGrid &grid, const ElasticPair &pair, double load,
                                double slope = 0.02, unsigned seed = 1)
{
  const HertzEllipse h = hertzEllipseOfAxes(0.01, pair.G / (1.0 - pair.nu), 1.0, 1.0);
  return pressed(grid, pair, h.curvatures.A, h.curvatures.B, load,
                 waves(grid, slope, 0.25, 1.0, seed));
}

Vector infiniteWhere(const Vector &pressure)
{
  return (pressure.array() > 0.0).select(Vector::Constant(pressure.size(), infinite), 0.0);
}

} // namespace

TEST(PatchRolling, ShiftOfAnyRoughnessAtNuZero)
{
  // Ciavarella (1998), Jaeger (1998): q = mu [p(N) - p(N - Q/mu)], stick is the contact of the
  // second; holds on the grid, too, because both kernels are the same
  const ElasticPair pair{1.0, 0.0};
  const double load = 0.01, mu = 0.3;
  const PatchGrid grid = centredGrid(64, 60, 3.4, 3.4);
  const NormalContactResult full = roughSphere(grid, pair, load);
  for (const double share : {0.2, 0.7, 0.95}) {
    const NormalContactResult inner = roughSphere(grid, pair, (1.0 - share) * load);
    TransientPatch patch(grid, pair);
    TransientPatch::Step step;
    step.bound = mu * full.pressure;
    step.cells = 0;
    step.forceX = -share * mu * load;
    step.forceY = 0.0;
    TangentialOptions options;
    options.tolerance = 1e-11;
    const TangentialResult result = patch.step(step, options);
    const Vector exact = -mu * (full.pressure - inner.pressure);
    EXPECT_LT((result.traction.x - exact).norm(), 1e-7 * exact.norm()); // p itself: 1e-8
    EXPECT_LT(result.traction.y.norm(), 1e-9 * exact.norm());
    for (int i = 0; i < grid.cells(); ++i)
      if (full.pressure[i] > 0.0) {
        EXPECT_EQ(result.state[i] == PatchState::Stick, inner.pressure[i] > 0.0);
      }
    EXPECT_NEAR(result.creepage.xi, mu * (full.approach - inner.approach), 1e-8 * full.approach);
  }
}

TEST(PatchRolling, ShiftOfARoughSphereByTheTheorem)
{
  // The theorem of above for nu > 0, with a tangential compliance (2 - nu)/(2 (1 - nu)) of the
  // normal one: only nearly true, since each traction pulls its neighbours sideways too. The numpy
  // program finds the force .14 % larger than the theorem's
  const ElasticPair pair{1.0, 0.3};
  const double load = 0.01, mu = 0.3, share = 0.7;
  const PatchGrid grid = centredGrid(96, 96, 3.4, 3.4);
  const NormalContactResult full = roughSphere(grid, pair, load);
  const NormalContactResult inner = roughSphere(grid, pair, (1.0 - share) * load);
  TransientPatch patch(grid, pair);
  TransientPatch::Step step;
  step.bound = mu * full.pressure;
  step.cells = 0;
  step.creepage.xi = mu * (full.approach - inner.approach) * (2.0 - 0.3) / (2.0 * (1.0 - 0.3));
  const double force = -patchSums(grid, patch.step(step)).forceX;
  EXPECT_GT(force, share * mu * load);
  EXPECT_NEAR(force, share * mu * load, 3e-3 * share * mu * load);
}

TEST(PatchRolling, FullStickIsReciprocal)
{
  // The matrix (Fx, Fy, Mz)/(xi, eta, phi) of rolling to one side is the transpose of that of
  // rolling to the other, on any contact: here a rough one, whose mirror image rolls the usual way
  const ElasticPair pair{1.0, 0.3};
  const PatchGrid grid = centredGrid(40, 36, 3.4, 3.4);
  const Vector mask = infiniteWhere(roughSphere(grid, pair, 0.01).pressure);
  Vector mirrored(grid.cells());
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix)
      mirrored[grid.index(ix, iy)] = mask[grid.index(grid.nx - 1 - ix, iy)];
  const auto matrix = [&](const Vector &bound) {
    TangentialSolver solver(grid, pair);
    Eigen::Matrix3d m;
    for (int column = 0; column < 3; ++column) {
      TangentialProblem problem;
      problem.bound = bound;
      problem.spinPoint = 0.0;
      problem.creepage = {column == 0 ? 1.0 : 0.0, column == 1 ? 1.0 : 0.0,
                          column == 2 ? 1.0 : 0.0};
      TangentialOptions options;
      options.tolerance = 1e-13;
      const PatchSums sums = patchSums(grid, solver.solve(problem, options));
      m.col(column) << sums.forceX, sums.forceY, sums.momentZ;
    }
    return m;
  };
  const Eigen::DiagonalMatrix<double, 3> mirror(-1.0, 1.0, -1.0);
  const Eigen::Matrix3d there = matrix(mask), back = mirror * matrix(mirrored) * mirror;
  EXPECT_LT((there - back.transpose()).norm(), 1e-11 * there.norm());
  EXPECT_GT((there - there.transpose()).norm(), 1e-2 * there.norm()); // not for one direction
}

TEST(PatchRolling, GroovesAlongTheWayMakeNoDifference)
{
  // Roughness that does not change along x travels without being seen: from rest, transient rolling
  // becomes steady rolling
  const ElasticPair pair{1.0, 0.3};
  const Sphere sphere;
  const int cellsPerPass = 24;
  const PatchGrid grid = centredGrid(41, 40, 41.0 * 2.0 / cellsPerPass, 3.4);
  const Vector grooves =
      sampled(grid, [](double, double y) { return 5e-4 * std::cos(2.0 * pi * y / 0.3); });
  const HertzEllipse h = sphere.hertz();
  const NormalContactResult normal =
      pressed(grid, pair, h.curvatures.A, h.curvatures.B, sphere.load, grooves);
  TangentialProblem steady;
  steady.bound = sphere.mu * normal.pressure;
  steady.creepage = {0.15 * sphere.creepUnit(), 0.1 * sphere.creepUnit(),
                     0.05 * sphere.creepUnit()};
  TangentialOptions tight;
  tight.tolerance = 1e-8;
  const TangentialResult frozen = TangentialSolver(grid, pair).solve(steady, tight);
  TransientPatch patch(grid, pair);
  TransientPatch::Step step;
  step.bound = steady.bound;
  step.creepage = steady.creepage;
  double before = 1.0;
  for (int pass = 1; pass <= 4; ++pass) {
    for (int i = 0; i < cellsPerPass; ++i)
      patch.step(step);
    const double difference = relativeDifference(patch.traction(), frozen.traction);
    EXPECT_LT(difference, before / 4.0) << "pass " << pass;
    before = difference;
  }
  EXPECT_LT(before, 1e-3);
  // and from the steady traction it stays there
  patch.startFrom(frozen.traction);
  patch.step(step, tight);
  EXPECT_LT(relativeDifference(patch.traction(), frozen.traction), 1e-6);
}

TEST(PatchRolling, CreepagesOfAGivenForceDoNotScatter)
{
  // Cattaneo's shift rolls on under its force, to Carter's state: at the usual tolerance every
  // step has the creepage of a tight one, and three Newton steps are enough for most
  const Sphere sphere;
  const PatchGrid grid = centredGrid(36, 36, 2.2, 2.2);
  const auto rolled = [&](TangentialOptions options, int &newtonSteps) {
    TransientPatch patch(grid, sphere.pair);
    TransientPatch::Step step;
    step.bound = sphere.bound(grid);
    step.forceX = -0.875 * sphere.mu * sphere.load;
    step.forceY = 0.0;
    step.cells = 0;
    patch.step(step, options);
    step.cells = 1;
    std::vector<double> creepages;
    for (int k = 0; k < 40; ++k) {
      const TangentialResult result = patch.step(step, options);
      step.creepage = result.creepage;
      newtonSteps += result.newtonSteps;
      creepages.push_back(result.creepage.xi);
    }
    return creepages;
  };
  int steps = 0, more = 0;
  const std::vector<double> found = rolled(TransientPatch::defaultOptions(), steps);
  TangentialOptions tight;
  tight.tolerance = 1e-9;
  const std::vector<double> exact = rolled(tight, more);
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k], exact[k], 2e-5 * exact[k]) << k;
  EXPECT_LE(steps, 3 * 40);
}

TEST(PatchRolling, StepInTheFrameOfTheMaterial)
{
  // A rolling step is a shift at rest, seen by an observer who travels with the material while the
  // contact moves on by a cell
  const ElasticPair pair{1.0, 0.3};
  const Sphere sphere;
  const PatchGrid grid = centredGrid(50, 40, 4.0, 3.4);
  const Vector first = sphere.bound(grid);
  Vector second = sphere.mu * roughSphere(grid, pair, sphere.load).pressure;
  TransientPatch rolling(grid, pair), material(grid, pair);
  TransientPatch::Step step;
  step.bound = first;
  step.creepage = {0.3 * sphere.creepUnit(), -0.1 * sphere.creepUnit(), 0.0};
  step.cells = 0;
  TangentialOptions tight;
  tight.tolerance = 1e-11;
  rolling.step(step, tight);
  material.step(step, tight);
  step.bound = second;
  step.cells = 1;
  rolling.step(step, tight);
  step.bound = shifted(grid, second, -1);
  step.creepage.xi *= grid.dx; // of a shift: a length
  step.creepage.eta *= grid.dx;
  step.cells = 0;
  material.step(step, tight);
  const TangentialField seen{shifted(grid, material.traction().x, 1),
                             shifted(grid, material.traction().y, 1)};
  EXPECT_LT(relativeDifference(seen, rolling.traction()), 1e-9);
}

TEST(PatchRolling, NoCreepNoTraction)
{
  const Sphere sphere;
  const PatchGrid grid = centredGrid(30, 30, 3.4, 3.4);
  TangentialProblem problem;
  problem.bound = sphere.bound(grid);
  const TangentialResult result = TangentialSolver(grid, sphere.pair).solve(problem);
  EXPECT_EQ(result.traction.x.norm() + result.traction.y.norm(), 0.0);
  EXPECT_EQ(result.slipCells(), 0);
  TransientPatch patch(grid, sphere.pair);
  TransientPatch::Step step;
  for (unsigned i = 1; i <= 3; ++i) {
    step.bound = roughSphere(grid, sphere.pair, sphere.load, 0.02, i).pressure;
    EXPECT_EQ(patch.step(step).traction.x.norm(), 0.0);
  }
}

TEST(PatchRolling, FullSlidingCarriesAllFriction)
{
  const Sphere sphere;
  const PatchGrid grid = centredGrid(40, 40, 2.5, 2.5);
  TangentialProblem problem;
  problem.bound = sphere.bound(grid);
  const double angle = 0.3, creep = 100.0 * sphere.creepUnit();
  problem.creepage = {creep * std::cos(angle), creep * std::sin(angle), 0.0};
  const PatchSums sums = patchSums(grid, TangentialSolver(grid, sphere.pair).solve(problem));
  const double most = problem.bound.sum() * grid.cellArea();
  EXPECT_NEAR(std::hypot(sums.forceX, sums.forceY), most, 1e-3 * most);
  EXPECT_NEAR(std::atan2(-sums.forceY, -sums.forceX), angle, 1e-3);
  EXPECT_EQ(sums.stickArea, 0.0);
  EXPECT_NEAR(sums.powerClosure(), 1.0, 1e-3);
}

TEST(PatchRolling, ConditionsHoldCellByCell)
{
  // |q| <= bound; in slip |q| = bound and q against the slip; in stick no slip; and the slip is
  // that of the definition, computed here anew
  const ElasticPair pair{1.0, 0.3};
  const PatchGrid grid = centredGrid(48, 48, 3.4, 3.4);
  const Vector bound = 0.3 * roughSphere(grid, pair, 0.01).pressure;
  TangentialProblem problem;
  problem.bound = bound;
  problem.creepage = {4e-4, -3e-4, 5e-4};
  const TangentialResult r = TangentialSolver(grid, pair).solve(problem);
  const TangentialField u = PatchHalfSpace(grid, pair).displacement(r.traction);
  EXPECT_GT(r.slipCells(), 0);
  EXPECT_GT(r.stickCells(), 0);
  const double creep = 6e-4, largest = bound.maxCoeff();
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const int i = grid.index(ix, iy);
      if (!(bound[i] > 0.0))
        continue;
      const Creepage &c = problem.creepage;
      const double sx = c.xi - c.phi * grid.y(iy) + (u.x[i] - u.x[i + 1]) / grid.dx;
      const double sy =
          c.eta + c.phi * (grid.x(ix) + 0.5 * grid.dx) + (u.y[i] - u.y[i + 1]) / grid.dx;
      ASSERT_NEAR(sx, r.slip.x[i], 1e-9 * creep);
      ASSERT_NEAR(sy, r.slip.y[i], 1e-9 * creep);
      const double q = std::hypot(r.traction.x[i], r.traction.y[i]), s = std::hypot(sx, sy);
      if (r.state[i] == PatchState::Stick) {
        ASSERT_LE(q, bound[i] * (1.0 + 1e-5));
        ASSERT_LE(s, 1e-5 * creep);
      } else {
        ASSERT_NEAR(q, bound[i], 1e-5 * largest);
        ASSERT_NEAR(r.traction.x[i] * sx + r.traction.y[i] * sy, -q * s, 1e-4 * q * creep);
      }
    }
}

TEST(PatchRolling, UnitsDoNotMatter)
{
  const Sphere sphere;
  const auto ratio = [&](double length, double stress) {
    const PatchGrid grid = centredGrid(40, 40, 2.5 * length, 2.5 * length);
    const PatchGrid unit = centredGrid(40, 40, 2.5, 2.5);
    TangentialProblem problem;
    problem.bound = stress * sphere.bound(unit);
    problem.creepage = {2e-4, 1e-4, 1e-4 / length};
    const TangentialResult r =
        TangentialSolver(grid, {stress * sphere.pair.G, sphere.pair.nu}).solve(problem);
    return patchSums(grid, r).forceX / (stress * length * length);
  };
  const double here = ratio(1.0, 1.0);
  EXPECT_NEAR(ratio(1e-9, 82e9), here, 1e-7 * std::abs(here));
  EXPECT_NEAR(ratio(1e6, 1e-7), here, 1e-7 * std::abs(here));
}

TEST(PatchRolling, TurnedByHalfATurnAndMirrored)
{
  // Mirror image in y: eta, phi, Fy, Mz change sign
  const Sphere sphere;
  const PatchGrid grid = centredGrid(40, 38, 2.6, 2.6);
  TangentialProblem problem;
  problem.bound = sphere.bound(grid);
  problem.creepage = {2e-4, 3e-4, 1e-4};
  TangentialSolver solver(grid, sphere.pair);
  const PatchSums one = patchSums(grid, solver.solve(problem));
  problem.creepage = {2e-4, -3e-4, -1e-4};
  const PatchSums other = patchSums(grid, solver.solve(problem));
  EXPECT_NEAR(one.forceX, other.forceX, 1e-6 * std::abs(one.forceX));
  EXPECT_NEAR(one.forceY, -other.forceY, 1e-6 * std::abs(one.forceY));
  EXPECT_NEAR(one.momentZ, -other.momentZ, 1e-6 * std::abs(one.momentZ));
  problem.creepage = {-2e-4, -3e-4, -1e-4};
  const PatchSums reversed = patchSums(grid, solver.solve(problem));
  EXPECT_NEAR(one.forceX, -reversed.forceX, 1e-6 * std::abs(one.forceX));
}

TEST(PatchRolling, PowerClosesInFirstOrder)
{
  const Sphere sphere;
  double before = 1.0;
  for (int n : {16, 32, 64, 128}) {
    const PatchGrid grid = centredGrid(n + n / 4, n + n / 4, 2.5, 2.5);
    TangentialProblem problem;
    problem.bound = sphere.bound(grid);
    problem.creepage.xi = 0.2329 * sphere.creepUnit();
    const PatchSums sums = patchSums(grid, TangentialSolver(grid, sphere.pair).solve(problem));
    const double open = 1.0 - sums.powerClosure();
    EXPECT_GT(open, 0.0);
    EXPECT_LT(open, 0.56 * before);
    before = open;
  }
  EXPECT_LT(before, 0.025);
}

TEST(PatchRolling, SpheresForces)
{
  // Extrapolated from two grids: within 0.2 % of an independent numpy program's, which are known to
  // +-.0006
  const Sphere sphere;
  const struct {
    Creepage scaled;
    double forceX, forceY, momentZ;
  } cases[] = {{{0.02329, 0.0, 0.0}, -0.0968, 0.0, 0.0},
               {{0.23291, 0.0, 0.0}, -0.7220, 0.0, 0.0},
               {{0.0, 0.16, 0.0}, 0.0, -0.4921, 0.1275},
               {{0.0, 0.0, 0.2}, 0.0, -0.2882, -0.1810}};
  for (const auto &c : cases) {
    const auto forces = [&](int n) {
      const PatchGrid grid = centredGrid(n, n, 2.5, 2.5);
      TangentialProblem problem;
      problem.bound = sphere.bound(grid);
      problem.creepage = {c.scaled.xi * sphere.creepUnit(), c.scaled.eta * sphere.creepUnit(),
                          c.scaled.phi * sphere.creepUnit()};
      const PatchSums sums = patchSums(grid, TangentialSolver(grid, sphere.pair).solve(problem));
      return Eigen::Vector3d(Eigen::Vector3d(sums.forceX, sums.forceY, sums.momentZ) /
                             (sphere.mu * sphere.load));
    };
    const Eigen::Vector3d limit = 2.0 * forces(320) - forces(160);
    const double reference[] = {c.forceX, c.forceY, c.momentZ};
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(limit[i], reference[i], 0.0006 + 0.002 * std::abs(reference[i]));
  }
}

TEST(PatchRollingLong, KalkersCoefficients)
{
  // nu = .25 and .3 by turns; an independent numpy program, +-.002 (C33 +-.005). Kalker's own
  // table (1990, nu .25, a/b 1): 4.12 3.67 1.47 1.19
  const struct {
    double axes, nu, c11, c22, c23, c33;
  } table[] = {
      {0.2, 0.25, 3.3751, 2.6327, 0.6027, 4.296}, {0.2, 0.3, 3.5911, 2.6400, 0.6344, 4.515},
      {0.5, 0.25, 3.6255, 3.0125, 0.9279, 1.939}, {0.5, 0.3, 3.8215, 3.0389, 0.9525, 1.988},
      {1.0, 0.25, 4.1128, 3.6681, 1.4657, 1.185}, {1.0, 0.3, 4.2936, 3.7273, 1.4957, 1.180},
      {2.0, 0.25, 5.0997, 4.9079, 2.6228, 0.821}, {2.0, 0.3, 5.2731, 5.0292, 2.6851, 0.789}};
  for (const auto &row : table) {
    const KalkerCoefficients k = ellipseKalkerCoefficients(row.axes, row.nu);
    EXPECT_NEAR(k.c11, row.c11, 0.003 * row.c11);
    EXPECT_NEAR(k.c22, row.c22, 0.003 * row.c22);
    EXPECT_NEAR(k.c23, row.c23, 0.003 * row.c23);
    EXPECT_NEAR(k.c33, row.c33, 0.01 * row.c33);
  }
  // 1.15 in some copies of Kalker's table is a misprint
  EXPECT_NEAR(ellipseKalkerCoefficients(0.8, 0.25).c23, 1.25, 0.005);
}

TEST(PatchRolling, KalkersCoefficientsOnOneGrid)
{
  // The numpy program on 128 cells a diameter, not extrapolated: the same equations. Its lever of
  // the spin is that at the beginning of a step, ours (for C23, C33) the midpoint's
  const int n = 128;
  const PatchGrid grid{{n + 1, n, 2.0 / n, 2.0 / n}, -1.0, -1.0};
  const Vector inside =
      sampled(grid, [](double x, double y) { return x * x + y * y < 1.0 ? 1.0 : 0.0; });
  TangentialSolver solver(grid, {1.0, 0.3});
  const KalkerCoefficients k =
      kalkerCoefficients(creepSensitivity(solver, inside), 1.0, inside.sum() * grid.cellArea());
  EXPECT_NEAR(k.c11, 4.3029, 0.55e-4);
  EXPECT_NEAR(k.c22, 3.7379, 0.55e-4);
  TangentialProblem spin;
  spin.bound = infiniteWhere(inside);
  spin.creepage.phi = 1.0;
  spin.spinPoint = 0.0;
  const PatchSums sums = patchSums(grid, solver.solve(spin));
  const double ab = inside.sum() * grid.cellArea() / pi;
  EXPECT_NEAR(-sums.forceY / std::pow(ab, 1.5), 1.4888, 0.55e-4);
  EXPECT_NEAR(-sums.momentZ / (ab * ab), 1.1944, 0.55e-4);
}

TEST(PatchRolling, StiffnessOfAnEllipse)
{
  // Mindlin (1949), Vermeulen and Johnson (1964): tangential over normal stiffness of a patch that
  // sticks, (1 - nu) K/((1 - nu) K + nu B) along the minor axis, D for B along the major one
  const ElasticPair pair{1.0, 0.3};
  const EllipticIntegrals e = ellipticIntegrals(0.75);
  const double minor = 0.7 * e.K / (0.7 * e.K + 0.3 * e.B);
  const double major = 0.7 * e.K / (0.7 * e.K + 0.3 * e.D);
  EXPECT_NEAR(minor, 0.848863, 1e-6);
  EXPECT_NEAR(major, 0.799664, 1e-6);
  const PatchGrid grid = centredGrid(80, 80, 2.0, 4.0);
  const Vector inside =
      sampled(grid, [](double x, double y) { return x * x + 0.25 * y * y < 1.0 ? 1.0 : 0.0; });
  PatchHalfSpace space(grid, pair);
  NormalContactProblem punch;
  punch.profile = (inside.array() > 0.0).select(Vector::Zero(grid.cells()), 1e3);
  punch.approach = 1.0;
  const double normal = solveNormalContact(space, punch).pressure.sum();
  TangentialProblem shift;
  shift.kind = TangentialProblem::Kind::Step;
  shift.distance = 1.0;
  shift.bound = infiniteWhere(inside);
  TangentialSolver solver(grid, pair);
  shift.creepage = {1.0, 0.0, 0.0};
  const double alongX = -solver.solve(shift).traction.x.sum();
  shift.creepage = {0.0, 1.0, 0.0};
  const double alongY = -solver.solve(shift).traction.y.sum();
  EXPECT_NEAR(alongX / normal, minor, 2e-3);
  EXPECT_NEAR(alongY / normal, major, 2e-3);
  // The mean compliance of any patch, rough ones too, is nearly (2 - nu)/(2 (1 - nu)) of the normal
  EXPECT_NEAR(0.5 * (normal / alongX + normal / alongY), 1.7 / 1.4, 2e-3 * 1.7 / 1.4);
}

TEST(PatchRolling, CattaneosSphere)
{
  // Exact for nu = 0: shift = 3 mu N (2 - nu)/(8 G a) [1 - (1 - Q/(mu N))^(2/3)]
  const ElasticPair pair{1.0, 0.0};
  const double load = 0.01, mu = 0.3, share = 0.6;
  const HertzEllipse h = hertzEllipseOfAxes(load, pair.G, 1.0, 1.0);
  const PatchGrid grid = centredGrid(96, 96, 2.4, 2.4);
  const NormalContactResult normal = pressed(grid, pair, h.curvatures.A, h.curvatures.B, load);
  TransientPatch patch(grid, pair);
  TransientPatch::Step step;
  step.bound = mu * normal.pressure;
  step.cells = 0;
  step.forceX = share * mu * load;
  step.forceY = 0.0;
  const double exact = 0.75 * mu * load * (1.0 - std::pow(1.0 - share, 2.0 / 3.0));
  EXPECT_NEAR(patch.step(step).creepage.xi, -exact, 2e-3 * exact);
}

TEST(PatchRolling, ProductsHardlyGrowWithTheGrid)
{
  // Four times as many cells each way: at most 1.5 times the products, warm ones a state's worth
  // more. (Slip that is preconditioned cell by cell takes 1.8 times as many, a step ten times.)
  const Sphere sphere;
  int cold[2], warm[2], step[2];
  for (int level : {0, 1}) {
    const int n = level ? 192 : 48;
    const PatchGrid grid = centredGrid(n, n, 2.2, 2.2);
    TangentialSolver solver(grid, sphere.pair);
    TangentialProblem problem;
    problem.bound = sphere.bound(grid);
    problem.creepage.xi = 0.2 * sphere.creepUnit();
    const TangentialResult first = solver.solve(problem);
    cold[level] = first.products;
    TangentialOptions options;
    options.start = first.traction;
    problem.creepage.xi *= 1.1;
    warm[level] = solver.solve(problem, options).products;
    TransientPatch patch(grid, sphere.pair);
    patch.startFrom(first.traction);
    TransientPatch::Step rolling;
    rolling.bound = problem.bound;
    rolling.creepage.xi = 0.2 * sphere.creepUnit();
    step[level] = patch.step(rolling).products;
  }
  EXPECT_LT(cold[1], 1.5 * cold[0]);
  EXPECT_LT(warm[1], 1.6 * warm[0]);
  EXPECT_LT(step[1], 1.4 * step[0]);
  EXPECT_LT(std::max({cold[1], warm[1], step[1]}), 36);
}

TEST(PatchRolling, SlopeOfALine)
{
  // One row of long cells: pi G/(4 (1 - nu)) times the contact's length along x, pi G/4 across
  const ElasticPair pair{1.0, 0.3};
  const int n = 200;
  const PatchGrid grid{{n + 1, 1, 2.0 / n, 1e4}, -1.0, -5e3};
  Vector mask = Vector::Ones(n + 1);
  mask[n] = 0.0;
  TangentialSolver solver(grid, pair);
  const CreepSensitivity s = creepSensitivity(solver, mask);
  EXPECT_NEAR(s.xx / 1e4, pi / 2.8 * 2.0, 0.01 * pi / 1.4);
  EXPECT_NEAR(s.yy / 1e4, pi / 4.0 * 2.0, 0.01 * pi / 2.0);
}

TEST(PatchRolling, ErrorsSayWhatIsWrong)
{
  const Sphere sphere;
  const PatchGrid tight = centredGrid(20, 24, 2.0, 2.4);
  TangentialProblem problem;
  problem.bound = sphere.bound(tight);
  problem.creepage.xi = 1e-4;
  TangentialSolver small(tight, sphere.pair);
  try {
    small.solve(problem);
    FAIL();
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    EXPECT_NE(std::string(error.what()).find("leading column"), std::string::npos);
  }
  const PatchGrid grid = centredGrid(24, 24, 2.6, 2.6);
  problem.bound = sphere.bound(grid);
  problem.forceX = -1.1 * sphere.mu * sphere.load;
  TangentialSolver solver(grid, sphere.pair);
  try {
    solver.solve(problem);
    FAIL();
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    EXPECT_NE(std::string(error.what()).find("cannot be carried"), std::string::npos);
  }
}
