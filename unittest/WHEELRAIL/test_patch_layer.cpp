// SPDX-License-Identifier: GPL-2.0-or-later
// A layer between the bodies: elastic, or elastic and perfectly plastic.
#include "case_text.h"
#include "contact/patch/patch_contact.h"
#include "contact/patch/solvers/kalker.h"
#include "contact/patch/solvers/transient.h"
#include "creep/patch/patch_point.h"
#include "law/forms/constant.h"
#include "patch_cases.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

namespace {

using mcawr::pi;

/// Force over xi of full stick on an ellipse, divided by that of the layer alone, 8 a^2 b/(3 l).
double slope(double a, double b, double layer, int cells)
{
  const ElasticPair pair{1.0, 0.3, 0.0, layer};
  const PatchGrid grid{{cells + 1, cells, 2.0 * a / cells, 2.0 * b / cells}, -a, -b};
  const Vector inside = sampled(grid, [&](double x, double y) {
    return x * x / (a * a) + y * y / (b * b) < 1.0 ? 1.0 : 0.0;
  });
  TangentialSolver solver(grid, pair);
  const double area = inside.sum() * grid.cellArea() / (pi * a * b);
  return creepSensitivity(solver, inside).xx / std::pow(area, 1.5);
}

PatchContact steelWheel(const InterfacialLayer &layer)
{
  PatchContactSpecification contact;
  contact.load = {1e5};
  contact.curvatures = GapCurvatures{1.0, 1.0};
  contact.bodies = {ElasticBody{210e9, 0.3}, ElasticBody{210e9, 0.3}};
  contact.domain = 2.2;
  contact.nx = contact.ny = 40;
  contact.layer = layer;
  return preparePatch(contact, {}, 1e5, 0, INFINITY, 0.0);
}

PatchPoint rolled(const PatchContact &contact, const PatchDrive &drive)
{
  CreepPhysics physics;
  physics.thermal.model = ThermalModel::Off;
  FrozenPatch rolling(physics, contact, 0.5);
  return rolling.solve(ConstantLaw(0.3), 20.0, drive);
}

} // namespace

// A very soft layer is the simplified theory: q = xi (way from the edge)/l in every cell, exactly.
TEST(PatchLayer, SoftOneIsWinklersFoundation)
{
  const double l = 1e6;
  const PatchGrid grid{{33, 32, 2.0 / 32, 2.0 / 32}, -1.0, -1.0};
  const Vector inside =
      sampled(grid, [&](double x, double y) { return x * x + y * y < 1.0 ? 1.0 : 0.0; });
  TangentialSolver solver(grid, {1.0, 0.3, 0.0, l});
  TangentialProblem problem;
  problem.bound = 1e3 * inside;
  problem.creepage.xi = 0.7;
  TangentialOptions options;
  options.tolerance = 1e-9;
  const TangentialResult result = solver.solve(problem, options);
  for (int iy = 0; iy < grid.ny; ++iy) {
    int before = 0; // cells from the leading edge
    for (int ix = grid.nx - 1; ix >= 0; --ix)
      if (inside[grid.index(ix, iy)] > 0.0) {
        ++before;
        EXPECT_NEAR(result.traction.x[grid.index(ix, iy)], -0.7 * grid.dx * before / l,
                    1e-5 * 0.7 / l);
      }
  }
}

// Initial slope between both limits: Winkler's in series with Kalker's, k = 1/(1/k_layer +
// 1/k_C11).
TEST(PatchLayer, InitialSlopeIsThatInSeries)
{
  constexpr double c11 = 4.2936, c11Half = 3.8215; // circle, a/b = 1/2; nu = 0.3
  for (const auto &[a, b, c] : {std::array{1.0, 1.0, c11}, {0.5, 1.0, c11Half}})
    for (const double share : {0.2, 1.0, 5.0}) { // of the layer, of the half-spaces
      const double kalker = a * b * c, layer = share * 8.0 * a / (3.0 * c);
      const double series = 8.0 * a * a * b / (3.0 * (layer + 8.0 * a / (3.0 * c)));
      const double found = 2.0 * slope(a, b, layer, 64) - slope(a, b, layer, 32);
      EXPECT_LT(found, kalker);
      EXPECT_LT(found, 8.0 * a * a * b / (3.0 * layer));
      EXPECT_NEAR(found, series, 0.06 * series) << share << " " << a;
    }
  const double soft = 1e4;
  EXPECT_NEAR(2.0 * slope(1.0, 1.0, soft, 64) - slope(1.0, 1.0, soft, 32), 8.0 / (3.0 * soft),
              0.005 * 8.0 / (3.0 * soft));
  EXPECT_NEAR(2.0 * slope(1.0, 1.0, 1e-9, 64) - slope(1.0, 1.0, 1e-9, 32), c11, 0.01 * c11);
}

TEST(PatchLayer, NoneChangesNoBit)
{
  PatchDrive drive;
  drive.creepage = {1e-3, 2e-4, 0.3};
  const PatchContact bare = steelWheel({});
  EXPECT_EQ(bare.pair.layer, 0.0);
  const PatchPoint without = rolled(bare, drive);
  // the former solver, whose products had no such term
  EXPECT_EQ(without.forceX, rolled(steelWheel({0.0, 1e6}), drive).forceX);
  const PatchPoint thin = rolled(steelWheel({1e-12, 1e9}), drive);
  EXPECT_NEAR(thin.forceX, without.forceX, 1e-5 * std::abs(without.forceX));
}

// q <= min(mu p, yield): a layer that yields below all pressures in the middle carries that much.
TEST(PatchLayer, FlowsAtItsYieldStress)
{
  PatchDrive drive;
  drive.creepage.xi = 0.2;
  const InterfacialLayer layer{20e-6, 500e6, 100e6};
  const PatchContact contact = steelWheel(layer);
  const PatchPoint point = rolled(contact, drive);
  const Vector bound = (0.3 * contact.normal.pressure).cwiseMin(100e6);
  EXPECT_NEAR(-point.forceX, bound.sum() * contact.grid.cellArea(), 1e-6 * -point.forceX);
  EXPECT_NEAR(point.peakTraction, 100e6, 1.0);
  EXPECT_NEAR(point.frictionWork, point.tGamma, 0.01 * point.tGamma); // flow is heat, too
  // never reached: elastic
  drive.creepage.xi = 2e-4;
  EXPECT_EQ(rolled(steelWheel({20e-6, 500e6, 1e12}), drive).forceX,
            rolled(steelWheel({20e-6, 500e6}), drive).forceX);
}

// Rolling step by step comes to the steady state, layer and all.
TEST(PatchLayer, TransientComesToTheSteadyState)
{
  const Sphere sphere;
  const ElasticPair pair{1.0, 0.3, 0.0, 0.8};
  const PatchGrid grid = centredGrid(24, 24, 2.4, 2.4);
  TangentialSolver solver(grid, pair);
  TangentialProblem problem;
  problem.bound = sphere.bound(grid);
  problem.creepage.xi = 0.3 * sphere.creepUnit();
  TangentialOptions options;
  options.tolerance = 1e-7;
  const double steady = patchSums(grid, solver.solve(problem, options)).forceX;
  TransientPatch transient(grid, pair);
  TransientPatch::Step step;
  step.bound = problem.bound;
  step.creepage = problem.creepage;
  double force = 0.0;
  for (int k = 0; k < 120; ++k)
    force = patchSums(grid, transient.step(step, options)).forceX;
  EXPECT_NEAR(force, steady, 2e-4 * std::abs(steady));
}

TEST(PatchLayer, IsReadFromTheCase)
{
  const std::string wheel = "contact: {load: 100 kN, youngs_modulus: 210 GPa, poissons_ratio: 0.3, "
                            "radii: {wheel_rolling: 0.5 m, rail_profile: 300 mm}}\ncreep: 0.01\n";
  const auto layerOf = [&](const std::string &text) {
    return std::get<PatchSpecification>(case_text::read(wheel + text).task).contact.layer;
  };
  const InterfacialLayer layer =
      layerOf("layer: {thickness: 20 um, shear_modulus: 0.5 GPa, yield_stress: 90 MPa}\n");
  EXPECT_DOUBLE_EQ(layer.compliance(), 20e-6 / 0.5e9);
  EXPECT_EQ(layer.yieldStress, 90e6);
  EXPECT_EQ(layerOf("").compliance(), 0.0);
  EXPECT_THROW(layerOf("layer: {thickness: 20 um}\n"), Error);
  EXPECT_THROW(layerOf("layer: {yield_stress: 90 MPa}\n"), Error);
}
