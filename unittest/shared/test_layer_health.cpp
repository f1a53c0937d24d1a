// SPDX-License-Identifier: GPL-2.0-or-later
// When a sliding layer is worn smooth, and how many junctions carry it.
#include "shared/layer_health.h"

#include <gtest/gtest.h>

#include <limits>

using mcawr::layer_health::junctions;
using mcawr::layer_health::SmoothSliding;

TEST(LayerHealth, PhasesCountInWhichTheLayerSlidADiameter)
{
  SmoothSliding s;
  EXPECT_EQ(s.share(), 0.0);
  for (int row = 0; row < 9; ++row) // 2.25 of 2.5: no phase yet
    s.add(0.25, 0.0, 2.5);
  EXPECT_EQ(s.share(), 0.0);
  s.add(0.25, 3.0, 2.5);
  for (int row = 0; row < 10; ++row) // the tenth row makes it one
    s.add(0.25, 0.0, 2.5);
  EXPECT_DOUBLE_EQ(s.way(), 5.0);
  EXPECT_DOUBLE_EQ(s.share(), 0.5);
  for (int row = 0; row < 10; ++row) // it goes on
    s.add(0.25, 0.0, 2.5);
  EXPECT_DOUBLE_EQ(s.share(), 5.0 / 7.5);
  for (int row = 0; row < 10; ++row)
    s.add(0.25, 1.0, 2.5);
  EXPECT_DOUBLE_EQ(s.share(), 0.5);
}

TEST(LayerHealth, JunctionsShareTheLoad)
{
  EXPECT_DOUBLE_EQ(junctions(15.0, 50.0, 40.0), 12.0);
  EXPECT_EQ(junctions(15.0, std::numeric_limits<double>::infinity(), 40.0), 0.0);
}
