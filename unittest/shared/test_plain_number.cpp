// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/plain_number.h"

#include "comma_locale.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <sstream>

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

TEST(PlainNumber, WordsAreThoseOfPrintf)
{
  for (const double value :
       {0.0, -0.0, 1.0, -1.5e-3, 1.0 / 3.0, 1e5, 1e6, 123456789.0, 6.02e23, -1e-300,
        std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min()})
    for (const int digits : {1, 6, 8, 10, 12, 15, 17}) {
      char word[40];
      std::snprintf(word, sizeof(word), "%.*g", digits, value);
      EXPECT_EQ(numberWord(value, digits), word);
    }
}

TEST(PlainNumber, SeventeenDigitsGiveTheNumberBack)
{
  for (const double value : {1.0 / 3.0, -1e-300, 123456.789, std::numeric_limits<double>::max()})
    EXPECT_EQ(plainNumber(numberWord(value, 17)), value);
}

TEST(PlainNumber, NoLocaleOfTheHostMatters)
{
  const CommaLocale comma;
  std::ostringstream stream;
  stream << 1234.5;
  ASSERT_EQ(stream.str(), "1.234,5");
  EXPECT_EQ(numberWord(1234.5), "1234.5");
  EXPECT_EQ(plainNumber("1234.5"), 1234.5);
}
