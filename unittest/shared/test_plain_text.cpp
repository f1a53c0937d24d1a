// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/plain_text.h"

#include <gtest/gtest.h>

using mcawr::plainText;
using namespace std::string_literals;

namespace {

const std::string plain = "# height: \xc2\xb5m\n0.5 \xe2\x88\x92 1\n\nend";

/// \param low, high places of a character's bytes in its two
std::string utf16(const std::u16string &text, bool bigEndian)
{
  std::string bytes;
  for (const char16_t c : text) {
    const char high = static_cast<char>(c >> 8), low = static_cast<char>(c & 0xff);
    bytes += bigEndian ? std::string{high, low} : std::string{low, high};
  }
  return bytes;
}

} // namespace

TEST(PlainText, StaysAsItIs)
{
  for (const std::string &text : {plain, ""s, "\n"s, "\xf0\x9f\x9a\x82\n"s}) {
    EXPECT_EQ(plainText(text).text, text);
    EXPECT_EQ(plainText(text).problem, "");
  }
}

TEST(PlainText, LineEndsOfOtherMachines)
{
  EXPECT_EQ(plainText("a\r\nb\r\n").text, "a\nb\n");
  EXPECT_EQ(plainText("a\rb\r").text, "a\nb\n");
  EXPECT_EQ(plainText("a\r\rb\r\n\r\n\nc").text, "a\n\nb\n\n\nc");
}

TEST(PlainText, ByteOrderMarks)
{
  const std::u16string text = u"# height: \u00b5m\n0.5 \u2212 1\n\nend";
  EXPECT_EQ(plainText("\xef\xbb\xbf" + plain).text, plain);
  EXPECT_EQ(plainText("\xff\xfe" + utf16(text, false)).text, plain);
  EXPECT_EQ(plainText("\xfe\xff" + utf16(text, true)).text, plain);
  EXPECT_EQ(plainText("\xff\xfe" + utf16(u"\U0001f682\r\n", false)).text, "\xf0\x9f\x9a\x82\n");
  EXPECT_EQ(plainText("\xff\xfe\x3d\xd8"s).text, "\xef\xbf\xbd"); // half of a pair
}

TEST(PlainText, Latin1)
{
  EXPECT_EQ(plainText("# height: \xb5m\r\n").text, "# height: \xc2\xb5m\n");
  EXPECT_EQ(plainText("20 \xb0\x43").text, "20 \xc2\xb0\x43");
}

TEST(PlainText, SaysWhatIsNoText)
{
  for (const bool bigEndian : {false, true})
    EXPECT_EQ(plainText(utf16(u"# height: um\n1 2 3\n", bigEndian)).problem,
              "is UTF-16 without a byte order mark; save it as UTF-8");
  EXPECT_EQ(plainText("\xff\xfe\0\0#\0\0\0"s).problem, "is UTF-32; save it as UTF-8");
  EXPECT_EQ(plainText("# a line\n\0\1\2"s).problem, "is binary, not text: byte 9 is 0");
}
