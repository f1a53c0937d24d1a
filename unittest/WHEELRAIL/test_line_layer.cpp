// SPDX-License-Identifier: GPL-2.0-or-later
// A layer between bodies on a line: elastic, or elastic and perfectly plastic.
#include "base/errors.h"
#include "case_text.h"
#include "contact/line/rolling_contact.h"
#include "contact/patch/elasticity/patch_half_space.h"
#include "contact/patch/solvers/tangential.h"
#include "contact_cases.h"
#include "creep/line/creep_curve.h"
#include "shared/pi.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;
using contact_cases::cylinder;

namespace {

using mcawr::pi;

std::string wheel(double creep, const std::string &more, int cells = 512)
{
  return case_text::table2 + fmt::format("friction: {{law: constant, mu: 0.3}}\nthermal: off\n"
                                         "speed: 10 m/s\ncells: {}\ncreep: {}\n{}",
                                         cells, creep, more);
}

CreepCurves solved(const std::string &text)
{
  const CreepSpecification asked = case_text::rolling(text);
  return solveCreepCurves(asked, asked.friction.read());
}

} // namespace

TEST(LineLayer, SoftOneIsWinklersFoundation)
{
  // q = creep (way from the edge)/l at the centre of every cell
  constexpr int n = 1024;
  constexpr double layer = 1e7, creep = 1e-3;
  HalfPlane plane(n, Boundary::Free);
  for (double slope : {0.0, 0.01}) {
    const NormalContactResult normal = solveNormalContact(plane, cylinder(n, slope));
    RollingOptions options;
    options.contact = contactIntervals(normal, Boundary::Free);
    options.layer = layer;
    const Vector q = solveFrozenRolling(plane, 1e9 * normal.pressure, creep, options).traction;
    for (const ContactInterval &interval : options.contact)
      for (int i = interval.first; i < interval.last; ++i)
        EXPECT_NEAR(q[i] * layer / creep / (interval.right - i), 1.0, 1e-4) << slope << " " << i;
  }
}

TEST(LineLayer, FewProductsForEveryCompliance)
{
  constexpr int n = 2048;
  HalfPlane plane(n, Boundary::Free);
  for (double slope : {0.0, 0.02}) {
    const NormalContactResult normal = solveNormalContact(plane, cylinder(n, slope));
    double last = 1.0;
    for (double layer : {0.0, 0.1, 1.0, 10.0, 100.0, 1e3, 1e5}) {
      RollingOptions options;
      options.contact = contactIntervals(normal, Boundary::Free);
      options.layer = layer;
      const RollingResult result = solveFrozenRolling(plane, 1e9 * normal.pressure, 1e-6, options);
      EXPECT_LE(result.products, slope > 0.0 ? 80 : 20) << slope << " " << layer;
      EXPECT_LT(result.force(), last) << slope << " " << layer;
      last = result.force();
    }
  }
}

TEST(LineLayer, AsOnAPatchThatIsLong)
{
  // One row of cells that are 4000 of their lengths across is a line, with edges at faces of cells:
  // both are off by the order of a cell, 1/n of the contact.
  constexpr int n = 200;
  constexpr double nu = 0.3, layer = 30.0, creep = 1e-3;
  const double modulus = 1.0 / (1.0 - nu); // of G = 1
  const PatchGrid grid{{n + 2, 1, 1.0, 4000.0}, -0.5 * (n + 2), -2000.0};
  Vector pressure = Vector::Zero(n + 2);
  for (int i = 1; i <= n; ++i)
    pressure[i] = 5e-3 * std::sqrt(1.0 - std::pow((i - 0.5 - 0.5 * n) / (0.5 * n), 2));
  const Vector bound = 0.3 * pressure;
  TangentialSolver patch(grid, ElasticPair{1.0, nu, 0.0, layer / modulus});
  TangentialProblem problem;
  problem.bound = bound;
  problem.creepage.xi = creep;
  const double ofPatch = -patch.solve(problem).traction.x.sum();
  HalfPlane plane(n + 2, Boundary::Free);
  RollingOptions options;
  options.layer = layer;
  const double ofLine =
      modulus * solveFrozenRolling(plane, bound / modulus, creep, options).force();
  EXPECT_NEAR(ofLine / ofPatch, 1.0, 0.02);
  EXPECT_LT(ofLine, 0.9 * bound.sum()); // in partial slip
  options.layer = 0.0;
  EXPECT_GT(modulus * solveFrozenRolling(plane, bound / modulus, creep, options).force(),
            1.1 * ofLine);
}

TEST(LineLayer, NoThicknessIsNoLayer)
{
  const double without = solved(wheel(1e-3, "")).points[0].tractionRatio;
  const double thin = solved(wheel(1e-3, "layer: {thickness: 1e-9 mm, shear_modulus: 1e9 MPa}\n"))
                          .points[0]
                          .tractionRatio;
  EXPECT_NEAR(thin / without, 1.0, 1e-9);
}

TEST(LineLayer, RefinedCellsKeepTheForce)
{
  // in the order of the cells squared: edges lie inside their cells, that of the layer, too
  const std::string layer = "layer: {thickness: 0.1 mm, shear_modulus: 2 GPa}\n";
  const double fine = solved(wheel(1e-3, layer, 4096)).points[0].tractionRatio;
  for (int n : {256, 300, 512})
    EXPECT_NEAR(solved(wheel(1e-3, layer, n)).points[0].tractionRatio / fine, 1.0, 3e-4) << n;
}

TEST(LineLayer, FlowsAtItsYieldStress)
{
  // CONTACT's carter_plast 3, 7, 11, a layer of no thickness with 35 MPa: T/(mu N) 0.5959, 0.5896,
  // 0.5864 on cells of 0.08, 0.04, 0.02 mm, whose error is of the first order: 0.5832
  const std::string text =
      "contact: {load_per_length: 178.9 N/mm, radius: 500 mm, youngs_modulus: 209920 MPa, "
      "poissons_ratio: 0.28}\nfriction: {law: constant, mu: 0.5}\nthermal: off\nspeed: 30 m/s\n"
      "cells: 400\ncreep: 4e-4\nlayer: {thickness: 1e-9 mm, shear_modulus: 82 GPa, "
      "yield_stress: 35 MPa}\n";
  const CreepCurves curves = solved(text);
  EXPECT_NEAR(curves.points[0].tractionRatio / 0.5, 0.5832, 7e-4);
  EXPECT_NEAR(curves.points[0].peakTraction, 35e6, 1.0);
  EXPECT_EQ(curves.points[0].muMean, 0.5);
}

TEST(LineLayer, AveragedHeatIsOfWhatTheLayerCarries)
{
  // where all slides the mean temperature goes like the traction, which the yield stress bounds
  const std::string text = case_text::table2 +
                           "friction: {law: constant, mu: 0.3}\nthermal: {model: averaged}\n"
                           "speed: 20 m/s\ncells: 512\ncreep: 0.05\n"
                           "layer: {thickness: 1e-9 mm, shear_modulus: 82 GPa";
  for (const std::string mode : {"", "mode: moving\nmoving: {passes: 8}\n"}) {
    const CurvePoint free = solved(text + "}\n" + mode).points[0];
    const CurvePoint bound = solved(text + ", yield_stress: 50 MPa}\n" + mode).points[0];
    EXPECT_LT(bound.tractionRatio, 0.5 * free.tractionRatio) << mode;
    EXPECT_NEAR(bound.temperatureRise / free.temperatureRise,
                bound.tractionRatio / free.tractionRatio, 1e-3)
        << mode;
  }
}

TEST(LineLayer, SmoothMovingContactComesToTheSteadyState)
{
  // the leading edge of a moving contact is that of a cell: of its first order
  const std::string layer =
      "layer: {thickness: 0.1 mm, shear_modulus: 2 GPa, yield_stress: 200 MPa}\n";
  const double steady = solved(wheel(1e-3, layer)).points[0].tractionRatio;
  const double moving =
      solved(wheel(1e-3, layer + "mode: moving\nmoving: {passes: 4}\n")).points[0].tractionRatio;
  EXPECT_NEAR(moving / steady, 1.0, 0.01);
}

TEST(LineLayer, RestIsRefused)
{
  try {
    case_text::read(case_text::table2 +
                    "friction: {law: constant, mu: 0.3}\nmode: static\n"
                    "static: {force_ratio: 0.5}\nlayer: {thickness: 1 um, shear_modulus: 1 GPa}\n");
    FAIL();
  } catch (const Error &error) {
    EXPECT_NE(std::string(error.what()).find("a layer of a line contact needs rolling"),
              std::string::npos)
        << error.what();
  }
}
