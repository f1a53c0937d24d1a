// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/friction_table.h"
#include "law/law_use.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

using namespace wheelrail;

namespace {

using Vector = Eigen::VectorXd;

/// Steel of the paper's contact.
FrictionSpecification railSteel()
{
  FrictionSpecification friction;
  friction.strength = 1e9;
  friction.strengthTemperature = 1250.0;
  friction.modulus = 206e9;
  friction.density = 7800.0;
  return friction;
}

/// Hertz' pressure on 2000 cells.
Vector hertzPressure(double largest)
{
  Vector pressure(2000);
  for (int i = 0; i < 2000; ++i)
    pressure[i] = largest * std::sqrt(std::max(0.0, 1.0 - std::pow((i - 999.5) / 900.0, 2)));
  return pressure;
}

bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(LawUse, LocalFrictionAsksForTheCellsPressures)
{
  FrictionSpecification friction = railSteel();
  friction.local = true;
  const Vector pressure = hertzPressure(542e6), cold = Vector::Zero(2000);
  const LawUse use = lawUse(friction, pressure, 2.0, cold);
  EXPECT_NEAR(use.kappa3[0], 206.0, 1e-12);
  EXPECT_EQ(use.kappa3[0], use.kappa3[1]);
  EXPECT_NEAR(use.kappa1[1], 7800.0 * 206e9 * 4.0 / 1e18, 1e-15);
  EXPECT_NEAR(use.kappa2[1], 542.0 * 0.206, 0.01 * 542 * 0.206);
  // load below p of Hertz' line contact: with s = p/p0, 1 - (2/pi)(asin(c) + c s), c = sqrt(1 -
  // s^2)
  const double s = use.kappa2[0] / (542.0 * 0.206), c = std::sqrt(1.0 - s * s);
  EXPECT_NEAR(1.0 - 2.0 / M_PI * (std::asin(c) + c * s), 0.005, 3e-4);
  // the sign of the sliding does not count; without the velocity term its speed does not
  EXPECT_EQ(lawUse(friction, pressure, -2.0, cold).kappa1, use.kappa1);
  friction.velocityTerm = false;
  EXPECT_EQ(lawUse(friction, pressure, 2.0, cold).kappa1, (Range{0.0, 0.0}));
}

TEST(LawUse, HeatWeakensSoThatEveryNumberGrows)
{
  FrictionSpecification friction = railSteel();
  friction.local = true;
  Vector warm = Vector::Zero(2000);
  warm.tail(1000).setConstant(250.0); // sigma_0 = 800 MPa
  const LawUse use = lawUse(friction, hertzPressure(542e6), 2.0, warm);
  EXPECT_NEAR(use.kappa3[1], 206.0 / 0.8, 1e-9);
  EXPECT_NEAR(use.kappa3[0], 206.0, 1e-9);
  EXPECT_NEAR(use.kappa1[1], 7800.0 * 206e9 * 4.0 / 0.64e18, 1e-12);
  EXPECT_NEAR(use.kappa2[1], 542.0 * 0.206 / 0.64, 2.0);
  LawUse both = lawUse(friction, hertzPressure(542e6), 0.0, Vector::Zero(2000));
  both.include(use);
  EXPECT_EQ(both.kappa1, (Range{0.0, use.kappa1[1]}));
  LawUse none;
  both.include(none);
  EXPECT_EQ(both.kappa1, (Range{0.0, use.kappa1[1]}));
  none.include(both);
  EXPECT_EQ(none.kappa2, both.kappa2);
}

TEST(LawUse, AveragedFrictionAsksForPressuresUpToTheHardness)
{
  const LawUse use = lawUse(railSteel(), hertzPressure(542e6), 0.0, Vector::Zero(2000));
  EXPECT_NEAR(use.kappa2[0], 3.0 * 206.0 * std::sqrt(0.005), 1e-9);
  EXPECT_NEAR(use.kappa2[1], 3.0 * 206.0 * std::sqrt(0.995), 1e-9);
}

TEST(LawUse, OutsideOfTheFitIsSaidWithBothNumbers)
{
  const FrictionSpecification friction = railSteel();
  const Vector pressure = hertzPressure(542e6), cold = Vector::Zero(2000);
  const LawUse use = lawUse(friction, pressure, 0.0, cold);
  const std::string paper = lawWarning(friction, bucher2006(), use);
  EXPECT_TRUE(contains(paper, "friction.law bucher2006 is used outside")) << paper;
  EXPECT_TRUE(contains(paper, "E/sigma_0 206 (373.2 to 2239)")) << paper;
  EXPECT_FALSE(contains(paper, "kappa")) << paper; // 62 to 616 is inside of 2 to 633
  FrictionLaw law = bucher2006();
  law.kappa3 = 228.0; // the law of a reference, within a tenth
  EXPECT_EQ(lawWarning(friction, law, use), "");
  law.kappa3 = 250.0;
  EXPECT_TRUE(contains(lawWarning(friction, law, use), "E/sigma_0 206 (250)"));
  law.kappa3.reset();
  law.kappa3Range.reset(); // what the law does not say cannot be compared
  EXPECT_EQ(lawWarning(friction, law, use), "");
  law.kappa2Range = {{2.0, 300.0}};
  law.kappa1Range = {{0.2, 19.0}};
  const std::string both = lawWarning(friction, law, use);
  EXPECT_TRUE(contains(both, "kappa1 0 (0.2 to 19), kappa2 43.7 to 616.5 (2 to 300)")) << both;
  law.kappa1Range.reset();
  law.kappa2Range = {{45.0, 570.0}}; // passed by less than a tenth at either end
  EXPECT_EQ(lawWarning(friction, law, use), "");
}

TEST(LawUse, TablesAreComparedByPressureAndSpeed)
{
  FrictionSpecification friction = railSteel();
  friction.law = "mu.csv";
  FrictionLaw law;
  auto table = std::make_shared<FrictionTable>();
  table->pressure = {0.0, 400e6};
  table->speed = {0.0, 5.0};
  law.table = table;
  const Vector pressure = hertzPressure(542e6), warm = Vector::Constant(2000, 100.0);
  const std::string high = lawWarning(friction, law, lawUse(friction, pressure, 3.0, warm));
  EXPECT_TRUE(contains(high, "pressure in MPa 12")) << high;
  EXPECT_TRUE(contains(high, " to 542 (0 to 400)")) << high;
  EXPECT_FALSE(contains(high, "speed")) << high;
  table->pressure.back() = 600e6;
  EXPECT_EQ(lawWarning(friction, law, lawUse(friction, pressure, 3.0, warm)), "");
  const std::string fast = lawWarning(friction, law, lawUse(friction, pressure, 6.0, warm));
  EXPECT_TRUE(contains(fast, "sliding speed in m/s 6 (0 to 5)")) << fast;
}

TEST(LawUse, ConstantFrictionHasNoRange)
{
  FrictionSpecification friction = railSteel();
  for (const char *law : {"constant", "polach"}) {
    friction.law = law;
    const LawUse use = lawUse(friction, hertzPressure(542e6), 1.0, Vector::Zero(2000));
    EXPECT_FALSE(use.any);
    EXPECT_EQ(lawWarning(friction, readLaw(friction), use), "");
  }
}
