// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case/keywords.h"

#include "law/friction_laws.h"

#include <algorithm>

namespace wheelrail {
namespace {

/// Puts the rows of the laws after that of friction.law.
std::vector<Keyword> withLaws(std::vector<Keyword> table)
{
  using Kind = Keyword::Kind;
  std::vector<Keyword> rows;
  for (const LawKeyword &keyword : lawKeywords()) {
    const Kind kind = keyword.kind == LawKeyword::Kind::Switch     ? Kind::Switch
                      : keyword.kind == LawKeyword::Kind::Quantity ? Kind::Quantity
                                                                   : Kind::Number;
    rows.push_back({keyword.name, kind, keyword.unit, keyword.initial, keyword.low, keyword.high, 0,
                    "", keyword.help});
  }
  const auto law = std::find_if(table.begin(), table.end(), [](const Keyword &keyword) {
    return std::string(keyword.name) == "friction.law";
  });
  table.insert(law + 1, rows.begin(), rows.end());
  return table;
}

} // namespace

const std::vector<Keyword> &keywords()
{
  using Kind = Keyword::Kind;
  static const std::string names = lawNames();
  static const std::vector<Keyword> table = withLaws({
      {"contact.load_per_length", Kind::Quantity, "N/m", "", 1e-6, 1e12, 0, "",
       "normal force per length of the cylinder: a line contact"},
      {"contact.load", Kind::QuantityList, "N", "", 1e-12, 1e12, 0, "",
       "normal force: a contact in a point, a list gives curves for each; or that on "
       "contact.width"},
      {"contact.width", Kind::Quantity, "m", "", 1e-9, 1e6, 0, "",
       "length of the cylinder that contact.load presses: a line contact of load/width"},
      {"contact.radius", Kind::Quantity, "m", "", 1e-9, 1e6, 0, "",
       "R of 1/R = 1/R1 + 1/R2 (on a flat rail: of the wheel)"},
      {"contact.radii.wheel_rolling", Kind::Quantity, "m", "", 1e-9, 1e6, 0, "",
       "point: rolling radius of the wheel"},
      {"contact.radii.wheel_profile", Kind::Quantity, "m", "", -1e6, 1e6, 1e-9, "",
       "point: transverse radius of the wheel, negative where hollow; straight if not given"},
      {"contact.radii.rail_profile", Kind::Quantity, "m", "", -1e6, 1e6, 1e-9, "",
       "point: transverse radius of the rail, likewise"},
      {"contact.curvatures", Kind::QuantityList, "1/m", "", 1e-9, 1e9, 0, "",
       "point, instead of radii: [A, B] of the gap A x^2 + B y^2"},
      {"contact.semi_axes", Kind::QuantityList, "m", "", 1e-9, 1e3, 0, "",
       "point, instead of radii: [a, b] of the ellipse, along x and y"},
      {"contact.youngs_modulus", Kind::QuantityList, "Pa", "", 1, 1e15, 0, "",
       "Young's modulus of both bodies, for the contact; point: or [wheel, rail]"},
      {"contact.poissons_ratio", Kind::NumberList, "1", "", 0, 0.5, 0, "",
       "Poisson's ratio of both bodies; point: or [wheel, rail]"},
      {"contact.hardness_limit", Kind::Switch, "1", "false", 0, 0, 0, "",
       "stop the pressure at the hardness, 3 x strength at the temperature reached"},
      {"contact.domain", Kind::Number, "1", "4", 2.1, 1000, 0, "",
       "length that is computed, in Hertz half-widths a; point: box in semi-axes"},
      {"contact.spin_point", Kind::Number, "1", "0.5", 0, 1, 0, "",
       "point: place in a cell where the spin's lever ends, 0.5: its middle"},
      {"contact.edges", Kind::Choice, "1", "whole", 0, 0, 0, "whole|inside",
       "point: cells count as a whole, or the leading edges lie inside their cells"},
      {"contact.period", Kind::Quantity, "m", "", 1e-9, 1e3, 0, "",
       "flat surfaces whose roughness repeats after this length (mode static)"},
      {"points", Kind::IntegerList, "1", "1024", 8, 1 << 24, 0, "",
       "cells on the whole domain; point: [nx, ny] of the box, or one number for both"},
      {"roughness", Kind::Choice, "1", "none", 0, 0, 0, "none",
       "none: smooth; otherwise the keywords below"},
      {"roughness.hurst", Kind::Number, "1", "", 0, 1, 0, "",
       "Hurst exponent of a generated profile"},
      {"roughness.rms_slope", Kind::Number, "1", "", 1e-9, 1, 0, "", "its root mean square slope"},
      {"roughness.rms_height", Kind::Quantity, "m", "", 1e-15, 1, 0, "",
       "its root mean square height, instead of rms_slope"},
      {"roughness.wavelength_min", Kind::Quantity, "m", "", 1e-12, 1e3, 0, "",
       "its shortest wavelength"},
      {"roughness.wavelength_max", Kind::Quantity, "m", "", 1e-12, 1e3, 0, "",
       "its longest wavelength"},
      {"roughness.seed", Kind::IntegerList, "1", "1", 0, 9e15, 0, "",
       "its random numbers; a list gives one creep curve for each"},
      {"roughness.stretch", Kind::Number, "1", "1", 1e-3, 1e3, 0, "",
       "point: how many times longer features are along x than along y, at the same area"},
      {"roughness.boxes", Kind::Integer, "1", "", 1, 10000, 0, "",
       "point: period of a generated surface along x, in lengths of the box"},
      {"roughness.rail", Kind::TextList, "1", "", 0, 0, 0, "",
       "measured profile of the rail: file; a list gives one creep curve for each"},
      {"roughness.wheel", Kind::TextList, "1", "", 0, 0, 0, "",
       "measured profile of the wheel: file, or as many as of the rail"},
      {"roughness.cutoff", Kind::Quantity, "m", "", 1e-12, 1e3, 0, "",
       "shorter wavelengths are filtered out of measured profiles"},
      {"roughness.detrend", Kind::Choice, "1", "line", 0, 0, 0, "none|mean|line|parabola",
       "what is taken off measured profiles"},
      {"roughness.unmeasured", Kind::Choice, "1", "refuse", 0, 0, 0, "refuse|fill",
       "point: what is done with points of a measured map that have no height"},
      {"roughness.spacing", Kind::QuantityList, "m", "", 1e-12, 1e3, 0, "",
       "point: spacing of npy maps, which do not state it; one, or [x, y]"},
      {"roughness.height_unit", Kind::Quantity, "m", "", 1e-15, 1e3, 0, "",
       "point: what a height of 1 in npy maps is"},
      {"roughness.turn", Kind::Choice, "1", "none", 0, 0, 0, "none|rail|wheel|both",
       "point: measured maps whose rows lie across the rolling direction"},
      {"roughness.mirror", Kind::Choice, "1", "none", 0, 0, 0, "none|rail|wheel|both",
       "point: measured maps whose y is turned around, as when looking at the wheel"},
      {"friction.law", Kind::Text, "1", Eq2Law::word, 0, 0, 0, "", names.c_str()},
      {"thermal", Kind::Choice, "1", "", 0, 0, 0, "off",
       "off: no temperature; otherwise the keywords below"},
      {"thermal.conductivity", Kind::Quantity, "W/(m K)", "50 W/(m K)", 1e-9, 1e9, 0, "",
       "lambda of both bodies"},
      {"thermal.density", Kind::Quantity, "kg/m3", "7800 kg/m3", 1e-6, 1e9, 0, "",
       "rho of both bodies"},
      {"thermal.specific_heat", Kind::Quantity, "J/(kg K)", "450 J/(kg K)", 1e-6, 1e9, 0, "",
       "c_p of both bodies"},
      {"thermal.model", Kind::Choice, "1", "averaged", 0, 0, 0, "averaged|averaged_power|local",
       "averaged: Eq. 11; averaged_power: Eq. 11 with T/N for mu; local: flash temperature"},
      {"mode", Kind::Choice, "1", "frozen", 0, 0, 0, "frozen|moving|static",
       "roughness fixed in the contact frame, travelling with the material; or no rolling"},
      {"moving.passes", Kind::Integer, "1", "4", 2, 1000, 0, "",
       "mode moving: lengths of the nominal contact that are rolled; point: 12 unless given"},
      {"moving.reference_length", Kind::Number, "1", "1", 0.6, 1000, 0, "",
       "mode moving: length of the half-plane's free constant, in a"},
      {"moving.start", Kind::Choice, "1", "steady", 0, 0, 0, "steady|rest|shift",
       "point: traction at the start: of steady rolling, none, of one shift under the forces"},
      {"static.force_ratio", Kind::NumberList, "1", "", 0, 0.999999, 1e-12, "",
       "mode static: tangential force T/(mu N), below full sliding"},
      {"static.shift", Kind::QuantityList, "m", "", -1, 1, 1e-15, "",
       "point, mode static: [x, y] of the wheel against the rail, instead of forces"},
      {"creep", Kind::RatioList, "1", "", -10, 10, 1e-12, "",
       "sliding/rolling speed, longitudinal: a list; or the keywords below"},
      {"creep.from", Kind::Ratio, "1", "", -10, 10, 1e-12, "", "first creep"},
      {"creep.to", Kind::Ratio, "1", "", -10, 10, 1e-12, "", "last creep"},
      {"creep.n", Kind::Integer, "1", "", 1, 1e6, 0, "", "number of creeps"},
      {"creep.spacing", Kind::Choice, "1", "log", 0, 0, 0, "log|linear", "of the creeps"},
      {"lateral", Kind::RatioList, "1", "0", -10, 10, 1e-12, "",
       "point: lateral creep, sliding/rolling speed; a list; or the keywords below"},
      {"lateral.from", Kind::Ratio, "1", "", -10, 10, 1e-12, "", "first lateral creep"},
      {"lateral.to", Kind::Ratio, "1", "", -10, 10, 1e-12, "", "last lateral creep"},
      {"lateral.n", Kind::Integer, "1", "", 1, 1e6, 0, "", "number of them"},
      {"lateral.spacing", Kind::Choice, "1", "linear", 0, 0, 0, "log|linear", "of them"},
      {"spin", Kind::QuantityList, "1/m", "0 1/m", -1e9, 1e9, 1e-12, "",
       "point: spin, turn of the wheel against the rail over the length rolled; a list; or the "
       "keywords below"},
      {"spin.from", Kind::Quantity, "1/m", "", -1e9, 1e9, 1e-12, "", "first spin"},
      {"spin.to", Kind::Quantity, "1/m", "", -1e9, 1e9, 1e-12, "", "last spin"},
      {"spin.n", Kind::Integer, "1", "", 1, 1e6, 0, "", "number of them"},
      {"spin.spacing", Kind::Choice, "1", "linear", 0, 0, 0, "log|linear", "of them"},
      {"force.longitudinal", Kind::QuantityList, "N", "", -1e12, 1e12, 1e-12, "",
       "point: force on the wheel along x; the longitudinal creep is found"},
      {"force.lateral", Kind::QuantityList, "N", "", -1e12, 1e12, 1e-12, "",
       "point: force on the wheel along y; the lateral creep is found"},
      {"sequence.time", Kind::QuantityList, "s", "", 0, 1e9, 1e-12, "",
       "point, mode moving: instants from 0 on, linear between them, static: stages; and at each "
       "of them"},
      {"sequence.load", Kind::QuantityList, "N", "", 1e-12, 1e12, 0, "", "the load"},
      {"sequence.creep", Kind::RatioList, "1", "", -10, 10, 1e-12, "", "the longitudinal creep"},
      {"sequence.lateral", Kind::RatioList, "1", "", -10, 10, 1e-12, "", "the lateral creep"},
      {"sequence.spin", Kind::QuantityList, "1/m", "", -1e9, 1e9, 1e-12, "", "the spin"},
      {"speed", Kind::QuantityList, "m/s", "[10 m/s, 20 m/s, 40 m/s]", 1e-9, 1000, 0, "",
       "rolling speeds v0"},
      {"fields", Kind::TextList, "1", "last", 0, 0, 0, "",
       "points whose fields are written: none, last, all, or numbers of points from 1 on"},
      {"sensitivities", Kind::Switch, "1", "true", 0, 0, 0, "",
       "point: Kalker's coefficients of every contact in summary.json"},
      {"uncertainty.method", Kind::Choice, "1", "linear", 0, 0, 0, "linear|sampled",
       "how a law's covariance makes the band of T/N: by derivatives, or by draws"},
      {"uncertainty.samples", Kind::Integer, "1", "200", 20, 100000, 0, "",
       "laws drawn with method sampled"},
      {"uncertainty.seed", Kind::Integer, "1", "1", 0, 9e15, 0, "", "of the draws"},
  });
  return table;
}

} // namespace wheelrail
