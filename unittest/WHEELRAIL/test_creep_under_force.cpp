// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "case_text.h"
#include "creep/line/creep_curve.h"
#include "creep/line/creep_under_force.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace wheelrail;

TEST(CreepUnderForce, IsTheInverse)
{
  const auto traction = [](double creep) { return 3.0 * std::tanh(800.0 * (creep + 1e-3)); };
  for (double force : {-2.9, -1.0, 0.0, 1.0, 2.0, 2.9})
    EXPECT_NEAR(traction(creepUnder(force, traction)), force, 1e-6) << force;
  EXPECT_EQ(creepUnder(0.0, [](double creep) { return creep; }), 0.0);
}

TEST(CreepUnderForce, TheNearestToZeroWhereFrictionFalls)
{
  const auto traction = [](double creep) { return creep / (1.0 + 1e4 * creep * creep); };
  EXPECT_NEAR(creepUnder(2e-3, traction), 0.0020871, 1e-7); // the other one is at 0.0479
}

/// The peak, 5e-3 at creep 0.01, is between two of the creeps that are tried: 0.0082 and 0.0164,
/// with 4.9e-3 and 4.4e-3.
TEST(CreepUnderForce, JustBelowThePeak)
{
  const auto traction = [](double creep) { return creep / (1.0 + 1e4 * creep * creep); };
  for (double force : {4.95e-3, 4.9999e-3, -4.9999e-3}) {
    const double creep = creepUnder(force, traction);
    EXPECT_NEAR(traction(creep), force, 1e-10);
    EXPECT_LT(std::abs(creep), 0.01);
  }
  try {
    creepUnder(5.01e-3, traction);
    FAIL();
  } catch (const Error &error) {
    EXPECT_STREQ(error.what(), "force.per_length: 0.00501 N/m is more than is carried: 0.005 N/m "
                               "at creep 0.01");
  }
}

TEST(CreepUnderForce, SlidingAtRestIsLeft)
{
  // unlike bodies with little friction slip without creep, some cells less, and turn far from it
  const auto traction = [](double creep) {
    return std::clamp(2e4 * (creep + 5e-4), -1.0, 1.0) - (creep > -3e-6 ? 0.0 : 1e-5);
  };
  EXPECT_NEAR(creepUnder(0.0, traction), -5e-4, 1e-8);
}

TEST(CreepUnderForce, MoreThanIsCarried)
{
  const auto traction = [](double creep) { return 3.0 * std::tanh(800.0 * creep); };
  for (double force : {3.1, -3.1})
    EXPECT_THROW(creepUnder(force, traction), Error) << force;
}

TEST(CreepUnderForce, CreepCurveOfForces)
{
  const std::string rest = case_text::table2 + "friction: {law: constant, mu: 0.3}\nthermal: off\n"
                                               "speed: [10 m/s, 20 m/s]\ncells: 512\n";
  const auto solved = [&](const std::string &drive) {
    const CreepSpecification asked = case_text::rolling(rest + drive);
    return solveCreepCurves(asked, asked.friction.read());
  };
  const CreepCurves creeps = solved("creep: [-1e-3, 5e-4, 2e-3]\n");
  std::string forces;
  for (int k : {0, 1, 2})
    forces += fmt::format("{:.12g} N/m, ", creeps.points[k].traction);
  const CreepCurves found = solved("force: {per_length: [" + forces + "1300 N/mm]}\n");
  ASSERT_EQ(found.points.size(), 8u);
  for (int k : {0, 1, 2}) {
    EXPECT_NEAR(found.points[k].creep / creeps.points[k].creep, 1.0, 1e-6);
    EXPECT_NEAR(found.points[k + 4].traction / creeps.points[k].traction, 1.0, 1e-6);
  }
  EXPECT_FALSE(found.points[3].converged());
  EXPECT_EQ(found.points[3].failure.substr(0, 51),
            "force.per_length: 1.3e+06 N/m is more than is carri");
}
