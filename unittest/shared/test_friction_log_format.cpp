// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/friction_log_format.h"

#include <gtest/gtest.h>
#include <limits>

using namespace mcawr::friction_log;

TEST(FrictionLogFormat, Lines)
{
  EXPECT_EQ(formatLine(), "# format: mca-friction 1");
  EXPECT_EQ(columnLine(), "step time displacement shear_stress normal_stress mu links broken "
                          "formed gap room lost flow_energy breaking_energy contact_energy check");
}

TEST(FrictionLogFormat, EachNumberHasOneRow)
{
  for (std::size_t k = 0; k < headNumbers.size(); k++) {
    EXPECT_EQ(&headNumber(headNumbers[k].value), &headNumbers[k]) << headNumbers[k].key;
    EXPECT_STRNE(headNumbers[k].meaning, "") << headNumbers[k].key;
  }
  EXPECT_EQ(sizeof(Head), headNumbers.size() * sizeof(double));
  EXPECT_STREQ(headNumber(&Head::seed).key, "seed");
  EXPECT_STREQ(columns[columnsNeeded - 1].name, "gap");
  EXPECT_EQ(sizeof(Row), columns.size() * sizeof(double));
  for (std::size_t k = 0; k < columns.size(); k++)
    for (std::size_t m = 0; m < k; m++)
      EXPECT_TRUE(columns[m].value != columns[k].value) << columns[k].name;
}

TEST(FrictionLogFormat, Ranges)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (Range range : {Range::Positive, Range::NotNegative, Range::PoissonsRatio, Range::Whole}) {
    EXPECT_FALSE(isIn(range, nan));
    EXPECT_FALSE(isIn(range, 2 * largest));
    EXPECT_FALSE(isIn(range, -1.0));
  }
  EXPECT_FALSE(isIn(Range::Positive, 0.0));
  EXPECT_FALSE(isIn(Range::Positive, 0.5 / largest));
  EXPECT_TRUE(isIn(Range::NotNegative, 0.0));
  EXPECT_FALSE(isIn(Range::PoissonsRatio, 0.5));
  EXPECT_TRUE(isIn(Range::PoissonsRatio, -0.5));
  EXPECT_FALSE(isIn(Range::Whole, 1.5));
  EXPECT_TRUE(isIn(Range::Whole, 0.0));
  EXPECT_EQ(describe(Range::Positive, "MPa"), "> 0 (MPa), 1e-12 to 1e+12");
  EXPECT_EQ(describe(Range::NotNegative, ""), ">= 0, 0 or 1e-12 to 1e+12");
}

TEST(FrictionLogFormat, RangesOfEitherSignAndOfRows)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double x : {0.0, 1.0, 1.0 / largest, largest}) {
    EXPECT_TRUE(isIn(Range::Signed, x)) << x;
    EXPECT_TRUE(isIn(Range::Signed, -x)) << x;
  }
  for (double x : {1e-13, -1e-308, 2e12, -1e308, infinity, nan})
    EXPECT_FALSE(isIn(Range::Signed, x)) << x;
  for (double x : {-largestWhole, -1.0, 0.0, largestWhole})
    EXPECT_TRUE(isIn(Range::SignedWhole, x)) << x;
  for (double x : {1.5, 2.0 * largestWhole, -infinity, nan})
    EXPECT_FALSE(isIn(Range::SignedWhole, x)) << x;
  EXPECT_TRUE(isInRow(-largest));
  EXPECT_FALSE(isInRow(1.1 * largest));
  EXPECT_FALSE(isInRow(nan));
  EXPECT_EQ(describe(Range::Signed, "m/s"), "of either sign (m/s), 0 or 1e-12 to 1e+12");
  EXPECT_EQ(describe(Range::SignedWhole, ""), "that is whole, -9e+15 to 9e+15");
}
