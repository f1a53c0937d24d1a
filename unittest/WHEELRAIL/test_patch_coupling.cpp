// SPDX-License-Identifier: GPL-2.0-or-later
// Unlike bodies: pressure and tangential traction influence each other. Exact statements of the
// influence, the printed results of an independent program, and what must hold of rolling.
#include "contact/patch/solvers/patch_coupling.h"
#include "creep/patch/moving_patch.h"
#include "creep/patch/patch_curve.h"
#include "creep/patch/static_patch.h"
#include "law/forms/constant.h"
#include "patch_cases.h"
#include "shared/pi.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

namespace {

using mcawr::pi;

ElasticBody bodyOf(double G, double nu)
{
  return {2.0 * G * (1.0 + nu), nu};
}

/// Nothing heats; the strength is not asked for.
CreepPhysics coldPhysics()
{
  CreepPhysics physics;
  physics.thermal.model = ThermalModel::Off;
  physics.strength = {1.0, 1.0, nullptr};
  return physics;
}

/// A contact on cells of one's own.
PatchContact contactOn(const PatchGrid &grid, const ElasticPair &pair, double load, double A,
                       double B)
{
  PatchContact contact;
  contact.grid = grid;
  contact.pair = pair;
  contact.load = load;
  contact.hertz = hertzEllipse(load, pair.G / (1.0 - pair.nu), {A, B});
  contact.normal = pressed(grid, pair, A, B, load);
  return contact;
}

bool always()
{
  return true;
}

} // namespace

TEST(PatchCoupling, IntegralsOverACell)
{
  // against the sum over many points, near and far; odd in one direction, even in the other
  const double dx = 0.8, dy = 1.3;
  for (const auto &[x, y] : {std::pair{0.8, 0.0}, {1.6, 2.6}, {-24.0, 9.1}, {80.0, 1300.0}}) {
    constexpr int n = 400;
    CouplingIntegrals sum{0.0, 0.0};
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double u = x + ((i + 0.5) / n - 0.5) * dx, v = y + ((j + 0.5) / n - 0.5) * dy;
        sum.x += u / (u * u + v * v) * dx * dy / n / n;
        sum.y += v / (u * u + v * v) * dx * dy / n / n;
      }
    const CouplingIntegrals exact = couplingIntegrals(x, y, dx, dy);
    const double size = std::hypot(exact.x, exact.y);
    EXPECT_NEAR(exact.x, sum.x, 1e-5 * size) << x;
    EXPECT_NEAR(exact.y, sum.y, 1e-5 * size) << x;
    const CouplingIntegrals mirrored = couplingIntegrals(-x, y, dx, dy);
    EXPECT_NEAR(mirrored.x, -exact.x, 1e-14 * size);
    EXPECT_NEAR(mirrored.y, exact.y, 1e-14 * size);
  }
  const CouplingIntegrals itself = couplingIntegrals(0.0, 0.0, dx, dy);
  EXPECT_NEAR(std::hypot(itself.x, itself.y), 0.0, 1e-15);
}

TEST(PatchCoupling, PressureOnACirclePullsTowardsItsMiddle)
{
  // The influence x/r^2 is that of gravity in two dimensions: under a pressure with circular
  // symmetry the displacement at r is K/(pi G) times the load inside r, over r, towards the middle
  const Sphere sphere;
  const ElasticPair pair{1.0, 0.3, 0.2};
  const PatchGrid grid = centredGrid(96, 80, 2.6, 2.6);
  const TangentialField u = PatchCoupling(grid, pair).tangential(sphere.bound(grid) / sphere.mu);
  const double scale = pair.K / pi * sphere.load;
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const double x = grid.x(ix), y = grid.y(iy), r2 = x * x + y * y;
      const double inside = r2 < 1.0 ? 1.0 - std::pow(1.0 - r2, 1.5) : 1.0;
      ASSERT_NEAR(u.x[grid.index(ix, iy)], -scale * inside * x / r2, 3e-3 * scale);
      ASSERT_NEAR(u.y[grid.index(ix, iy)], -scale * inside * y / r2, 3e-3 * scale);
    }
}

TEST(PatchCoupling, WorkIsTheSameBothWays)
{
  // Betti: what a traction does on the displacements of a pressure, the pressure does on those of
  // the traction
  const PatchGrid grid = centredGrid(21, 34, 3.0, 2.0);
  PatchCoupling coupling(grid, {1.0, 0.3, -0.3});
  const Vector p = waves(grid, 1.0, 0.3, 2.0, 1);
  const TangentialField q{waves(grid, 1.0, 0.3, 2.0, 2), waves(grid, 1.0, 0.3, 2.0, 3)};
  const TangentialField u = coupling.tangential(p);
  const double one = q.x.dot(u.x) + q.y.dot(u.y), other = p.dot(coupling.normal(q));
  EXPECT_NEAR(one, other, 1e-13 * p.norm() * coupling.normal(q).norm());
  EXPECT_GT(std::abs(one), 1e-3 * p.norm() * coupling.normal(q).norm());
  EXPECT_FALSE(PatchCoupling(grid, {1.0, 0.3}).any());
}

TEST(PatchCoupling, CompressionOfASphereByStages)
{
  // CONTACT's printed results (see test_patch_cases.cpp): G 0.5 and 1e5, nu 0, mu 0.2986, 35 loads
  const ElasticPair pair = combinedPair(bodyOf(0.5, 0.0), bodyOf(1e5, 0.0));
  EXPECT_NEAR(pair.K, 0.5, 1e-5);
  const double A = 0.004116, mu = 0.2986;
  PatchSequence stages;
  for (int k = 1; k <= 35; ++k) {
    stages.time.push_back(k);
    stages.load.push_back(std::pow(k / 45.0, 3));
  }
  const PatchGrid grid = gridFrom(45, 45, 0.2, -4.4999, -4.4999);
  const PatchContact contact = contactOn(grid, pair, stages.load.back(), A, A);
  PatchTask task{};
  task.forceRatio = 0.0;
  const CreepPhysics physics = coldPhysics();
  const ConstantLaw law(mu);
  PatchHistory history;
  const StaticPatch still = *solveStaticPatch(physics, law, contact, task, stages, always, history);
  ASSERT_EQ(history.steps.size(), 35U);
  EXPECT_EQ(history.steps.back().approach, still.point.approach);
  EXPECT_LT(history.steps.front().peakPressure, 0.1 * still.point.peakPressure);
  EXPECT_NEAR(still.point.approach, 9.874e-2, 0.55e-5);
  EXPECT_NEAR(still.point.peakPressure, 2.392e-2, 0.55e-5);
  const auto count = [&](PatchState state) {
    return std::count(still.fields.state.begin(), still.fields.state.end(), state);
  };
  EXPECT_EQ(count(PatchState::Stick), 225);
  EXPECT_EQ(count(PatchState::Slip), 696);
  // in one go the history, and with it the state, is another one
  const StaticPatch atOnce = *solveStaticPatch(physics, law, contact, task, {}, always, history);
  EXPECT_LT(atOnce.point.stickFraction, 0.9 * still.point.stickFraction);
}

TEST(PatchCoupling, WheelAndRailExchanged)
{
  // The other body the softer one: K, tractions and creepages change sign, the pressure stays
  const PatchGrid grid = centredGrid(36, 36, 2.5, 2.5);
  const ElasticBody soft = bodyOf(0.6, 0.1), hard = bodyOf(5.0, 0.3);
  const Sphere sphere;
  const CreepPhysics physics = coldPhysics();
  const ConstantLaw law(sphere.mu);
  PatchPoint points[2];
  PatchFields fields[2];
  for (int k : {0, 1}) {
    const ElasticPair pair = k ? combinedPair(hard, soft) : combinedPair(soft, hard);
    const HertzEllipse h = hertzEllipseOfAxes(sphere.load, pair.G / (1.0 - pair.nu), 1.0, 1.0);
    const PatchContact contact = contactOn(grid, pair, sphere.load, h.curvatures.A, h.curvatures.B);
    FrozenPatch frozen(physics, contact, 0.5);
    PatchDrive drive;
    const double creep = (k ? -0.2 : 0.2) * sphere.creepUnit();
    drive.creepage = {creep, 0.5 * creep, 0.3 * creep};
    points[k] = frozen.solve(law, 1.0, drive);
    fields[k] = frozen.fields();
    // the pressure under friction is not Hertz's
    EXPECT_GT((fields[k].pressure - contact.normal.pressure).norm(),
              1e-2 * fields[k].pressure.norm());
  }
  EXPECT_NEAR(points[0].forceX, -points[1].forceX, 1e-4 * std::abs(points[0].forceX));
  EXPECT_NEAR(points[0].forceY, -points[1].forceY, 1e-4 * std::abs(points[0].forceX));
  EXPECT_NEAR(points[0].momentZ, -points[1].momentZ, 1e-4 * std::abs(points[0].forceX));
  EXPECT_LT((fields[0].pressure - fields[1].pressure).norm(), 1e-4 * fields[0].pressure.norm());
}

TEST(PatchCoupling, TransientRollingStaysSteady)
{
  const PatchGrid grid = centredGrid(36, 32, 2.6, 2.5);
  const ElasticPair pair = combinedPair(bodyOf(0.6, 0.1), bodyOf(5.0, 0.3));
  const Sphere sphere;
  const HertzEllipse h = hertzEllipseOfAxes(sphere.load, pair.G / (1.0 - pair.nu), 1.0, 1.0);
  const PatchContact contact = contactOn(grid, pair, sphere.load, h.curvatures.A, h.curvatures.B);
  const CreepPhysics physics = coldPhysics();
  const ConstantLaw law(sphere.mu);
  PatchDrive drive;
  drive.creepage = {0.15 * sphere.creepUnit(), 0.1 * sphere.creepUnit(), 0.0};
  FrozenPatch frozen(physics, contact, 0.5);
  const PatchPoint steady = frozen.solve(law, 1.0, drive);
  for (const RollingStart start : {RollingStart::Steady, RollingStart::Rest}) {
    MovingPatchSpecification moving;
    moving.passes = start == RollingStart::Steady ? 2 : 5;
    moving.start = start;
    const PatchSequence none;
    MovingPatch rolling(physics, moving, none, law, contact, 0.5);
    rolling.solve(1.0, drive, always);
    const PatchStep &last = rolling.series().back();
    const double tolerance = start == RollingStart::Steady ? 3e-4 : 2e-3;
    EXPECT_NEAR(last.forceX, steady.forceX, tolerance * std::abs(steady.forceX));
    EXPECT_NEAR(last.forceY, steady.forceY, tolerance * std::abs(steady.forceX));
    EXPECT_NEAR(last.peakPressure, steady.peakPressure, tolerance * steady.peakPressure);
  }
}

TEST(PatchCoupling, PowerClosesWithTheRollingResistance)
{
  // The traction makes the pressure lopsided: its moment about the middle times the rolling speed
  // over R, that is the integral of p times the slope 2 A x, is power too. Without creep it is all.
  const ElasticPair pair = combinedPair(bodyOf(0.6, 0.1), bodyOf(5.0, 0.3));
  const Sphere sphere;
  const HertzEllipse h = hertzEllipseOfAxes(sphere.load, pair.G / (1.0 - pair.nu), 1.0, 1.0);
  const CreepPhysics physics = coldPhysics();
  const ConstantLaw law(sphere.mu);
  for (const double scaled : {0.0, 0.2}) {
    double former = 1.0;
    for (const int n : {24, 48, 96}) {
      const PatchGrid grid = centredGrid(n, n, 2.6, 2.6);
      const PatchContact contact =
          contactOn(grid, pair, sphere.load, h.curvatures.A, h.curvatures.B);
      FrozenPatch frozen(physics, contact, 0.5);
      PatchDrive drive;
      drive.creepage = {scaled * sphere.creepUnit(), 0.5 * scaled * sphere.creepUnit(), 0.0};
      const PatchPoint point = frozen.solve(law, 1.0, drive);
      ASSERT_GT(point.frictionalPower, 0.0);
      const double missing = 1.0 - point.powerClosure;
      EXPECT_GT(missing, 0.0);
      EXPECT_LT(missing, 0.7 * former);
      former = missing;
      double moment = 0.0;
      for (int iy = 0; iy < n; ++iy)
        for (int ix = 0; ix < n; ++ix)
          moment += grid.x(ix) * frozen.fields().pressure[grid.index(ix, iy)] * grid.cellArea();
      const double resistance = 2.0 * h.curvatures.A * moment;
      const double given = -(point.creepage.xi * point.forceX + point.creepage.eta * point.forceY);
      const double byPressure = point.frictionalPower / point.powerClosure - given;
      EXPECT_GT(resistance, 0.0);
      EXPECT_NEAR(byPressure, resistance, 4.0 / n * resistance); // of first order in the cells
    }
  }
}
