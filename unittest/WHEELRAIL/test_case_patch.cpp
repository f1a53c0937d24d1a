// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/quantity.h"
#include "case_text.h"
#include "shared/pi.h"

#include <gtest/gtest.h>
#include <numeric>

using namespace wheelrail;

namespace {

PatchSpecification patchCase(const std::string &text, const std::vector<std::string> &changes = {})
{
  return std::get<PatchSpecification>(case_text::read(text, changes).task);
}

/// Message of the error; "" when there is none.
std::string problemOf(const std::string &text, const std::vector<std::string> &changes = {})
{
  try {
    case_text::read(text, changes);
  } catch (const Error &error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

const std::string wheel = "contact: {load: [50 kN, 100 kN], youngs_modulus: 210 GPa, "
                          "poissons_ratio: 0.3,\n  radii: {wheel_rolling: 0.5 m, rail_profile: "
                          "300 mm}}\n";

} // namespace

TEST(CasePatch, FillsInDefaults)
{
  const PatchSpecification p = patchCase(wheel + "creep: [-0.5 %, 0.02]\n");
  EXPECT_EQ(p.contact.load, (std::vector<double>{5e4, 1e5}));
  ASSERT_TRUE(p.contact.curvatures);
  EXPECT_DOUBLE_EQ(p.contact.curvatures->A, 1.0);
  EXPECT_DOUBLE_EQ(p.contact.curvatures->B, 0.5 / 0.3);
  EXPECT_EQ(p.creep, (std::vector<double>{-0.005, 0.02}));
  EXPECT_EQ(p.lateral, std::vector<double>{0.0});
  EXPECT_EQ(p.spin, std::vector<double>{0.0});
  EXPECT_EQ(p.contact.nx, 128);
  EXPECT_EQ(p.contact.ny, 128);
  EXPECT_EQ(p.contact.domain, 2.2);
  EXPECT_EQ(p.mode, PatchMode::Frozen);
  EXPECT_EQ(p.physics.thermal.model, ThermalModel::Averaged);
}

TEST(CasePatch, SensitivitiesAreOfRolling)
{
  EXPECT_TRUE(patchCase(wheel + "creep: 0\n").sensitivities);
  const std::string still = wheel + "mode: static\nstatic: {force_ratio: 0.5}\n";
  EXPECT_EQ(problemOf(still), "");
  EXPECT_TRUE(
      contains(problemOf(still + "sensitivities: true\n"), ":5: sensitivities: is not used"));
  const std::string rolls = wheel + "creep: 0\nsensitivities: false\n";
  const std::vector<std::string> changes = {"mode=static", "static.force_ratio=0.5"};
  EXPECT_EQ(problemOf(rolls, changes), "");
  EXPECT_TRUE(contains(problemOf(rolls, {changes[0], changes[1], "sensitivities=true"}),
                       "--set sensitivities: is not used"));
}

TEST(CasePatch, OneEllipseIsOfOneLoadOrApproach)
{
  const auto problem = [](const std::string &press) {
    return problemOf("contact: {" + press +
                     ", semi_axes: [6 mm, 4 mm], youngs_modulus: 210 GPa,\n"
                     "          poissons_ratio: 0.3}\ncreep: 0\n");
  };
  for (const std::string name : {"load", "approach"}) {
    const std::string unit = name == "load" ? " kN" : " um";
    EXPECT_EQ(problem(name + ": [50" + unit + "]"), "");
    EXPECT_TRUE(contains(problem(name + ": [50" + unit + ", 60" + unit + "]"),
                         ":1: contact.semi_axes: goes with one contact." + name + ";"));
  }
}

TEST(CasePatch, NoBodyIsColderThanAbsoluteZero)
{
  const auto problem = [](const std::string &bulk, const std::string &more = "") {
    return problemOf(wheel + "creep: 0\n" + more + "thermal: {bulk: " + bulk + "}\n");
  };
  EXPECT_EQ(problem("[-292 K, 5000 K]"), "");
  EXPECT_TRUE(contains(problem("-1000 K"), ":4: thermal.bulk: '-1000 K', allowed: above -293 K, "
                                           "absolute zero in surroundings of 293 K"));
  EXPECT_TRUE(contains(problem("[20 K, -293 K]"), "'-293 K', allowed"));
  // a law of a material knows its surroundings; of its file only the format is looked at
  const std::string law =
      (std::filesystem::temp_directory_path() / fmt::format("wr-law-{}.json", ::getpid())).string();
  writeOutputFile(law, R"({"format": "mca-friction-law 2"})");
  const std::string material = "friction: {law: " + law + ", ambient: 200 K}\n";
  EXPECT_EQ(problem("-199 K", material), "");
  EXPECT_TRUE(contains(problem("-201 K", material),
                       "above -200 K, absolute zero in surroundings of "
                       "200 K (friction.ambient)"));
  std::filesystem::remove(law);
}

TEST(CasePatch, OrderOfThePoints)
{
  const PatchSpecification p =
      patchCase(wheel + "creep: [1e-3, 2e-3]\nlateral: [0, 1 %]\nspin: [0 1/mm, 1e-3 1/mm]\n"
                        "speed: [10 m/s, 20 m/s]\n");
  const std::vector<PatchTask> tasks = patchTasks(p);
  ASSERT_EQ(tasks.size(), 32u); // 2 loads, speeds, spins, lateral and longitudinal creeps
  EXPECT_EQ(tasks[1].drive.creepage.xi, 2e-3);
  EXPECT_EQ(tasks[2].drive.creepage.eta, 0.01);
  EXPECT_DOUBLE_EQ(tasks[4].drive.creepage.phi, 1.0);
  EXPECT_EQ(tasks[8].speed, 20.0);
  EXPECT_EQ(tasks[15].contact, 0u);
  EXPECT_EQ(tasks[16].contact, 1u);
}

TEST(CasePatch, Forces)
{
  const PatchSpecification p =
      patchCase(wheel + "force: {longitudinal: [-1 kN, -2 kN]}\nlateral: 0.1 %\n");
  const std::vector<PatchTask> tasks = patchTasks(p);
  EXPECT_EQ(tasks[1].drive.forceX, -2000.0);
  EXPECT_FALSE(tasks[1].drive.forceY);
  EXPECT_EQ(tasks[1].drive.creepage.eta, 0.001);
}

TEST(CasePatch, ConfigurationReadsBackToTheSame)
{
  for (const std::string more :
       {"creep: {from: -1e-4, to: -0.1, n: 5}\nlateral: {from: -1 %, to: 1 %, n: 3}\n",
        "mode: moving\nsequence: {time: [0 s, 1 s], load: [1 N, 2 N], creep: [0, 1 %]}\n",
        "mode: static\nstatic: {shift: [1 um, 0 um]}\ncells: [40, 60]\nfields: [1, 2]\n"}) {
    const Case first = case_text::read(wheel + more);
    EXPECT_EQ(first.text, case_text::read(first.text).text) << more;
  }
}

TEST(CasePatch, CombinedBodies)
{
  const ElasticBody steel{210e9, 0.3}, soft{21e9, 0.3}, rubber{3e9, 0.5}, other{9e9, 0.5};
  const ElasticPair pair = combinedPair(steel, soft);
  // 1/E* is the sum of both bodies' (1 - nu^2)/E
  EXPECT_NEAR((1.0 - pair.nu) / pair.G * 1e9, (0.91 / 210.0 + 0.91 / 21.0), 1e-12);
  EXPECT_LT(pair.K, -0.1); // the softer body is the rail
  EXPECT_EQ(combinedPair(soft, steel).K, -pair.K);
  EXPECT_EQ(combinedPair(steel, steel).K, 0.0);
  EXPECT_EQ(combinedPair(rubber, other).K, 0.0);
}

TEST(CasePatch, BatchMeans)
{
  std::vector<double> series(100);
  std::iota(series.begin(), series.end(), 0.0); // means of 4 batches: 12, 37, 62, 87
  EXPECT_NEAR(batchError(series, 4), std::sqrt((2 * 37.5 * 37.5 + 2 * 12.5 * 12.5) / 3 / 4), 1e-12);
  EXPECT_EQ(batchError(series, 1), 0.0);
}

TEST(CasePatch, SequenceIsLinearBetweenItsInstants)
{
  PatchSequence sequence;
  sequence.time = {0.0, 1.0, 3.0};
  sequence.load = {2.0, 4.0, 0.0};
  EXPECT_EQ(sequence.at(sequence.load, 0.5, 9.0), 3.0);
  EXPECT_EQ(sequence.at(sequence.load, 2.0, 9.0), 2.0);
  EXPECT_EQ(sequence.at(sequence.load, 7.0, 9.0), 0.0);
  EXPECT_EQ(sequence.at(sequence.creep, 7.0, 9.0), 9.0);
}

TEST(CasePatch, SequenceIsHeldUntilTheNextInstant)
{
  PatchSequence sequence;
  sequence.held = true;
  sequence.time = {0.0, 1.0, 3.0};
  sequence.load = {2.0, 4.0, 5.0};
  EXPECT_EQ(sequence.at(sequence.load, 0.999, 9.0), 2.0);
  for (double end : {1.0 - 1e-12, 1.0, 1.0 + 1e-12}) // of a step until the instant
    EXPECT_EQ(sequence.at(sequence.load, end, 9.0), 2.0);
  EXPECT_EQ(sequence.at(sequence.load, 0.0, 9.0), 2.0);
  EXPECT_EQ(sequence.at(sequence.load, 1.001, 9.0), 4.0);
  for (double end : {2.999, 3.0, 3.001}) // a step ends on either side of the last instant
    EXPECT_EQ(sequence.at(sequence.load, end, 9.0), 4.0);
}

TEST(CasePatch, SpeedsMakeTheWay)
{
  PatchSequence sequence;
  EXPECT_EQ(sequence.timeAt(6.0, 2.0), 3.0);
  sequence.time = {0.0, 2.0, 3.0, 7.0};
  sequence.speed = {0.0, 4.0, 4.0, 0.0}; // 4 m, 4 m, 8 m
  EXPECT_DOUBLE_EQ(sequence.distanceAt(1.0, 9.0), 1.0);
  EXPECT_DOUBLE_EQ(sequence.distanceAt(7.0, 9.0), 16.0);
  for (double t : {0.0, 0.5, 2.0, 2.7, 3.0, 5.0, 6.9})
    EXPECT_NEAR(sequence.timeAt(sequence.distanceAt(t, 9.0), 9.0), t, 1e-12) << t;
  sequence.held = true; // 2, 4, 16 m
  sequence.speed.front() = 1.0;
  EXPECT_DOUBLE_EQ(sequence.distanceAt(7.0, 9.0), 22.0);
  EXPECT_DOUBLE_EQ(sequence.timeAt(4.0, 9.0), 2.5);
}

TEST(CasePatch, FieldsAreOfTheNearestStep)
{
  PatchSequence sequence;
  sequence.fields = {0.0, 1.2, 1.3, 4.0};
  PatchHistory history;
  PatchStep step;
  for (double time : {1.0, 2.0, 3.0}) {
    step.time = time;
    PatchFields fields;
    fields.mu = Eigen::VectorXd::Constant(1, time);
    history.add(step, time + 1.0, sequence, fields);
  }
  ASSERT_EQ(history.fields.size(), 3U); // the way ended before the fourth
  PatchFields last;
  last.mu = Eigen::VectorXd::Constant(1, 3.0);
  history.end(sequence, last);
  ASSERT_EQ(history.fields.size(), 4U);
  EXPECT_EQ(history.fields.at(4).mu[0], 3.0);
  EXPECT_EQ(history.fields.at(1).mu[0], 1.0);
  EXPECT_EQ(history.fields.at(2).mu[0], 1.0);
  EXPECT_EQ(history.fields.at(3).mu[0], 1.0);
  EXPECT_EQ(stepAt(history.steps, 1.6), 1U);
  EXPECT_EQ(stepAt(history.steps, 4.0), 2U);
}

TEST(CasePatch, FieldsOfUnevenStagesAreOfTheNearest)
{
  PatchSequence sequence;
  sequence.time = {0.0, 10.0, 11.0};
  sequence.fields = {4.0, 6.0, 11.0};
  PatchHistory history;
  PatchStep step;
  for (std::size_t k = 0; k < 3; ++k) {
    step.time = sequence.time[k];
    PatchFields fields;
    fields.mu = Eigen::VectorXd::Constant(1, step.time);
    history.add(step, k < 2 ? sequence.time[k + 1] : step.time, sequence, fields);
  }
  ASSERT_EQ(history.fields.size(), 3U);
  for (int k : {0, 1, 2}) {
    EXPECT_EQ(history.fields.at(k + 1).mu[0], sequence.time[k]);
    EXPECT_EQ(stepAt(history.steps, sequence.fields[k]), static_cast<std::size_t>(k));
  }
}

/// A way through a map: whole cells are exact, between them six points of a wave of eight cells.
TEST(CasePatch, MapsTravel)
{
  const PatchGrid box = centredGrid(16, 16, 16.0, 16.0);
  RoughMap map;
  map.nx = map.ny = 32;
  map.height.resize(32 * 32);
  const auto wave = [](double x, double y) {
    return std::cos(0.25 * mcawr::pi * (x + 2.0)) + 0.1 * std::sin(0.25 * mcawr::pi * y);
  };
  for (int iy = 0; iy < 32; ++iy)
    for (int ix = 0; ix < 32; ++ix)
      map.height[ix + 32 * iy] = wave(ix, iy);
  for (const auto &[x, y] :
       {std::pair{0.0, 0.0}, {5.0, 0.0}, {37.0, -3.0}, {2.3, 0.6}, {-1.7, 40.5}}) {
    Travel travel;
    travel.x = x;
    travel.y = y;
    const Eigen::VectorXd seen = map.window(box, travel);
    double worst = 0.0;
    for (int iy = 0; iy < 16; ++iy)
      for (int ix = 0; ix < 16; ++ix)
        worst =
            std::max(worst, std::abs(seen[box.index(ix, iy)] - wave(ix + travel.x, iy + travel.y)));
    const bool whole = travel.x == std::floor(travel.x) && travel.y == std::floor(travel.y);
    EXPECT_LT(worst, whole ? 1e-12 : 2e-3) << travel.x;
  }
  map.periodic = false;
  Travel travel;
  travel.x = 16.0;
  EXPECT_NO_THROW(map.window(box, travel));
  travel.x = 16.5;
  EXPECT_THROW(map.window(box, travel), std::exception);
}

TEST(CasePatch, RatiosAndReciprocals)
{
  EXPECT_EQ(parseRatio("0.5 %"), 0.005);
  EXPECT_EQ(parseRatio("-2%"), -0.02);
  EXPECT_EQ(parseRatio("0.25"), 0.25);
  EXPECT_THROW(parseRatio("3 mm"), std::invalid_argument);
  EXPECT_DOUBLE_EQ(parseQuantity("6.25e-4 1/mm", "1/m"), 0.625);
  EXPECT_DOUBLE_EQ(parseQuantity("2 mm-1", "1/m"), 2000.0);
  EXPECT_THROW(parseQuantity("2 1/2 mm", "1/m"), std::invalid_argument);
}
