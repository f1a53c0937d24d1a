#include "base/nearest_word.h"

#include <gtest/gtest.h>

using namespace wheelrail;

TEST(NearestWord, CountsEdits)
{
  EXPECT_EQ(editDistance("creep", "creep"), 0);
  EXPECT_EQ(editDistance("crep", "creep"), 1);
  EXPECT_EQ(editDistance("cerep", "creep"), 1); // a swap of neighbours is one edit
  EXPECT_EQ(editDistance("", "abc"), 3);
}

TEST(NearestWord, NamesTheNearest)
{
  EXPECT_EQ(nearestWord("rms_slpe", {"hurst", "rms_slope", "seed"}), "rms_slope");
  EXPECT_EQ(nearestWord("x", {}), "");
}
