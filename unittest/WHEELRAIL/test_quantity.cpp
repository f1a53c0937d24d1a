// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/quantity.h"

#include "../shared/comma_locale.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <stdexcept>

using namespace wheelrail;

TEST(Quantity, ConvertsUnits)
{
  EXPECT_DOUBLE_EQ(parseQuantity("4000 N/mm", "N/m"), 4e6);
  EXPECT_DOUBLE_EQ(parseQuantity("206 GPa", "Pa"), 206e9);
  EXPECT_DOUBLE_EQ(parseQuantity(" 0.5m ", "m"), 0.5);
  EXPECT_DOUBLE_EQ(parseQuantity("72 km/h", "m/s"), 20.0);
  EXPECT_DOUBLE_EQ(parseQuantity("80\u00a0kN", "N"), 80e3);
  EXPECT_DOUBLE_EQ(parseQuantity("72\u202fkm/h", "m/s"), 20.0);
  EXPECT_DOUBLE_EQ(parseQuantity("50 W/(m K)", "W/(m K)"), 50.0);
  EXPECT_DOUBLE_EQ(parseQuantity("0.45 kJ/(kg K)", "J/(kg K)"), 450.0);
  EXPECT_DOUBLE_EQ(parseQuantity("1e-3", "1"), 1e-3);
  for (const char *text : {"7800 kg/m3", "7800 kg/m^3", "7800 kg/m**3", "7800 kg m-3",
                           "7800 kg m^-3", "7.8 g/cm3", "+7800 kg.m-3"})
    EXPECT_DOUBLE_EQ(parseQuantity(text, "kg/m3"), 7800.0) << text;
}

TEST(Quantity, RefusesWhatIsNotOne)
{
  for (const char *text : {"", "abc", "N/mm", "4000", "nan N/m", "inf N/m", "1e999 N/m", "4000 N",
                           "4000 furlonggs", "4000 N/mm extra", "0x10 N/m"})
    EXPECT_THROW(parseQuantity(text, "N/m"), std::invalid_argument) << text;
  try {
    parseQuantity("20 degC", "K"); // a rise has no offset, and a temperature is told in K, too
    FAIL() << "was accepted";
  } catch (const std::invalid_argument &error) {
    EXPECT_STREQ(error.what(), "'20 degC': must be given in K, not on a scale with another zero");
  }
  EXPECT_THROW(parseQuantity("1 mm", "1"), std::invalid_argument);
}

TEST(Quantity, RefusesASecondNumber)
{
  for (const char *text : {"1 500 N/m", "1,500 N/m", "1'500 N/m", "1 .5 N/m", "1 -5 N/m", "1 N/5 m",
                           "1 N*5/m", "1 N 5/m", "1.5.3 N/m"})
    EXPECT_THROW(parseQuantity(text, "N/m"), std::invalid_argument) << text;
}

TEST(Quantity, PlainNumbersAreDecimal)
{
  EXPECT_EQ(parseNumber(" 16 "), 16.0);
  for (const char *text : {"0x10", "0X1p4", "1 500", "1_500", "16 m", "nan", "", "infinity"})
    EXPECT_THROW(parseNumber(text), std::invalid_argument) << text;
}

TEST(Quantity, SaysInOneLineWhatIsWrong)
{
  for (const char *text : {"1 \x1b[31m", "\n", "5 m\nN", "nan\r"}) {
    try {
      parseQuantity(text, "N/m");
      FAIL() << text;
    } catch (const std::invalid_argument &problem) {
      EXPECT_EQ(std::string(problem.what()).find_first_of("\x1b\n\r"), std::string::npos);
    }
  }
}

// in a process of its own, which has not yet read the database of units
TEST(QuantityDeathTest, UnitsDoNotFollowTheLocaleOfAHostProgram)
{
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const CommaLocale comma;
        const bool right = parseQuantity("0.5 kN", "N") == 500.0 &&
                           std::abs(parseQuantity("1.5 inch", "m") - 0.0381) < 1e-15;
        std::exit(right ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}
