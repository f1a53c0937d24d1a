// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case/common_groups.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <stdexcept>

namespace wheelrail {
namespace {

/// What a list of keywords that decide one thing is called in a message, and which of them is
/// there.
std::string onlyOne(const CaseReader &reader, const std::vector<std::string> &names)
{
  std::string given;
  for (const std::string &name : names) {
    if (!reader.has(name) && !reader.hasGroup(name))
      continue;
    if (!given.empty())
      reader.fail(name, "does not go with " + given);
    given = name;
  }
  return given;
}

double radiusOf(CaseReader &reader, const std::string &name)
{
  if (!reader.has(name))
    return std::numeric_limits<double>::infinity();
  const double radius = reader.number(name);
  if (radius == 0.0)
    reader.fail(name, "'0' is not allowed; positive, or negative where hollow");
  return radius;
}

/// Ellipses that are almost a line are beyond the series of their integrals.
void requireRatio(const CaseReader &reader, const std::string &name, const char *what, double ratio,
                  double most)
{
  if (!(ratio >= 1.0 / most && ratio <= most))
    reader.fail(name,
                fmt::format("{} = {:.3g} is not in the allowed range [{}, {}]; a line contact "
                            "has contact.load_per_length",
                            what, ratio, 1.0 / most, most));
}

void readShape(CaseReader &reader, PatchContactSpecification &contact)
{
  const std::string shape =
      onlyOne(reader, {"contact.radii", "contact.curvatures", "contact.semi_axes"});
  if (shape.empty())
    reader.fail("contact.radii", "is missing: radii, curvatures or semi_axes are needed beside "
                                 "contact.load");
  if (shape == "contact.semi_axes") {
    contact.semiAxes = readPair(reader, shape, "[a, b]");
    requireRatio(reader, shape, "a/b", contact.semiAxes[0] / contact.semiAxes[1], 1e4);
    if (contact.load.size() > 1)
      reader.fail(
          shape, fmt::format("goes with one {}; give radii or curvatures for several",
                             reader.has("contact.approach") ? "contact.approach" : "contact.load"));
    if (!contact.approach.empty()) // Hertz: of a given ellipse they are proportional
      contact.load = {contact.approach.front() / contact.hertz(1.0).approach};
    // the sequence's loads need the curvatures
    contact.curvatures = contact.hertz(contact.load.front()).curvatures;
  } else if (shape == "contact.curvatures") {
    const auto [A, B] = readPair(reader, shape, "[A, B]");
    contact.curvatures = GapCurvatures{A, B};
  } else {
    reader.require("contact.radii.wheel_rolling");
    contact.curvatures = gapOfRadii(reader.number("contact.radii.wheel_rolling"),
                                    radiusOf(reader, "contact.radii.wheel_profile"),
                                    radiusOf(reader, "contact.radii.rail_profile"));
    if (!(contact.curvatures->B > 0.0))
      reader.fail("contact.radii",
                  fmt::format("the transverse curvatures add up to {:g} 1/m; above 0 is needed "
                              "(for two straight profiles there is contact.load_per_length)",
                              2.0 * contact.curvatures->B));
  }
  requireRatio(reader, shape, "A/B", contact.curvatures->A / contact.curvatures->B, 1e6);
  if (shape != "contact.semi_axes")
    for (std::size_t k = 0; k < contact.approach.size(); ++k)
      contact.load[k] = std::pow(contact.approach[k] / contact.hertz(1.0).approach, 1.5); // Hertz
}

/// The box, if it does not follow from the ellipse, and where it lies.
void readBox(CaseReader &reader, PatchContactSpecification &contact)
{
  if (reader.has("contact.centre"))
    contact.centre = readPair(reader, "contact.centre", "[x, y]");
  const bool cells = reader.has("contact.cell");
  if (!cells && !reader.has("contact.box"))
    return;
  const char *name = cells ? "contact.cell" : "contact.box";
  std::array<double, 2> box = readPair(reader, name, "[x, y]");
  if (cells)
    box = {box[0] * contact.nx, box[1] * contact.ny};
  contact.box = box;
  for (double load : contact.load) {
    const HertzEllipse hertz = contact.hertz(load);
    const double across =
        2.0 * std::min(hertz.a * contact.nx / box[0], hertz.b * contact.ny / box[1]);
    if (across < fewestCellsAcross)
      reader.fail(name, fmt::format("{:.3g} cells for the width of the contact of {:.4g} x {:.4g} "
                                    "mm; at least {} are needed",
                                    across, 2e3 * hertz.a, 2e3 * hertz.b, fewestCellsAcross));
  }
}

/// How the law's mu changes across the contact.
void readAcross(CaseReader &reader, PatchContactSpecification &contact)
{
  if (!reader.has("friction.across_y") && !reader.has("friction.across_factor"))
    return;
  for (const char *name : {"friction.across_y", "friction.across_factor"})
    reader.require(name);
  contact.acrossY = reader.numbers("friction.across_y");
  contact.acrossFactor = reader.numbers("friction.across_factor");
  if (contact.acrossFactor.size() != contact.acrossY.size())
    reader.fail("friction.across_factor",
                fmt::format("{} values; one for each of the {} places of friction.across_y is "
                            "expected",
                            contact.acrossFactor.size(), contact.acrossY.size()));
  if (std::adjacent_find(contact.acrossY.begin(), contact.acrossY.end(), std::greater_equal<>()) !=
      contact.acrossY.end())
    reader.fail("friction.across_y", "places that increase are expected");
}

void readPoints(CaseReader &reader, PatchContactSpecification &contact)
{
  constexpr int most = 1 << 14; // a side
  reader.setDefault("cells", "128");
  const std::vector<double> points = reader.numbers("cells");
  if (points.size() > 2)
    reader.fail("cells",
                fmt::format("{} values; [nx, ny] or one number is expected", points.size()));
  contact.nx = static_cast<int>(std::min<double>(points.front(), most + 1));
  contact.ny = static_cast<int>(std::min<double>(points.back(), most + 1));
  if (std::max(contact.nx, contact.ny) > most)
    reader.fail("cells", fmt::format("more than {} cells along a side of the box", most));
  if (!reader.has("contact.box") && !reader.has("contact.cell"))
    requireCellsInContact(reader, std::min(contact.nx, contact.ny), contact.domain);
}

PatchContactSpecification readContact(CaseReader &reader, bool rough)
{
  PatchContactSpecification contact;
  if (reader.has("contact.approach")) {
    contact.approach = reader.numbers("contact.approach");
    contact.load.assign(contact.approach.size(), 1.0); // found in `readShape`
  } else {
    contact.load = reader.numbers("contact.load");
  }
  contact.bodies = readElasticBodies(reader);
  readShape(reader, contact);
  // rough contact reaches further than the smooth one
  if (!reader.has("contact.box") && !reader.has("contact.cell")) {
    reader.setDefault("contact.domain", rough ? "3.4" : "2.2");
    contact.domain = reader.number("contact.domain");
  }
  readPoints(reader, contact);
  readBox(reader, contact);
  readAcross(reader, contact);
  contact.spinPoint = reader.number("contact.spin_point");
  contact.layer = readLayer(reader);
  contact.edgesInside = reader.word("contact.edges") == "inside";
  return contact;
}

/// What some files do not know of themselves.
void readScale(CaseReader &reader, const RoughPatchSpecification &surface, HeightMapScale &scale)
{
  if (std::all_of(surface.rail.begin(), surface.rail.end(), statesLengths) &&
      std::all_of(surface.wheel.begin(), surface.wheel.end(), statesLengths)) {
    const auto isMissing = [](const std::string &path) {
      std::error_code ignored;
      return !std::filesystem::exists(path, ignored);
    };
    const bool someMissing = std::any_of(surface.rail.begin(), surface.rail.end(), isMissing) ||
                             std::any_of(surface.wheel.begin(), surface.wheel.end(), isMissing);
    for (const char *name : {"roughness.spacing", "roughness.height_unit"})
      if (!someMissing)
        reader.refuse(name, "maps that state it themselves; it is for npy files");
      else if (reader.has(name)) // the file is refused when it is read
        reader.numbers(name);
    return;
  }
  for (const char *name : {"roughness.spacing", "roughness.height_unit"})
    reader.require(name);
  const std::vector<double> spacing = reader.numbers("roughness.spacing");
  if (spacing.size() > 2)
    reader.fail("roughness.spacing",
                fmt::format("{} values; one, or two for x and y, are expected", spacing.size()));
  scale = {spacing.front(), spacing.back(), reader.number("roughness.height_unit")};
}

void readMeasured(CaseReader &reader, const std::string &caseFile, RoughPatchSpecification &surface)
{
  surface.kind = RoughnessKind::Measured;
  const MeasuredSurfaces measured = readMeasuredSurfaces(reader, caseFile);
  surface.rail = measured.rail;
  surface.wheel = measured.wheel;
  HeightMapPreparation common;
  common.cutoff = measured.cutoff;
  constexpr Form forms[] = {Form::None, Form::Mean, Form::Plane, Form::SecondOrder};
  common.form = forms[measured.detrend];
  common.fill = reader.word("roughness.unmeasured") == "fill";
  common.pointwise = reader.word("roughness.sampling") == "cells";
  readScale(reader, surface, common.scale);
  surface.railMap = surface.wheelMap = common;
  const std::string turn = reader.word("roughness.turn"), mirror = reader.word("roughness.mirror");
  surface.railMap.turn = turn == "rail" || turn == "both";
  surface.wheelMap.turn = turn == "wheel" || turn == "both";
  surface.railMap.mirror = mirror == "rail" || mirror == "both";
  surface.wheelMap.mirror = mirror == "wheel" || mirror == "both";
  for (const auto &[keyword, word] :
       {std::pair{"roughness.turn", turn}, {"roughness.mirror", mirror}})
    for (const char *body : {"rail", "wheel"})
      if ((word == body || word == "both") && !reader.has(fmt::format("roughness.{}", body)))
        reader.fail(keyword, fmt::format("{} needs roughness.{}, which is not given", word, body));
}

void readFractal(CaseReader &reader, RoughPatchSpecification &surface)
{
  surface.kind = RoughnessKind::Fractal;
  FractalPatch &fractal = surface.fractal;
  surface.seeds = readFractalWaves(reader, fractal);
  fractal.stretch = reader.number("roughness.stretch");
  if (reader.has("roughness.boxes"))
    surface.boxes = reader.integer("roughness.boxes");
}

RoughPatchSpecification readRoughness(CaseReader &reader, const std::string &caseFile)
{
  RoughPatchSpecification surface;
  if (!reader.hasGroup("roughness"))
    reader.words("roughness");
  else if (reader.has("roughness.rail") || reader.has("roughness.wheel"))
    readMeasured(reader, caseFile, surface);
  else
    readFractal(reader, surface);
  return surface;
}

/// Creepages, or the forces in their place.
/// A list that is not read (mode static, or a sequence has its own) holds one 0, so that the loops
/// over the points run once.
void readDrive(CaseReader &reader, PatchSpecification &patch)
{
  // of a sequence the last force stands for the operating point
  const PatchSequence &sequence = patch.sequence;
  if (!sequence.forceX.empty()) {
    patch.forceX = {sequence.forceX.back()};
  } else if (reader.has("force.longitudinal")) {
    patch.forceX = reader.numbers("force.longitudinal");
  } else if (patch.mode != PatchMode::Static && !reader.has("sequence.creep")) {
    patch.creep = readSeries(reader, "creep");
  } else {
    patch.creep = {0.0};
  }
  if (!sequence.forceY.empty()) {
    patch.forceY = {sequence.forceY.back()};
  } else if (reader.has("force.lateral")) {
    patch.forceY = reader.numbers("force.lateral");
  } else {
    patch.lateral =
        patch.mode == PatchMode::Static ? std::vector<double>{0.0} : readSeries(reader, "lateral");
  }
  patch.spin =
      patch.mode == PatchMode::Static ? std::vector<double>{0.0} : readSeries(reader, "spin");
}

std::vector<double> readColumn(CaseReader &reader, const std::string &name, std::size_t instants)
{
  if (!reader.has(name))
    return {};
  std::vector<double> values = reader.numbers(name);
  if (values.size() != instants)
    reader.fail(name, fmt::format("{} values; one for each of the {} instants of sequence.time is "
                                  "expected",
                                  values.size(), instants));
  return values;
}

/// Speeds with which a wheel gets on: it may be at rest for an instant, not from one to the next.
void checkSpeeds(const CaseReader &reader, const PatchSequence &sequence)
{
  for (std::size_t k = 0; k + 1 < sequence.speed.size(); ++k)
    if (sequence.speed[k] == 0.0 && (sequence.held || sequence.speed[k + 1] == 0.0))
      reader.fail("sequence.speed",
                  fmt::format("'0' from instant {} to the next: the wheel would not roll; mode "
                              "static is for what does not",
                              k + 1));
}

PatchSequence readSequence(CaseReader &reader, bool rolls)
{
  PatchSequence sequence;
  if (!reader.hasGroup("sequence"))
    return sequence;
  reader.require("sequence.time");
  sequence.time = reader.numbers("sequence.time");
  if (sequence.time.size() < 2 || sequence.time.front() != 0.0 ||
      std::adjacent_find(sequence.time.begin(), sequence.time.end(), std::greater_equal<>()) !=
          sequence.time.end())
    reader.fail("sequence.time", "at least two instants are needed, from 0 on, that increase");
  const std::size_t n = sequence.time.size();
  sequence.load = readColumn(reader, "sequence.load", n);
  sequence.approach = readColumn(reader, "sequence.approach", n);
  sequence.creep = readColumn(reader, "sequence.creep", n);
  sequence.lateral = readColumn(reader, "sequence.lateral", n);
  sequence.spin = readColumn(reader, "sequence.spin", n);
  sequence.forceX = readColumn(reader, "sequence.force_longitudinal", n);
  sequence.forceY = readColumn(reader, "sequence.force_lateral", n);
  sequence.speed = readColumn(reader, "sequence.speed", n);
  if (rolls)
    sequence.held = reader.word("sequence.between") == "held";
  checkSpeeds(reader, sequence);
  if (reader.has("sequence.fields") && reader.word("fields") != "none")
    sequence.fields = reader.numbers("sequence.fields");
  if (std::adjacent_find(sequence.fields.begin(), sequence.fields.end(), std::greater_equal<>()) !=
          sequence.fields.end() ||
      (!sequence.fields.empty() && sequence.fields.back() > sequence.time.back()))
    reader.fail("sequence.fields",
                fmt::format("instants that increase, up to the last of sequence.time, {:g} s, are "
                            "expected",
                            sequence.time.back()));
  return sequence;
}

void readMoving(CaseReader &reader, PatchSpecification &patch)
{
  patch.sequence = readSequence(reader, true);
  if (!patch.sequence.speed.empty() && patch.physics.thermal.model == ThermalModel::Local)
    reader.fail("sequence.speed", "does not go with thermal.model local, which has one speed");
  if (!patch.sequence.any()) {
    reader.setDefault("moving.passes", "12"); // ten of them make a standard error
    patch.moving.passes = reader.integer("moving.passes");
  }
  patch.moving.stepCells = reader.integer("moving.step");
  if (patch.moving.stepCells > 1) {
    if (patch.physics.thermal.model == ThermalModel::Local)
      reader.fail("moving.step",
                  "does not go with thermal.model local: heat goes from cell to cell");
    if (patch.physics.memoryLength > 0.0)
      reader.fail("moving.step", "does not go with friction.memory_length: material takes its "
                                 "memory from cell to cell");
    if (patch.contact.edgesInside)
      reader.fail("moving.step", "does not go with contact.edges inside");
  }
  const std::string start = reader.word("moving.start");
  patch.moving.start = start == "steady" ? RollingStart::Steady
                       : start == "rest" ? RollingStart::Rest
                                         : RollingStart::Shift;
  const bool givesForce =
      reader.hasGroup("force") || !patch.sequence.forceX.empty() || !patch.sequence.forceY.empty();
  if (patch.moving.start == RollingStart::Shift && !givesForce)
    reader.fail("moving.start", "'shift' needs force.longitudinal or force.lateral, or those of "
                                "sequence");
}

/// Surroundings whose temperature no law knows count as those that a law of a material has unless
/// given.
void checkBulk(CaseReader &reader, const LawChoice &friction)
{
  if (!reader.has("thermal.bulk"))
    return;
  const char *const keyword = "friction.ambient";
  const double ambient = friction.hasStrength ? reader.number(keyword) : reader.initial(keyword);
  const std::vector<double> &bulk = reader.numbers("thermal.bulk");
  for (std::size_t k = 0; k < bulk.size(); ++k)
    if (!(ambient + bulk[k] > 0.0))
      reader.fail("thermal.bulk",
                  fmt::format("'{}', allowed: above {:g} K, absolute zero in surroundings of {:g} K"
                              "{}",
                              reader.words("thermal.bulk")[k], -ambient, ambient,
                              friction.hasStrength ? " (friction.ambient)" : ""));
}

WearLaw readWear(CaseReader &reader)
{
  WearLaw wear;
  const std::string law = reader.word("wear.law");
  if (law != "archard")
    for (const char *name : {"wear.coefficient", "wear.hardness"})
      reader.refuse(name, "wear.law: " + law + "; it is for archard");
  if (law == "archard") {
    wear.kind = WearLaw::Kind::Archard;
    wear.coefficient = reader.number("wear.coefficient");
    wear.hardness = reader.number("wear.hardness");
  } else if (law == "t_gamma") {
    wear.kind = WearLaw::Kind::TGamma;
    wear.density = reader.number("wear.density");
  }
  return wear;
}

void readStatic(CaseReader &reader, PatchSpecification &patch)
{
  patch.physics.thermal.model = ThermalModel::Off;
  patch.sequence = readSequence(reader, false);
  const bool givesForce = !patch.sequence.forceX.empty() || !patch.sequence.forceY.empty();
  if (patch.sequence.any() && !givesForce && patch.sequence.approach.empty())
    reader.require("sequence.load");
  const std::string given = onlyOne(reader, {"static.force_ratio", "static.shift", "force"});
  if (given.empty() && !givesForce)
    reader.fail("static.force_ratio", "is missing: a force ratio, a shift (static.shift) or forces "
                                      "(force) are needed in mode static");
  if (given == "static.force_ratio")
    patch.forceRatio = reader.numbers(given);
  if (given == "static.shift")
    patch.shift.push_back(readPair(reader, given, "[x, y]"));
  if (reader.has("static.twist")) {
    if (patch.shift.empty())
      reader.fail("static.twist", "needs static.shift; [0 m, 0 m] is allowed");
    patch.twist = reader.number("static.twist");
  }
}

} // namespace

PatchSpecification readPatch(CaseReader &reader, const std::string &caseFile)
{
  PatchSpecification patch;
  patch.roughness = readRoughness(reader, caseFile);
  patch.contact = readContact(reader, patch.roughness.kind != RoughnessKind::None);
  patch.physics.hardnessLimit = reader.flag("contact.hardness_limit");
  patch.friction = readFriction(reader, caseFile);
  patch.physics.strength = readStrength(reader, patch.friction, patch.physics.hardnessLimit);
  const std::string mode = reader.word("mode");
  patch.mode = mode == "frozen"   ? PatchMode::Frozen
               : mode == "moving" ? PatchMode::Moving
                                  : PatchMode::Static;
  if (patch.mode == PatchMode::Static) {
    readStatic(reader, patch);
  } else {
    patch.physics.thermal = readThermal(reader, true);
    checkBulk(reader, patch.friction);
    patch.physics.wear = readWear(reader);
    patch.physics.memoryLength = readMemoryLength(reader);
    patch.spread = readSpread(reader, patch.friction);
    patch.sensitivities = reader.flag("sensitivities");
  }
  if (patch.mode == PatchMode::Moving)
    readMoving(reader, patch);
  readDrive(reader, patch);
  const std::vector<double> &speeds = patch.sequence.speed;
  if (!speeds.empty()) // one operating point; its speeds are the sequence's
    patch.speed = {*std::max_element(speeds.begin(), speeds.end())};
  else if (patch.mode != PatchMode::Static)
    patch.speed = reader.numbers("speed");
  double points = double(patch.roughness.surfaces());
  for (const auto *list : {&patch.contact.load, &patch.speed, &patch.spin, &patch.lateral,
                           &patch.forceY, &patch.creep, &patch.forceX, &patch.forceRatio})
    points *= double(std::max<std::size_t>(1, list->size()));
  requireFewPoints(reader, points);
  patch.fields = readFields(reader, patchTasks(patch).size());
  if (patch.fields.kind != FieldSelection::Kind::None &&
      (reader.has("depths") || reader.hasGroup("depths")))
    patch.depths = readSeries(reader, "depths");
  return patch;
}

} // namespace wheelrail
