// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "contact/gmres.h"
#include "contact/line/line_coupling.h"
#include "contact/line/rolling_contact.h"
#include "contact_cases.h"
#include "shared/pi.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;
using contact_cases::cylinder;
using contact_cases::table2;

namespace {
using mcawr::pi;

double ratio(const RollingResult &result, const NormalContactProblem &problem)
{
  return result.force() / problem.load;
}

/// Slow reference: dense elimination on the stick cells, one change of the sets a time round.
Vector denseRolling(const Vector &bound, const Vector &drive, double layer = 0.0)
{
  const int n = static_cast<int>(bound.size());
  const auto kernel = [layer](int m) {
    return 2.0 / (pi * (m + 0.5)) + (m == 0 ? layer : m == -1 ? -layer : 0.0);
  };
  std::vector<int> state(n, 0); // 0: stick, +-1: slip
  Vector q = Vector::Zero(n);
  for (int round = 0; round < 200; ++round) {
    std::vector<int> stick;
    for (int i = 0; i < n; ++i) {
      if (bound[i] > 0.0 && state[i] == 0)
        stick.push_back(i);
      q[i] = state[i] * bound[i];
    }
    const int m = static_cast<int>(stick.size());
    Eigen::MatrixXd a(m, m);
    Vector b(m);
    for (int i = 0; i < m; ++i) {
      b[i] = drive[stick[i]];
      for (int j = 0; j < n; ++j)
        b[i] -= kernel(stick[i] - j) * q[j];
      for (int j = 0; j < m; ++j)
        a(i, j) = kernel(stick[i] - stick[j]);
    }
    const Vector x = a.partialPivLu().solve(b);
    for (int i = 0; i < m; ++i)
      q[stick[i]] = x[i];
    bool changed = false;
    for (int i = 0; i < n; ++i) {
      if (bound[i] == 0.0)
        continue;
      double slip = drive[i];
      for (int j = 0; j < n; ++j)
        slip -= kernel(i - j) * q[j];
      const int before = state[i];
      if (before == 0 && std::abs(q[i]) > bound[i] * (1 + 1e-12))
        state[i] = q[i] > 0 ? 1 : -1;
      else if (before != 0 && before * slip < -1e-12)
        state[i] = 0;
      changed = changed || state[i] != before;
    }
    if (!changed)
      return q;
  }
  ADD_FAILURE() << "the reference does not settle";
  return q;
}
} // namespace

TEST(Gmres, SolvesWithRelativeTolerance)
{
  // Rows of very different size, right-hand side near 1e-8: an absolute tolerance would stop at
  // once
  const int n = 40;
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(n, n);
  for (int i = 0; i + 1 < n; ++i)
    a(i, i + 1) = 0.8 * std::sin(i), a(i + 1, i) = 0.3;
  const Vector b = 1e-8 * Vector::LinSpaced(n, 1.0, 2.0);
  Vector x = Vector::Zero(n);
  const auto apply = [&](const Vector &v) { return Vector(a * v); };
  const auto same = [](const Vector &v) { return v; };
  const GmresReport report = gmres(apply, same, b, x, b.norm(), 1e-10, 8);
  EXPECT_TRUE(report.converged);
  EXPECT_LT((a * x - b).norm(), 1e-10 * b.norm());
  EXPECT_LT((x - a.fullPivLu().solve(b)).norm(), 1e-8 * x.norm());
}

namespace {
/// Largest error of T/N, relative to its exact value, at a hundred creeps below full sliding.
/// Carter: T/N = mu (1 - (1 - creep/sliding)^2).
double carterError(int n, double domain)
{
  constexpr double mu = 0.3;
  constexpr double slidingCreep = 1e-3 / (1.0 - 0.645225296); // mu a/R of Table 2's contact
  HalfPlane plane(n, Boundary::Free);
  const NormalContactProblem problem = cylinder(n, 0.0, 1, domain);
  const NormalContactResult normal = solveNormalContact(plane, problem);
  RollingOptions options;
  options.contact = contactIntervals(normal, Boundary::Free);
  double worst = 0.0;
  for (int k = 1; k <= 100; ++k) {
    const double adhering = 1.0 - k / 101.0;
    const double exact = mu * (1.0 - adhering * adhering);
    const RollingResult result =
        solveFrozenRolling(plane, mu * normal.pressure, slidingCreep * k / 101.0, options);
    worst = std::max(worst, std::abs(ratio(result, problem) / exact - 1.0));
  }
  return worst;
}
} // namespace

TEST(FrozenRollingLong, CarterAtAHundredCreeps)
{
  // wherever the edges of the contact lie in their cells
  for (double domain : {2.4, 2.7254, 3.0, 3.539, 3.7, 3.9977, 4.0})
    EXPECT_LT(carterError(1000, domain), 2e-4) << domain;
}

TEST(FrozenRolling, CarterErrorFallsFasterThanTheCellSize)
{
  // edges at faces of cells on every grid
  double last = 1.0;
  for (int n : {250, 500, 1000, 2000}) {
    const double error = carterError(n, 2.5);
    EXPECT_LT(error, 0.4 * last) << n;
    last = error;
  }
  EXPECT_LT(last, 5e-6);
}

TEST(FrozenRolling, CarterWithWholeCells)
{
  // without the edges the force converges, too, but in the first order
  double last = 1.0;
  for (int n : {500, 1000, 2000, 4000}) {
    HalfPlane plane(n, Boundary::Free);
    const NormalContactProblem problem = cylinder(n);
    const Vector bound = 0.3 * solveNormalContact(plane, problem).pressure;
    const double error =
        std::abs(ratio(solveFrozenRolling(plane, bound, 1e-3), problem) - 0.175105295);
    EXPECT_LT(error, 0.55 * last);
    last = error;
  }
}

TEST(FrozenRolling, StickZoneTouchesTheLeadingEdge)
{
  const int n = 2000;
  HalfPlane plane(n, Boundary::Free);
  const Vector pressure = solveNormalContact(plane, cylinder(n)).pressure;
  const RollingResult result = solveFrozenRolling(plane, 0.3 * pressure, 1e-3);
  const double h = 4.0 / n; // in a
  int first = n, last = 0;
  for (int i = 0; i < n; ++i)
    if (result.state[i] == Adhesion::Stick) {
      first = std::min(first, i);
      last = i;
    }
  EXPECT_NEAR((last + 1 - n / 2) * h, 1.0, 1.5 * h);
  EXPECT_NEAR((last + 1 - first) * h, 2 * 0.645225296, 3 * h);
  for (int i = first; i <= last; ++i)
    EXPECT_NEAR(result.slip[i], 0.0, 1e-9);
}

TEST(FrozenRolling, EqualsDenseReference)
{
  for (double slope : {0.0, 0.01, 0.02}) {
    const int n = 760;
    HalfPlane plane(n, Boundary::Free);
    const Vector pressure = solveNormalContact(plane, cylinder(n, slope)).pressure;
    const Vector bound = 0.3 * pressure;
    for (double creep : {2e-4, 1e-3, 2.5e-3}) {
      const Vector q = solveFrozenRolling(plane, bound, creep).traction;
      const Vector reference = denseRolling(bound, Vector::Constant(n, creep));
      EXPECT_LT((q - reference).cwiseAbs().maxCoeff(), 1e-6 * bound.maxCoeff())
          << slope << " " << creep;
    }
  }
}

TEST(FrozenRolling, EqualsDenseReferenceWithALayerAndUnlikeBodies)
{
  struct Case {
    double slope, beta, layer;
    int cells;
  };
  for (const Case &given : {Case{0.0, -0.2, 0.5, 300}, Case{0.0, 0.15, 0.0, 300},
                            Case{0.0, 0.15, 50.0, 300}, Case{0.02, -0.2, 5.0, 760}}) {
    HalfPlane plane(given.cells, Boundary::Free);
    const Vector pressure = solveNormalContact(plane, cylinder(given.cells, given.slope)).pressure;
    const Vector bound = 0.3 * pressure;
    RollingOptions options;
    options.layer = given.layer;
    options.imposed = couplingSlip(given.beta, pressure);
    const Vector q = solveFrozenRolling(plane, bound, 1e-3, options).traction;
    const Vector drive = options.imposed.array() + 1e-3;
    EXPECT_LT((q - denseRolling(bound, drive, given.layer)).cwiseAbs().maxCoeff(),
              1e-6 * bound.maxCoeff())
        << given.beta << " " << given.layer;
  }
}

TEST(FrozenRolling, InitialSlopeIsTheLengthInCells)
{
  // Exactly, whatever the profile and the friction, where edge cells count as a whole
  HalfPlane plane(2048, Boundary::Free);
  for (double slope : {0.01, 0.04}) {
    const Vector pressure = solveNormalContact(plane, cylinder(2048, slope)).pressure;
    const double force = solveFrozenRolling(plane, 1e9 * pressure, 1e-6).force();
    EXPECT_NEAR(force / 1e-6 / (pi / 4.0 * (pressure.array() > 0.0).count()), 1.0, 1e-6);
  }
}

TEST(FrozenRolling, InitialSlopeIsRealContactLength)
{
  // dT/dcreep = (pi E*/4) x real contact length within 2 %, whatever the friction: against the
  // length on 32768 cells (350 on the shortest wave), and the error falls with the cell size
  for (double slope : {0.01, 0.02, 0.04}) {
    double exact = 0.0;
    double errors[3] = {};
    int k = -1;
    for (int n : {32768, 1024, 2048, 8192}) {
      HalfPlane plane(n, Boundary::Free);
      const NormalContactResult normal = solveNormalContact(plane, cylinder(n, slope));
      RollingOptions options;
      options.contact = contactIntervals(normal, Boundary::Free);
      const double length = contactLength(options.contact);
      const double force = solveFrozenRolling(plane, 1e9 * normal.pressure, 1e-6, options).force();
      EXPECT_NEAR(force / 1e-6 / (pi / 4.0 * length), 1.0, n > 1024 ? 2e-3 : 5e-3);
      if (k < 0)
        exact = length / n;
      else
        errors[k] = std::abs(force / 1e-6 / (pi / 4.0) / n / exact - 1.0);
      ++k;
    }
    EXPECT_LT(errors[0], 0.02) << slope;
    EXPECT_LT(errors[1], 0.01) << slope;
    EXPECT_LT(errors[2], 0.0025) << slope;
  }
}

TEST(FrozenRolling, ProductsHardlyGrowWithTheNumberOfCells)
{
  std::vector<int> products;
  for (int n : {1024, 16384}) {
    HalfPlane plane(n, Boundary::Free);
    const Vector pressure = solveNormalContact(plane, cylinder(n, 0.01)).pressure;
    products.push_back(solveFrozenRolling(plane, 1e9 * pressure, 1e-6).products);
  }
  EXPECT_LE(products[0], 20);
  EXPECT_LE(products[1], 20);
}

TEST(FrozenRolling, TractionGrowsWithCreepAndStaysBounded)
{
  HalfPlane plane(1024, Boundary::Free);
  const Vector bound = 0.3 * solveNormalContact(plane, cylinder(1024, 0.02)).pressure;
  double last = 0.0;
  for (double creep : {1e-5, 1e-4, 5e-4, 1e-3, 3e-3, 1e-2, 3e-2}) {
    const RollingResult result = solveFrozenRolling(plane, bound, creep);
    EXPECT_GT(result.force(), last * (1.0 - 1e-12));
    EXPECT_LE(result.force(), bound.sum() * (1.0 + 1e-9));
    for (int i = 0; i < bound.size(); ++i)
      EXPECT_LE(std::abs(result.traction[i]), bound[i] * (1.0 + 1e-6));
    last = result.force();
  }
  EXPECT_NEAR(last, bound.sum(), 1e-9 * last);
}

TEST(FrozenRolling, WarmStartChangesNothing)
{
  HalfPlane plane(2048, Boundary::Free);
  const Vector bound = 0.3 * solveNormalContact(plane, cylinder(2048, 0.01)).pressure;
  const RollingResult cold = solveFrozenRolling(plane, bound, 1e-3);
  const RollingResult other = solveFrozenRolling(plane, bound, 3e-3);
  RollingOptions options;
  options.start = other.state;
  options.startTraction = other.traction;
  const RollingResult warm = solveFrozenRolling(plane, bound, 1e-3, options);
  EXPECT_LT((warm.traction - cold.traction).cwiseAbs().maxCoeff(), 1e-6 * bound.maxCoeff());
}

TEST(FrozenRolling, NoCreepNoTraction)
{
  HalfPlane plane(256, Boundary::Free);
  const Vector bound = 0.3 * solveNormalContact(plane, cylinder(256)).pressure;
  EXPECT_EQ(solveFrozenRolling(plane, bound, 0.0).force(), 0.0);
  EXPECT_THROW(solveFrozenRolling(plane, bound, -1e-3), Error);
}

TEST(FrozenRolling, NoCreepSticksAfterFullSlip)
{
  const NormalContactProblem problem = cylinder(256);
  HalfPlane plane(256, Boundary::Free);
  const Vector bound = 0.3 * solveNormalContact(plane, problem).pressure;
  RollingOptions options;
  options.start = solveFrozenRolling(plane, bound, 1.0).state;
  const RollingResult result = solveFrozenRolling(plane, bound, 0.0, options);
  for (int i = 0; i < 256; ++i)
    EXPECT_EQ(result.state[i], bound[i] > 0.0 ? Adhesion::Stick : Adhesion::Apart);
}

TEST(TransientRolling, ReachesTheSteadyStateOfASmoothContact)
{
  const int n = 512;
  HalfPlane plane(n, Boundary::Free);
  const NormalContactProblem problem = cylinder(n);
  const Vector bound = 0.3 * solveNormalContact(plane, problem).pressure;
  for (double creep : {5e-4, 1e-3, 2e-3}) {
    const double steady = solveFrozenRolling(plane, bound, creep).force();
    for (double reference : {0.8, 2.0}) { // the free constant does not change the steady state
      TransientRolling rolling(plane, reference * n / 4);
      RollingResult result;
      for (int step = 0; step < 2 * n; ++step)
        result = rolling.step(bound, creep);
      EXPECT_NEAR(result.force() / steady, 1.0, 6e-3) << creep << " " << reference;
    }
  }
}
