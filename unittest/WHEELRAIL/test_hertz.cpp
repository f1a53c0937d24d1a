// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_cases.h"

#include <gtest/gtest.h>

using namespace wheelrail;

using contact_cases::table2;

TEST(Hertz, GivesTable2)
{
  const HertzContact contact = table2();
  EXPECT_NEAR(contact.modulus * 1e-9, 115.384615, 1e-6);
  EXPECT_NEAR(contact.halfWidth * 1e3, 4.697817, 1e-6);
  EXPECT_NEAR(contact.hertzPressure * 1e-6, 542.055818, 1e-6);
}

TEST(Hertz, PressureAndGap)
{
  const HertzContact contact = table2();
  const double a = contact.halfWidth;
  for (const auto &[x, p] : {std::pair{0.0, 1.0},
                             {0.25, 0.96824584},
                             {0.5, 0.86602540},
                             {0.9, 0.43588989},
                             {0.99, 0.14106736},
                             {1.5, 0.0}})
    EXPECT_NEAR(contact.pressure(x * a) / contact.hertzPressure, p, 1e-8);
  for (const auto &[x, gap] : {std::pair{0.5, 0.0},
                               {1.1, 1.335537},
                               {1.5, 15.771458},
                               {2.0, 47.386357},
                               {3.0, 148.362871}})
    EXPECT_NEAR(contact.gap(-x * a) * 1e6, gap, 1e-6);
}

TEST(Hertz, InitialSlopeIsThatOfCarter)
{
  const HertzContact contact = table2();
  const double slope = initialSlope(contact.modulus, 2.0 * contact.halfWidth);
  EXPECT_NEAR(slope * 1e-3, 851459.29, 0.01); // N/mm
  EXPECT_NEAR(contact_cases::carter(contact, 0.3, 1e-9) * contact.load / 1e-9 / slope, 1.0, 1e-6);
}
