// SPDX-License-Identifier: GPL-2.0-or-later
#include "../shared/other_machines.h"
#include "base/errors.h"
#include "fit/found_logs.h"
#include "fit/friction_log.h"
#include "fit/friction_run.h"
#include "fit/replicates.h"
#include "shared/friction_log_format.h"
#include "shared/running_checksum.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

using namespace wheelrail;

namespace {

const std::string head = R"(# format: mca-friction 1
# program: {name: mca-wheelrail, version: 0.1.0, lammps: 20250204}
# units: {time: ns, length: nm, stress: MPa, velocity: m/s, density: kg/m3, viscosity: Pa s}
# material: {youngs_modulus: 206000, poissons_ratio: 0.3, density: 7800, elastic_limit: 50.968, yield_strength: 80.04, yield_strain: 0.015, strength: 92, breaking_strain: 0.04, viscosity: 0.41}
# loading: {pressure: 15, velocity: 5}
# geometry: {width: 100, thickness: 1, diameter: 2.5, packing: hex, automata: 1280}
# laws: {preset: B}
# run: {timestep: 5e-05, every: 1000, seed: 7}
)";
const std::string columns =
    "step time displacement shear_stress normal_stress mu links broken formed gap\n";

std::string row(int i, double mu)
{
  return fmt::format("{} {:.10g} {:.10g} {:.10g} 15.02 {:.10g} 3456 2 1 -0.013\n", 1000 * i,
                     0.05 * i, 0.25 * i, 15 * mu, mu);
}

std::string goodLog(int rows = 100)
{
  std::string text = head + columns;
  for (int i = 1; i <= rows; ++i)
    text += row(i, 0.4 + 0.01 * (i % 7));
  return text;
}

std::string write(const std::string &content)
{
  const auto *test = testing::UnitTest::GetInstance()->current_test_info();
  std::string path = testing::TempDir() + "log_" + test->name() + ".friction";
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

std::string replaced(std::string text, const std::string &from, const std::string &to)
{
  const auto place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

std::string problemOf(const std::string &content)
{
  try {
    readFrictionLog(write(content));
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "read without complaint";
}

void expectContains(const std::string &text, const std::string &part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

} // namespace

TEST(FrictionLog, readsMaterialLoadingAndSeries)
{
  const auto log = readFrictionLog(write(goodLog()));
  EXPECT_EQ(log.head.youngsModulus, 206000);
  EXPECT_EQ(log.head.strength, 92);
  EXPECT_EQ(log.head.pressure, 15);
  EXPECT_EQ(log.head.seed, 7);
  EXPECT_EQ(log.madeBy.at("laws.preset"), "B");
  EXPECT_EQ(log.madeBy.at("program.lammps"), "20250204");
  ASSERT_EQ(log.mu.size(), 100u);
  EXPECT_DOUBLE_EQ(log.mu[2], 0.43);
  EXPECT_NEAR(log.interval(), 0.05, 1e-12);
  EXPECT_NEAR(log.kappa1(), 4.745983, 1e-6);
  EXPECT_NEAR(log.kappa2(), 365.0756, 1e-4);
  EXPECT_EQ(log.note, "");
}

TEST(FrictionLog, stateBeforeTheFirstStepIsNoRow)
{
  const auto log =
      readFrictionLog(write(replaced(goodLog(), columns, columns + "0 0 0 0 0 0 3456 0 0 0\n")));
  EXPECT_EQ(log.mu.size(), 100u);
  EXPECT_DOUBLE_EQ(log.mu[0], 0.41);
}

TEST(FrictionLog, furtherColumnsAndWindowsLineEndsAreRead)
{
  std::string text;
  for (char c : replaced(goodLog(1), "mu links", "mu  links")) {
    if (c == '\n')
      text += '\r';
    text += c;
  }
  EXPECT_EQ(readFrictionLog(write(text)).mu.size(), 1u);
}

TEST(FrictionLog, cutLastLineIsDroppedAndSaid)
{
  for (const std::string &end : {std::string("101000 5.05 25"), row(101, 0.4).substr(0, 30)}) {
    const auto log = readFrictionLog(write(goodLog() + end));
    EXPECT_EQ(log.mu.size(), 100u);
    expectContains(log.note, ":110: the last line was cut");
  }
  // but not one that has its end, and not if something else is wrong too
  expectContains(problemOf(goodLog() + "101000 5.05\n"), ":110: 2 columns");
  expectContains(problemOf(replaced(goodLog(), row(50, 0.41), "50000 2.5\n") + "101000 5.0"),
                 ":59:");
}

TEST(FrictionLog, badHeadIsOneClearLine)
{
  expectContains(problemOf(""), "empty");
  EXPECT_THROW(parseFrictionLog("a.tar.xz/a.friction", ""), Error);
  expectContains(problemOf("hello\n"), "not a friction log");
  expectContains(problemOf(head), "cut short");
  expectContains(problemOf(head.substr(0, 300)), "not YAML");
  expectContains(problemOf(head + columns), "no row");
  expectContains(problemOf(head + "# ---\n# loading: {pressure: 30}\n" + columns),
                 ":9: the head is not YAML: a second document (after '---'), or what belongs to "
                 "none; one is allowed");
  expectContains(problemOf(replaced(goodLog(), "mca-friction 1", "mca-friction 2")),
                 ":1: format: 'mca-friction 2' cannot be read, must be 'mca-friction 1'");
  expectContains(problemOf(replaced(goodLog(), "stress: MPa", "stress: Pa")),
                 ":3: units: stress: 'Pa' is not allowed, must be 'MPa'");
  expectContains(problemOf(replaced(goodLog(), "youngs_modulus", "young_modulus")),
                 ":4: material: 'youngs_modulus' is missing; 'young_modulus' is unknown, the "
                 "nearest known one is 'youngs_modulus'");
  expectContains(
      problemOf(replaced(goodLog(), "pressure: 15", "pressure: -15")),
      ":5: loading: pressure: '-15' is not allowed, must be a number >= 0 (MPa), 0 or 1e-12 to "
      "1e+12");
  expectContains(problemOf(replaced(goodLog(), "strength: 92", "strength: nan")), "'nan'");
  expectContains(problemOf(replaced(goodLog(), "density: 7800", "density: heavy")), "'heavy'");
  expectContains(problemOf(replaced(goodLog(), "poissons_ratio: 0.3", "poissons_ratio: 0.5")),
                 "in -1 .. 0.5");
  expectContains(problemOf(replaced(goodLog(), "206000", "1e305")),
                 ":4: material: youngs_modulus: '1e305'");
  expectContains(problemOf(replaced(goodLog(), "velocity: 5", "velocity: 1e200")),
                 ":5: loading: velocity: '1e200' is not allowed, must be a number of either sign "
                 "(m/s), 0 or 1e-12 to 1e+12");
  expectContains(problemOf(replaced(goodLog(), "strength: 92", "strength: 1e-200")), "'1e-200'");
  for (const char *seed : {"1.5", "1e300", "-9007199254740993", "0x10"})
    expectContains(
        problemOf(replaced(goodLog(), "seed: 7", std::string("seed: ") + seed)),
        fmt::format(":8: run: seed: '{}' is not allowed, must be a number that is whole, "
                    "-9e+15 to 9e+15",
                    seed));
  expectContains(problemOf(replaced(goodLog(), "{pressure", "{pressure: 20, pressure")),
                 ":5: pressure: appears twice in the head");
  expectContains(problemOf(replaced(goodLog(), "# run", "# loading: {pressure: 20}\n# run")),
                 ":8: loading: appears twice in the head");
  expectContains(problemOf(replaced(goodLog(), "velocity: 5}", "velocity: 5,5}")),
                 ":5: velocity: '5,5' has a decimal comma");
  expectContains(problemOf(replaced(goodLog(), "thickness: 1,", "thickness: 0,8,")),
                 ":6: thickness: '0,8' has a decimal comma");
  expectContains(problemOf(replaced(goodLog(), "shear_stress", "shear_strain")),
                 ":9: column 'shear_stress' is missing; the nearest of those given is "
                 "'shear_strain'");
}

TEST(FrictionLog, whatTheDriveMayWriteIsRead)
{
  namespace format = mcawr::friction_log;
  EXPECT_EQ(readFrictionLog(write(replaced(goodLog(), "seed: 7", "seed: -1"))).head.seed, -1);
  // driven backwards: shear stress and mu are negative, the friction coefficient is not
  std::string backwards = replaced(head, "velocity: 5", "velocity: -5") + columns;
  for (int i = 1; i <= 100; ++i)
    backwards += row(i, -0.4);
  const auto log = readFrictionLog(write(backwards));
  EXPECT_EQ(log.head.velocity, -5.0);
  EXPECT_DOUBLE_EQ(log.mu[99], 0.4);
  EXPECT_DOUBLE_EQ(log.kappa1(), readFrictionLog(write(goodLog())).kappa1());
  // without pressure the plugin writes mu = 0, whatever the shear stress
  std::string unpressed = replaced(head, "pressure: 15", "pressure: 0") + columns;
  unpressed += "1000 0.05 0.25 0.3 0.1 0 3456 2 1 0\n2000 0.1 0.5 -0.3 0.1 0 3456 2 1 0\n";
  EXPECT_EQ(readFrictionLog(write(unpressed)).kappa2(), 0.0);
  EXPECT_EQ(readFrictionLog(write(unpressed)).mu, (std::vector<double>{0.0, 0.0}));
  // the ends of every range are read back
  const auto withPressure = [&](double p) {
    return readFrictionLog(write(replaced(head, "pressure: 15", fmt::format("pressure: {}", p)) +
                                 columns + "1000 1e12 -1e12 0 0 0 0 0 0 1e12\n"));
  };
  for (double p : {0.0, 1.0 / format::largest, format::largest})
    EXPECT_EQ(withPressure(p).head.pressure, p);
}

TEST(FrictionLog, whatRanIsKeysAndValues)
{
  for (const char *laws : {"[1, 2]", "B", "{preset: [B]}", "{[a]: b}", "&x {a: *x}"})
    expectContains(problemOf(replaced(goodLog(), "{preset: B}", laws)), ":7: laws: ");
}

TEST(FrictionLog, theCheckFindsWhatWasChanged)
{
  std::string good = replaced(head + columns, "gap\n", "gap check\n");
  const std::size_t names = good.rfind("step");
  for (int i = 1; i <= 3; ++i) {
    good += row(i, 0.4 + 1e-9 * i);
    good.back() = ' ';
    mcawr::RunningChecksum sum;
    sum.add(good);
    good += std::to_string(sum.value()) + "\n";
  }
  EXPECT_EQ(readFrictionLog(write(good)).mu.size(), 3u);
  EXPECT_EQ(readFrictionLog(write(good.substr(0, good.size() - 5))).mu.size(), 2u);
  for (std::size_t at = 0; at < good.size() - 1; ++at)
    if (at < names ||
        good.find('\n', names) < at) { // names: what they call is not there, or another
      std::string changed = good;
      changed[at] = static_cast<char>(changed[at] ^ 1);
      EXPECT_NE(problemOf(changed), "read without complaint") << "byte " << at;
    }
  expectContains(problemOf(replaced(good, " 0.400000002 ", " 0.400000003 ")), ":11: check: 3");
  expectContains(problemOf(replaced(good, " seed: 7}", " seed: 8}")), ":10: check: ");
}

TEST(FrictionLog, whatOtherMachinesSaveIsReadWithItsCheck)
{
  std::string text = head + "step time displacement shear_stress normal_stress mu links broken "
                            "formed gap check\n";
  for (int i = 1; i <= 50; ++i) {
    text += replaced(row(i, 0.4), "\n", " ");
    mcawr::RunningChecksum sum;
    sum.add(text);
    text += std::to_string(sum.value()) + "\n";
  }
  const auto plain = readFrictionLog(write(text));
  for (const auto &[what, bytes] : asOtherMachinesSave(text)) {
    const auto log = readFrictionLog(write(bytes));
    EXPECT_EQ(log.mu, plain.mu) << what;
    EXPECT_EQ(log.note, "") << what;
  }
  // Latin-1 in a comment of somebody's own
  EXPECT_EQ(readFrictionLog(write(replaced(goodLog(), "# laws:", "# note: 20 \xb0\x43\n# laws:")))
                .mu.size(),
            100U);
  expectContains(problemOf(withoutMark(text)), "is UTF-16 without a byte order mark");
  expectContains(problemOf(replaced(text, "0.4 ", std::string("0.4\0", 4))), "is binary, not text");
}

TEST(FrictionLog, noMessageRepeatsTheFile)
{
  const std::string word(58000, '7');
  for (const std::string &text :
       {word, "# " + word, "# format: " + word + "\n", replaced(goodLog(), "0.4 ", word + " "),
        replaced(goodLog(), "206000", word), replaced(goodLog(), "gap\n", word + "\n")})
    EXPECT_LT(problemOf(text).size(), 700U);
}

TEST(FrictionLog, badRowsAreOneClearLine)
{
  const auto third = row(3, 0.43);
  const auto with = [&](const std::string &line) {
    return problemOf(replaced(goodLog(), third, line));
  };
  expectContains(with("3000 0.15 0.75\n"), ":12: 3 columns, 10 are expected");
  expectContains(with("3000 0.15 0.75 nan 15.02 0.43 3456 2 1 -0.013\n"),
                 ":12: shear_stress: 'nan' is not a finite number");
  expectContains(with("3000 0.15 0.75 1e308 15.02 1e308 3456 2 1 -0.013\n"),
                 ":12: shear_stress: '1e308' is not allowed, must be within +-1e+12");
  expectContains(with("1e300 0.15 0.75 6.45 15.02 0.43 3456 2 1 -0.013\n"), ":12: step: '1e300'");
  expectContains(with("3000 0.15 0.75 6.45 inf 0.43 3456 2 1 -0.013\n"), "normal_stress: 'inf'");
  expectContains(with("3000 0.15 x 6.45 15 0.43 3456 2 1 -0.013\n"), "displacement: 'x'");
  expectContains(with("1000 0.15 0.75 6.45 15 0.43 3456 2 1 -0.013\n"), "must increase");
  expectContains(with("3500 0.175 0.75 6.45 15 0.43 3456 2 1 -0.013\n"), "evenly spaced");
  expectContains(with("3000.5 0.15 0.75 6.45 15 0.43 3456 2 1 -0.013\n"), "whole number");
  expectContains(with("3000 0.15 0.75 6.45 15 0.53 3456 2 1 -0.013\n"),
                 "mu: 0.53 is not shear_stress/pressure = 0.43");
  EXPECT_THROW(readFrictionLog("/nonexistent.friction"), Error);
}

TEST(FrictionLog, foldersAreSearchedAndNothingCountsTwice)
{
  namespace fs = std::filesystem;
  const fs::path folder = testing::TempDir() + "logs";
  fs::remove_all(folder);
  fs::create_directories(folder / "b");
  for (const char *name : {"z.friction", "b/run.friction", "b/run.friction.part", "other.txt"})
    std::ofstream(folder / name) << goodLog();
  const auto files =
      findFrictionLogs({(folder / "z.friction").string(), folder.string(), folder.string() + "/b"});
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(fs::path(files[0].file).filename(), "z.friction");
  EXPECT_EQ(fs::path(files[1].file).filename(), "run.friction");
  EXPECT_EQ(files[1].onDisk(), files[1].file);
  EXPECT_EQ(files[1].read().mu.size(), 100u);
  fs::create_directories(folder / "empty");
  EXPECT_THROW(findFrictionLogs({(folder / "empty").string()}), Error);
  EXPECT_THROW(findFrictionLogs({(folder / "absent").string()}), Error);
  // a log that cannot be read is not passed over
  fs::create_symlink("loop.friction", folder / "empty" / "loop.friction");
  EXPECT_EQ(findFrictionLogs({(folder / "empty").string()}).size(), 1u);
  fs::create_directory_symlink(folder, folder / "empty" / "back");
  EXPECT_EQ(findFrictionLogs({(folder / "empty").string()}).size(), 1u);
}

TEST(FrictionRun, grindingInIsWhatComesBeforeTheStationaryPart)
{
  std::string text = head + columns;
  for (int i = 1; i <= 1000; ++i) // 50 ns; the first 10 ns at 0.8
    text +=
        row(i, (i <= 200 ? 0.8 : 0.4) + 0.01 * std::sin(1.7 * i) + 0.01 * std::sin(0.9 * i * i));
  const auto log = readFrictionLog(write(text));
  const auto run = frictionRun(log, {});
  EXPECT_TRUE(run.stationary());
  EXPECT_NEAR(run.tStart, 10.0, 0.5);
  EXPECT_NEAR(run.mu, 0.4, 0.003);
  EXPECT_NEAR(run.muGrindingIn, 0.8, 0.01);
  EXPECT_NEAR(run.muEq2, 0.441758, 1e-6);
  AveragingOptions fixed;
  fixed.start = 0.0;
  fixed.grindingIn = 20.0;
  const auto all = frictionRun(log, fixed);
  EXPECT_NEAR(all.mu, 0.48, 0.003);
  EXPECT_NEAR(all.muGrindingIn, 0.6, 0.003);
  fixed.start = 60.0;
  EXPECT_THROW(frictionRun(log, fixed), Error);
}

TEST(FrictionRun, copiesOfARunAreToldFromOtherRuns)
{
  // rows are means over `rows` rows of the run, written with seven digits
  const auto runOf = [](int rows, int count, double other = 0.0) {
    std::string text = head + columns;
    for (int i = 1; i <= count; ++i) {
      double sum = 0.0;
      for (int k = rows * (i - 1) + 1; k <= rows * i; ++k)
        sum += std::round(1e7 * (0.4 + 0.1 * std::sin(k * k))) / 1e7;
      text += fmt::format("{} {:.10g} 1 {:.7g} 15 {:.7g} 3456 2 1 0\n", 1000 * rows * i,
                          0.05 * rows * i, 15 * (sum / rows + other), sum / rows + other);
    }
    return frictionRun(readFrictionLog(write(text)), {});
  };
  const auto run = runOf(1, 300);
  for (const auto &copy : {run, runOf(1, 200), runOf(4, 75), runOf(4, 20), runOf(3, 150)}) {
    EXPECT_TRUE(sameRun(run, copy));
    EXPECT_TRUE(sameRun(copy, run));
  }
  EXPECT_TRUE(sameRun(runOf(4, 60), runOf(6, 60)));
  EXPECT_FALSE(sameRun(run, runOf(1, 300, 1e-5)));
  EXPECT_FALSE(sameRun(run, runOf(4, 75, 1e-5)));
  EXPECT_FALSE(sameRun(runOf(1, 3), runOf(4, 75))); // no row in common
  auto another = run;
  another.head.seed = 8; // whose rough line gave the same blocks
  EXPECT_TRUE(sameRun(run, another));
  another.madeBy["laws.preset"] = "A";
  EXPECT_FALSE(sameRun(run, another));
}

TEST(Replicates, runsOfEqualKappasAreGrouped)
{
  std::vector<FrictionRun> runs(6);
  const double kappa1[] = {4.7, 1.0, 4.7001, 4.7, 4.7, 4.7};
  const double mu[] = {0.40, 0.3, 0.42, 0.44, 0.9, 0.9};
  for (int i = 0; i < 6; ++i) {
    runs[i].kappa1 = kappa1[i];
    runs[i].kappa2 = i == 4 ? 30.0 : 365.0;
    runs[i].mu = mu[i];
    runs[i].muSe = 0.01 * (i + 1);
  }
  runs[5].leftOut = "no stationary part";
  const auto groups = replicateGroups(runs);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].n, 3);
  EXPECT_DOUBLE_EQ(groups[0].mu, 0.42);
  EXPECT_NEAR(groups[0].scatter, 0.02 / 0.42, 1e-12);
  EXPECT_NEAR(groups[0].expected, std::sqrt((1.0 + 9.0 + 16.0) / 3.0) * 0.01 / 0.42, 1e-12);
}
