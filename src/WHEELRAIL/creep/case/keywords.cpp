// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case/keywords.h"

#include "law/friction_laws.h"

#include <algorithm>
#include <utility>

namespace wheelrail {
namespace {

using Kind = Keyword::Kind;

/// Puts the rows of the laws after that of friction.law.
std::vector<Keyword> withLaws(std::vector<Keyword> table)
{
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
  static const std::string names = lawNames();
  static const std::vector<Keyword> table = withLaws({
      {"contact.load_per_length", Kind::Quantity, "N/m", "", 1e-6, 1e12, 0, "",
       "normal force per length of the cylinder", scope::line},
      {"contact.load", Kind::QuantityList, "N", "", 1e-12, 1e12, 0, "",
       "normal force: a point contact, a list gives curves for each; or that on "
       "contact.width"},
      {"contact.approach", Kind::QuantityList, "m", "", 1e-12, 1, 0, "",
       "how much nearer than touching the bodies are, in place of contact.load",
       scope::pointFrozen | scope::pointStatic, "rolling is under a load"},
      {"contact.width", Kind::Quantity, "m", "", 1e-9, 1e6, 0, "",
       "length of the cylinder that contact.load presses: a line contact of load/width"},
      {"contact.radius", Kind::Quantity, "m", "", 1e-9, 1e6, 0, "",
       "R of 1/R = 1/R1 + 1/R2 (on a flat rail: of the wheel)", scope::line},
      {"contact.radii.wheel_rolling", Kind::Quantity, "m", "", 1e-9, 1e6, 0, "",
       "rolling radius of the wheel", scope::point},
      {"contact.radii.wheel_profile", Kind::Quantity, "m", "", -1e6, 1e6, 1e-9, "",
       "transverse radius of the wheel, negative where hollow; straight if not given",
       scope::point},
      {"contact.radii.rail_profile", Kind::Quantity, "m", "", -1e6, 1e6, 1e-9, "",
       "transverse radius of the rail, likewise", scope::point},
      {"contact.curvatures", Kind::QuantityList, "1/m", "", 1e-9, 1e9, 0, "",
       "instead of radii: [A, B] of the gap A x^2 + B y^2", scope::point},
      {"contact.semi_axes", Kind::QuantityList, "m", "", 1e-9, 1e3, 0, "",
       "instead of radii: [a, b] of the ellipse, along x and y", scope::point},
      {"contact.youngs_modulus", Kind::QuantityList, "Pa", "", 1, 1e15, 0, "",
       "Young's modulus of both bodies, for the contact, or [wheel, rail]"},
      {"contact.poissons_ratio", Kind::NumberList, "1", "", 0, 0.5, 0, "",
       "Poisson's ratio of both bodies, or [wheel, rail]"},
      {"contact.hardness_limit", Kind::Switch, "1", "false", 0, 0, 0, "",
       "stop the pressure at the hardness, 3 x strength at the temperature reached"},
      {"contact.domain", Kind::Number, "1", "4", 2.1, 1000, 0, "",
       "length that is computed, in Hertz half-widths a; of a point contact the box, in semi-axes"},
      {"contact.box", Kind::QuantityList, "m", "", 1e-9, 1e6, 0, "",
       "lengths [x, y] of the box, in place of contact.domain", scope::point},
      {"contact.cell", Kind::QuantityList, "m", "", 1e-12, 1e3, 0, "",
       "size [x, y] of a cell: the box has as many as cells says", scope::point},
      {"contact.centre", Kind::QuantityList, "m", "[0 m, 0 m]", -1e6, 1e6, 0, "",
       "[x, y] of the middle of the box; the bodies touch at the origin", scope::point},
      {"contact.spin_point", Kind::Number, "1", "0.5", 0, 1, 0, "",
       "place in a cell where the spin's lever ends, 0.5: its middle", scope::point},
      {"contact.edges", Kind::Choice, "1", "whole", 0, 0, 0, "whole|inside",
       "cells count as a whole, or the leading edges lie inside their cells", scope::point},
      {"contact.period", Kind::Quantity, "m", "", 1e-9, 1e3, 0, "",
       "flat surfaces whose roughness repeats after this length", scope::lineStatic,
       "rolling needs a radius"},
      {"layer.thickness", Kind::Quantity, "m", "", 1e-12, 1, 0, "",
       "of a layer between the bodies, which gives way to shear", scope::rolling | scope::point,
       "a layer of a line contact needs rolling"},
      {"layer.shear_modulus", Kind::Quantity, "Pa", "", 1, 1e15, 0, "", "of the layer",
       scope::rolling | scope::point, "a layer of a line contact needs rolling"},
      {"layer.yield_stress", Kind::Quantity, "Pa", "", 1, 1e15, 0, "",
       "shear stress at which the layer flows; it only shears elastically if not given",
       scope::rolling | scope::point, "a layer of a line contact needs rolling"},
      {"cells", Kind::IntegerList, "1", "1024", 8, 1 << 24, 0, "",
       "cells on the whole domain; of a point contact [nx, ny] of its box, or one number"},
      {"roughness", Kind::Choice, "1", "none", 0, 0, 0, "none",
       "none: smooth; otherwise the keywords below"},
      {"roughness.hurst", Kind::Number, "1", "", 0, 1, 0, "",
       "Hurst exponent of a generated profile", scope::everywhere | scope::generated},
      {"roughness.rms_slope", Kind::Number, "1", "", 1e-9, 1, 0, "", "its root mean square slope",
       scope::everywhere | scope::generated},
      {"roughness.rms_height", Kind::Quantity, "m", "", 1e-15, 1, 0, "",
       "its root mean square height, instead of rms_slope", scope::everywhere | scope::generated},
      {"roughness.wavelength_min", Kind::Quantity, "m", "", 1e-12, 1e3, 0, "",
       "its shortest wavelength", scope::everywhere | scope::generated},
      {"roughness.wavelength_max", Kind::Quantity, "m", "", 1e-12, 1e3, 0, "",
       "its longest wavelength", scope::everywhere | scope::generated},
      {"roughness.seed", Kind::IntegerList, "1", "1", 0, 9e15, 0, "",
       "its random numbers; a list gives one creep curve for each",
       scope::everywhere | scope::generated},
      {"roughness.stretch", Kind::Number, "1", "1", 1e-3, 1e3, 0, "",
       "how many times longer features are along x than along y, at the same area",
       scope::point | scope::generated},
      {"roughness.boxes", Kind::Integer, "1", "", 1, 10000, 0, "",
       "period of a generated surface along x, in lengths of the box",
       scope::point | scope::generated},
      {"roughness.rail", Kind::TextList, "1", "", 0, 0, 0, "",
       "measured profile of the rail: file; a list gives one creep curve for each"},
      {"roughness.wheel", Kind::TextList, "1", "", 0, 0, 0, "",
       "measured profile of the wheel: file, or as many as of the rail"},
      {"roughness.cutoff", Kind::Quantity, "m", "", 1e-12, 1e3, 0, "",
       "shorter wavelengths are filtered out of measured profiles",
       scope::everywhere | scope::measured},
      {"roughness.detrend", Kind::Choice, "1", "line", 0, 0, 0, "none|mean|line|parabola",
       "what is taken off measured profiles", scope::everywhere | scope::measured},
      {"roughness.unmeasured", Kind::Choice, "1", "refuse", 0, 0, 0, "refuse|fill",
       "what is done where a measured map has no height", scope::point | scope::measured},
      {"roughness.spacing", Kind::QuantityList, "m", "", 1e-12, 1e3, 0, "",
       "spacing of npy maps, which do not state it; one, or [x, y]",
       scope::point | scope::measured},
      {"roughness.height_unit", Kind::Unit, "m", "", 1e-15, 1e3, 0, "",
       "what a height of 1 in npy maps is: mm, or 0.1 um", scope::point | scope::measured},
      {"roughness.sampling", Kind::Choice, "1", "mean", 0, 0, 0, "mean|cells",
       "heights of measured maps: means over the cells, or those of the points, which are the "
       "cells' centres",
       scope::point | scope::measured},
      {"roughness.turn", Kind::Choice, "1", "none", 0, 0, 0, "none|rail|wheel|both",
       "measured maps whose rows lie across the rolling direction", scope::point | scope::measured},
      {"roughness.mirror", Kind::Choice, "1", "none", 0, 0, 0, "none|rail|wheel|both",
       "measured maps whose y is turned around, as when looking at the wheel",
       scope::point | scope::measured},
      {"friction.law", Kind::Text, "1", Eq2Law::word, 0, 0, 0, "", names.c_str()},
      {"friction.memory_length", Kind::Quantity, "m", "", 1e-9, 1, 0, "",
       "mu falls with the slip of each cell, over that way of sliding; if not given with the one "
       "sliding speed of the contact",
       scope::rolling, "nothing slides on"},
      {"friction.hot_factor", Kind::Number, "1", "1", 0.01, 10, 0, "",
       "any law: mu where the contact is hot over that of the law"},
      {"friction.hot_start", Kind::Quantity, "K", "0 K", 0, 10000, 0, "",
       "temperature rise up to which mu is that of the law"},
      {"friction.hot_end", Kind::Quantity, "K", "600 K", 0.001, 10000, 0, "",
       "temperature rise from which it is hot_factor times that, linear before"},
      {"friction.across_y", Kind::QuantityList, "m", "", -1e3, 1e3, 0, "",
       "places across the contact, and at each of them", scope::point},
      {"friction.across_factor", Kind::NumberList, "1", "", 1e-6, 1e6, 0, "",
       "the factor on the law's mu, linear between them", scope::point},
      {"thermal", Kind::Choice, "1", "", 0, 0, 0, "off",
       "off: no temperature; otherwise the keywords below"},
      {"thermal.conductivity", Kind::QuantityList, "W/(m K)", "50 W/(m K)", 1e-3, 1e4, 0, "",
       "lambda of both bodies, or [wheel, rail]"},
      {"thermal.density", Kind::QuantityList, "kg/m3", "7800 kg/m3", 10, 1e5, 0, "",
       "rho of both bodies, or [wheel, rail]"},
      {"thermal.specific_heat", Kind::QuantityList, "J/(kg K)", "450 J/(kg K)", 1, 1e5, 0, "",
       "c_p of both bodies, or [wheel, rail]"},
      {"thermal.bulk", Kind::QuantityList, "K", "0 K", -1000, 1e5, 0, "",
       "how much warmer than the surroundings both bodies are far away, or [wheel, rail]",
       scope::pointFrozen | scope::pointMoving},
      {"thermal.model", Kind::Choice, "1", "averaged", 0, 0, 0, "averaged|averaged_power|local",
       "averaged: Eq. 11; averaged_power: Eq. 11 with the heat of friction; local: flash "
       "temperature"},
      {"wear.law", Kind::Choice, "1", "none", 0, 0, 0, "none|archard|t_gamma",
       "columns of wear: k p s/H of Archard, or of T gamma/A (Braghin et al. 2006)",
       scope::pointFrozen | scope::pointMoving, "nothing rolls"},
      {"wear.coefficient", Kind::Number, "1", "", 1e-15, 1, 0, "", "k of the wear law archard",
       scope::pointFrozen | scope::pointMoving, "nothing rolls"},
      {"wear.hardness", Kind::Quantity, "Pa", "", 1, 1e15, 0, "",
       "H of the wear law archard, of the body that wears", scope::pointFrozen | scope::pointMoving,
       "nothing rolls"},
      {"wear.density", Kind::Quantity, "kg/m3", "7800 kg/m3", 1e-6, 1e9, 0, "",
       "of the wear law t_gamma, which gives a mass", scope::pointFrozen | scope::pointMoving,
       "nothing rolls"},
      {"mode", Kind::Choice, "1", "frozen", 0, 0, 0, "frozen|moving|static",
       "roughness fixed in the contact frame, travelling with the material; or no rolling"},
      {"moving.passes", Kind::Integer, "1", "4", 2, 1000, 0, "",
       "mode moving: lengths of the nominal contact that are rolled; of a point contact 12 unless "
       "given"},
      {"moving.step", Kind::Integer, "1", "1", 1, 1000, 0, "", "cells that are rolled in a step",
       scope::pointMoving},
      {"moving.reference_length", Kind::Number, "1", "1", 0.6, 1000, 0, "",
       "mode moving: length of the half-plane's free constant, in a",
       scope::everywhere & ~scope::pointMoving, "a point contact has no free constant"},
      {"moving.start", Kind::Choice, "1", "steady", 0, 0, 0, "steady|rest|shift",
       "traction at the start: of steady rolling, none, of one shift under the forces",
       scope::point},
      {"static.force_ratio", Kind::NumberList, "1", "", 0, 0.999999, 1e-12, "",
       "mode static: tangential force T/(mu N), below full sliding"},
      {"static.shift", Kind::QuantityList, "m", "", -1, 1, 1e-15, "",
       "mode static: [x, y] of the wheel against the rail, instead of forces", scope::point},
      {"static.twist", Kind::Number, "1", "0", -1, 1, 1e-15, "",
       "turn (rad) of the wheel against the rail, beside static.shift", scope::pointStatic},
      {"creep", Kind::RatioList, "1", "", -10, 10, -1e-12, "",
       "slip of the wheel over the rolling speed, longitudinal, positive: braking; or the keywords "
       "below"},
      {"creep.from", Kind::Ratio, "1", "", -10, 10, -1e-12, "", "first creep"},
      {"creep.to", Kind::Ratio, "1", "", -10, 10, -1e-12, "", "last creep"},
      {"creep.n", Kind::Integer, "1", "", 1, 1e6, 0, "", "number of creeps"},
      {"creep.spacing", Kind::Choice, "1", "log", 0, 0, 0, "log|linear", "of the creeps"},
      {"lateral", Kind::RatioList, "1", "0", -10, 10, -1e-12, "",
       "lateral creep, sliding/rolling speed; a list; or the keywords below", scope::point},
      {"lateral.from", Kind::Ratio, "1", "", -10, 10, -1e-12, "", "first lateral creep",
       scope::point},
      {"lateral.to", Kind::Ratio, "1", "", -10, 10, -1e-12, "", "last lateral creep", scope::point},
      {"lateral.n", Kind::Integer, "1", "", 1, 1e6, 0, "", "number of them", scope::point},
      {"lateral.spacing", Kind::Choice, "1", "linear", 0, 0, 0, "log|linear", "of them",
       scope::point},
      {"spin", Kind::QuantityList, "1/m", "0 1/m", -1e9, 1e9, -1e-12, "",
       "spin, turn of the wheel against the rail over the length rolled; a list; or the "
       "keywords below",
       scope::point},
      {"spin.from", Kind::Quantity, "1/m", "", -1e9, 1e9, -1e-12, "", "first spin", scope::point},
      {"spin.to", Kind::Quantity, "1/m", "", -1e9, 1e9, -1e-12, "", "last spin", scope::point},
      {"spin.n", Kind::Integer, "1", "", 1, 1e6, 0, "", "number of them", scope::point},
      {"spin.spacing", Kind::Choice, "1", "linear", 0, 0, 0, "log|linear", "of them", scope::point},
      {"force.longitudinal", Kind::QuantityList, "N", "", -1e12, 1e12, 1e-12, "",
       "force on the wheel along x; the longitudinal creep is found", scope::point},
      {"force.lateral", Kind::QuantityList, "N", "", -1e12, 1e12, 1e-12, "",
       "force on the wheel along y; the lateral creep is found", scope::point},
      {"force.per_length", Kind::QuantityList, "N/m", "", -1e12, 1e12, 1e-12, "",
       "T, on the rail, per length of the cylinder; the creep is found", scope::lineFrozen,
       "mode frozen is needed"},
      {"sequence.time", Kind::QuantityList, "s", "", 0, 1e9, 1e-12, "",
       "instants from 0 on, in mode static stages; and at each of them",
       scope::pointMoving | scope::pointStatic, "mode moving or static is needed"},
      {"sequence.load", Kind::QuantityList, "N", "", 1e-12, 1e12, 0, "", "the load",
       scope::pointMoving | scope::pointStatic, "mode moving or static is needed"},
      {"sequence.approach", Kind::QuantityList, "m", "", 0, 1, 1e-12, "",
       "how much nearer than touching the bodies are, in place of the load; 0: under the load",
       scope::pointStatic, "mode static is needed"},
      {"sequence.force_longitudinal", Kind::QuantityList, "N", "", -1e12, 1e12, 1e-12, "",
       "the force on the wheel along x; the longitudinal creep is found",
       scope::pointMoving | scope::pointStatic, "mode moving or static is needed"},
      {"sequence.force_lateral", Kind::QuantityList, "N", "", -1e12, 1e12, 1e-12, "",
       "the force on the wheel along y; the lateral creep is found",
       scope::pointMoving | scope::pointStatic, "mode moving or static is needed"},
      {"sequence.creep", Kind::RatioList, "1", "", -10, 10, -1e-12, "", "the longitudinal creep",
       scope::pointMoving},
      {"sequence.lateral", Kind::RatioList, "1", "", -10, 10, -1e-12, "", "the lateral creep",
       scope::pointMoving},
      {"sequence.spin", Kind::QuantityList, "1/m", "", -1e9, 1e9, -1e-12, "", "the spin",
       scope::pointMoving},
      {"sequence.speed", Kind::QuantityList, "m/s", "", 0, 1000, 1e-9, "",
       "the rolling speed; at one instant it may be 0", scope::pointMoving},
      {"sequence.between", Kind::Choice, "1", "linear", 0, 0, 0, "linear|held",
       "all of them linear between the instants, or held until the next one, so that the last "
       "instant only ends the sequence",
       scope::pointMoving},
      {"sequence.fields", Kind::QuantityList, "s", "", 0, 1e9, 1e-12, "",
       "instants at which the fields of an operating point are written, too",
       scope::pointMoving | scope::pointStatic, "mode moving or static is needed"},
      {"speed", Kind::QuantityList, "m/s", "[10 m/s, 20 m/s, 40 m/s]", 1e-9, 1000, 0, "",
       "rolling speeds v0"},
      {"fields", Kind::TextList, "1", "last", 0, 0, 0, "",
       "operating points whose fields are written: none, last, all, or their numbers from 1 on"},
      {"depths", Kind::QuantityList, "m", "", 1e-9, 1e3, 0, "",
       "depths at which the stresses of these operating points are written; a list; or the "
       "keywords below",
       scope::point},
      {"depths.from", Kind::Quantity, "m", "", 1e-9, 1e3, 0, "", "first depth", scope::point},
      {"depths.to", Kind::Quantity, "m", "", 1e-9, 1e3, 0, "", "last depth", scope::point},
      {"depths.n", Kind::Integer, "1", "", 1, 1000, 0, "", "number of them", scope::point},
      {"depths.spacing", Kind::Choice, "1", "linear", 0, 0, 0, "log|linear", "of them",
       scope::point},
      {"sensitivities", Kind::Switch, "1", "true", 0, 0, 0, "",
       "Kalker's coefficients of every contact that rolls in summary.json", scope::point},
      {"uncertainty.method", Kind::Choice, "1", "linear", 0, 0, 0, "linear|sampled",
       "how a law's covariance makes the band of T/N: by derivatives, or by draws",
       scope::everywhere & ~scope::pointStatic, "it has no band"},
      {"uncertainty.samples", Kind::Integer, "1", "200", 20, 100000, 0, "",
       "laws drawn with method sampled", scope::everywhere & ~scope::pointStatic, "it has no band"},
      {"uncertainty.seed", Kind::Integer, "1", "1", 0, 9e15, 0, "", "of the draws",
       scope::everywhere & ~scope::pointStatic, "it has no band"},
  });
  return table;
}

const std::vector<Exclusion> &exclusions()
{
  using namespace scope;
  static const std::vector<Exclusion> table = {
      {"contact.width", "contact.load_per_length", "contact.load is spread over it", line},
      {"contact.approach", "contact.load", "the load is found", point},
      {"contact.approach", "sequence.load", "the load is found", point},
      {"contact.approach", "sequence.approach", "its stages begin under a load", point},
      {"contact.cell", "contact.domain", "cells and their number decide the box", point},
      {"contact.cell", "contact.box", "cells and their number decide the box", point},
      {"contact.box", "contact.domain", "", point},
      {"contact.period", "contact.radius", "the surfaces are flat", line},
      {"contact.period", "contact.domain", "the surfaces are flat", line},
      {"force.per_length", "creep", "the creep is found", line},
      {"force.longitudinal", "creep", "the creep is found", point},
      {"force.longitudinal", "sequence.creep", "the creep is found", point},
      {"force.lateral", "lateral", "the lateral creep is found", point},
      {"force.lateral", "sequence.lateral", "the lateral creep is found", point},
      {"sequence.force_longitudinal", "force.longitudinal", "", pointMoving | pointStatic},
      {"sequence.force_longitudinal", "creep", "the creep is found", pointMoving},
      {"sequence.force_longitudinal", "sequence.creep", "the creep is found", pointMoving},
      {"sequence.force_lateral", "force.lateral", "", pointMoving | pointStatic},
      {"sequence.force_lateral", "lateral", "the lateral creep is found", pointMoving},
      {"sequence.force_lateral", "sequence.lateral", "the lateral creep is found", pointMoving},
      {"sequence.force_longitudinal", "static.force_ratio", "", pointStatic},
      {"sequence.force_lateral", "static.force_ratio", "", pointStatic},
      {"sequence.speed", "speed", "", pointMoving},
      {"sequence", "moving.passes", "its last instant ends the rolling", pointMoving},
      {"sequence.creep", "creep", "", pointMoving},
      {"sequence.lateral", "lateral", "", pointMoving},
      {"sequence.spin", "spin", "", pointMoving},
      {"sequence", "static.shift", "a force ratio or forces", pointStatic}};
  return table;
}

std::string presentName(const std::string &name)
{
  return name == "points" ? "cells" : name;
}

std::string scopeWords(const Keyword &keyword)
{
  const Scope onLine = keyword.scope & scope::line, onPoint = (keyword.scope & scope::point) / 8;
  const Scope modes = onLine ? onLine : onPoint;
  std::string contact = onLine ? "line contact" : "point contact";
  if (onLine == onPoint)
    contact.clear();
  else if (onLine && onPoint)
    return "";
  if (modes == scope::line)
    return contact.empty() ? "" : contact + ": ";
  if (!contact.empty())
    contact += ", ";
  std::string words;
  for (const auto &[bit, name] : {std::pair{scope::lineFrozen, "frozen"},
                                  {scope::lineMoving, "moving"},
                                  {scope::lineStatic, "static"}})
    if (modes & bit)
      words += (words.empty() ? "" : " or ") + std::string(name);
  return contact + "mode " + words + ": ";
}

} // namespace wheelrail
