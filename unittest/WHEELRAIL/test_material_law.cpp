// SPDX-License-Identifier: GPL-2.0-or-later
// mu(p, v, T) of one material: the bound by the shear strength, the table, the file, the fit, and
// what a contact makes of them.
#include "base/errors.h"
#include "creep/patch/moving_patch.h"
#include "fit/law_fit.h"
#include "fit/material_fit.h"
#include "law/forms/material.h"
#include "law/friction_laws.h"
#include "law/material_law.h"

#include <Eigen/Dense>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

using namespace wheelrail;
using testing::HasSubstr;

namespace {

/// Eq. 3 with a power and a bound that rises with the speed.
LawParameters someParameters()
{
  LawParameters x;
  x << 0.15, 0.0442, 0.3243, 0.195, 0.00212, 0.2, 0.5, 3.0, 0.2, 0.7;
  return x;
}

/// The rail steel at three of its temperatures; K, Pa.
SofteningMaterial steel()
{
  SofteningMaterial material;
  material.name = "steel";
  material.temperature = {293.0, 673.0, 873.0};
  material.strength = {900e6, 720e6, 338.4e6};
  material.modulus = {206e9, 144.2e9, 63.86e9};
  material.density = 7800.0;
  return material;
}

MuTable someTable()
{
  MuTable table;
  table.rows = {{293.0, {0.1, 0.7, 2.6}, {0.50, 0.42, 0.18}, {0.02, 0.02, 0.01}},
                {673.0,
                 {0.1, 0.3, 0.7, 1.3, 2.6},
                 {0.42, 0.42, 0.40, 0.30, 0.16},
                 {0.02, 0.02, 0.02, 0.01, 0.01}},
                {873.0, {0.1, 1.3}, {0.36, 0.25}, {0.03, 0.01}}};
  table.speed = {{0.3, 0.7, 2.6}, {-0.05, 0.15, 0.05}, {0.03, 0.02, 0.01}, {0.5, 5.0}, 5.0};
  return table;
}

std::string written(const MaterialLaw &law, const std::string &name)
{
  const std::string path = testing::TempDir() + name;
  std::ofstream(path) << toJson(law).dump(2) << "\n";
  return path;
}

std::string messageOf(const std::string &path)
{
  try {
    readMaterialLaw(path);
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    return error.what();
  }
  return "";
}

} // namespace

TEST(BoundedMu, IsEq2FarBelowTheLimitAndTheShearStrengthFarAboveIt)
{
  const LawParameters x = someParameters();
  const double base = 0.15 + 0.0442 * 2.0 / (1.0 + 0.195 * 2.0) + 0.3243;
  EXPECT_NEAR(boundedMu(x, {2.0, 0.0, 500.0}, 1.0), base, 1e-15);
  // p/sigma_0 = 1000: mu p = 0.5 sigma_0 at rest
  EXPECT_NEAR(boundedMu(x, {0.0, 5e5, 500.0}, 1.0), 0.5 / 1000.0, 1e-9);
  const double moving = 0.5 + 0.2 * 2.0 / (1.0 + 0.7 * 2.0);
  EXPECT_NEAR(boundedMu(x, {2.0, 5e5, 500.0}, 1.0), moving / 1000.0, 1e-9);
  // where both are equal: 2^(-1/q) of them
  LawParameters y = LawParameters::Zero();
  y[Mu0] = 0.4, y[S] = 0.4, y[Q] = 3.0;
  EXPECT_NEAR(boundedMu(y, {0.0, 300.0, 300.0}, 300.0), 0.4 * std::pow(2.0, -1.0 / 3.0), 1e-15);
  y[N] = 0.5;
  EXPECT_NEAR(boundedMu(y, {0.0, 0.0, 400.0}, 4.0), 0.8, 1e-15);
  y[S] = 0.0; // no limit
  EXPECT_NEAR(boundedMu(y, {0.0, 1e9, 400.0}, 4.0), 0.8, 1e-15);
}

TEST(BoundedMu, IsBelowBothSidesAndTheirOrderOfSizeWhateverTheSharpness)
{
  LawParameters x = LawParameters::Zero();
  x[Mu0] = 0.4, x[S] = 0.5;
  for (const double q : {1.0, 4.0, 50.0}) {
    x[Q] = q;
    double last = 1.0;
    for (double ratio = 1e-6; ratio < 1e6; ratio *= 1.3) {
      const double mu = boundedMu(x, {0.0, 200.0 * ratio, 200.0}, 200.0);
      const double least = std::min(0.4, 0.5 / ratio);
      EXPECT_LE(mu, least * (1.0 + 1e-15)) << q << " " << ratio;
      EXPECT_GE(mu, least * std::pow(2.0, -1.0 / q) * (1.0 - 1e-12)) << q << " " << ratio;
      EXPECT_LE(mu, last);
      last = mu;
    }
  }
}

TEST(BoundedMu, GradientIsThatOfFiniteDifferences)
{
  for (const double kappa2 : {0.0, 3.0, 80.0, 150.0, 600.0, 6e4})
    for (const double limit : {0.5, 0.0}) {
      LawParameters x = someParameters();
      x[S] = limit;
      const Kappas kappas = {1.5, kappa2, 229.0};
      LawParameters gradient;
      boundedMu(x, kappas, kappas.kappa3 / 400.0, &gradient);
      for (int k = 0; k < allParameters; ++k) {
        if (k == S && limit == 0.0)
          continue; // there is no law on the other side
        const double h = 1e-6 * std::abs(x[k]);
        LawParameters up = x, down = x;
        up[k] += h, down[k] -= h;
        const double slope = (boundedMu(up, kappas, kappas.kappa3 / 400.0) -
                              boundedMu(down, kappas, kappas.kappa3 / 400.0)) /
                             std::max(2.0 * h, 1e-300);
        EXPECT_NEAR(gradient[k], h > 0.0 ? slope : 0.0, 2e-8 * (1.0 + std::abs(slope)))
            << parameterNames[k] << " " << kappa2 << " " << limit;
      }
    }
}

TEST(MonotoneCurve, GoesThroughItsValuesWithoutAKinkAndStaysBetweenThem)
{
  const MonotoneCurve curve{{0.0, 1.0, 1.5, 4.0, 5.0, 7.0}, {3.0, 3.0, 2.0, 1.9, 0.2, 0.4}};
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    EXPECT_DOUBLE_EQ(curve(curve.x[k]), curve.y[k]);
    const double h = 1e-6;
    const double left = (curve(curve.x[k]) - curve(curve.x[k] - h)) / h;
    const double right = (curve(curve.x[k] + h) - curve(curve.x[k])) / h;
    EXPECT_NEAR(left, right, 1e-4) << k;
  }
  for (double at = -1.0; at < 8.0; at += 0.01) {
    const std::size_t k = at <= 0.0 ? 0 : at >= 7.0 ? 4 : pieceOf(curve.x, at);
    EXPECT_LE(curve(at), std::max(curve.y[k], curve.y[k + 1]) + 1e-12);
    EXPECT_GE(curve(at), std::min(curve.y[k], curve.y[k + 1]) - 1e-12);
  }
  EXPECT_EQ(curve(-1e9), 3.0);
  EXPECT_EQ(curve(1e9), 0.4);
  EXPECT_EQ((MonotoneCurve{{2.0}, {5.0}}(1.0)), 5.0);
  // a straight line stays one
  EXPECT_NEAR((MonotoneCurve{{0.0, 1.0, 2.0, 3.0}, {0.0, 2.0, 4.0, 6.0}}(1.3)), 2.6, 1e-14);
  EXPECT_EQ(limitedSlope(1.0, -1.0), 0.0);
  EXPECT_EQ(limitedSlope(0.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(limitedSlope(-3.0, -3.0), -3.0);
  for (const double steep : {1.0, 1.2, 2.0, 30.0})
    EXPECT_LE(limitedSlope(1.0, steep), 1.06);
}

TEST(MuTable, HasItsValuesAndNoKink)
{
  const MuTable table = someTable();
  for (const MuTable::Row &row : table.rows)
    for (std::size_t k = 0; k < row.ratio.size(); ++k)
      EXPECT_NEAR(table(row.ratio[k], row.temperature, 5.0), row.mu[k], 1e-14);
  // derivatives from both sides, by pressure at the values of a row and at its ends, by temperature
  // at all rows
  const auto jump = [&](double ratio, double kelvin, double dr, double dT) {
    const double h = 1e-5;
    const double here = table(ratio, kelvin, 5.0);
    const double left = (here - table(ratio * (1 - h * dr), kelvin - 100 * h * dT, 5.0)) / h;
    const double right = (table(ratio * (1 + h * dr), kelvin + 100 * h * dT, 5.0) - here) / h;
    return std::abs(left - right);
  };
  for (const double kelvin : {293.0, 500.0, 673.0, 700.0, 873.0})
    for (const double ratio : {0.05, 0.1, 0.3, 0.7, 1.3, 2.6, 3.0}) {
      EXPECT_LT(jump(ratio, kelvin, 1, 0), 2e-4) << ratio << " " << kelvin;
      EXPECT_LT(jump(ratio, kelvin, 0, 1), 2e-4) << ratio << " " << kelvin;
    }
}

TEST(MuTable, FallsWhereItsValuesFallAndEndsInAConstantFrictionStress)
{
  const MuTable table = someTable();
  for (const double kelvin : {293.0, 673.0, 873.0}) {
    double last = 1.0;
    for (double ratio = 1e-4; ratio < 1e3; ratio *= 1.05) {
      const double mu = table(ratio, kelvin, 5.0);
      EXPECT_LE(mu, last * (1.0 + 1e-12)) << ratio << " " << kelvin;
      last = mu;
    }
    EXPECT_NEAR(table(1e5, kelvin, 5.0) * 1e5, table(1e4, kelvin, 5.0) * 1e4, 1e-3);
    EXPECT_NEAR(table(0.0, kelvin, 5.0), table(1e-8, kelvin, 5.0), 1e-6);
  }
  double last = 1.0;
  for (double kelvin = 200.0; kelvin < 1000.0; kelvin += 5.0) {
    const double mu = table(0.1, kelvin, 5.0);
    EXPECT_LE(mu, last);
    last = mu;
  }
  EXPECT_EQ(table(0.7, 100.0, 5.0), table(0.7, 293.0, 5.0));
  EXPECT_EQ(table(0.7, 2000.0, 5.0), table(0.7, 873.0, 5.0));
  EXPECT_NEAR(table(0.7, 673.0, 1.0), 0.40 * std::pow(0.2, 0.15), 1e-14);
  EXPECT_EQ(table(0.7, 673.0, 0.0), table(0.7, 673.0, 0.5)); // nearest end
  EXPECT_EQ(table(0.7, 673.0, 50.0), table(0.7, 673.0, 5.0));
}

TEST(MuTable, ItsPowerOfTheSpeedGoesWithThePressure)
{
  const MuTable table = someTable();
  const auto power = [&](double ratio, double kelvin) {
    return std::log(table(ratio, kelvin, 1.0) / table(ratio, kelvin, 5.0)) / std::log(0.2);
  };
  for (const double kelvin : {293.0, 800.0}) {
    EXPECT_NEAR(power(0.3, kelvin), -0.05, 1e-13);
    EXPECT_NEAR(power(0.7, kelvin), 0.15, 1e-13);
    EXPECT_NEAR(power(2.6, kelvin), 0.05, 1e-13);
    EXPECT_NEAR(power(0.01, kelvin), -0.05, 1e-13); // the ends hold beyond
    EXPECT_NEAR(power(30.0, kelvin), 0.05, 1e-13);
  }
  double last = -0.05;
  for (double ratio = 0.3; ratio < 0.7; ratio *= 1.01) {
    const double here = power(ratio, 500.0);
    EXPECT_GE(here, last - 1e-12) << ratio;
    EXPECT_LT(here - last, 0.01) << ratio;
    last = here;
  }
  MuTable changed = table.changed(table.standardErrors());
  ASSERT_EQ(table.parameters(), 13);
  EXPECT_DOUBLE_EQ(changed.speed.exponent[1], 0.17);
  changed.speed = {};
  EXPECT_EQ(changed(0.7, 500.0, 1.0), changed(0.7, 500.0, 5.0));
}

/// Three speeds at one pressure and temperature: the line through all of them by their own errors,
/// so that a wrong value at the usual speed does not tilt it.
TEST(MuTable, PowerOfTheSpeedIsTheSlopeThroughAllSpeeds)
{
  const std::array<double, 3> speeds = {5.0, 2.0, 0.5}, mus = {0.36, 0.28, 0.26},
                              errors = {0.06, 0.003, 0.004};
  std::vector<FrictionRun> runs(4);
  std::vector<FitCondition> conditions(4);
  for (int i = 0; i < 4; ++i) {
    const int k = std::min(i, 2);
    runs[i].temperature = i < 3 ? 293.0 : 873.0; // the usual speed is that of most
    runs[i].head.velocity = i < 3 ? speeds[k] : 5.0;
    conditions[i].runs = {static_cast<std::size_t>(i)};
    conditions[i].mean = {1.0, 100.0, mus[k], errors[k]};
    conditions[i].mean.kappa3 = 200.0;
  }
  Eigen::Matrix<double, 3, 2> line;
  Eigen::Vector3d y;
  for (int k = 0; k < 3; ++k) {
    const double weight = mus[k] / errors[k];
    line.row(k) << weight, weight * std::log(speeds[k] / 5.0);
    y[k] = weight * std::log(mus[k]);
  }
  const Eigen::Matrix2d covariance = (line.transpose() * line).inverse();
  const Eigen::Vector2d found = covariance * line.transpose() * y;
  const MuTable table = tableOf(conditions, runs);
  ASSERT_EQ(table.speed.ratio, std::vector<double>{0.5});
  EXPECT_NEAR(table.speed.exponent[0], found[1], 1e-12);
  const double scatter = std::sqrt(std::max(1.0, (y - line * found).squaredNorm()));
  EXPECT_NEAR(table.speed.exponentSe[0], scatter * std::sqrt(covariance(1, 1)), 1e-12);
}

TEST(SofteningMaterial, KnowsTheTemperatureOfARun)
{
  const SofteningMaterial material = readPotentialFile(PROJECT_SOURCE "/potentials/rail_steel.mca");
  EXPECT_EQ(material.temperature.front(), 293.0);
  EXPECT_EQ(material.strength.front(), 900e6);
  EXPECT_EQ(material.density, 7800.0);
  EXPECT_EQ(material.temperatureOf(900e6, 206e9), 293.0);
  EXPECT_NEAR(material.temperatureOf(338.4e6, 63.86e9), 873.0, 1e-9);
  EXPECT_NEAR(material.temperatureOf(640.8e6, 133.9e9), 723.0, 1e-9);
  EXPECT_NEAR(material.temperatureOf(900e6, 195.7e9), 423.0, 1e-9);
  EXPECT_TRUE(std::isnan(material.temperatureOf(500e6, 206e9)));
  EXPECT_TRUE(std::isnan(material.temperatureOf(92e6, 206e9)));
}

TEST(SofteningMaterial, FaultsOfItsFileAreNamed)
{
  const auto messageOfFile = [](const std::string &text) -> std::string {
    const std::string path = testing::TempDir() + "faulty.mca";
    std::ofstream(path) << text;
    try {
      readPotentialFile(path);
    } catch (const Error &error) {
      return error.what();
    }
    return "";
  };
  const std::string good = "# UNITS: si\nstrength 3e8\nyoungs_modulus 70e9\ndensity 2700\nnu 0.3\n";
  EXPECT_EQ(messageOfFile(good), "");
  EXPECT_THAT(messageOfFile("strength 3e8\n"), HasSubstr("faulty.mca:1: UNITS:"));
  EXPECT_THAT(messageOfFile("# UNITS: lj\n"), HasSubstr("nano, si, micro or cgs"));
  EXPECT_THAT(messageOfFile(good + "strength 1\n"), HasSubstr(":6: strength: appears twice"));
  EXPECT_THAT(messageOfFile("# UNITS: si\nstrength -1\n"), HasSubstr("'-1' is not allowed"));
  EXPECT_THAT(messageOfFile("# UNITS: si\nstrength 1e301\n"), HasSubstr("'1e301' is not allowed"));
  EXPECT_THAT(messageOfFile("# UNITS: si\nstrength 1\n"), HasSubstr("is missing"));
  EXPECT_THAT(messageOfFile(good + "temperature 300 200\n"), HasSubstr("temperature: must rise"));
  EXPECT_THAT(messageOfFile("# UNITS: si\ntemperature 300 400 500\nstrength 1 2\n"),
              HasSubstr("2 values, must be 1 or 3"));
}

TEST(MaterialLaw, ItsFileIsReadBackToTheLastBit)
{
  MaterialLaw form;
  form.material = steel();
  form.parameters = someParameters();
  form.kappa3 = 229.0;
  form.covariance = MaterialLaw::Covariance(1e-4 * MaterialLaw::Covariance::Identity());
  form.pressureRange = {0.03, 2.6};
  form.temperatureRange = {293.0, 873.0};
  form.speedRange = {0.5, 5.0};
  form.n = 36;
  form.rmsRelative = 0.07;
  form.fittedOn = {{"strength", {79.2, 900.0}}};
  form.source = "test";
  MaterialLaw table = form;
  table.covariance.reset();
  table.table = someTable();
  table.parameters.setZero();
  for (const MaterialLaw &law : {form, table}) {
    const std::string path = written(law, "law.json");
    EXPECT_TRUE(isMaterialLaw(path));
    const MaterialLaw read = readMaterialLaw(path);
    EXPECT_EQ(toJson(read).dump(), toJson(law).dump());
    EXPECT_EQ(read(100e6, 2.0, 500.0), law(100e6, 2.0, 500.0));
  }
  EXPECT_FALSE(isMaterialLaw(PROJECT_SOURCE "/CITATION.cff"));
  EXPECT_FALSE(isMaterialLaw(testing::TempDir() + "no such file"));
}

TEST(MaterialLaw, OnePowerOfTheSpeedHoldsAtAllPressures)
{
  MaterialLaw law;
  law.material = steel();
  law.table = someTable();
  law.speedRange = {0.5, 5.0};
  for (const double power : {0.1, 0.0}) {
    nlohmann::ordered_json json = toJson(law);
    json.erase("speed_pressure");
    json["speed_exponent"] = power;
    json["speed_exponent_se"] = 0.02;
    const std::string path = testing::TempDir() + "one_power.json";
    std::ofstream(path) << json.dump(2) << "\n";
    const MaterialLaw read = readMaterialLaw(path);
    EXPECT_EQ(read.dependsOnSpeed(), power != 0.0);
    for (const double pressure : {30e6, 630e6, 5e9})
      EXPECT_NEAR(read(pressure, 1.0, 293.0) / read(pressure, 5.0, 293.0), std::pow(0.2, power),
                  1e-13);
  }
}

TEST(MaterialLaw, FaultsOfItsFileAreNamed)
{
  MaterialLaw law;
  law.material = steel();
  law.table = someTable();
  law.speedRange = {0.5, 5.0};
  const auto messageWith = [&](const std::string &key, const nlohmann::json &value) {
    nlohmann::ordered_json json = toJson(law);
    if (value.is_null())
      json.erase(key);
    else
      json[key] = value;
    const std::string path = testing::TempDir() + "faulty.json";
    std::ofstream(path) << json.dump(2);
    return messageOf(path);
  };
  EXPECT_EQ(messageWith("source", "x"), "");
  EXPECT_THAT(messageWith("kappa3", 200.0), HasSubstr("kappa3: does not go with a table"));
  EXPECT_THAT(messageWith("mu0", 0.4), HasSubstr("mu0: does not go with a table"));
  EXPECT_THAT(messageWith("density", nullptr), HasSubstr("density: is missing"));
  EXPECT_THAT(messageWith("temperature", {293, 293, 873}), HasSubstr("must be > 0 and rise"));
  EXPECT_THAT(messageWith("strength", {900, 720}), HasSubstr("2 numbers, must be 3"));
  EXPECT_THAT(messageWith("strength", {900, 0, 1}), HasSubstr("0 is not allowed, must be > 0"));
  EXPECT_THAT(messageWith("table_mu", {{0.5}, {0.4}}), HasSubstr("2 lists, must be 3"));
  EXPECT_THAT(messageWith("table_mu", {{0.5}, {0.4}, {0.3}}), HasSubstr("1 numbers at 293 K"));
  EXPECT_THAT(messageWith("table_pressure", {{2, 1, 3}, {1}, {1}}), HasSubstr("rise"));
  EXPECT_THAT(messageWith("reference_velocity", nullptr), HasSubstr("is missing"));
  EXPECT_THAT(messageWith("velocity_range", nullptr), HasSubstr("speed_exponent"));
  EXPECT_THAT(messageWith("speed_exponent", {0.1, 0.2}), HasSubstr("2 numbers, must be 3"));
  EXPECT_THAT(messageWith("speed_exponent_se", {0.1, -0.2, 0.1}),
              HasSubstr("-0.2 is not allowed, must be >= 0"));
  EXPECT_THAT(messageWith("speed_pressure", {1, 1, 2}), HasSubstr("rise"));
  EXPECT_THAT(messageWith("speed_pressure", nullptr), HasSubstr("speed_exponent"));
  law.table.reset();
  law.parameters[Mu0] = 0.4;
  EXPECT_EQ(messageWith("source", "x"), "");
  EXPECT_THAT(messageWith("mu0", nullptr), HasSubstr("mu0: is missing"));
  EXPECT_THAT(messageWith("s", 0.5), HasSubstr("s: needs q"));
  EXPECT_THAT(messageWith("covariance", {1, 2}), HasSubstr("10 x 10 matrix"));
  EXPECT_THAT(messageWith("table_mu", {1, 2}), HasSubstr("table_mu: goes with a table only"));
}

TEST(LawOfMaterial, SeesPressureAndTemperatureOfEachCell)
{
  MaterialLaw law;
  law.material = steel();
  law.parameters[Mu0] = 0.45, law.parameters[S] = 0.5, law.parameters[Q] = 4.0;
  law.pressureRange = {0.1, 2.6};
  law.temperatureRange = {293.0, 873.0};
  law.speedRange = {0.5, 5.0};
  const std::string path = written(law, "steel.json");
  const LawForm &form = lawFormOf({"steel.json", path});
  EXPECT_STREQ(form.word, "law of a material");
  const LawChoice choice = form.choose({{"steel.json", path}, {{"friction.ambient", 293.0}}});
  EXPECT_TRUE(choice.hasStrength);
  ASSERT_EQ(choice.files.size(), 1u);
  const LawPointer read = choice.read();
  Eigen::VectorXd pressure(4), rise(4);
  pressure << 0.0, 90e6, 900e6, 900e6;
  rise << 0.0, 0.0, 0.0, 580.0;
  const Eigen::VectorXd mu = read->mu({pressure, 1.0, rise});
  EXPECT_DOUBLE_EQ(mu[0], 0.45);
  for (int i = 1; i < 4; ++i) {
    const double ratio = pressure[i] / (rise[i] > 0.0 ? 338.4e6 : 900e6);
    EXPECT_NEAR(mu[i], std::pow(std::pow(0.45, -4) + std::pow(0.5 / ratio, -4), -0.25), 1e-14);
    EXPECT_NEAR(mu[i], law(pressure[i], 1.0, 293.0 + rise[i]), 1e-14);
  }
  const Eigen::VectorXd none;
  EXPECT_EQ(read->mu({none, 1.0, none}).size(), 0);
  EXPECT_TRUE(read->dependsOnTemperature());
  EXPECT_FALSE(read->dependsOnSpeed());
  ASSERT_NE(read->strength(), nullptr);
  EXPECT_DOUBLE_EQ(read->strength()->hardnessAt(580.0), 3.0 * 338.4e6);
  EXPECT_FALSE(read->strength()->vanishesAt(5000.0));
  const LawUse use = read->use({pressure, 0.01, rise});
  EXPECT_THAT(read->warning(use), HasSubstr("sliding speed in m/s 0.01 (0.5 to 5)"));
  EXPECT_THAT(read->warning(use), testing::Not(HasSubstr("p/sigma_0")));
  // warmer bodies
  const LawPointer warm = form.choose({{"", path}, {{"friction.ambient", 873.0}}}).read();
  EXPECT_DOUBLE_EQ(warm->mu({pressure, 1.0, Eigen::VectorXd::Zero(4)})[2], mu[3]);
}

// A draw from the covariance has to be a law that could have been fitted: no rounder than q = 1.
TEST(LawOfMaterial, IsNoRounderThanAFittedOne)
{
  MaterialLaw law;
  law.material = steel();
  law.parameters[Mu0] = 0.45, law.parameters[S] = 0.5, law.parameters[Q] = 1.2;
  const LawOfMaterial own("round", law, 293.0);
  LawParameters change = LawParameters::Zero();
  change[Q] = -0.2;
  EXPECT_TRUE(own.changed(change)->isSound());
  change[Q] = -0.21;
  EXPECT_FALSE(own.changed(change)->isSound());
  law.parameters[S] = law.parameters[Q] = 0.0; // without a bound
  EXPECT_TRUE(LawOfMaterial("free", law, 293.0).isSound());
}

TEST(LawOfMaterial, BandsComeFromTheErrorsOfItsTable)
{
  MaterialLaw law;
  law.material = steel();
  law.table = someTable();
  law.speedRange = {0.5, 5.0};
  const LawOfMaterial own("table", law, 293.0);
  const Eigen::VectorXd errors = own.standardErrors();
  ASSERT_EQ(errors.size(), 13);
  EXPECT_DOUBLE_EQ(errors[1], 0.02);
  EXPECT_DOUBLE_EQ(errors[11], 0.02);
  Eigen::VectorXd pressure = Eigen::VectorXd::Constant(1, 630e6), cold = Eigen::VectorXd::Zero(1);
  Eigen::VectorXd change = Eigen::VectorXd::Zero(13);
  change[1] = 0.05;
  EXPECT_NEAR(own.changed(change)->mu({pressure, 5.0, cold})[0], 0.47, 1e-12);
  change[1] = -0.5;
  EXPECT_FALSE(own.changed(change)->isSound());
  EXPECT_TRUE(own.isSound());
  EXPECT_TRUE(own.dependsOnSpeed());
}

// Steady rolling beyond the hardness: each cell stops at that of its own temperature, hot ones far
// below cold ones; and material that rolls through the contact comes to the same.
TEST(LawOfMaterial, HotCellsOfAPointContactAreSofter)
{
  MaterialLaw law;
  law.material = steel();
  for (double &strength : law.material.strength)
    strength *= 0.4;
  law.parameters[Mu0] = 0.36, law.parameters[S] = 0.46, law.parameters[Q] = 6.0;
  const LawOfMaterial own("steel", law, 293.0);
  PatchContactSpecification wheel;
  wheel.load = {1e5};
  wheel.curvatures = GapCurvatures{4.0, 3.2};
  wheel.bodies = {ElasticBody{210e9, 0.3}, ElasticBody{210e9, 0.3}};
  wheel.domain = 4.2;
  wheel.nx = wheel.ny = 40;
  CreepPhysics physics;
  physics.thermal = {ThermalModel::Local, {50.0, 7800.0, 450.0}, 0.0};
  physics.hardnessLimit = true;
  const double load = 1e5, speed = 20.0;
  const PatchContact contact =
      preparePatch(wheel, {}, load, 0, physics.pressureLimit(own, 0.0), 0.0);
  PatchDrive drive;
  drive.creepage.xi = 0.1;
  FrozenPatch rolling(physics, contact, 0.5);
  const PatchPoint point = rolling.solve(own, speed, drive);
  const PatchFields &fields = rolling.fields();
  double hottest = 0.0, coldest = 1e4; // of the cells that flow
  for (int i = 0; i < fields.pressure.size(); ++i) {
    const double hardness = own.strength()->hardnessAt(fields.temperature[i]);
    EXPECT_LE(fields.pressure[i], hardness * (1.0 + 1e-6));
    if (fields.pressure[i] >= hardness * (1.0 - 1e-6)) {
      hottest = std::max(hottest, fields.temperature[i]);
      coldest = std::min(coldest, fields.temperature[i]);
    }
  }
  EXPECT_GT(hottest, coldest + 100.0);
  EXPECT_NEAR(fields.pressure.sum() * contact.grid.cellArea(), load, 1e-6 * load);

  MovingPatchSpecification moving;
  moving.passes = 3;
  const PatchSequence none;
  MovingPatch material(physics, moving, none, own, contact, 0.5);
  material.solve(speed, drive, [] { return true; });
  EXPECT_NEAR(material.series().back().forceX / point.forceX, 1.0, 0.03);
  EXPECT_NEAR(material.series().back().peakPressure / point.peakPressure, 1.0, 0.01);
}

namespace {

/// Conditions of plan rail with a law that is known; mu scatters by a share of itself.
/// \param slower speeds (m/s) at which 0.7 of the strength slides, too
std::vector<ConditionMean> railConditions(const LawParameters &truth, double reference,
                                          double scatter, std::mt19937_64 &generator,
                                          const std::vector<double> &slower = {})
{
  std::normal_distribution<double> normal;
  std::vector<ConditionMean> means;
  const SofteningMaterial material = readPotentialFile(PROJECT_SOURCE "/potentials/rail_steel.mca");
  for (const double kelvin : {293.0, 473.0, 673.0, 773.0, 873.0, 1073.0}) {
    MaterialLaw law;
    law.material = material;
    const auto add = [&](double ratio, double speed) {
      const Kappas k = law.kappas(ratio * material.strengthAt(kelvin), speed, kelvin);
      const double mu =
          boundedMu(truth, k, k.kappa3 / reference) * (1.0 + scatter * normal(generator));
      means.push_back({k.kappa1, k.kappa2, mu, 0.0, k.kappa3});
    };
    for (const double ratio : {0.03, 0.1, 0.3, 0.7, 1.3, 2.6})
      add(ratio, 5.0);
    for (const double speed : slower)
      add(0.7, speed);
  }
  return means;
}

} // namespace

TEST(BoundedFit, ExactConditionsGiveTheLawBack)
{
  std::mt19937_64 generator(3);
  LawParameters truth = LawParameters::Zero();
  truth[Mu0] = 0.45, truth[S] = 0.52, truth[Q] = 3.2;
  const auto fit = fitLaw(LawModel::Bounded, railConditions(truth, 1.0, 0.0, generator));
  for (const int k : {Mu0, S, Q})
    EXPECT_NEAR(fit.parameters[k] / truth[k], 1.0, 1e-6) << parameterNames[k];
  EXPECT_EQ(fit.freedom, 33);
  EXPECT_EQ(fit.notIdentifiable, "");
  truth[N] = 0.15;
  const auto power =
      fitLaw(LawModel::BoundedKappa3, railConditions(truth, 229.0, 0.0, generator), 0.95, 229.0);
  for (const int k : {Mu0, N, S, Q})
    EXPECT_NEAR(power.parameters[k] / truth[k], 1.0, 1e-6) << parameterNames[k];
  truth[N] = 0.0, truth[Mu0] = 0.2, truth[Mu2] = 0.3, truth[C] = 0.02;
  const auto eq4 = fitLaw(LawModel::BoundedPressure, railConditions(truth, 1.0, 0.0, generator));
  for (const int k : {Mu0, Mu2, C, S, Q})
    EXPECT_NEAR(eq4.parameters[k] / truth[k], 1.0, 1e-4) << parameterNames[k];
}

TEST(BoundedFit, ALimitThatRisesWithTheSpeedIsToldFromOneThatDoesNot)
{
  std::mt19937_64 generator(7);
  LawParameters truth = LawParameters::Zero();
  truth[Mu0] = 0.45, truth[S] = 0.3, truth[Q] = 1.5, truth[S1] = 8.0, truth[D] = 15.0;
  const auto exact =
      fitLaw(LawModel::BoundedRate, railConditions(truth, 1.0, 0.0, generator, {0.5, 2.0}));
  for (const int k : {Mu0, S, Q, S1, D})
    EXPECT_NEAR(exact.parameters[k] / truth[k], 1.0, 1e-5) << parameterNames[k];
  EXPECT_EQ(exact.notIdentifiable, "");

  auto means = railConditions(truth, 1.0, 0.05, generator, {0.5, 2.0});
  EXPECT_LT(fitLaw(LawModel::BoundedRate, means, 0.0).aicc,
            fitLaw(LawModel::Bounded, means, 0.0).aicc - 10.0);
  truth[S1] = 0.0, truth[S] = 0.5;
  means = railConditions(truth, 1.0, 0.05, generator, {0.5, 2.0});
  EXPECT_GT(fitLaw(LawModel::BoundedRate, means, 0.0).aicc,
            fitLaw(LawModel::Bounded, means, 0.0).aicc);
}

TEST(BoundedFitLong, ErrorsAreThoseThatRepeatedPlansScatterBy)
{
  std::mt19937_64 generator(17);
  LawParameters truth = LawParameters::Zero();
  truth[Mu0] = 0.45, truth[S] = 0.52, truth[Q] = 3.2;
  constexpr int plans = 40;
  double error = 0.0, spread = 0.0;
  int covered = 0, preferred = 0;
  for (int i = 0; i < plans; ++i) {
    const auto means = railConditions(truth, 1.0, 0.06, generator);
    const auto fit = fitLaw(LawModel::Bounded, means);
    error += std::sqrt(fit.covariance(S, S)) / plans;
    spread += std::pow(fit.parameters[S] - truth[S], 2) / plans;
    covered += fit.intervals[S].lower <= truth[S] && truth[S] <= fit.intervals[S].upper;
    preferred += fit.aicc < fitLaw(LawModel::Pressure, means, 0.0).aicc;
  }
  EXPECT_NEAR(error / std::sqrt(spread), 1.0, 0.3);
  EXPECT_GE(covered, 34);
  EXPECT_EQ(preferred, plans); // the paper's form does not know the limit
}

TEST(BoundedFit, ALimitThatNoConditionFeelsIsNamed)
{
  std::mt19937_64 generator(5);
  LawParameters truth = LawParameters::Zero();
  truth[Mu0] = 0.45;
  auto means = railConditions(truth, 1.0, 0.02, generator);
  means.erase(std::remove_if(means.begin(), means.end(),
                             [](const ConditionMean &m) { return m.kappa2 > 0.4 * m.kappa3; }),
              means.end());
  ASSERT_EQ(means.size(), 18u);
  EXPECT_EQ(
      obstacleTo(LawModel::Bounded, {means[0], means[0], means[0], means[0], means[0]}).tooFew,
      false);
  EXPECT_THAT(
      obstacleTo(LawModel::Bounded, {means[0], means[0], means[0], means[0], means[0]}).reason,
      HasSubstr("p/sigma_0"));
  const auto fit = fitLaw(LawModel::Bounded, means);
  EXPECT_NE(fit.notIdentifiable, "");
}
