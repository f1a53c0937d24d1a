// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/statistics.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

using namespace wheelrail;

TEST(Statistics, studentWithClosedForms)
{
  for (double t : {-30.0, -2.0, -0.1, 0.0, 0.7, 4.0}) {
    EXPECT_NEAR(studentCdf(t, 1), 0.5 + std::atan(t) / mcawr::pi, 1e-14); // Cauchy
    EXPECT_NEAR(studentCdf(t, 2), 0.5 + t / (2.0 * std::sqrt(2.0 + t * t)), 1e-14);
    EXPECT_NEAR(studentCdf(t, 1e6), 0.5 * std::erfc(-t / std::sqrt(2.0)), 1e-6); // normal
  }
}

TEST(Statistics, quantilesOfTheUsualTable)
{
  EXPECT_NEAR(studentQuantile(0.975, 1), std::tan(mcawr::pi * 0.475), 1e-9);
  EXPECT_NEAR(studentQuantile(0.975, 10), 2.228139, 5e-7);
  EXPECT_NEAR(studentQuantile(0.975, 29), 2.045230, 5e-7);
  EXPECT_NEAR(studentQuantile(0.995, 5), 4.032143, 5e-7);
  EXPECT_NEAR(studentQuantile(0.025, 10), -2.228139, 5e-7);
  EXPECT_THROW(studentQuantile(1.0, 3), std::invalid_argument);
}

TEST(Statistics, farTailsAndFractionsOfADegree)
{
  // the closed form for two degrees of freedom, without cancellation
  const double t = 1e5;
  EXPECT_NEAR(studentCdf(-t, 2) / (1.0 / (2.0 + t * t + t * std::sqrt(2.0 + t * t))), 1.0, 1e-12);
  EXPECT_NEAR(studentQuantile(studentCdf(-1.3, 4.7), 4.7), -1.3, 1e-13);
  EXPECT_EQ(studentQuantile(0.5, 3), 0.0);
  EXPECT_THROW(studentCdf(1.0, 0.0), std::invalid_argument);
}
