// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/program_files.h"
#include "creep/patch/measured_fit.h"
#include "law/forms/constant.h"
#include "law/forms/polach.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace wheelrail;

namespace {

constexpr double load = 1e5;
bool always()
{
  return true;
}

PatchContact steelWheel()
{
  PatchContactSpecification contact;
  contact.load = {load};
  contact.curvatures = GapCurvatures{1.0, 1.0};
  contact.bodies = {ElasticBody{210e9, 0.3}, ElasticBody{210e9, 0.3}};
  contact.domain = 2.2;
  contact.nx = contact.ny = 24;
  return preparePatch(contact, {}, load, 0, INFINITY, 0.0);
}

PolachContact ellipseOf(const PatchContact &contact)
{
  return {contact.pair.G / 1e6, contact.hertz.a * 1e3, contact.hertz.b * 1e3, load,
          ellipseKalkerCoefficients(contact.hertz.a / contact.hertz.b, contact.pair.nu)};
}

CreepPhysics cold()
{
  CreepPhysics physics;
  physics.thermal.model = ThermalModel::Off;
  return physics;
}

const std::vector<double> creeps = {2e-4, 5e-4, 1e-3, 2e-3, 4e-3, 1e-2, 3e-2, 0.1, 0.2};

/// Scatter of a curve, of no kind in particular but the same each time.
double scatter(std::size_t k, double size)
{
  return size * std::sin(3.7 * double((k + 1) * (k + 1)));
}
constexpr double noise = 2e-3, rounding = 1e-6;

const MeasuredParameter &named(const MeasuredModel &model, const std::string &name)
{
  for (const MeasuredParameter &p : model.parameters)
    if (p.name == name)
      return p;
  throw std::out_of_range(name);
}

/// The interval is of the right size: it reaches to the value that is known, or nearly so, as 95 %
/// of intervals do, and no further than a fifth of it.
void expectHolds(const MeasuredModel &model, const std::string &name, double value)
{
  const MeasuredParameter &p = named(model, name);
  EXPECT_LT(p.value - 1.5 * (p.value - p.low), value) << name;
  EXPECT_GT(p.value + 1.5 * (p.high - p.value), value) << name;
  EXPECT_LT(p.high - p.low, 0.4 * value) << name;
}
void expectExactly(const MeasuredModel &model, const std::string &name, double value, double share)
{
  EXPECT_NEAR(named(model, name).value, value, share * value) << name;
}

std::vector<MeasuredTraction> readText(const std::string &text,
                                       std::optional<double> speed = std::nullopt)
{
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("wr-curve-{}.csv", ::getpid()))
          .string();
  writeOutputFile(path, text);
  try {
    std::vector<MeasuredTraction> curve = readMeasuredCurve(path, speed);
    std::filesystem::remove(path);
    return curve;
  } catch (...) {
    std::filesystem::remove(path);
    throw;
  }
}

std::string refusal(const std::string &text)
{
  try {
    readText(text);
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    return error.what();
  }
  return "";
}

} // namespace

TEST(MeasuredFit, ReadsACurve)
{
  const auto curve =
      readText("# Eurosprinter\n# speed: km/h\n# creep: %\ntraction_ratio;creep;speed\n"
               "0,1;0,2;36\n0,3;1;72\n");
  ASSERT_EQ(curve.size(), 2U);
  EXPECT_DOUBLE_EQ(curve[0].creep, 2e-3);
  EXPECT_DOUBLE_EQ(curve[0].speed, 10.0);
  EXPECT_DOUBLE_EQ(curve[1].tractionRatio, 0.3);
  const std::string head = "# speed: m/s\n";
  const std::string names = "creep,speed,traction_ratio\n";
  EXPECT_NE(refusal(names + "0.1,10,0.2\n").find("# speed: UNIT"), std::string::npos);
  EXPECT_NE(refusal(head + "creep,speed,force\n").find("force"), std::string::npos);
  EXPECT_NE(refusal(head + names + "0.1,10,-0.2\n").find("traction_ratio"), std::string::npos);
  EXPECT_NE(refusal(head + names + "0.1,10\n").find("2 cells"), std::string::npos);
  EXPECT_NE(refusal(head + names).find("no row"), std::string::npos);
  EXPECT_NE(refusal("# speed: K\n" + names).find("speed"), std::string::npos);
  EXPECT_NE(refusal("# creep: mm\n" + head + names).find("creep"), std::string::npos);
}

TEST(MeasuredFit, ReadsACurveOfOneSpeedInPercent)
{
  const std::string text = "creep_percent,traction_ratio\n0.2,0.1\n1,0.3\n";
  const auto curve = readText(text, 12.0);
  ASSERT_EQ(curve.size(), 2U);
  EXPECT_DOUBLE_EQ(curve[0].creep, 2e-3);
  EXPECT_DOUBLE_EQ(curve[1].creep, 1e-2);
  EXPECT_EQ(curve[1].speed, 12.0);
  EXPECT_EQ(curve[1].tractionRatio, 0.3);
  EXPECT_NE(refusal(text).find("the column 'speed' is needed"), std::string::npos);
  EXPECT_NE(refusal("# creep: 1\n" + text).find("given once"), std::string::npos);
  EXPECT_NE(refusal("creep_percent,creep,traction_ratio\n").find("'creep' is needed, once"),
            std::string::npos);
  EXPECT_NE(refusal("# speed: m/s\nspeed_percent,creep,traction_ratio\n").find("speed_percent"),
            std::string::npos);
  // a column of speed is read, whatever the case has
  EXPECT_EQ(readText("# speed: km/h\ncreep,speed,traction_ratio\n0.1,36,0.2\n", 12.0)[0].speed,
            10.0);
}

// Curves of Polach's form at three speeds, with known parameters and some scatter. (Nine values at
// one speed with that scatter are described as well by other kA and kS.)
TEST(MeasuredFit, FindsPolachsParameters)
{
  const PatchContact contact = steelWheel();
  const PolachContact ellipse = ellipseOf(contact);
  const PolachParameters known{0.38, 0.45, 0.5, 0.7, 0.5};
  const auto curveWith = [&](double size) {
    std::vector<MeasuredTraction> curve;
    for (const double speed : {5.0, 15.0, 40.0})
      for (const double creep : creeps) {
        const PolachState state{creep, 0.0, 0.0, speed, load};
        const double ratio = -polachForce(known, ellipse, state).x / load;
        curve.push_back({creep, speed, ratio + scatter(curve.size(), size)});
      }
    return curve;
  };
  const std::vector<MeasuredTraction> curve = curveWith(noise);
  const MeasuredFit fit =
      fitMeasured(curve, cold(), contact, 0.5, ConstantLaw(0.3), ellipse, always);
  const MeasuredFit clean =
      fitMeasured(curveWith(rounding), cold(), contact, 0.5, ConstantLaw(0.3), ellipse, always);
  for (const auto &[name, value] : {std::pair{"mu0", known.mu0},
                                    {"A", known.A},
                                    {"B", known.B},
                                    {"kA", known.kA},
                                    {"kS", known.kS}}) {
    expectHolds(fit.polach, name, value);
    expectExactly(clean.polach, name, value, 1e-3);
  }
  EXPECT_LT(fit.polach.rms, 4e-3);
  EXPECT_GT(fit.predictedRms, 5.0 * fit.polach.rms); // nothing of it was fitted
  EXPECT_EQ(fit.predicted.size(), curve.size());
}

// A curve of the contact itself, with a layer.
TEST(MeasuredFit, FindsTheLayer)
{
  PatchContact contact = steelWheel();
  const PolachContact ellipse = ellipseOf(contact);
  PatchContact layered = contact;
  const double unit = 8.0 * contact.hertz.a / (3.0 * contact.pair.G * ellipse.kalker.c11);
  layered.pair.layer = 1.5 * unit;
  const CreepPhysics physics = cold();
  const auto curveWith = [&](double size) {
    FrozenPatch rolling(physics, layered, 0.5);
    std::vector<MeasuredTraction> curve;
    for (std::size_t k = 0; k < creeps.size(); ++k) {
      PatchDrive drive;
      drive.creepage.xi = creeps[k];
      const PolachLaw law(FallingFriction{0.35, 0.5, 0.4});
      curve.push_back(
          {creeps[k], 15.0, rolling.solve(law, 15.0, drive).tractionRatio() + scatter(k, size)});
    }
    return curve;
  };
  const std::vector<MeasuredTraction> curve = curveWith(noise);
  const MeasuredFit fit =
      fitMeasured(curve, physics, contact, 0.5, ConstantLaw(0.3), ellipse, always);
  const MeasuredFit clean =
      fitMeasured(curveWith(rounding), physics, contact, 0.5, ConstantLaw(0.3), ellipse, always);
  expectHolds(fit.layer, "mu0", 0.35);
  expectHolds(fit.layer, "compliance", layered.pair.layer);
  expectExactly(clean.layer, "mu0", 0.35, 2e-3); // what the interpolation leaves
  expectExactly(clean.layer, "compliance", layered.pair.layer, 0.01);
  EXPECT_NEAR(clean.slopeShare, 0.4, 2e-3);
  EXPECT_LT(fit.layer.rms, 4e-3);
  const std::string json = measuredJson(fit, "curve.csv");
  EXPECT_NE(json.find("\"compliance\""), std::string::npos);
  EXPECT_EQ(measuredCsv(fit, curve).find("nan"), std::string::npos);
}

// Without values in the rising part nothing is said of the slope.
TEST(MeasuredFit, SaysWhereACurveSaysNothing)
{
  const PatchContact contact = steelWheel();
  std::vector<MeasuredTraction> curve;
  for (const double creep : {0.05, 0.1, 0.15})
    curve.push_back({creep, 10.0, 0.3});
  EXPECT_THROW(
      fitMeasured(curve, cold(), contact, 0.5, ConstantLaw(0.3), ellipseOf(contact), always),
      Error);
}
