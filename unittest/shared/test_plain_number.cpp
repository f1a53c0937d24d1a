// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/plain_number.h"

#include <gtest/gtest.h>

using namespace mcawr;

TEST(PlainNumber, ReadsDecimalNumbers)
{
  EXPECT_EQ(plainNumber("0"), 0.0);
  EXPECT_EQ(plainNumber("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(plainNumber("+2"), 2.0);
  EXPECT_EQ(plainNumber(".5"), 0.5);
  EXPECT_EQ(plainNumber("0.1"), 0.1);
}

TEST(PlainNumber, RefusesAllElse)
{
  for (const char *text : {"", " 1", "1 ", "0x10", "0X10", "1 500", "1,5", "1e", "nan", "inf",
                           "1e999", "+-1", "+", "one", "1k"})
    EXPECT_FALSE(plainNumber(text)) << text;
}

TEST(PlainNumber, LeavesTheRest)
{
  EXPECT_EQ(leadingNumber("4000 N/mm")->value, 4000.0);
  EXPECT_EQ(leadingNumber("4000 N/mm")->rest, " N/mm");
  EXPECT_EQ(leadingNumber("0x10")->rest, "x10");
  EXPECT_FALSE(leadingNumber("N/mm"));
}
