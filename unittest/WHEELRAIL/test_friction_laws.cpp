// SPDX-License-Identifier: GPL-2.0-or-later
// The laws as contacts use them, and the list by which a case finds them.
#include "base/errors.h"
#include "law/friction_laws.h"
#include "law/temperature_factor.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace wheelrail;

namespace {

using Vector = Eigen::VectorXd;

const LawForm &formOf(const std::string &word)
{
  return lawFormOf({word, "folder/" + word});
}

std::string wordOf(const std::string &name)
{
  return formOf(name).word;
}

/// What a law needs, by keyword.
LawValues valuesOf(const std::string &word, const std::map<std::string, double> &numbers)
{
  return {{word, "folder/" + word}, numbers};
}

const std::map<std::string, double> railSteel = {
    {"friction.local", 1.0},     {"friction.velocity_term", 0.0},
    {"friction.strength", 1e9},  {"friction.strength_temperature", 1250.0},
    {"friction.modulus", 206e9}, {"friction.density", 7800.0}};

} // namespace

TEST(FrictionLaws, EveryNameBelongsToOneLaw)
{
  EXPECT_EQ(wordOf("constant"), std::string("constant"));
  EXPECT_EQ(wordOf("polach"), std::string("polach"));
  for (const char *table : {"mu.csv", "MU.CSV", "folder.d/Mu.Csv"})
    EXPECT_EQ(wordOf(table), std::string(".csv")) << table;
  EXPECT_EQ(wordOf("bucher2006"), std::string("bucher2006"));
  for (const char *file :
       {"law.json", ".csv", "csv", "x.csv/law", "constant.json", "polach ", "mu.csv2"})
    EXPECT_EQ(wordOf(file), std::string("bucher2006")) << file;
}

TEST(FrictionLaws, KeywordsThatSeveralLawsReadStandThereOnce)
{
  for (const LawKeyword &keyword : lawKeywords())
    for (const LawForm &form : lawForms())
      for (const LawKeyword &own : form.keywords)
        if (std::string(own.name) == keyword.name) {
          EXPECT_STREQ(own.help, keyword.help) << own.name;
          EXPECT_STREQ(own.unit, keyword.unit) << own.name;
          EXPECT_STREQ(own.initial, keyword.initial) << own.name;
          EXPECT_EQ(own.low, keyword.low) << own.name;
          EXPECT_EQ(own.high, keyword.high) << own.name;
        }
  EXPECT_TRUE(formOf("polach").reads("friction.mu0"));
  EXPECT_FALSE(formOf("polach").reads("friction.mu"));
  EXPECT_EQ(lawsWith("friction.B"), "'law: polach'");
}

TEST(FrictionLaws, ConstantIsTheSameEverywhere)
{
  const LawPointer law =
      formOf("constant").choose(valuesOf("constant", {{"friction.mu", 0.3}})).read();
  const Vector mu = law->mu({Vector::Constant(3, 1e9), 5.0, Vector::Constant(3, 300.0)});
  EXPECT_EQ(mu, Vector::Constant(3, 0.3));
  EXPECT_FALSE(law->dependsOnSpeed() || law->dependsOnTemperature());
  EXPECT_EQ(law->json()["mu0"], 0.3);
}

TEST(FrictionLaws, PolachsFormFallsWithTheSlidingSpeed)
{
  const LawPointer law =
      formOf("polach")
          .choose(valuesOf("polach",
                           {{"friction.mu0", 0.4}, {"friction.A", 0.25}, {"friction.B", 0.6}}))
          .read();
  const Vector pressure = Vector::Constant(2, 1e9), cold = Vector::Zero(2);
  for (const double w : {0.0, 0.5, 3.0, 1e3})
    for (const double sign : {1.0, -1.0})
      EXPECT_DOUBLE_EQ(law->mu({pressure, sign * w, cold})[1],
                       0.4 * (0.75 * std::exp(-0.6 * w) + 0.25));
  EXPECT_TRUE(law->dependsOnSpeed());
  EXPECT_FALSE(law->dependsOnTemperature());
}

TEST(FrictionLaws, ATableIsReadWithThePressureOfEachCell)
{
  FrictionTable table{{1e8, 3e8}, {0.0, 10.0}, Eigen::MatrixXd(2, 2)};
  table.mu << 0.5, 0.4, 0.3, 0.1;
  const TableLaw law("mu.csv", table);
  Vector pressure(3);
  pressure << 0.0, 2e8, 3e8;
  const Vector mu = law.mu({pressure, -5.0, Vector::Constant(3, 500.0)});
  for (int i = 0; i < 3; ++i)
    EXPECT_DOUBLE_EQ(mu[i], table(pressure[i], 5.0));
  EXPECT_EQ(law.json()["pressure_MPa"], (nlohmann::ordered_json{100.0, 300.0}));
  // the file is named by the choice and opened by `read` only
  const LawChoice choice = formOf("none.csv").choose(valuesOf("none.csv", {}));
  EXPECT_EQ(choice.files, (std::vector<std::string>{"folder/none.csv"}));
  EXPECT_THROW(choice.read(), Error);
  EXPECT_EQ(choice.cellwise->keyword, "friction.law");
}

TEST(FrictionLaws, Eq2SeesPressureSpeedAndTemperatureOfEachCell)
{
  // by hand: Eq. 2 with sigma_0 of Eq. 10
  const Eq2Law law("bucher2006", bucher2006(), {true, true, {1e9, 1250.0}, 206e9, 7800.0});
  Vector pressure(3), rise(3);
  pressure << 0.0, 500e6, 900e6;
  rise << 0.0, 250.0, 500.0;
  const double w = 4.0;
  const Vector mu = law.mu({pressure, w, rise});
  for (int i = 0; i < 3; ++i) {
    const double sigma = 1e9 * (1.0 - rise[i] / 1250.0);
    const double k1 = 7800.0 * 206e9 * w * w / (sigma * sigma);
    const double k2 = pressure[i] * 206e9 / (sigma * sigma);
    EXPECT_NEAR(mu[i], 0.15 + 0.0442 * k1 / (1.0 + 0.195 * k1) + 0.3243 / (1.0 + 0.00212 * k2),
                1e-14);
  }
  EXPECT_EQ(law.mu({pressure, -w, rise}), mu);
  // averaged: no cell's own pressure
  const Eq2Law mean("bucher2006", bucher2006(), {false, true, {1e9, 1250.0}, 206e9, 7800.0});
  const Vector same = mean.mu({pressure, w, Vector::Zero(3)});
  EXPECT_EQ(same[0], same[2]);
  EXPECT_LT(mean.mu({pressure, w, rise})[2], same[2]);
}

TEST(FrictionLaws, Eq2TakesItsKeywordsFromTheCase)
{
  const LawChoice choice = formOf("bucher2006").choose(valuesOf("bucher2006", railSteel));
  EXPECT_TRUE(choice.files.empty());
  EXPECT_TRUE(choice.mayHaveCovariance);
  EXPECT_EQ(choice.cellwise->keyword, "friction.local");
  const LawPointer law = choice.read();
  EXPECT_FALSE(law->dependsOnSpeed()); // no velocity term
  EXPECT_TRUE(law->dependsOnTemperature());
  const Vector mu = law->mu({Vector::Constant(1, 1e9), 9.0, Vector::Zero(1)});
  EXPECT_NEAR(mu[0], 0.15 + 0.3243 / (1.0 + 0.00212 * 206.0), 1e-14);
  const LawChoice file = formOf("law.json").choose(valuesOf("law.json", railSteel));
  EXPECT_EQ(file.files, (std::vector<std::string>{"folder/law.json"}));
  EXPECT_THROW(file.read(), Error);
}

TEST(FrictionLaws, Eq2RefusesAMuThatIsNone)
{
  KappaLaw law = bucher2006();
  law.mu0 = -0.2;
  const Eq2Law friction("law.json", law, {true, false, {1e9, 1250.0}, 206e9, 7800.0});
  try {
    static_cast<void>(friction.mu({Vector::Constant(1, 3e9), 1.0, Vector::Zero(1)}));
    FAIL() << "was accepted";
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::NotConverged);
    EXPECT_NE(std::string(error.what()).find("friction.law: mu = -"), std::string::npos);
  }
  EXPECT_FALSE(friction.isSound());
}

TEST(TemperatureFactor, IsOneThenLinearThenTheFactor)
{
  const TemperatureFactor factor{0.4, 100.0, 500.0};
  EXPECT_EQ(factor.at(0.0), 1.0);
  EXPECT_EQ(factor.at(100.0), 1.0);
  EXPECT_DOUBLE_EQ(factor.at(300.0), 0.7);
  EXPECT_DOUBLE_EQ(factor.at(500.0), 0.4);
  EXPECT_DOUBLE_EQ(factor.at(5000.0), 0.4);
}

TEST(TemperatureFactor, MultipliesTheLawOfEachCellAndKeepsTheRest)
{
  const auto cold = std::make_shared<PolachLaw>(FallingFriction{0.4, 0.5, 0.1});
  const LawPointer hot = heatedLaw(cold, {0.4, 100.0, 500.0});
  const Vector pressure = Vector::Constant(3, 1e9);
  const Vector rise = (Vector(3) << 0.0, 300.0, 900.0).finished();
  const FrictionState state{pressure, 2.0, rise};
  const Vector mu = hot->mu(state), of = cold->mu(state);
  for (int i = 0; i < 3; ++i)
    EXPECT_DOUBLE_EQ(mu[i], of[i] * (i == 0 ? 1.0 : i == 1 ? 0.7 : 0.4));
  EXPECT_TRUE(hot->dependsOnTemperature() && hot->dependsOnSpeed());
  EXPECT_FALSE(hot->dependsOnStrength());
  EXPECT_EQ(hot->json()["temperature_factor"]["hot"], 0.4);
  EXPECT_EQ(hot->json()["mu0"], 0.4);
}

TEST(TemperatureFactor, KeepsStrengthAndCovariance)
{
  const LawChoice choice = formOf("bucher2006").choose(valuesOf("bucher2006", railSteel));
  const LawPointer cold = choice.read(), hot = heatedLaw(cold, {0.5, 0.0, 100.0});
  EXPECT_EQ(hot->dependsOnStrength(), cold->dependsOnStrength());
  EXPECT_EQ(hot->strength(), cold->strength());
  EXPECT_EQ(hot->standardErrors(), cold->standardErrors());
  EXPECT_EQ(hot->inputs().size(), cold->inputs().size());
}
