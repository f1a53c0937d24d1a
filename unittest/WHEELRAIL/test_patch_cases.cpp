// SPDX-License-Identifier: GPL-2.0-or-later
// Printed results of CONTACT (Vollebregt; github.com/eve70a/CONTACT, commit d431cdb, July 2025: its
// shipped examples cattaneo, bench1 and the like with their reference outputs), an independent
// program for the same equations on the same grids: numbers agree to the digits it prints, and so
// does every cell's state.
#include "contact/patch/solvers/transient.h"
#include "patch_cases.h"
#include "shared/pi.h"

#include <gtest/gtest.h>
#include <map>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

namespace {

/// Half a unit of the last digit printed, and a tenth for its rounding.
constexpr double halfDigit = 0.55;

TransientPatch::Step shiftWithForce(const Vector &bound, double forceX)
{
  TransientPatch::Step step;
  step.bound = bound;
  step.cells = 0;
  step.forceX = forceX;
  step.forceY = 0.0;
  return step;
}

/// For digits that the reference prints.
TangentialOptions accurate()
{
  TangentialOptions options;
  options.tolerance = 1e-7;
  return options;
}

/// Elastic energy of the pressure: N mm.
double normalEnergy(const PatchGrid &grid, const ElasticPair &pair, const Vector &pressure)
{
  PatchHalfSpace space(grid, pair);
  return 0.5 * grid.cellArea() * pressure.dot(space.displacement(pressure));
}

double tangentialEnergy(const PatchGrid &grid, const TangentialField &q, const TangentialField &u)
{
  return 0.5 * grid.cellArea() * (q.x.dot(u.x) + q.y.dot(u.y));
}

} // namespace

TEST(PatchCases, CattaneoShift)
{
  const ElasticPair pair{200.0, 0.42};
  const double load = 9.1954, mu = 0.4;
  const PatchGrid grid = gridFrom(19, 19, 0.4 / 3.0, -3.8 / 3.0, -3.8 / 3.0);
  const NormalContactResult normal = pressed(grid, pair, 0.01, 0.01, load);
  EXPECT_EQ(normal.contactCells(), 177);
  EXPECT_NEAR(normal.approach, 1.998e-2, halfDigit * 1e-5);
  EXPECT_NEAR(normal.peakPressure(), 4.393, halfDigit * 1e-3);

  TransientPatch patch(grid, pair);
  const TangentialResult result =
      patch.step(shiftWithForce(mu * normal.pressure, -0.875 * mu * load), accurate());
  EXPECT_EQ(result.stickCells(), 45);
  EXPECT_EQ(result.slipCells(), 132);
  EXPECT_NEAR(result.creepage.xi, 8.155e-3, halfDigit * 1e-6);
  EXPECT_NEAR(patchSums(grid, result).forceX, -0.875 * mu * load, 1e-6 * mu * load);
  const double energy = normalEnergy(grid, pair, normal.pressure) +
                        tangentialEnergy(grid, patch.traction(), patch.displacement());
  EXPECT_NEAR(1e-3 * energy, 8.525e-5, halfDigit * 1e-8); // printed in J
}

TEST(PatchCases, ShiftWithApproachGiven)
{
  const ElasticPair pair{82000.0, 0.28};
  const double mu = 0.3;
  const PatchGrid grid = gridFrom(17, 17, 0.4 / 3.0, -3.4 / 3.0, -3.4 / 3.0);
  PatchHalfSpace space(grid, pair);
  NormalContactProblem problem;
  problem.profile = sampled(grid, [](double x, double y) { return 0.0056566 * (x * x + y * y); });
  problem.approach = 0.01131;
  const NormalContactResult normal = solveNormalContact(space, problem);
  EXPECT_NEAR(normal.pressure.sum() * grid.cellArea(), 1720.0, halfDigit);
  EXPECT_NEAR(normal.peakPressure(), 821.0, halfDigit * 0.1);

  TransientPatch patch(grid, pair);
  TransientPatch::Step step;
  step.bound = mu * normal.pressure;
  step.cells = 0;
  step.creepage.xi = 0.00304;
  const TangentialResult result = patch.step(step, accurate());
  EXPECT_NEAR(patchSums(grid, result).forceX, -451.5, halfDigit * 0.1);
  EXPECT_EQ(result.stickCells(), 45);
  EXPECT_EQ(result.slipCells(), 132);
}

TEST(PatchCases, FromCattaneoToCarter)
{
  const ElasticPair pair{1.0, 0.28};
  const double mu = 0.4013, load = 0.4705;
  const PatchGrid grid = gridFrom(34, 33, 0.25, -4.125, -4.125);
  const NormalContactResult normal = pressed(grid, pair, 0.002963, 0.002963, load);
  EXPECT_EQ(normal.contactCells(), 621);
  EXPECT_NEAR(normal.peakPressure(), 1.834e-2, halfDigit * 1e-5);

  TransientPatch patch(grid, pair);
  TransientPatch::Step step = shiftWithForce(mu * normal.pressure, -0.657 * mu * load);
  TangentialResult result = patch.step(step, accurate());
  EXPECT_NEAR(result.creepage.xi, 1.774e-2, halfDigit * 1e-5);
  EXPECT_EQ(result.stickCells(), 305);
  EXPECT_EQ(result.slipCells(), 316);

  const std::map<int, double> creeps = {
      {1, 1.824},  {2, 1.882},  {3, 1.955},  {4, 2.050},  {5, 2.140},  {6, 2.221},
      {7, 2.334},  {8, 2.428},  {9, 2.551},  {10, 2.676}, {11, 2.801}, {12, 2.968},
      {13, 3.184}, {14, 3.403}, {24, 3.062}, {33, 3.111}, {56, 3.101}};
  step.cells = 1;
  for (int i = 1; i <= 56; ++i) {
    result = patch.step(step, accurate());
    step.creepage = result.creepage;
    const auto printed = creeps.find(i);
    if (printed != creeps.end()) {
      EXPECT_NEAR(1e3 * result.creepage.xi, printed->second, halfDigit * 1e-3) << "step " << i;
    }
  }
  EXPECT_EQ(result.stickCells(), 346);
  EXPECT_EQ(result.slipCells(), 275);
}

TEST(PatchCases, SteadyRolling)
{
  // 41 x 41 cells from the reference; finer ones from an independent numpy program
  const ElasticPair pair{1.0, 0.28};
  const double mu = 0.4013, load = 0.4705;
  const double forces[] = {0.6466, 0.64183, 0.63927};
  for (int level = 0; level < 3; ++level) {
    const int refined = 1 << level;
    const PatchGrid grid = gridFrom(41 * refined, 41 * refined, 0.2 / refined, -4.1, -4.1);
    const NormalContactResult normal = pressed(grid, pair, 0.002963, 0.002963, load);
    TangentialProblem problem;
    problem.bound = mu * normal.pressure;
    problem.creepage.xi = -0.00304;
    TangentialSolver solver(grid, pair);
    const TangentialResult result = solver.solve(problem);
    const double digit = level ? 1e-5 : 1e-4;
    EXPECT_NEAR(patchSums(grid, result).forceX / (mu * load), forces[level], halfDigit * digit);
    if (level == 0) {
      EXPECT_EQ(normal.contactCells(), 973);
      EXPECT_EQ(result.stickCells(), 555);
      EXPECT_EQ(result.slipCells(), 418);
    }
    // the operating point anew, with the force given:
    problem.forceX = patchSums(grid, result).forceX;
    problem.forceY = 0.0;
    problem.creepage.xi = 0.0;
    const TangentialResult driven = solver.solve(problem);
    EXPECT_NEAR(driven.creepage.xi, -0.00304, 1e-8);
    EXPECT_NEAR(driven.creepage.eta, 0.0, 1e-8);
  }
}

TEST(PatchCases, CreepCurveOfAWheel)
{
  const ElasticPair pair{82000.0, 0.28};
  const double mu = 0.33, load = 106700.0, A = 0.8e-3;
  const HertzEllipse hertz =
      hertzEllipse(load, pair.G / (1.0 - pair.nu), {A, A / curvatureRatio(0.5)});
  EXPECT_NEAR(hertz.a, 6.3035, 1e-3);
  EXPECT_NEAR(hertz.hertzPressure, 641.05, 0.05);
  const double creeps[] = {4e-4, 1.2e-3, 2e-3, 2.8e-3};
  const double forces[2][4] = {{0.2588, 0.6482, 0.8816, 0.9832},      // reference
                               {0.25627, 0.64231, 0.87540, 0.98071}}; // numpy program
  const int stick[] = {1182, 782, 422, 132};
  for (int level = 0; level < 2; ++level) {
    const int refined = level ? 3 : 1;
    const PatchGrid grid = centredGrid(48 * refined, 44 * refined, 2.2 * 6.30352, 2.2 * 12.60756);
    const NormalContactResult normal = pressed(grid, pair, A, hertz.curvatures.B, load);
    TangentialSolver solver(grid, pair);
    TangentialOptions options;
    for (int i = 0; i < 4; ++i) {
      TangentialProblem problem;
      problem.bound = mu * normal.pressure;
      problem.creepage.xi = creeps[i];
      const TangentialResult result = solver.solve(problem, options);
      options.start = result.traction;
      EXPECT_NEAR(-patchSums(grid, result).forceX / (mu * load), forces[level][i],
                  halfDigit * (level ? 1e-5 : 1e-4));
      if (level == 0) {
        EXPECT_EQ(result.stickCells(), stick[i]);
      }
    }
    if (level == 0) {
      EXPECT_EQ(normal.contactCells(), 1384);
    }
  }
}

TEST(PatchCases, LateralCreepAndSpin)
{
  const ElasticPair pair{82000.0, 0.28};
  const double mu = 0.3, load = 82000.0, a = 8.0, b = 4.0, speed = 30.0;
  const HertzEllipse hertz = hertzEllipseOfAxes(load, pair.G / (1.0 - pair.nu), a, b);
  const PatchGrid grid = centredGrid(44, 44, 2.2 * a, 2.2 * b);
  const NormalContactResult normal =
      pressed(grid, pair, hertz.curvatures.A, hertz.curvatures.B, load);
  EXPECT_EQ(normal.contactCells(), 1276);
  EXPECT_NEAR(normal.peakPressure(), 1223.0, halfDigit);
  TangentialProblem problem;
  problem.bound = mu * normal.pressure;
  problem.creepage = {0.0, -6.25e-4, 6.25e-4};
  problem.spinPoint = 1.0 / 6.0; // the reference's
  const TangentialResult result = TangentialSolver(grid, pair).solve(problem);
  const PatchSums sums = patchSums(grid, result);
  EXPECT_NEAR(sums.forceY / (mu * load), -0.6074, halfDigit * 1e-4);
  EXPECT_NEAR(sums.momentZ, -4.821e4, halfDigit * 10.0);
  EXPECT_EQ(result.stickCells(), 356);
  EXPECT_EQ(result.slipCells(), 920);
  EXPECT_NEAR(-speed * sums.frictionalPower, -540.4, halfDigit * 0.1); // N m/s
}

TEST(PatchCases, OneRowOfLongCellsIsCarter)
{
  const ElasticPair pair{1.0, 0.28};
  const double peak = 1e-3, mu = 0.3, length = 1000.0;
  const double modulus = pair.G / (1.0 - pair.nu);
  const double radius = 0.5 * modulus / peak, load = 0.5 * mcawr::pi * peak * length;
  const double saturation = mu / radius;
  const double creeps[] = {0.1, 0.4, 0.7}, exact[] = {0.19, 0.64, 0.91};
  const double fine[] = {0.19016, 0.64057, 0.91081}; // n = 400, numpy program
  for (int n : {100, 400}) {
    const double dx = 2.0 / n;
    const PatchGrid grid{{n + 2, 1, dx, length}, -1.0 - dx, -0.5 * length};
    const NormalContactResult normal = pressed(grid, pair, 0.5 / radius, 0.0, load);
    TangentialSolver solver(grid, pair);
    for (int i = 0; i < 3; ++i) {
      TangentialProblem problem;
      problem.bound = mu * normal.pressure;
      problem.creepage.xi = creeps[i] * saturation;
      const double ratio = -patchSums(grid, solver.solve(problem)).forceX / (mu * load);
      EXPECT_NEAR(ratio, exact[i], 4.0 / n * exact[i]); // first order
      if (n == 400) {
        EXPECT_NEAR(ratio, fine[i], halfDigit * 1e-5);
      }
    }
  }
}
