// SPDX-License-Identifier: GPL-2.0-or-later
// Friction that falls with the slip of each cell.
#include "case_text.h"
#include "contact/patch/patch_contact.h"
#include "creep/line/creep_curve.h"
#include "creep/patch/moving_patch.h"
#include "creep/sweep/slip_memory.h"
#include "law/forms/constant.h"
#include "law/forms/polach.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {

const FallingFriction falling{0.4, 0.4, 0.6};
constexpr double speed = 20.0;

PatchContact steelWheel(int cells)
{
  PatchContactSpecification contact;
  contact.load = {1e5};
  contact.curvatures = GapCurvatures{1.0, 1.0};
  contact.bodies = {ElasticBody{210e9, 0.3}, ElasticBody{210e9, 0.3}};
  contact.domain = 2.4;
  contact.nx = contact.ny = cells;
  return preparePatch(contact, {}, 1e5, 0, INFINITY, 0.0);
}

CreepPhysics physicsOf(double length)
{
  CreepPhysics physics;
  physics.thermal.model = ThermalModel::Off;
  physics.strength = {1e9, 1250.0, nullptr};
  physics.memoryLength = length;
  return physics;
}

struct Rolled {
  PatchPoint point;
  PatchFields fields;
};
Rolled rolled(const PatchContact &contact, double length, double creep, const FrictionLaw &law)
{
  const CreepPhysics physics = physicsOf(length);
  FrozenPatch rolling(physics, contact, 0.5);
  PatchDrive drive;
  drive.creepage.xi = creep;
  const PatchPoint point = rolling.solve(law, speed, drive);
  return {point, rolling.fields()};
}

/// A steel cylinder under 4000 N/mm at 20 m/s with the same law; T/N.
std::vector<double> lineCurve(const std::string &mode, const std::string &length,
                              const std::string &creeps)
{
  const CreepSpecification asked = case_text::rolling(
      "contact: {load_per_length: 4000 N/mm, radius: 0.5 m, youngs_modulus: 210 GPa,"
      " poissons_ratio: 0.3}\nthermal: off\nspeed: 20 m/s\ncells: 500\nmode: " +
      mode + "\nfriction: {law: polach, mu0: 0.4, A: 0.4, B: 0.6 s/m" +
      (length.empty() ? "" : ", memory_length: " + length) + "}\ncreep: " + creeps + "\n");
  std::vector<double> ratios;
  for (const CurvePoint &point : solveCreepCurves(asked, asked.friction.read(), {}).points)
    ratios.push_back(point.tractionRatio);
  return ratios;
}

} // namespace

// Where all slides with the creep, r = t + (1 - t) exp(-creep way/length) with t = mu(w)/mu(0).
TEST(SlipMemory, OfFullSlidingIsAnExponential)
{
  const PatchContact contact = steelWheel(40);
  const double creep = 0.2, length = 0.5e-3;
  const Rolled found = rolled(contact, length, creep, PolachLaw(falling));
  const PatchGrid &grid = contact.grid;
  const double target = falling(creep * speed) / falling(0.0);
  const int iy = grid.ny / 2;
  int inside = 0;
  for (int ix = grid.nx - 1; ix >= 0; --ix) {
    const int i = grid.index(ix, iy);
    if (!(found.fields.pressure[i] > 0.0))
      continue;
    ++inside;
    // the elastic slip is some hundredths of the creep
    const double expected =
        falling(0.0) *
        (target + (1.0 - target) * std::exp(-creep * (inside - 0.5) * grid.dx / length));
    EXPECT_NEAR(found.fields.mu[i], expected, 0.01 * expected) << inside;
  }
  EXPECT_GT(inside, 20);
}

TEST(SlipMemory, LimitsOfItsLength)
{
  const PatchContact contact = steelWheel(32);
  // never forgets: friction at rest
  const double rest = rolled(contact, 1e3, 0.01, PolachLaw(falling)).point.forceX;
  const double constant = rolled(contact, 0.0, 0.01, ConstantLaw(falling(0.0))).point.forceX;
  EXPECT_NEAR(rest, constant, 1e-5 * std::abs(constant));
  // forgets at once: the slip of each cell; where all slides nearly that of the contact
  const double local = rolled(contact, 1e-6, 0.2, PolachLaw(falling)).point.forceX;
  const double global = rolled(contact, 0.0, 0.2, PolachLaw(falling)).point.forceX;
  EXPECT_NEAR(local, global, 0.01 * std::abs(global));
}

// A longer memory carries more at one creep, and a law without speed knows none.
TEST(SlipMemory, ForceGrowsWithItsLength)
{
  const PatchContact contact = steelWheel(32);
  double former = 0.0;
  for (const double length : {1e-5, 1e-4, 1e-3}) {
    const double force = -rolled(contact, length, 0.01, PolachLaw(falling)).point.forceX;
    EXPECT_GT(force, former);
    former = force;
  }
  EXPECT_EQ(rolled(contact, 1e-4, 0.01, ConstantLaw(0.3)).point.forceX,
            rolled(contact, 0.0, 0.01, ConstantLaw(0.3)).point.forceX);
}

// The material takes its memory along: a smooth contact comes to the steady state, but for the
// half cell that the friction of a step is late.
TEST(SlipMemory, MovingComesToFrozen)
{
  const PatchContact contact = steelWheel(36);
  const CreepPhysics physics = physicsOf(0.1e-3);
  const PolachLaw law(falling);
  MovingPatchSpecification moving;
  moving.passes = 4;
  moving.start = RollingStart::Rest;
  const PatchSequence none;
  MovingPatch rolling(physics, moving, none, law, contact, 0.5);
  PatchDrive drive;
  drive.creepage.xi = 0.01;
  rolling.solve(speed, drive, [] { return true; });
  const double steady = rolled(contact, 0.1e-3, 0.01, law).point.forceX;
  EXPECT_NEAR(rolling.series().back().forceX, steady, 2e-3 * std::abs(steady));
}

// On the line, all slides: mu from the leading edge on is the exponential, under Hertz's ellipse.
TEST(SlipMemory, OfALineThatSlides)
{
  const double creep = 0.1, length = 1e-3;
  const double halfWidth = hertzContact(4e6, 0.5, 210e9 / (2.0 * (1.0 - 0.3 * 0.3))).halfWidth;
  const double target = falling(creep * speed) / falling(0.0);
  constexpr int panels = 20000;
  double force = 0.0, load = 0.0;
  for (int i = 0; i < panels; ++i) {
    const double x = 1.0 - 2.0 * (i + 0.5) / panels; // of the half-width, from the leading edge on
    const double pressure = std::sqrt(1.0 - x * x);
    load += pressure;
    force += pressure * falling(0.0) *
             (target + (1.0 - target) * std::exp(-creep * (1.0 - x) * halfWidth / length));
  }
  const double expected = force / load;
  EXPECT_GT(expected, 1.05 * falling(creep * speed)); // or else it would show nothing
  for (const char *mode : {"frozen", "moving"})
    EXPECT_NEAR(lineCurve(mode, "1 mm", "[0.1]").at(0), expected, 4e-3 * expected) << mode;
}

TEST(SlipMemory, LimitsOnTheLine)
{
  const std::string creeps = "[1e-3, 2e-3, 1e-2, 0.1]";
  const std::vector<double> one = lineCurve("frozen", "", creeps);
  const std::vector<double> brief = lineCurve("frozen", "1 um", "[0.1]");
  EXPECT_NEAR(brief.at(0), one.at(3), 0.01 * one.at(3));
  // the longer the memory the more is carried
  std::vector<double> former(4, 0.0);
  for (const char *length : {"0.01 mm", "0.1 mm", "1 m"}) {
    const std::vector<double> found = lineCurve("frozen", length, creeps);
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_GE(found[k], former[k] * (1.0 - 1e-9)) << length << " " << k;
    former = found;
  }
  EXPECT_NEAR(former.at(3), falling(0.0), 2e-3);
  // a profile that travels comes to the steady state where nothing is rough
  const std::vector<double> frozen = lineCurve("frozen", "0.1 mm", creeps);
  const std::vector<double> moving = lineCurve("moving", "0.1 mm", creeps);
  for (std::size_t k = 0; k < frozen.size(); ++k)
    EXPECT_NEAR(moving[k], frozen[k], 3e-3 * frozen[k]) << k;
}

// Between two spots nothing slides: the second finds what the first left, as material that moves.
TEST(SlipMemory, KeepsThroughAGap)
{
  const CellGrid grid{30, 1, 1e-4, 1.0};
  const SlipMemory memory(grid, 1e-4);
  const PolachLaw law(falling);
  Vector pressure = Vector::Constant(30, 1e9);
  pressure.segment(10, 10).setZero();
  const Vector cold = Vector::Zero(30), slip = Vector::Constant(30, 0.1);
  const Vector found = memory.steady(law, pressure, cold, speed, slip);
  const double target = falling(0.1 * speed) / falling(0.0);
  const auto after = [&](double cells) { return target + (1.0 - target) * std::exp(-0.1 * cells); };
  for (int ix = 0; ix < 10; ++ix) {
    EXPECT_NEAR(found[29 - ix], after(ix + 0.5), 1e-12) << ix;
    EXPECT_NEAR(found[9 - ix], after(10 + ix + 0.5), 1e-12) << ix;
  }
  // material that moves with the grid's cells, from the largest x on
  double moving = 1.0;
  for (int ix = 29; ix >= 0; --ix)
    moving = memory.after(Vector::Constant(30, moving), law, pressure, cold, speed, slip)[ix];
  EXPECT_NEAR(moving, after(20), 1e-12);
}
