// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "case_text.h"
#include "contact_cases.h"
#include "creep/line/creep_curve.h"
#include "creep/patch/patch_curve.h"
#include "law/forms/eq2.h"

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <unistd.h>

using namespace wheelrail;

namespace {

using case_text::table2;

const std::string rough = "roughness: {hurst: 0.8, rms_slope: 0.02, wavelength_min: 0.1 mm, "
                          "wavelength_max: 10 mm, seed: [1, 2]}\n";

CreepCurves solve(const std::string &text, const SweepOptions &options = {})
{
  const CreepSpecification asked = case_text::rolling(table2 + text);
  return solveCreepCurves(asked, asked.friction.read(), options);
}

/// The paper's law with a covariance, for the steel of table 2.
LawPointer steelLaw(const std::optional<LawCovariance> &covariance, bool local = false)
{
  KappaLaw law = bucher2006();
  law.covariance = covariance;
  return std::make_shared<Eq2Law>(law.source, law,
                                  Eq2Scale{local, true, {1e9, 1250.0}, 206e9, 7800.0});
}

/// A law that counts how often it, and those near it, are asked for mu.
class CountedLaw final : public FrictionLaw {
 public:
  CountedLaw(LawPointer law, std::atomic<int> &count) : law_(std::move(law)), count_(count) {}
  Eigen::VectorXd mu(const FrictionState &state) const override
  {
    ++count_;
    return law_->mu(state);
  }
  bool dependsOnSpeed() const override { return law_->dependsOnSpeed(); }
  bool dependsOnTemperature() const override { return law_->dependsOnTemperature(); }
  nlohmann::ordered_json json() const override { return law_->json(); }
  Eigen::VectorXd standardErrors() const override { return law_->standardErrors(); }
  LawPointer changed(const Eigen::VectorXd &change) const override
  {
    return std::make_shared<CountedLaw>(law_->changed(change), count_);
  }
  double variance(const Eigen::VectorXd &derivative) const override
  {
    return law_->variance(derivative);
  }
  bool isDefined() const override { return law_->isDefined(); }

 private:
  LawPointer law_;
  std::atomic<int> &count_;
};

void expectSame(const CreepCurves &a, const CreepCurves &b)
{
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    EXPECT_EQ(a.points[k].tractionRatio, b.points[k].tractionRatio);
    EXPECT_EQ(a.points[k].temperatureRise, b.points[k].temperatureRise);
    EXPECT_EQ(a.points[k].band.low, b.points[k].band.low);
    EXPECT_EQ(a.points[k].profile, b.points[k].profile);
  }
}

} // namespace

// Eqs. 9 to 11 on the smooth contact: fixed points. The traction below full sliding is numerical
// (5e-6 at this grid); Carter's closed form with the converged mu has to give the table's.
TEST(CreepCurve, FeedbackTable)
{
  const CreepCurves curves =
      solve("creep: [0.0005, 0.001, 0.002, 0.003, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2]\n"
            "speed: [10 m/s, 20 m/s, 40 m/s]\n");
  const HertzContact contact = hertzContact(4e6, 0.5, 210e9 / (2.0 * (1.0 - 0.3 * 0.3)));
  std::ifstream file(TEST_DATA "/feedback.csv");
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  int found = 0;
  while (std::getline(file, line)) {
    double creep, speed, mu, rise, ratio;
    // NOLINTNEXTLINE(cert-err34-c): a table of our own
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &creep, &speed, &mu, &rise, &ratio),
              5);
    for (const CurvePoint &point : curves.points) {
      if (point.creep != creep || point.speed != speed)
        continue;
      ++found;
      EXPECT_NEAR(point.muMean, mu, 1e-8);
      EXPECT_NEAR(point.temperatureRise, rise, 1e-4); // the table's digits
      EXPECT_NEAR(contact_cases::carter(contact, point.muMean, creep), ratio, 2e-8);
      EXPECT_NEAR(point.tractionRatio, ratio, 5e-6);
      EXPECT_LE(point.iterations, 12);
    }
  }
  EXPECT_EQ(found, 30);
}

TEST(CreepCurve, LocalLawOnTheSmoothContact)
{
  const double table[] = {0.02103986, 0.10003875, 0.18668879, 0.31844681, 0.39509222, 0.42028597};
  const CreepCurves curves =
      solve("friction: {local: true, velocity_term: false}\nthermal: off\n"
            "creep: [1e-4, 5e-4, 1e-3, 2e-3, 3e-3, 4e-3, 1e-2]\nspeed: 10 m/s\n");
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(curves.points[k].tractionRatio, table[k], 2e-6);
  EXPECT_NEAR(curves.points[6].tractionRatio, 0.4203656918, 1e-6);
}

TEST(CreepCurve, PowerBelowFullSlidingIsThatOfTheTraction)
{
  const std::string common = "friction: {law: constant, mu: 0.3}\nspeed: 20 m/s\ncreep: [1e-3]\n";
  const CurvePoint paper = solve(common).points[0];
  const CurvePoint power = solve(common + "thermal: {model: averaged_power}\n").points[0];
  EXPECT_NEAR(power.temperatureRise / paper.temperatureRise, power.tractionRatio / 0.3, 1e-9);
}

TEST(CreepCurve, FlashTemperatureInFullSlidingHasEq11sMean)
{
  // 1 - eps/7 from elastic slip, eps = mu a/(R creep) (contact.domain keeps the grid fine)
  const std::string common = "friction: {law: constant, mu: 0.3}\nspeed: 20 m/s\ncreep: [0.05]\n"
                             "cells: 4096\n";
  const CurvePoint mean = solve(common).points[0];
  const CurvePoint local = solve(common + "thermal: {model: local}\n").points[0];
  const double elastic = 1.0 - 0.3 * 4.697817e-3 / (0.5 * 0.05) / 7.0;
  EXPECT_NEAR(local.temperatureRise / mean.temperatureRise, elastic, 1e-3);
  EXPECT_NEAR(local.temperatureMaximum / mean.temperatureMaximum, 1.0, 0.02);
}

TEST(CreepCurve, SameForAnyNumberOfThreads)
{
  const std::string text = rough + "creep: {from: 1e-4, to: 0.1, n: 20}\nspeed: [10 m/s, 40 m/s]\n"
                                   "friction: {local: true}\nthermal: {model: local}\n";
  SweepOptions one, three;
  one.threads = 1;
  three.threads = 3;
  expectSame(solve(text, one), solve(text, three));
}

TEST(CreepCurve, ResumesToTheSameResult)
{
  const std::string text = rough + "creep: {from: 1e-4, to: 0.1, n: 40}\nspeed: 20 m/s\n";
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("wr-journal-{}", ::getpid())).string();
  Journal journal(path, text, [](const std::string &line) { ADD_FAILURE() << line; });
  std::atomic<bool> stop{false};
  SweepOptions options;
  options.journal = &journal;
  options.threads = 1;
  options.interrupted = [&] { return stop.load(); };
  options.progress = [&](int done, int) { stop = done >= 16; };
  try {
    solve(text, options);
    FAIL() << "was not interrupted";
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::Interrupted);
  }
  EXPECT_TRUE(std::filesystem::exists(path));
  stop = false;
  options.progress = nullptr;
  const CreepCurves resumed = solve(text, options);
  EXPECT_GE(resumed.resumed, 16);
  EXPECT_TRUE(std::filesystem::exists(path)); // the results are not in place yet
  expectSame(resumed, solve(text));
  expectSame(solve(text, options), resumed);
  journal.remove();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(CreepCurve, LawsCovarianceBecomesABand)
{
  // In full sliding with the averaged law T/N = mu0 + ..., so that its error is that of mu0
  const CreepSpecification input =
      case_text::rolling(table2 + "creep: [0.05]\nspeed: 20 m/s\nthermal: off\n");
  LawCovariance covariance = LawCovariance::Zero();
  covariance(0, 0) = 0.02 * 0.02;
  const CreepCurves curves = solveCreepCurves(input, steelLaw(covariance));
  EXPECT_TRUE(curves.hasBand);
  EXPECT_NEAR(curves.points[0].band.standardError, 0.02, 1e-6);
}

TEST(CreepCurve, LawsThatChangeNothingAreNotSolved)
{
  LawCovariance one = LawCovariance::Zero(); // of five parameters
  one(0, 0) = 0.02 * 0.02;
  const std::string few = "creep: [0.01, 0.05]\nspeed: 20 m/s\nthermal: off\n";
  const CreepSpecification frozen = case_text::rolling(table2 + few + "cells: 128\n");
  const CreepSpecification moving = case_text::rolling(table2 + few + "cells: 128\nmode: moving\n");
  const auto point = std::get<PatchSpecification>(
      case_text::read("contact: {load: 80 kN, curvatures: [1 1/m, 2 1/m],\n"
                      "          youngs_modulus: 210 GPa, poissons_ratio: 0.3}\n"
                      "cells: 16\nmode: moving\nmoving.passes: 2\n" +
                      few)
          .task);
  const auto asked = [&](const auto &solve, const std::optional<LawCovariance> &covariance) {
    std::atomic<int> count{0};
    solve(std::make_shared<CountedLaw>(steelLaw(covariance), count));
    return count.load();
  };
  const auto onLine = [&](const LawPointer &law) { solveCreepCurves(frozen, law); };
  const auto movingOnLine = [&](const LawPointer &law) { solveCreepCurves(moving, law); };
  const auto movingOnPoint = [&](const LawPointer &law) { solvePatchCurves(point, law); };
  EXPECT_EQ(asked(onLine, one), 3 * asked(onLine, std::nullopt));
  EXPECT_EQ(asked(movingOnLine, one), 3 * asked(movingOnLine, std::nullopt));
  EXPECT_EQ(asked(movingOnPoint, one), 3 * asked(movingOnPoint, std::nullopt));
}

TEST(CreepCurve, SampledBandIsTheLinearOneForASmallCovariance)
{
  const std::string text = rough + "creep: [1e-3, 0.03]\nspeed: 20 m/s\nfriction: {local: true}\n"
                                   "thermal: {model: local}\ncells: 1024\n";
  LawCovariance covariance = LawCovariance::Zero();
  covariance.diagonal() << 1e-5, 0.0, 2e-5, 0.0, 1e-9;
  covariance(0, 2) = covariance(2, 0) = -1e-5;
  const CreepSpecification linear = case_text::rolling(table2 + text);
  const CreepSpecification sampled =
      case_text::rolling(table2 + text + "uncertainty: {method: sampled}\n");
  const LawPointer local = steelLaw(covariance, true);
  const CreepCurves lines = solveCreepCurves(linear, local);
  SweepOptions one, three;
  one.threads = 1;
  three.threads = 3;
  const CreepCurves samples = solveCreepCurves(sampled, local, one);
  expectSame(samples, solveCreepCurves(sampled, local, three));
  for (std::size_t k = 0; k < lines.points.size(); ++k) {
    const Band &a = lines.points[k].band, &b = samples.points[k].band;
    EXPECT_NEAR(b.standardError / a.standardError, 1.0, 0.15); // 200 samples: +-5 %
    EXPECT_NEAR(b.low, a.low, 0.5 * a.standardError);
    EXPECT_NEAR(b.high, a.high, 0.5 * a.standardError);
    EXPECT_EQ(lines.points[k].tractionRatio, samples.points[k].tractionRatio);
  }
}

TEST(CreepCurve, HardnessFallsWithTemperature)
{
  const std::string common = "roughness: {hurst: 0.8, rms_slope: 0.04, wavelength_min: 0.1 mm, "
                             "wavelength_max: 10 mm}\nspeed: 20 m/s\ncreep: [1e-3, 0.2]\n";
  const CreepCurves elastic = solve(common);
  const std::string limited = "contact: {load_per_length: 4000 N/mm, radius: 0.5 m,\n"
                              "          youngs_modulus: 210 GPa, poissons_ratio: 0.3,\n"
                              "          hardness_limit: true}\n";
  const CreepSpecification input = case_text::rolling(limited + common);
  const CreepCurves curves = solveCreepCurves(input, input.friction.read());
  EXPECT_GT(elastic.fields.begin()->second.pressure.maxCoeff(), 3e9);
  const double rise = curves.points[1].temperatureRise;
  EXPECT_GT(rise, 100.0);
  EXPECT_NEAR(curves.fields.begin()->second.pressure.maxCoeff(), 3e9 * (1.0 - rise / 1250.0), 1e4);
}

// Hot cells are softer than cold ones of the same contact.
TEST(CreepCurve, HardnessFallsWithTheTemperatureOfEachCell)
{
  const std::string text = "contact: {load_per_length: 4000 N/mm, radius: 0.5 m,\n"
                           "          youngs_modulus: 210 GPa, poissons_ratio: 0.3,\n"
                           "          hardness_limit: true}\n"
                           "roughness: {hurst: 0.8, rms_slope: 0.04, wavelength_min: 0.2 mm, "
                           "wavelength_max: 10 mm}\nspeed: 20 m/s\ncreep: [0.02]\n"
                           "friction: {local: true}\nthermal: {model: local}\ncells: 512\n";
  const auto hardness = [](double rise) { return 3e9 * (1.0 - rise / 1250.0); };
  for (const char *mode : {"frozen", "moving"}) {
    // what a step of rolling sees is the heat of the step before
    const double late = *mode == 'm' ? 0.02 * 3e9 : 1e4;
    const CreepSpecification input = case_text::rolling(
        text + "mode: " + mode + (*mode == 'm' ? "\nmoving: {passes: 2}\n" : "\n"));
    const CreepCurves curves = solveCreepCurves(input, input.friction.read());
    const ContactFields &fields = curves.fields.begin()->second;
    double hottest = 0.0, coldest = 1250.0; // of the cells that flow
    for (int i = 0; i < fields.pressure.size(); ++i) {
      const double limit = hardness(fields.temperature[i]);
      EXPECT_LE(fields.pressure[i], limit + late) << mode << " " << i;
      if (fields.pressure[i] >= limit - late) {
        hottest = std::max(hottest, fields.temperature[i]);
        coldest = std::min(coldest, fields.temperature[i]);
      }
    }
    EXPECT_GT(hottest, coldest + 50.0) << mode;
  }
}

TEST(CreepCurve, MovingRoughnessKeepsTheInitialSlope)
{
  // Asperities that travel with the material hardly lower the slope, fixed ones do by the area
  const std::string common = "roughness: {hurst: 0.8, rms_slope: 0.01, wavelength_min: 0.2 mm, "
                             "wavelength_max: 10 mm}\nspeed: 20 m/s\ncreep: [2e-4]\nthermal: off\n"
                             "friction: {law: constant, mu: 0.3}\ncells: 512\n";
  const double frozen = solve(common).points[0].tractionRatio;
  const double moving = solve(common + "mode: moving\n").points[0].tractionRatio;
  EXPECT_LT(frozen, 0.85 * 0.041062583);
  EXPECT_NEAR(moving / 0.041062583, 1.0, 0.06);
}

TEST(CreepCurve, MovingSmoothContactIsTheSteadyOne)
{
  // Traction and temperature with all three models; the grid makes the small difference
  const std::string common = "creep: [1e-3, 0.05]\nspeed: 20 m/s\nfriction: {local: true}\n"
                             "points: 512\n";
  for (const char *model : {"averaged", "averaged_power", "local"}) {
    const std::string text = common + "thermal: {model: " + model + "}\n";
    const CreepCurves frozen = solve(text), moving = solve(text + "mode: moving\n");
    for (std::size_t k = 0; k < 2; ++k) {
      const CurvePoint &a = frozen.points[k], &b = moving.points[k];
      EXPECT_NEAR(b.tractionRatio / a.tractionRatio, 1.0, 0.01) << model << k;
      EXPECT_NEAR(b.temperatureRise / a.temperatureRise, 1.0, 0.02) << model << k;
      EXPECT_NEAR(b.temperatureMaximum / a.temperatureMaximum, 1.0, 0.03) << model << k;
    }
  }
}

TEST(CreepCurve, MovingIsTheSameForAnyNumberOfThreads)
{
  const std::string text = "roughness: {hurst: 0.8, rms_slope: 0.01, wavelength_min: 0.4 mm, "
                           "wavelength_max: 10 mm}\nspeed: 20 m/s\ncells: 256\nmode: moving\n"
                           "moving: {passes: 2}\ncreep: {from: 1e-4, to: 0.01, n: 6}\n"
                           "friction: {local: true}\nthermal: {model: local}\n";
  SweepOptions one, three;
  one.threads = 1;
  three.threads = 3;
  expectSame(solve(text, one), solve(text, three));
}

TEST(CreepCurve, TooHotIsNotConverged)
{
  try {
    solve("creep: [0.9]\nspeed: 500 m/s\nthermal: {conductivity: 0.1 W/(m K)}\n");
    FAIL() << "was accepted";
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::NotConverged);
  }
}
