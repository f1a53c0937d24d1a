#include "base/quantity.h"

#include <gtest/gtest.h>
#include <stdexcept>

using namespace wheelrail;

TEST(Quantity, ConvertsUnits)
{
  EXPECT_DOUBLE_EQ(parseQuantity("4000 N/mm", "N/m"), 4e6);
  EXPECT_DOUBLE_EQ(parseQuantity("206 GPa", "Pa"), 206e9);
  EXPECT_DOUBLE_EQ(parseQuantity(" 0.5m ", "m"), 0.5);
  EXPECT_DOUBLE_EQ(parseQuantity("72 km/h", "m/s"), 20.0);
  EXPECT_DOUBLE_EQ(parseQuantity("50 W/(m K)", "W/(m K)"), 50.0);
  EXPECT_DOUBLE_EQ(parseQuantity("0.45 kJ/(kg K)", "J/(kg K)"), 450.0);
  EXPECT_DOUBLE_EQ(parseQuantity("1e-3", "1"), 1e-3);
}

TEST(Quantity, RefusesWhatIsNotOne)
{
  for (const char *text : {"", "abc", "N/mm", "4000", "nan N/m", "inf N/m", "1e999 N/m", "4000 N",
                           "4000 furlonggs", "4000 N/mm extra"})
    EXPECT_THROW(parseQuantity(text, "N/m"), std::invalid_argument) << text;
  EXPECT_THROW(parseQuantity("20 degC", "K"), std::invalid_argument); // a rise has no offset
  EXPECT_THROW(parseQuantity("1 mm", "1"), std::invalid_argument);
}
