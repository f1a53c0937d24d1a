// SPDX-License-Identifier: GPL-2.0-or-later
// The contact that is asked step by step gives what a sweep gives.
#include "creep/online/online_contact.h"

#include "base/errors.h"
#include "creep/patch/patch_curve.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <yaml-cpp/yaml.h>

using namespace wheelrail;
using testing::HasSubstr;

namespace {

const std::string steel = "contact: {load: 100 kN, radii: {wheel_rolling: 0.5 m, rail_profile: "
                          "0.3 m}, youngs_modulus: 210 GPa, poissons_ratio: 0.3}\n"
                          "speed: 20 m/s\ncells: [48, 44]\nsensitivities: false\n";
const std::string plain = steel + "friction: {law: constant, mu: 0.3}\nthermal: off\n";

Case caseWith(const std::string &base, const std::string &changes)
{
  YAML::Node tree = YAML::Load(base);
  for (const auto &pair : YAML::Load(changes))
    tree[pair.first.Scalar()] = pair.second;
  return caseOfTree("case", tree);
}

/// What a sweep gives for the one operating point of a case.
PatchPoint swept(const Case &input)
{
  const auto &asked = std::get<PatchSpecification>(input.task);
  return solvePatchCurves(asked, asked.friction.read()).points.front();
}

/// Both points begin elsewhere, so that they agree to the tolerance of the contact that is asked
/// step by step: forces to 1e-5 of what friction carries, 0.3 of the load.
void expectEqual(const PatchPoint &a, const PatchPoint &b)
{
  const double unit = 3e-6 * b.load;
  EXPECT_NEAR(a.forceX, b.forceX, unit);
  EXPECT_NEAR(a.forceY, b.forceY, unit);
  EXPECT_NEAR(a.momentZ, b.momentZ, unit * 0.01); // levers are below a centimetre
  EXPECT_NEAR(a.peakPressure, b.peakPressure, 1e-6 * b.peakPressure);
  EXPECT_NEAR(a.approach, b.approach, 1e-6 * b.approach);
  EXPECT_NEAR(a.temperatureRise, b.temperatureRise, 1e-4);
}

std::string messageOf(const std::function<void()> &action)
{
  try {
    action();
  } catch (const Error &error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(OnlineContact, GivesWhatASweepGives)
{
  for (const std::string &base : {plain, steel + "friction: {local: true}\n"}) {
    OnlineContact contact(caseWith(base, "{creep: 0}"));
    contact.setCreepages({1e-3, 5e-4, 0.2});
    contact.step();
    contact.setCreepages({2e-3, -1e-3, 0.1});
    expectEqual(contact.step(),
                swept(caseWith(base, "{creep: 0.2 %, lateral: -0.1 %, spin: 0.1 1/m}")));
    contact.setSpeed(35.0);
    expectEqual(contact.step(), swept(caseWith(base, "{creep: 0.2 %, lateral: -0.1 %, spin: 0.1 "
                                                     "1/m, speed: 35 m/s}")));
  }
}

TEST(OnlineContact, BeginsWithTheCase)
{
  const Case input = caseWith(plain, "{creep: [0.1 %, 1 %], spin: 0.1 1/m}");
  OnlineContact contact(input);
  expectEqual(contact.step(), swept(input));
}

/// A box that is as large for a smaller load: 2.2 semi-axes of 100 kN are so many of 60 kN.
TEST(OnlineContact, KeepsItsBoxUnderAnotherLoad)
{
  OnlineContact contact(caseWith(plain, "{creep: 0.1 %, lateral: 0.05 %}"));
  contact.step();
  contact.setLoad(60e3);
  const PatchPoint point = contact.step();
  YAML::Node tree = YAML::Load(plain);
  tree["contact"]["load"] = "60 kN";
  tree["contact"]["domain"] = fmt::format("{:.16g}", 2.2 * std::cbrt(100.0 / 60.0));
  tree["creep"] = "0.1 %";
  tree["lateral"] = "0.05 %";
  expectEqual(point, swept(caseOfTree("case", tree)));
  contact.setLoad(100e3);
  expectEqual(contact.step(), swept(caseWith(plain, "{creep: 0.1 %, lateral: 0.05 %}")));
}

TEST(OnlineContact, RefusesALoadThatLeavesTheBoxAndGoesOn)
{
  OnlineContact contact(caseWith(plain, "{creep: 0.1 %}"));
  const double before = contact.step().forceX;
  contact.setLoad(200e3);
  EXPECT_THAT(messageOf([&] { contact.step(); }), HasSubstr("contact.domain"));
  EXPECT_THAT(messageOf([&] { contact.point(); }), HasSubstr("there is no result"));
  contact.setLoad(100e3);
  EXPECT_NEAR(contact.step().forceX, before, 1e-6 * 100e3);
}

TEST(OnlineContact, RefusesWhatAKeywordMayNotBe)
{
  OnlineContact contact(caseWith(plain, "{creep: 0.1 %}"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(messageOf([&] { contact.setLoad(-1.0); }),
              HasSubstr("contact.load: '-1' is not in the allowed range [1e-12, 1e+12] N"));
  EXPECT_THAT(messageOf([&] { contact.setSpeed(0.0); }), HasSubstr("speed: '0'"));
  EXPECT_THAT(messageOf([&] { contact.setCreepages({0.0, 0.0, nan}); }), HasSubstr("spin: 'nan'"));
  EXPECT_THAT(messageOf([&] { contact.setCreepages({0.0, 11.0, 0.0}); }), HasSubstr("lateral"));
  EXPECT_LT(contact.step().forceX, 0.0);       // of the creep that was set before
  contact.setCreepages({1e-18, -1e-300, 0.0}); // rounding of a code's own
  EXPECT_NEAR(contact.step().forceX, 0.0, 1e-6 * 100e3);
}

/// 48 cells on 2.2 semi-axes are 43.6 across, 44 are 40: 4 are left of a thousandth of the load.
TEST(OnlineContact, RefusesALoadOnTooFewCells)
{
  OnlineContact contact(caseWith(plain, "{creep: 0.1 %, thermal: {model: local}}"));
  const double before = contact.step().forceX;
  EXPECT_THAT(messageOf([&] { contact.setLoad(99.0); }),
              HasSubstr("contact.load: 99 N: 3.99 cells for the width of the contact of "));
  EXPECT_EQ(contact.load(), 100e3);
  EXPECT_EQ(contact.point().forceX, before);
  contact.setLoad(101.0);
  EXPECT_TRUE(std::isfinite(contact.step().temperatureRise));
}

TEST(OnlineContact, SetsAllOrNothing)
{
  OnlineContact contact(caseWith(plain, "{creep: 0.1 %}"));
  EXPECT_THAT(messageOf([&] {
                contact.set({0.05, 0.0, 0.0}, -1.0, 30.0);
              }),
              HasSubstr("contact.load: '-1'"));
  EXPECT_THAT(messageOf([&] {
                contact.set({0.05, 0.0, 0.0}, 90e3, 0.0);
              }),
              HasSubstr("speed: '0'"));
  EXPECT_EQ(contact.creepage().xi, 1e-3);
  EXPECT_EQ(contact.load(), 100e3);
  EXPECT_EQ(contact.speed(), 20.0);
}

TEST(OnlineContact, RefusesOtherCases)
{
  const auto refusal = [](const std::string &base, const std::string &changes) {
    return messageOf([&] { OnlineContact contact(caseWith(base, changes)); });
  };
  EXPECT_THAT(refusal(plain, "{creep: 0.1 %, mode: moving}"), HasSubstr("mode: "));
  EXPECT_THAT(refusal("contact: {approach: 0.05 mm, radii: {wheel_rolling: 0.5 m, rail_profile: "
                      "0.3 m}, youngs_modulus: 210 GPa, poissons_ratio: 0.3}\nspeed: 20 m/s\n"
                      "friction: {law: constant, mu: 0.3}\n",
                      "{creep: 0.1 %}"),
              HasSubstr("contact.approach: "));
  EXPECT_THAT(refusal(plain, "{force: {longitudinal: 1 kN}}"), HasSubstr("force: "));
  EXPECT_THAT(refusal(plain, "{creep: 0.1 %, roughness: {hurst: 0.8, rms_slope: 0.01, "
                             "wavelength_min: 2 mm, wavelength_max: 8 mm, seed: [1, 2]}}"),
              HasSubstr("one surface; 2 are given"));
  EXPECT_THAT(refusal("creep: 0.1 %\nspeed: 20 m/s\nfriction: {law: constant, mu: 0.3}\n",
                      "{contact: {load_per_length: 4000 N/mm, radius: 0.5 m, youngs_modulus: 206 "
                      "GPa, poissons_ratio: 0.3}}"),
              HasSubstr("point contact"));
}

TEST(CaseOfTree, IsTheCaseOfTheText)
{
  const std::string text = plain + "creep: [0.1 %, 0.2 %]\n";
  EXPECT_EQ(caseOfTree("case", YAML::Load(text)).text, caseOfText("case", text).text);
  EXPECT_THAT(messageOf([&] { caseOfText("case", plain + "creep: x\n"); }),
              HasSubstr("case:7: creep: "));
  YAML::Node tree = YAML::Load(plain);
  tree["creeep"] = "1";
  EXPECT_THAT(messageOf([&] { caseOfTree("case", tree); }),
              HasSubstr("case: creeep: unknown keyword"));
}

/// A step of a slow change goes on along the steps before it. Products are the time of a call;
/// without these steps, and with a product for each slip that is looked at, the median is 15 or
/// more.
TEST(OnlineContact, FollowsASlowChangeWithFewProducts)
{
  OnlineContact contact(caseWith(plain, "{creep: 0}"));
  std::vector<int> products;
  for (int i = 0; i < 60; ++i) { // creep 0.05 to 0.15 % at 10 Hz, lateral at 7 Hz, steps of 1 ms
    contact.setCreepages({1e-3 + 5e-4 * std::sin(0.0628 * i), 5e-4 * std::sin(0.044 * i), 0.1});
    products.push_back(contact.step().products);
  }
  std::nth_element(products.begin(), products.begin() + 30, products.end());
  EXPECT_LE(products[30], 9);
  contact.setCreepages({1.2e-3, 1e-4, 0.1}); // an end to it
  expectEqual(contact.step(),
              swept(caseWith(plain, "{creep: 0.12 %, lateral: 0.01 %, spin: 0.1 1/m}")));
}
