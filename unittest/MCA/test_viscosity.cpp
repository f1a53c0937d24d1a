// SPDX-License-Identifier: GPL-2.0-or-later
#include "laws/viscosity.h"

#include <gtest/gtest.h>

#include <cmath>

using mca::unlinkedStress;

TEST(Viscosity, ForceIsEtaOverRootThreeTimesVelocityTimesThickness)
{
  const double eta = 410, v = -2.0, d = 2.5, h = 3.0;
  const double force = unlinkedStress(0.0, eta, v, 1 / d) * d * h / std::sqrt(3.0);
  EXPECT_NEAR(force, eta / std::sqrt(3.0) * v * h, 1e-12 * std::abs(force));
}

TEST(Viscosity, NeverTensile)
{
  EXPECT_EQ(unlinkedStress(-10, 410, 1e3, 0.4), 0.0);
  EXPECT_EQ(unlinkedStress(0, 410, 1e-3, 0.4), 0.0);
  EXPECT_EQ(unlinkedStress(0, 410, 0, 0.4), 0.0);
  EXPECT_DOUBLE_EQ(unlinkedStress(-10, 410, 0.01, 0.4), -10 + 410 * 0.01 * 0.4);
}

TEST(Viscosity, AddsToTheElasticStress)
{
  EXPECT_DOUBLE_EQ(unlinkedStress(-10, 410, -0.5, 0.4), -10 - 82);
  EXPECT_EQ(unlinkedStress(-10, 0, -100, 0.4), -10);
}
