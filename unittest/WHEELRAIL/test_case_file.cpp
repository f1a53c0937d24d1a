// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "case_text.h"
#include "creep/case/keywords.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;

namespace {

using case_text::read;
using case_text::rolling;
using case_text::still;
using case_text::table2;

const std::string minimal = table2 + "creep: [1e-3, 1e-2]\n";

/// Message of the error; "" when there is none.
std::string messageOf(const std::string &text, const std::vector<std::string> &changes = {},
                      ExitCode code = ExitCode::BadInput)
{
  try {
    read(text, changes);
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  return "";
}

bool contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(CaseFile, FillsInDefaults)
{
  const CreepSpecification c = rolling(minimal);
  EXPECT_DOUBLE_EQ(c.contact.load, 4e6);
  EXPECT_DOUBLE_EQ(c.contact.bodies[1].youngsModulus, 210e9);
  EXPECT_EQ(c.contact.points, 1024);
  EXPECT_EQ(c.surface.kind, RoughnessKind::None);
  EXPECT_TRUE(c.friction.files.empty()); // built in
  EXPECT_TRUE(c.friction.mayHaveCovariance);
  EXPECT_EQ(c.physics.thermal.model, ThermalModel::Averaged);
  EXPECT_EQ(c.mode, RollingMode::Frozen);
  EXPECT_DOUBLE_EQ(c.physics.strength.cold, 1e9);
  EXPECT_EQ(c.speed, (std::vector<double>{10.0, 20.0, 40.0}));
  EXPECT_EQ(c.creep, (std::vector<double>{1e-3, 1e-2}));
}

TEST(CaseFile, RefusesWhatWouldChangeNothing)
{
  for (const auto &[group, below] : {std::pair{"thermal: off", "thermal.conductivity: 9 W/(m K)"},
                                     {"roughness: none", "roughness.seed: 3"},
                                     {"creep: 0.1 %", "creep.n: 3"}})
    for (const std::string &text :
         {std::string(group) + "\n" + below, std::string(below) + "\n" + group}) {
      const std::string message = messageOf(table2 + text + "\n");
      EXPECT_TRUE(contains(message, "does not go with " + std::string(group)) ||
                  contains(message, "is given twice"))
          << text << "\n"
          << message;
    }
  const std::string point = "contact: {load: 80 kN, curvatures: [1 1/m, 2 1/m],\n"
                            "          youngs_modulus: 210 GPa, poissons_ratio: 0.3}\n"
                            "creep: 0.1 %\nspeed: 20 m/s\nwear: {density: 7800 kg/m3}\n";
  EXPECT_TRUE(contains(messageOf(point), "wear.density: is not used in this case"));
  // a rolling case as it stands may be asked for its static contact, for frozen roughness, or for
  // linear errors
  EXPECT_EQ(messageOf(minimal + "uncertainty: {method: sampled, samples: 100}\n",
                      {"uncertainty.method=linear"}),
            "");
  const std::string moving = minimal + "mode: moving\nmoving: {passes: 3}\n";
  EXPECT_EQ(messageOf(moving, {"mode=frozen"}), "");
  EXPECT_EQ(messageOf(moving, {"mode=static", "static.force_ratio=0.5"}), "");
  // nor by a change of something else
  for (const std::string odd :
       {"moving: {passes: 3}", "uncertainty: {samples: 100}", "friction: {hot_start: 50 K}",
        "friction: {law: constant, mu: 0.3, strength: 800 MPa}"}) {
    const std::string text = minimal + odd + "\n";
    EXPECT_NE(messageOf(text), "") << odd;
    EXPECT_EQ(messageOf(text, {"cells=2048", "contact.domain=5"}), messageOf(text)) << odd;
  }
  // not what the file says of itself, nor what a change says
  const std::string unused = "is not used in this case";
  const std::string frozen = minimal + "mode: frozen\n";
  EXPECT_TRUE(contains(messageOf(frozen + "moving: {passes: 3}\n"), "moving.passes: " + unused));
  EXPECT_TRUE(contains(messageOf(frozen + "uncertainty: {method: linear, samples: 100}\n"),
                       "uncertainty.samples: " + unused));
  EXPECT_TRUE(
      contains(messageOf(frozen + "friction: {law: bucher2006, mu: 0.3}\n"), "friction.mu: "));
  EXPECT_TRUE(contains(messageOf(frozen, {"moving.passes=3"}), "--set moving.passes: " + unused))
      << "not the file's fault";
  // without a factor the temperatures change nothing; one of 1 may stand in a series of them
  EXPECT_TRUE(contains(messageOf(frozen + "friction: {hot_start: 50 K}\n"), "start: " + unused));
  for (const std::string factor : {"0.9", "1"})
    EXPECT_EQ(messageOf(frozen + "friction: {hot_start: 50 K, hot_factor: " + factor + "}\n"), "");
  // depths are of points with fields
  const std::string smooth = point.substr(0, point.find("wear"));
  const std::string deep = smooth + "depths: [0.1 mm, 1 mm]\n";
  EXPECT_EQ(messageOf(deep), "");
  EXPECT_TRUE(contains(messageOf(deep + "fields: none\n"), "depths: " + unused));
  EXPECT_EQ(messageOf(deep, {"fields=none"}), "");
  // and so are the instants of a sequence
  const std::string pull = smooth + "mode: moving\ncells: [40, 40]\n"
                                    "sequence: {time: [0 s, 1 s], fields: [0.5 s]}\n";
  EXPECT_EQ(messageOf(pull), "");
  EXPECT_TRUE(contains(messageOf(pull + "fields: none\n"), "sequence.fields: " + unused));
  EXPECT_EQ(messageOf(pull, {"fields=none"}), "");
  EXPECT_TRUE(contains(messageOf(pull, {"mode=frozen"}), "sequence."));
  // a strength is of a law that takes it, and of the limit of the pressure
  const std::string constant = smooth + "friction: {law: constant, mu: 0.3, strength: 800 MPa}\n";
  EXPECT_TRUE(contains(messageOf(constant), "friction.strength: " + unused));
  EXPECT_EQ(messageOf(smooth + "friction: {strength: 800 MPa}\n", {"friction.law=a.csv"}), "");
  EXPECT_EQ(messageOf(smooth + "friction: {law: bucher2006, strength: 800 MPa}\n"), "");
  EXPECT_EQ(messageOf(constant, {"contact.hardness_limit=true"}), "");
  // a map that is not there
  const std::string map = smooth + "roughness: {rail: a.gsf, ";
  for (const std::string keyword : {"turn", "mirror"}) {
    EXPECT_EQ(messageOf(map + keyword + ": rail}\n"), "");
    for (const std::string body : {"wheel", "both"})
      EXPECT_TRUE(contains(messageOf(map + keyword + ": " + body + "}\n"),
                           "roughness." + keyword + ": " + body + " needs roughness.wheel"));
  }
  EXPECT_EQ(
      messageOf(constant + "contact.hardness_limit: true\n", {"contact.hardness_limit=false"}), "");
  const std::string still = table2 + "mode: static\nstatic: {force_ratio: 0.5}\n";
  EXPECT_EQ(messageOf(still + "thermal: off\n"), "");
  EXPECT_TRUE(
      contains(messageOf(still + "friction: {hot_factor: 0.9}\n"),
               "friction.hot_factor: does not go with mode: static, where nothing becomes hot"));
  for (const std::vector<std::string> &changes :
       {std::vector<std::string>{}, {"cells=2048"}, {"static.force_ratio=0.4"}})
    EXPECT_TRUE(contains(messageOf(still + "speed: 20 m/s\n", changes), "speed: " + unused));
  EXPECT_EQ(messageOf(still + "speed: 20 m/s\n", {"mode=static"}), "");
}

/// "[0,1 %, 0,2 %]" is 0, 1 %, 0 and 2 % to YAML.
TEST(CaseFile, RefusesDecimalCommas)
{
  const auto creep = [](const std::string &list) { return messageOf(table2 + "creep: " + list); };
  for (const std::string list : {"[0,1 %, 0,2 %]", "[0,1 %]", "[0, 0,1 %]", "[0,001, 0,01]",
                                 "[0,001,0,01]", "[1 %, 2,5 %]", "[-0,1 %, 0]"})
    EXPECT_TRUE(contains(creep(list), "creep: '") && contains(creep(list), "has a decimal comma"))
        << list << " " << creep(list);
  for (const std::string list : {"[0, 0.1 %]", "[0.001,0.01]", "[0,1]", "[ 0 , 1 % ]",
                                 "[0, 1 %,2 %]", "[1e-3,1e-2]", "[0,0.1 %]", "[-1 %,1 %]"})
    EXPECT_EQ(creep(list), "") << list;
  EXPECT_EQ(messageOf(minimal + "cells: 64\nroughness: {hurst: 0.8, rms_slope: 0.02,\n"
                                "  wavelength_min: 0.1 mm, wavelength_max: 5 mm, seed: [1,2, 3]}"),
            "");
  EXPECT_TRUE(contains(messageOf(minimal + "friction: {law: constant, mu: 0,3}\n"),
                       ":4: friction.mu: '0,3' has a decimal comma"));
  EXPECT_TRUE(contains(messageOf(minimal, {"creep=[0,1 %]"}, ExitCode::Usage),
                       "--set creep: '0,1 %' has a decimal comma"));
}

TEST(CaseFile, SeriesThatPassZeroHoldIt)
{
  const auto creeps = [](const std::string &series) {
    return rolling(table2 + "creep: {" + series + ", spacing: linear}\n").creep;
  };
  // in binary numbers both miss 0 by some 1e-18
  EXPECT_EQ(creeps("from: -2 %, to: 4 %, n: 7")[2], 0.0);
  EXPECT_EQ(creeps("from: -4 %, to: 2 %, n: 7")[4], 0.0);
  EXPECT_EQ(creeps("from: -1e-11, to: 1e-11, n: 2"), (std::vector<double>{-1e-11, 1e-11}));
}

TEST(CaseFile, SeriesOfOneValueHaveOneEnd)
{
  const auto message = [](const std::string &series) {
    return messageOf(table2 + "creep: {" + series + "}\n");
  };
  EXPECT_EQ(message("from: 1e-4, to: 1e-4, n: 1"), "");
  for (const std::string to : {"0.1", "1e-5"})
    EXPECT_TRUE(
        contains(message("from: 1e-4, to: " + to + ", n: 1"),
                 ":3: creep.to: '" + to + "', allowed where creep.n is 1: creep.from, '1e-4'"))
        << to;
  EXPECT_TRUE(contains(message("from: 1e-4, to: 1e-4, n: 2"), "must be above creep.from"));
}

TEST(CaseFile, NamesAKeywordAsItWasGiven)
{
  EXPECT_TRUE(contains(messageOf(minimal, {"points=3"}, ExitCode::Usage), "points: '3'"));
  EXPECT_TRUE(contains(messageOf(minimal, {"cells=3"}, ExitCode::Usage), "cells: '3'"));
  EXPECT_TRUE(contains(messageOf(minimal + "points: 3\n"), "points: '3'"));
}

TEST(CaseFile, ReadsPointsAsCells)
{
  EXPECT_EQ(rolling(minimal + "points: 2048\n").contact.points, 2048);
  EXPECT_EQ(rolling(minimal + "cells: 2048\n", {"points=512"}).contact.points, 512);
  EXPECT_EQ(rolling(minimal + "points: 2048\n", {"cells=512"}).contact.points, 512);
  EXPECT_TRUE(contains(messageOf(minimal + "points: 64\ncells: 64\n"), "cells: is given twice"));
}

TEST(CaseFile, ReadsGroupsAndChoices)
{
  const CreepSpecification c =
      rolling(table2 + "roughness: {hurst: 0.8, rms_slope: 0.02, wavelength_min: 0.1 mm, "
                       "wavelength_max: 1 cm, seed: [4, 5]}\n"
                       "friction: {law: constant, mu: 0.3}\n"
                       "thermal: off\nmode: moving\nspeed: 36 km/h\n"
                       "creep: {from: 1e-4, to: 1e-1, n: 4}\ncells: 2048\n");
  EXPECT_EQ(c.surface.kind, RoughnessKind::Fractal);
  EXPECT_DOUBLE_EQ(c.surface.fractal.wavelengthMax, 10e-3);
  EXPECT_EQ(c.surface.seeds, (std::vector<std::uint64_t>{4, 5}));
  EXPECT_EQ(c.physics.thermal.model, ThermalModel::Off);
  EXPECT_EQ(c.mode, RollingMode::Moving);
  EXPECT_EQ(c.speed, std::vector<double>{10.0});
  ASSERT_EQ(c.creep.size(), 4u);
  EXPECT_NEAR(c.creep[1], 1e-3, 1e-15);
  EXPECT_EQ(c.creep[3], 1e-1);
}

TEST(CaseFile, ConfigurationReadsBackToTheSame)
{
  for (const std::string &more : {std::string("creep: [1e-3]\n"),
                                  std::string("creep: {from: 0, to: 0.1, n: 3, spacing: linear}\n"
                                              "thermal: off\nroughness: {rail: \"a b.csv\", "
                                              "cutoff: 0.1 mm}\nfriction: {local: true}\n")}) {
    const Case first = read(table2 + more);
    const Case second = read(first.text);
    EXPECT_EQ(first.text, second.text);
    const auto a = std::get<CreepSpecification>(first.task);
    const auto b = std::get<CreepSpecification>(second.task);
    EXPECT_EQ(a.creep, b.creep);
    EXPECT_EQ(a.physics.thermal.model, b.physics.thermal.model);
  }
}

TEST(CaseFile, ChangesFromTheCommandLine)
{
  const Case whole =
      read(minimal, {"creep={from: 1e-3, to: 1e-2, n: 2}", "speed=20 m/s", "contact.radius=460 mm",
                     "thermal=off",
                     "roughness={hurst: 0.8, rms_height: 2 um, wavelength_min: 1 mm, "
                     "wavelength_max: 9 mm}",
                     "roughness.seed=3"});
  const auto c = std::get<CreepSpecification>(whole.task);
  EXPECT_DOUBLE_EQ(c.contact.radius, 0.46);
  EXPECT_EQ(c.creep.size(), 2u);
  EXPECT_EQ(c.surface.seeds, std::vector<std::uint64_t>{3});
  const CreepSpecification smooth =
      rolling(whole.text, {"roughness=none", "thermal.conductivity=40 W/(m K)"});
  EXPECT_EQ(smooth.surface.kind, RoughnessKind::None);
  EXPECT_DOUBLE_EQ(smooth.physics.thermal.material.conductivity, 40.0);
  EXPECT_TRUE(contains(messageOf(minimal, {"cells"}, ExitCode::Usage), "KEYWORD=VALUE"));
  EXPECT_TRUE(contains(messageOf(minimal, {"cels=4"}, ExitCode::Usage), "'cells'"));
  EXPECT_TRUE(contains(messageOf(minimal, {"cells=many"}, ExitCode::Usage), "many"));
  EXPECT_TRUE(contains(messageOf(minimal, {"creep=[1, 2"}, ExitCode::Usage), "creep"));
}

TEST(CaseFile, NamesLineKeywordAndNearest)
{
  const std::string message = messageOf(minimal + "frictoin: {mu: 0.3}\n");
  EXPECT_TRUE(contains(message, ":4: frictoin: unknown keyword 'frictoin'")) << message;
  EXPECT_TRUE(contains(message, "'friction'")) << message;
  EXPECT_TRUE(contains(messageOf(minimal + "friction:\n  locl: true\n"), ":5: friction.locl"));
  EXPECT_TRUE(contains(messageOf(minimal + "friction:\n  locl: true\n"), "'friction.local'"));
  // nothing near: what there is in the group; a beginning is near
  EXPECT_TRUE(contains(messageOf(minimal + "thermal: {heat: 3}\n"),
                       "known: thermal.conductivity, thermal.density, thermal.specific_heat"));
  EXPECT_TRUE(
      contains(messageOf("contact: {load_per_lenght: 4000 N/mm}\n"), "'contact.load_per_length'"));
}

TEST(CaseFile, BadValues)
{
  const char *const faults[][2] = {
      {"cells: nan\n", "cells"},
      {"cells: 0x100\n", "plain number"},
      {"speed: 0x10 m/s\n", "not a unit"},
      {"friction: {strength: 1 500 MPa}\n", "second number"},
      {"friction: {strength: \"1,500 MPa\"}\n", "second number"},
      {"cells: 100.5\n", "whole number"},
      {"cells: -5\n", "allowed range"},
      {"cells: [1024]\n", "not a list"},
      {"cells: 1024 mm\n", "plain number"},
      {"cells:\n", "no value"},
      {"cells: {n: 1024}\n", "no keywords below"},
      {"mode: rolling\n", "moving"},
      {"speed: [10 m/s, -1 m/s]\n", "allowed range"},
      {"speed: 10\n", "no unit"},
      {"speed: 10 mm\n", "dimension"},
      {"speed: inf m/s\n", "finite"},
      {"speed: []\n", "empty"},
      {"thermal: none\n", "off"},
      {"thermal: {conductivity: 0 W/(m K)}\n", "allowed range"},
      // of other units: W/(mm K), g/cm3 without a name for it, kJ
      {"thermal: {conductivity: 50 W/(mm K)}\n", "[0.001, 10000] W/(m K)"},
      {"thermal: {density: 7.8 kg/m3}\n", "[10, 100000] kg/m3"},
      {"thermal: {specific_heat: 450 kJ/(kg K)}\n", "[1, 100000] J/(kg K)"},
      {"thermal: off\nthermal: off\n", "twice"},
      {"friction: {law: constant}\n", "friction.mu"},
      {"friction: {mu: 0.3}\n", "constant"},
      {"friction: {law: constant, mu: [0.3]}\n", "not a list"},
      {"roughness: {hurst: 0.8}\n", "wavelength_min"},
      {"roughness: rough\n", "none"},
      {"roughness: {hurst: 0.8, rail: a.csv}\n", "does not go with"},
      {"roughness: {hurst: 0.8, rms_slope: 0.1, rms_height: 1 um, wavelength_min: 1 mm, "
       "wavelength_max: 9 mm}\n",
       "not both"},
      {"roughness: {hurst: 0.8, rms_slope: 0.1, wavelength_min: 10 mm, wavelength_max: 9 mm}\n",
       "above wavelength_max"},
      {"contact: {load_per_length: 1 N/mm}\n", "twice"},
      {"cells: \"\n", ":"},
      {"mode: static\n", "static.force_ratio"},
      {"mode: static\nstatic: {force_ratio: 1}\n", "allowed range"},
      {"mode: static\nstatic: {force_ratio: 0.5}\nfriction: {local: true}\n", "friction.local"},
      {"roughness: {rail: [a.csv, b.csv], wheel: [c.csv]}\n", "as many as of roughness.rail"},
      {"uncertainty: {method: bootstrap}\n", "sampled"},
      {"uncertainty: {samples: 3}\n", "allowed range"},
  };
  for (const auto &[text, part] : faults) {
    const std::string message = messageOf(minimal + text);
    EXPECT_TRUE(contains(message, part)) << text << message;
    EXPECT_FALSE(contains(message, "\n")) << message;
  }
  EXPECT_TRUE(contains(messageOf(table2 + "creep: {from: 1, to: 0.1, n: 3}\n"), "creep.to"));
  EXPECT_TRUE(contains(messageOf(table2 + "creep: {from: 0, to: 0.1, n: 3}\n"), "positive"));
  EXPECT_TRUE(contains(messageOf(table2), "creep"));
  EXPECT_TRUE(contains(messageOf("creep: 1e-3\n"), "contact.load_per_length"));
}

TEST(CaseFile, StaticModeAndPeriod)
{
  const std::string flat = "contact: {load_per_length: 2000 N/mm, period: 10 mm,\n"
                           "          youngs_modulus: 210 GPa, poissons_ratio: 0.3}\n";
  const std::string forces = "mode: static\nstatic: {force_ratio: [0, 0.5]}\n";
  const Case whole = read(flat + forces);
  const auto c = std::get<StaticSpecification>(whole.task);
  EXPECT_EQ(c.physics.thermal.model, ThermalModel::Off);
  EXPECT_DOUBLE_EQ(c.contact.period, 0.01);
  EXPECT_EQ(c.forceRatio, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(read(whole.text).text, whole.text);
  EXPECT_TRUE(contains(messageOf(flat + "creep: 1e-3\n"), "contact.period: does not go with mode"));
  EXPECT_TRUE(contains(messageOf("mode: static\nstatic: {force_ratio: 0.5}\n"
                                 "friction: {law: constant, mu: 0.3, memory_length: 1 mm}\n"),
                       "friction.memory_length: does not go with mode static: nothing slides on"));
  EXPECT_TRUE(contains(messageOf(flat + forces, {"contact.radius=1 m"}), "does not go with"));
  EXPECT_TRUE(
      contains(messageOf(flat + forces, {"contact.hardness_limit=true"}), "elastic contact"));
  EXPECT_EQ(messageOf(flat + forces, {"contact.hardness_limit=true", "static.force_ratio=0"}), "");
  // a case of rolling becomes static without its creeps and speeds getting in the way
  EXPECT_EQ(still(minimal, {"mode=static", "static.force_ratio=0.5"}).forceRatio.size(), 1u);
}

TEST(CaseFile, SeveralProfiles)
{
  const Case c = read(minimal + "roughness: {rail: [a.csv, b.csv], wheel: [c.csv, d.csv]}\n");
  const SurfaceSpecification &surface = std::get<CreepSpecification>(c.task).surface;
  EXPECT_EQ(surface.profiles(), 2u);
  EXPECT_TRUE(contains(surface.wheel[1], "d.csv"));
  EXPECT_EQ(c.files().size(), 4u); // the law is built in
  EXPECT_EQ(rolling(minimal).surface.profiles(), 1u);
}

TEST(CaseFile, TruncatedEmptyOrOther)
{
  EXPECT_TRUE(contains(messageOf(minimal.substr(0, 60)), ":"));
  EXPECT_TRUE(contains(messageOf("# nothing\n"), "not a case file"));
  EXPECT_TRUE(contains(messageOf("just words\n"), "not a case file"));
  EXPECT_TRUE(contains(messageOf("- 1\n- 2\n"), "not a case file"));
  EXPECT_THROW(readCase("/nonexistent/case.yaml"), Error);
}

TEST(CaseFile, HasOneDocument)
{
  const std::string problem =
      "a second document (after '---'), or what belongs to none; one is allowed";
  for (const auto &[more, line] : {std::pair{"---\ncreep: 0.002\n", ":4: "},
                                   {"...\ncreep: 0.002\n", ":5: "},
                                   {"---\n# nothing\n", ":4: "}})
    EXPECT_TRUE(contains(messageOf(minimal + more), line + problem)) << messageOf(minimal + more);
  for (const std::string &one :
       {"---\n" + minimal, minimal + "...\n", "%YAML 1.2\n---\n" + minimal})
    EXPECT_EQ(messageOf(one), "") << one;
  for (const char *change : {"creep=0.1\n---\n0.2", "creep=[0.1, 0.2], 0.3"})
    EXPECT_TRUE(contains(messageOf(minimal, {change}, ExitCode::Usage), "--set creep: " + problem));
}

TEST(CaseFile, TableOfKeywordsIsSound)
{
  for (const Keyword &keyword : keywords()) {
    EXPECT_GT(std::string(keyword.help).size(), 3u) << keyword.name;
    EXPECT_LE(keyword.low, keyword.high) << keyword.name;
    EXPECT_TRUE(std::isfinite(keyword.low) && std::isfinite(keyword.high)) << keyword.name;
  }
}

TEST(CaseFile, EveryNumberHasARangeThatTheMessageSays)
{
  using Kind = Keyword::Kind;
  for (const Keyword &keyword : keywords()) {
    if (keyword.kind == Kind::Switch || keyword.kind == Kind::Choice ||
        keyword.kind == Kind::Text || keyword.kind == Kind::TextList)
      continue;
    const std::string unit = std::string(keyword.unit) == "1" ? "" : keyword.unit;
    for (const char *number : {"1e308", "-1e308", "1e999", "-1e-999", "nan", "0x10", "1 500"}) {
      const std::string change = fmt::format("{}={} {}", keyword.name, number, unit);
      const std::string message = messageOf(minimal, {change}, ExitCode::Usage);
      EXPECT_TRUE(contains(message, keyword.name)) << change << ": " << message;
      EXPECT_TRUE(contains(message, rangeOf(keyword))) << change << ": " << message;
    }
    const std::string change = fmt::format("{}=1e-308 {}", keyword.name, unit);
    if (keyword.low > 0.0 || keyword.smallest > 0.0) {
      EXPECT_TRUE(contains(messageOf(minimal, {change}, ExitCode::Usage), rangeOf(keyword)))
          << change;
    }
  }
}

TEST(CaseFile, ContactsHaveCells)
{
  const std::string message =
      messageOf(minimal, {"contact.domain=100", "cells=32"}, ExitCode::BadInput);
  EXPECT_TRUE(contains(message, "cells: 32 on a contact.domain of 100 leave 0.64 cells"))
      << message;
  EXPECT_TRUE(contains(message, "200 cells")) << message;
  EXPECT_EQ(messageOf(minimal, {"contact.domain=100", "cells=200"}), "");
  const std::string point = "contact: {load: 80 kN, curvatures: [1 1/m, 2 1/m],\n"
                            "          youngs_modulus: 210 GPa, poissons_ratio: 0.3}\n"
                            "creep: 1e-3\nthermal: off\n";
  EXPECT_TRUE(contains(messageOf(point, {"contact.domain=100", "cells=[300, 32]"}), "cells: 32"));
  EXPECT_EQ(messageOf(point, {"contact.domain=100", "cells=[300, 200]"}), "");
}

TEST(CaseFile, ListsThatMultiplyHaveALimit)
{
  const std::string many = "creep={from: 1e-4, to: 1e-2, n: 1000000}";
  EXPECT_EQ(messageOf(minimal, {many}), "");
  EXPECT_TRUE(contains(messageOf(minimal, {many, "speed=[1 m/s, 2 m/s, 3 m/s, 4 m/s, 5 m/s, 6 m/s, "
                                                 "7 m/s, 8 m/s, 9 m/s, 10 m/s, 11 m/s]"}),
                       "creep.n: all lists together make 1.1e+07 operating points; at most 1e+07"));
}

TEST(CaseFile, EllipsesThatAreAlmostALineAreRefused)
{
  const auto with = [](const std::string &shape) {
    return "contact: {load: 80 kN, " + shape +
           ", youngs_modulus: 210 GPa, poissons_ratio: 0.3}\ncreep: 1e-3\nthermal: off\n";
  };
  EXPECT_TRUE(contains(messageOf(with("semi_axes: [1 m, 1e-8 m]")), "contact.semi_axes: a/b"));
  EXPECT_TRUE(
      contains(messageOf(with("curvatures: [1 1/m, 1e-8 1/m]")), "contact.curvatures: A/B"));
  EXPECT_TRUE(contains(messageOf(with("radii: {wheel_rolling: 1e-3 m, rail_profile: 1e6 m}")),
                       "contact.radii: A/B"));
}

TEST(CaseFile, ControlCharactersAreShownAndReadBack)
{
  const std::string message = messageOf(minimal + "\"a\\e[31m\\nb\": 1\n");
  EXPECT_TRUE(contains(message, "'a\\x1b[31m\\nb'")) << message;
  EXPECT_FALSE(contains(message, "\x1b")) << message;
  const Case odd = read(minimal + "roughness: {rail: \"a\\e[2J\\n b.csv\"}\n");
  EXPECT_FALSE(contains(odd.text, "\x1b"));
  EXPECT_EQ(read(odd.text).text, odd.text);
  EXPECT_EQ(read(odd.text).files(), odd.files());
  EXPECT_TRUE(contains(messageOf(minimal, {"=3"}, ExitCode::Usage), "KEYWORD=VALUE"));
}

TEST(CaseFile, IsKnownByTheContentOfItsFiles)
{
  const std::string file =
      (std::filesystem::temp_directory_path() / fmt::format("wr-rail-{}.csv", ::getpid())).string();
  const auto identity = [&](const std::string &content) {
    writeOutputFile(file, content);
    return read(minimal + "roughness: {rail: " + file + "}\n").identity();
  };
  const std::string first = identity("1\n");
  EXPECT_EQ(identity("1\n"), first);
  EXPECT_NE(identity("2\n"), first);
  EXPECT_NE(identity("1\n\n"), first);
  std::filesystem::remove(file);
  EXPECT_EQ(read(minimal).identity(), read(minimal).text);
}
