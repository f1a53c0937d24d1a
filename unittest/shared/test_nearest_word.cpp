// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/nearest_word.h"

#include <gtest/gtest.h>

using namespace mcawr;

namespace {
const std::vector<std::string> keywords = {"contact.load_per_length",
                                           "contact.radius",
                                           "contact.domain",
                                           "contact.youngs_modulus",
                                           "points",
                                           "creep",
                                           "creep.from",
                                           "creep.to",
                                           "creep.n"};
const std::vector<std::string> material = {"youngs_modulus", "poissons_ratio", "density",
                                           "strength",       "yield_strain",   "viscosity"};
} // namespace

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
  EXPECT_EQ(nearestWord("viscocity", material), "viscosity");
  EXPECT_EQ(nearestWord("pionts", keywords), "points");
  EXPECT_EQ(nearestWord("contact.raduis", keywords), "contact.radius");
  EXPECT_EQ(nearestWord("contcat.radius", keywords), "contact.radius");
  EXPECT_EQ(nearestWord("x", {}), "");
}

TEST(NearestWord, ABeginningIsNear)
{
  EXPECT_EQ(nearestWord("youngs", material), "youngs_modulus");
  EXPECT_EQ(nearestWord("yield", material), "yield_strain");
  EXPECT_EQ(nearestWord("contact.load", keywords), "contact.load_per_length");
  EXPECT_EQ(nearestWord("s", {"strength", "seed"}), "seed");      // the shortest
  EXPECT_EQ(nearestWord("seed", {"seeds_of_all", "sed"}), "sed"); // an edit goes before
}

TEST(NearestWord, WhatIsFarIsNotNamed)
{
  EXPECT_EQ(nearestWord("youngs", {"strength", "density"}), "");
  EXPECT_EQ(nearestWord("contact.load", {"contact.domain", "contact.radius"}), "");
  EXPECT_EQ(nearestWord("creep.y", {"creep.n", "creep.to"}), "");
  EXPECT_EQ(nearestWord("", material), "");
}

TEST(NearestWord, TheMessageListsWhatThereIs)
{
  EXPECT_EQ(unknownWord("keyword", "strenght", material),
            "unknown keyword 'strenght'; the nearest known one is 'strength'");
  EXPECT_EQ(unknownWord("keyword", "creep.step", keywords),
            "unknown keyword 'creep.step'; known: creep.from, creep.to, creep.n");
  EXPECT_EQ(unknownWord("keyword", "thermal.x", keywords),
            "unknown keyword 'thermal.x'; known: points, creep");
  EXPECT_EQ(unknownWord("option", "--x", {}), "unknown option '--x'");
}
