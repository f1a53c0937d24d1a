// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/forms/constant.h"
#include "law/forms/eq2.h"
#include "law/forms/polach.h"
#include "law/forms/table.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

using namespace wheelrail;

namespace {

using Vector = Eigen::VectorXd;

/// Steel of the paper's contact.
Eq2Scale railSteel(bool local = false, bool velocityTerm = true)
{
  return {local, velocityTerm, {1e9, 1250.0}, 206e9, 7800.0};
}

Eq2Law paperLaw(const Eq2Scale &scale)
{
  return {"bucher2006", bucher2006(), scale};
}

/// Hertz' pressure on 2000 cells.
Vector hertzPressure(double largest)
{
  Vector pressure(2000);
  for (int i = 0; i < 2000; ++i)
    pressure[i] = largest * std::sqrt(std::max(0.0, 1.0 - std::pow((i - 999.5) / 900.0, 2)));
  return pressure;
}

/// The ranges that a law is asked for, by key.
std::map<std::string, Range> rangesOf(const FrictionLaw &law, const LawUse &use)
{
  const std::vector<LawInput> inputs = law.inputs();
  EXPECT_EQ(inputs.size(), use.ranges.size());
  std::map<std::string, Range> ranges;
  for (std::size_t k = 0; k < inputs.size(); ++k)
    ranges[inputs[k].key] = use.ranges[k];
  return ranges;
}

bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(LawUse, LocalFrictionAsksForTheCellsPressures)
{
  const Eq2Law law = paperLaw(railSteel(true));
  const Vector pressure = hertzPressure(542e6), cold = Vector::Zero(2000);
  auto use = rangesOf(law, law.use({pressure, 2.0, cold}));
  EXPECT_NEAR(use["kappa3"][0], 206.0, 1e-12);
  EXPECT_EQ(use["kappa3"][0], use["kappa3"][1]);
  EXPECT_NEAR(use["kappa1"][1], 7800.0 * 206e9 * 4.0 / 1e18, 1e-15);
  EXPECT_NEAR(use["kappa2"][1], 542.0 * 0.206, 0.01 * 542 * 0.206);
  // load below p of Hertz' line contact: with s = p/p0, 1 - (2/pi)(asin(c) + c s), c = sqrt(1 -
  // s^2)
  const double s = use["kappa2"][0] / (542.0 * 0.206), c = std::sqrt(1.0 - s * s);
  EXPECT_NEAR(1.0 - 2.0 / mcawr::pi * (std::asin(c) + c * s), 0.005, 3e-4);
  // the sign of the sliding does not count; without the velocity term its speed does not
  EXPECT_EQ(law.use({pressure, -2.0, cold}).ranges, law.use({pressure, 2.0, cold}).ranges);
  const Eq2Law atRest = paperLaw(railSteel(true, false));
  EXPECT_EQ(rangesOf(atRest, atRest.use({pressure, 2.0, cold}))["kappa1"], (Range{0.0, 0.0}));
}

TEST(LawUse, HeatWeakensSoThatEveryNumberGrows)
{
  const Eq2Law law = paperLaw(railSteel(true));
  Vector warm = Vector::Zero(2000);
  warm.tail(1000).setConstant(250.0); // sigma_0 = 800 MPa
  const LawUse asked = law.use({hertzPressure(542e6), 2.0, warm});
  auto use = rangesOf(law, asked);
  EXPECT_NEAR(use["kappa3"][1], 206.0 / 0.8, 1e-9);
  EXPECT_NEAR(use["kappa3"][0], 206.0, 1e-9);
  EXPECT_NEAR(use["kappa1"][1], 7800.0 * 206e9 * 4.0 / 0.64e18, 1e-12);
  EXPECT_NEAR(use["kappa2"][1], 542.0 * 0.206 / 0.64, 2.0);
  LawUse both = law.use({hertzPressure(542e6), 0.0, Vector::Zero(2000)});
  both.include(asked);
  EXPECT_EQ(rangesOf(law, both)["kappa1"], (Range{0.0, use["kappa1"][1]}));
  LawUse none;
  both.include(none);
  EXPECT_EQ(rangesOf(law, both)["kappa1"], (Range{0.0, use["kappa1"][1]}));
  none.include(both);
  EXPECT_EQ(none.ranges, both.ranges);
  // a contact that touches nowhere asks for nothing
  EXPECT_TRUE(law.use({Vector::Zero(5), 2.0, Vector::Zero(5)}).ranges.empty());
}

TEST(LawUse, AveragedFrictionAsksForPressuresUpToTheHardness)
{
  const Eq2Law law = paperLaw(railSteel());
  auto use = rangesOf(law, law.use({hertzPressure(542e6), 0.0, Vector::Zero(2000)}));
  EXPECT_NEAR(use["kappa2"][0], 3.0 * 206.0 * std::sqrt(0.005), 1e-9);
  EXPECT_NEAR(use["kappa2"][1], 3.0 * 206.0 * std::sqrt(0.995), 1e-9);
}

TEST(LawUse, OutsideOfTheFitIsSaidWithBothNumbers)
{
  const Vector pressure = hertzPressure(542e6), cold = Vector::Zero(2000);
  const auto warningOf = [&](const KappaLaw &law) {
    const Eq2Law friction("bucher2006", law, railSteel());
    return friction.warning(friction.use({pressure, 0.0, cold}));
  };
  const std::string paper = warningOf(bucher2006());
  EXPECT_TRUE(contains(paper, "friction.law bucher2006 is used outside")) << paper;
  EXPECT_TRUE(contains(paper, "E/sigma_0 206 (373.2 to 2239)")) << paper;
  EXPECT_FALSE(contains(paper, "kappa")) << paper; // 62 to 616 is inside of 2 to 633
  KappaLaw law = bucher2006();
  law.kappa3 = 228.0; // the law of a reference, within a tenth
  EXPECT_EQ(warningOf(law), "");
  law.kappa3 = 250.0;
  EXPECT_TRUE(contains(warningOf(law), "E/sigma_0 206 (250)"));
  law.kappa3.reset();
  law.kappa3Range.reset(); // what the law does not say cannot be compared
  EXPECT_EQ(warningOf(law), "");
  law.kappa2Range = {{2.0, 300.0}};
  law.kappa1Range = {{0.2, 19.0}};
  const std::string both = warningOf(law);
  EXPECT_TRUE(contains(both, "kappa1 0 (0.2 to 19), kappa2 43.7 to 616.5 (2 to 300)")) << both;
  law.kappa1Range.reset();
  law.kappa2Range = {{45.0, 570.0}}; // passed by less than a tenth at either end
  EXPECT_EQ(warningOf(law), "");
}

TEST(LawUse, TablesAreComparedByPressureAndSpeed)
{
  const Vector pressure = hertzPressure(542e6), warm = Vector::Constant(2000, 100.0);
  const auto warningOf = [&](double most, double speed) {
    const TableLaw law("mu.csv", {{0.0, most}, {0.0, 5.0}, Eigen::MatrixXd::Constant(2, 2, 0.3)});
    return law.warning(law.use({pressure, speed, warm}));
  };
  const std::string high = warningOf(400e6, 3.0);
  EXPECT_TRUE(contains(high, "pressure in MPa 12")) << high;
  EXPECT_TRUE(contains(high, " to 542 (0 to 400)")) << high;
  EXPECT_FALSE(contains(high, "speed")) << high;
  EXPECT_EQ(warningOf(600e6, 3.0), "");
  const std::string fast = warningOf(600e6, 6.0);
  EXPECT_TRUE(contains(fast, "sliding speed in m/s 6 (0 to 5)")) << fast;
}

TEST(LawUse, ConstantFrictionHasNoRange)
{
  const ConstantLaw constant(0.3);
  const PolachLaw polach({0.4, 0.25, 0.6});
  for (const FrictionLaw *law :
       {static_cast<const FrictionLaw *>(&constant), static_cast<const FrictionLaw *>(&polach)}) {
    const LawUse use = law->use({hertzPressure(542e6), 1.0, Vector::Zero(2000)});
    EXPECT_TRUE(use.ranges.empty());
    EXPECT_EQ(law->warning(use), "");
  }
}
