// SPDX-License-Identifier: GPL-2.0-or-later
// Friction that falls with the slip of each cell.
#include "contact/patch/patch_contact.h"
#include "creep/patch/moving_patch.h"
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
