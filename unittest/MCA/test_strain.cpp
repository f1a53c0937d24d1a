// SPDX-License-Identifier: GPL-2.0-or-later
#include "laws/strain.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace mca;

TEST(Strain, TheLogarithmIsThatOfTheLibrary)
{
  EXPECT_EQ(logarithm(1.0), 0.0);
  for (int k = -9000; k <= 9000; k++) {
    const double eps = 1e-4 * k;
    EXPECT_NEAR(logarithm(std::exp(eps)), eps, 4e-16 + 3e-16 * std::abs(eps)) << eps;
  }
  for (const double eps : {1e-9, -1e-9, 1e-12}) // no digits are lost of small strains
    EXPECT_NEAR(logarithm(1.0 + eps), std::log1p(eps), 3e-16);
}

TEST(Strain, FarOutsideTheLogarithmIsStillMonotone)
{
  double last = logarithm(1e-9);
  EXPECT_TRUE(std::isfinite(last));
  for (double x = 2e-9; x < 1e9; x *= 1.01) {
    const double next = logarithm(x);
    EXPECT_GE(next, last) << x;
    last = next;
  }
}

TEST(Strain, OnlyPlasticityIsochoricIsLogarithmic)
{
  EXPECT_NEAR(normalStrain(true, 1.25), std::log(1.25), 1e-15);
  EXPECT_EQ(normalStrain(false, 1.25), 0.25);
}

// The kernel takes the short one for blocks in which it is the long one to the last bit.
TEST(Strain, ShortLogarithmIsTheLongOneNear1)
{
  for (int k = -220000; k <= 220000; k++)
    if (const double x = 1.0 + 5e-7 * k; isNear1(x)) {
      EXPECT_EQ(logarithmNear1(x), logarithm(x)) << x;
    }
  EXPECT_FALSE(isNear1(0.89));
  EXPECT_FALSE(isNear1(1.11));
  EXPECT_TRUE(isNear1(1.099));
}
