// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/printable.h"

#include <gtest/gtest.h>

using mcawr::printable;
using mcawr::printableLines;
using mcawr::shortened;

TEST(Printable, LongMessagesLoseTheirMiddle)
{
  const std::string fits(400, 'x'), begin = "line 7: '", end = "' is not a number";
  EXPECT_EQ(shortened(fits), fits);
  const std::string shown = shortened(begin + std::string(58000, '7') + end);
  EXPECT_LT(shown.size(), 300U);
  EXPECT_EQ(shown.substr(0, begin.size()), begin);
  EXPECT_EQ(shown.substr(shown.size() - end.size()), end);
  std::string greek; // two bytes each: cut between characters
  for (int i = 0; i < 1000; ++i)
    greek += "\xce\xbc";
  EXPECT_EQ(printable(shortened("x" + greek)), shortened("x" + greek));
}

TEST(Printable, showsWhatATerminalWouldObey)
{
  EXPECT_EQ(printable("plain, \\ and 'quotes'"), "plain, \\ and 'quotes'");
  EXPECT_EQ(printable("two\nlines\tand\r"), "two\\nlines\\tand\\r");
  EXPECT_EQ(printable("\x1b[31mred\x1b[0m\x7f\b"), "\\x1b[31mred\\x1b[0m\\x7f\\x08");
  EXPECT_EQ(printable(std::string_view("\0a", 2)), "\\x00a");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\xc2\\x9b31m"); // CSI of one character
}

TEST(Printable, keepsUtf8AndShowsWhatIsNone)
{
  for (const char *text : {"K\xc3\xb6ln", "\xe2\x82\xac 5", "\xf0\x9f\x9a\x82", "\xed\x9f\xbf"})
    EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable("K\xf6ln"), "K\\xf6ln");                      // Latin-1
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");                   // cut
  EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b");                   // escape, too long
  EXPECT_EQ(printable("\xe0\x80\x9b"), "\\xe0\\x80\\x9b");          // likewise
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");          // half a pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80"); // beyond the last one
}

TEST(Printable, isTheSameWhenItGoesThroughTwice)
{
  const std::string once = printable("a\n\x1b\\n\xff");
  EXPECT_EQ(printable(once), once);
}

TEST(Printable, keepsTheLinesOfAReport)
{
  EXPECT_EQ(printableLines("one\n\x1b[2Jtwo\n"), "one\n\\x1b[2Jtwo\n");
}
