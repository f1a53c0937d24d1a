// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/material_file.h"

#include "../shared/comma_locale.h"
#include "../shared/other_machines.h"
#include "files/units.h"
#include "sample.h"

#include <gmock/gmock.h>

using mca::Material;
using testing::HasSubstr;

namespace {

/// The message of reading a text, or "" when there is none.
std::string problemOf(const std::string &text, const std::string &units = "nano")
{
  try {
    mca::readMaterial(text, "x.mca", units);
  } catch (const mca::MaterialError &e) {
    return e.what();
  }
  return "";
}

/// steelText() at three temperatures, two of whose strengths are given.
std::string softening(const std::string &last = "40")
{
  std::string text = steelText();
  const std::string from = "strength 92";
  return text.replace(text.find(from), from.size(),
                      "temperature 300 600 900\nstrength 92 80 " + last);
}

Material softened(std::optional<double> temperature, const std::string &last = "40")
{
  return mca::readMaterial(softening(last), "x.mca", "nano", temperature);
}

std::string softenedProblem(std::optional<double> temperature, const std::string &last = "40")
{
  try {
    softened(temperature, last);
  } catch (const mca::MaterialError &e) {
    return e.what();
  }
  return "";
}

std::string changed(const std::string &from, const std::string &to)
{
  std::string text = steelText();
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string overrideProblem(const std::vector<std::string> &words)
{
  try {
    mca::overrideMaterial(steel(), words);
  } catch (const mca::MaterialError &e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST(MaterialFile, ReadsWhatIsWritten)
{
  EXPECT_TRUE(mca::readMaterial(steelText(), "x.mca", "nano") == steel());
}

TEST(MaterialFile, CommentsBlankLinesAndCarriageReturnsAreNothing)
{
  const std::string text = changed("density", "\n  # a comment\n\t\ndensity");
  EXPECT_TRUE(mca::readMaterial(text, "x.mca", "nano") == steel());
  std::string dos;
  for (const char c : steelText())
    dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(mca::readMaterial(dos, "x.mca", "nano") == steel());
}

TEST(MaterialFile, Empty)
{
  EXPECT_EQ(problemOf(""), "x.mca: the file is empty");
  EXPECT_THAT(problemOf("\n"), HasSubstr("x.mca:1: no UNITS:"));
}

TEST(MaterialFile, Truncated)
{
  // cut after each line: something is missing, and the message names what
  const std::string text = steelText();
  for (size_t at = text.find('\n'); at + 1 < text.size(); at = text.find('\n', at + 1)) {
    const std::string line = problemOf(text.substr(0, at + 1));
    EXPECT_THAT(line, HasSubstr("x.mca: ")) << at;
    EXPECT_THAT(line, HasSubstr(" is missing")) << at;
  }
  EXPECT_EQ(problemOf(text.substr(0, text.find("\ndiameter") + 1)), "x.mca: diameter is missing");
  // cut within a line
  EXPECT_THAT(problemOf(text.substr(0, text.find("density") + 4)),
              HasSubstr("x.mca:4: unknown keyword 'dens'; the nearest known one is 'density'"));
  EXPECT_THAT(problemOf(text.substr(0, text.find("density") + 7)),
              HasSubstr("x.mca:4: density has no value, allowed: > 0"));
}

TEST(MaterialFile, NotANumber)
{
  const std::string line = problemOf(changed("density 0.0077999999999999996", "density 7.8g"));
  EXPECT_EQ(line, "x.mca:4: density is '7.8g', allowed: a finite number > 0, 1e-60 to "
                  "1e60 [mass/volume]");
  for (const char *value : {"nan", "inf", "-inf", "1e999", "0x", "--1", "seven"})
    EXPECT_THAT(problemOf(changed("strength 92", std::string("strength ") + value)),
                HasSubstr(std::string("strength is '") + value + "', allowed: a finite number > 0"))
        << value;
}

TEST(MaterialFile, OutOfRange)
{
  const std::string line =
      problemOf(changed("poissons_ratio 0.29999999999999999", "poissons_ratio 0.6"));
  EXPECT_THAT(line, HasSubstr("x.mca"));
  EXPECT_THAT(line, HasSubstr("poissons_ratio is 0.6, allowed: > -1 and < 0.5"));
  for (const char *keyword : {"youngs_modulus", "density", "strength", "viscosity", "diameter"}) {
    std::string text = steelText();
    const auto at = text.find(std::string("\n") + keyword + " ") + 1 + std::string(keyword).size();
    text.replace(at, text.find('\n', at) - at, " -3");
    EXPECT_THAT(problemOf(text), HasSubstr(std::string(keyword) + " is -3, allowed: >")) << keyword;
  }
}

TEST(MaterialFile, UnknownKeywordNamesTheNearest)
{
  EXPECT_EQ(problemOf(changed("viscosity", "viscocity")),
            "x.mca:10: unknown keyword 'viscocity'; the nearest known one is 'viscosity'");
}

TEST(MaterialFile, TwiceOrTwoValues)
{
  EXPECT_EQ(problemOf(changed("strength 92", "strength 92\nstrength 93")),
            "x.mca:6: strength appears twice");
  EXPECT_EQ(problemOf(changed("strength 92", "strength 92 93")),
            "x.mca:5: strength has 2 values, allowed: one, or a line temperature with as many");
  EXPECT_THAT(problemOf(changed("strength 92", "strength 92 MPa")),
              HasSubstr("x.mca:5: strength is 'MPa', allowed: a finite number > 0"));
}

TEST(MaterialFile, OtherUnits)
{
  for (const std::string style : {"nano", "si", "cgs", "micro", "metal", "real"}) {
    const Material m = mca::readMaterial(steelText(), "x.mca", style);
    const mca::Units u = *mca::findUnits(style);
    EXPECT_NEAR(m.youngsModulus * u.stress, 206000, 1e-9) << style;
    EXPECT_NEAR(m.density * u.density(), 7800, 1e-10) << style;
    EXPECT_NEAR(m.viscosity * u.viscosity(), 0.41, 1e-14) << style;
    EXPECT_NEAR(m.diameter * u.length, 2.5, 1e-14) << style;
    EXPECT_EQ(m.poissonsRatio, 0.3);
    EXPECT_EQ(m.yieldStrength, 0.870);
  }
  const std::string allowed =
      ", allowed: any two of nano, si, cgs, micro, metal, real, or lj in both";
  EXPECT_EQ(problemOf(steelText(), "lj"),
            "x.mca:1: UNITS is nano and the input script has units lj" + allowed);
  EXPECT_EQ(problemOf(changed("UNITS: nano", "UNITS: electron"), "electron"),
            "x.mca:1: UNITS is electron and the input script has units electron" + allowed);
  EXPECT_EQ(problemOf(changed("UNITS: nano", "UNITS: imperial"), "si"),
            "x.mca:1: UNITS is imperial and the input script has units si" + allowed);
  EXPECT_EQ(problemOf(changed("UNITS: nano", "UNITS: lj"), "lj"), "");
  EXPECT_EQ(problemOf(changed("UNITS: nano ", "")),
            "x.mca:1: no UNITS: in the first line, allowed: UNITS: nano");
}

TEST(MaterialFile, OverrideTakesPrecedenceAndIsChecked)
{
  const Material m = mca::overrideMaterial(steel(), {"strength", "200", "viscosity", "0"});
  EXPECT_EQ(m.strength, 200);
  EXPECT_EQ(m.viscosity, 0);
  EXPECT_EQ(m.density, steel().density);
  EXPECT_EQ(overrideProblem({}), "");
  EXPECT_EQ(overrideProblem({"strenght", "200"}),
            "unknown keyword 'strenght'; the nearest known one is 'strength'");
  EXPECT_THAT(overrideProblem({"strength"}), HasSubstr("keyword strength has no value"));
  EXPECT_THAT(overrideProblem({"strength", "2oo"}), HasSubstr("strength is '2oo', allowed:"));
  EXPECT_THAT(overrideProblem({"strength", "0x10"}), HasSubstr("strength is '0x10', allowed:"));
  EXPECT_THAT(overrideProblem({"strength", "nan"}), HasSubstr("strength is 'nan'"));
  EXPECT_THAT(overrideProblem({"density", "-1"}), HasSubstr("density is -1, allowed: > 0"));
  // together with the rest of the material: sigma_0/E beyond the breaking strain
  EXPECT_NE(overrideProblem({"strength", "20000"}), "");
}

TEST(MaterialFile, Temperatures)
{
  Material expected = steel();
  EXPECT_TRUE(softened(300.0) == expected);
  expected.strength = 80;
  EXPECT_TRUE(softened(600.0) == expected); // to the last bit
  expected.strength = 40;
  EXPECT_TRUE(softened(900.0) == expected);
  EXPECT_DOUBLE_EQ(softened(450.0).strength, 86.0);
  EXPECT_DOUBLE_EQ(softened(825.0).strength, 50.0);
  EXPECT_EQ(softened(825.0).viscosity, steel().viscosity);
  // converted like all other values
  EXPECT_NEAR(mca::readMaterial(softening(), "x.mca", "si", 825.0).strength, 50e6, 1e-6);
}

TEST(MaterialFile, TemperaturesThatAreWrong)
{
  EXPECT_EQ(softenedProblem({}), "keyword temperature is missing, allowed with x.mca: 300 to 900");
  EXPECT_EQ(softenedProblem(299.0), "keyword temperature is 299, allowed with x.mca: 300 to 900");
  EXPECT_EQ(softenedProblem(901.0), "keyword temperature is 901, allowed with x.mca: 300 to 900");
  EXPECT_EQ(softenedProblem(300.0, "40 30"),
            "x.mca:6: strength has 4 values, allowed: 1 or 3, as many as temperature");
  // each column is a material, whichever is asked for
  EXPECT_THAT(softenedProblem(300.0, "0"),
              HasSubstr("x.mca: at temperature 900: strength is 0, allowed: > 0"));
  const auto wrong = [](const std::string &line) {
    return problemOf(changed("strength 92", line + "\nstrength 92"));
  };
  EXPECT_EQ(wrong("temperature 300"),
            "x.mca:5: temperature has one value, allowed: at least two that rise");
  EXPECT_EQ(wrong("temperature 300 300"),
            "x.mca:5: temperature 300 stands after 300, allowed: values that rise");
  EXPECT_EQ(wrong("temperature -1 300"),
            "x.mca:5: temperature is '-1', allowed: a finite number > 0 [temperature]");
  EXPECT_EQ(wrong("temperature"), "x.mca:5: temperature has no value, allowed: > 0");
  EXPECT_EQ(wrong("temprature 1 2"),
            "x.mca:5: unknown keyword 'temprature'; the nearest known one is 'temperature'");
  try {
    mca::readMaterial(steelText(), "x.mca", "nano", 300.0);
    FAIL();
  } catch (const mca::MaterialError &e) {
    EXPECT_STREQ(e.what(),
                 "keyword temperature needs a file with a line temperature, which x.mca has not");
  }
}

TEST(MaterialFile, TemperatureAmongKeywords)
{
  std::vector<std::string> words = {"strength", "50", "temperature", "400", "viscosity", "0"};
  EXPECT_EQ(mca::takeTemperature(words), 400.0);
  EXPECT_THAT(words, testing::ElementsAre("strength", "50", "viscosity", "0"));
  EXPECT_FALSE(mca::takeTemperature(words));
  for (const char *value : {"0", "nan", "x"}) {
    words = {"temperature", value};
    EXPECT_THROW(mca::takeTemperature(words), mca::MaterialError) << value;
  }
  words = {"temperature"};
  EXPECT_THROW(mca::takeTemperature(words), mca::MaterialError);
}

TEST(MaterialFile, NoLocaleOfTheHostMatters)
{
  const std::string text = steelText(), bad = changed("strength 92", "strength -1234.5");
  const CommaLocale comma;
  EXPECT_TRUE(mca::readMaterial(text, "x.mca", "nano") == steel());
  EXPECT_THAT(problemOf(bad), HasSubstr("strength is -1234.5, allowed"));
  EXPECT_THAT(overrideProblem({"strength", "-1234.5"}), HasSubstr("strength is -1234.5, allowed"));
}

TEST(MaterialFile, WhatOtherMachinesSaveIsReadOrNamed)
{
  for (const auto &[what, bytes] : asOtherMachinesSave(steelText()))
    EXPECT_EQ(problemOf(bytes), "") << what;
  EXPECT_TRUE(mca::readMaterial(asOtherMachinesSave(steelText())[1].second, "x.mca", "nano") ==
              steel());
  EXPECT_EQ(problemOf(withoutMark(steelText())),
            "x.mca: is UTF-16 without a byte order mark; save it as UTF-8");
  EXPECT_EQ(problemOf(changed("strength 92", "strength 92 # 20 \xb0\x43")), "");
  EXPECT_LT(problemOf(changed("strength 92", "strength " + std::string(58000, 'x'))).size(), 500U);
}
