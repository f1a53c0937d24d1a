// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case/case_file.h"

#include "base/checksum.h"
#include "base/program_files.h"
#include "creep/case/case_scope.h"
#include "creep/case/common_groups.h"
#include "creep/line/line_task.h"
#include "creep/patch/patch_task.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <yaml-cpp/yaml.h>

namespace wheelrail {
namespace {

/// N/m, given as such or as a load on a width.
double readLoadPerLength(CaseReader &reader)
{
  if (!reader.has("contact.width")) {
    reader.require("contact.load_per_length");
    return reader.number("contact.load_per_length");
  }
  if (!reader.has("contact.load"))
    reader.fail("contact.width", "needs contact.load, which is spread over it, in place of "
                                 "contact.load_per_length");
  return reader.single("contact.load") / reader.number("contact.width");
}

LineContactSpecification readContact(CaseReader &reader)
{
  LineContactSpecification contact;
  contact.load = readLoadPerLength(reader);
  if (reader.has("contact.period")) {
    contact.period = reader.number("contact.period");
    contact.radius = std::numeric_limits<double>::infinity();
  } else {
    contact.radius = reader.number("contact.radius");
    contact.domain = reader.number("contact.domain");
  }
  contact.bodies = readElasticBodies(reader);
  contact.layer = readLayer(reader);
  contact.points = static_cast<int>(reader.single("cells"));
  constexpr int fewestPoints = 32;
  if (contact.points < fewestPoints)
    reader.fail("cells", fmt::format("'{}' is not in the allowed range of a line contact, [{}, "
                                     "16777216]",
                                     contact.points, fewestPoints));
  if (contact.period == 0.0)
    requireCellsInContact(reader, contact.points, contact.domain);
  return contact;
}

void readMeasured(CaseReader &reader, const std::string &caseFile, SurfaceSpecification &surface)
{
  surface.kind = RoughnessKind::Measured;
  const MeasuredSurfaces measured = readMeasuredSurfaces(reader, caseFile);
  surface.rail = measured.rail;
  surface.wheel = measured.wheel;
  surface.cutoff = measured.cutoff;
  surface.detrend = measured.detrend - 1;
}

void readFractal(CaseReader &reader, SurfaceSpecification &surface)
{
  surface.kind = RoughnessKind::Fractal;
  surface.seeds = readFractalWaves(reader, surface.fractal);
}

SurfaceSpecification readSurface(CaseReader &reader, const std::string &caseFile)
{
  SurfaceSpecification surface;
  if (!reader.hasGroup("roughness"))
    reader.words("roughness");
  else if (reader.has("roughness.rail") || reader.has("roughness.wheel"))
    readMeasured(reader, caseFile, surface);
  else
    readFractal(reader, surface);
  return surface;
}

CreepSpecification readRolling(CaseReader &reader, const std::string &mode,
                               const LineContactSpecification &contact,
                               const SurfaceSpecification &surface, const LawChoice &friction,
                               const CreepPhysics &physics)
{
  CreepSpecification rolling;
  rolling.contact = contact;
  rolling.surface = surface;
  rolling.friction = friction;
  rolling.physics = physics;
  rolling.mode = mode == "moving" ? RollingMode::Moving : RollingMode::Frozen;
  rolling.physics.thermal = readThermal(reader, false);
  rolling.physics.memoryLength = readMemoryLength(reader);
  rolling.speed = reader.numbers("speed");
  if (reader.has("force.per_length"))
    rolling.force = reader.numbers("force.per_length");
  else
    rolling.creep = readSeries(reader, "creep");
  requireFewPoints(reader, double(rolling.drives().size()) * double(rolling.speed.size()) *
                               double(surface.profiles()));
  if (rolling.mode == RollingMode::Moving) {
    rolling.moving.passes = reader.integer("moving.passes");
    rolling.moving.referenceLength = reader.number("moving.reference_length");
  }
  rolling.spread = readSpread(reader, friction);
  rolling.fields = readFields(reader, rolling.drives().size() * rolling.speed.size() *
                                          rolling.surface.profiles());
  return rolling;
}

/// What rolling needs, temperature included, is left alone: nothing slides for long.
StaticSpecification readStatic(CaseReader &reader, const LineContactSpecification &contact,
                               const SurfaceSpecification &surface, const LawChoice &friction,
                               const CreepPhysics &physics)
{
  if (couplingOf(contact.bodies) != 0.0)
    reader.fail("contact.youngs_modulus",
                "mode static of a line contact needs bodies whose pressure and traction do not "
                "influence each other: (1 - 2 nu)/G of [wheel, rail] must be the same; a point "
                "contact takes all");
  StaticSpecification still{contact, surface, friction, physics, {}, {}};
  still.physics.thermal.model = ThermalModel::Off;
  reader.require("static.force_ratio");
  still.forceRatio = reader.numbers("static.force_ratio");
  if (friction.cellwise)
    reader.fail(friction.cellwise->keyword,
                fmt::format("mode static needs one friction coefficient for the whole contact: {}",
                            friction.cellwise->needed));
  if (physics.hardnessLimit &&
      *std::max_element(still.forceRatio.begin(), still.forceRatio.end()) > 0.0)
    reader.fail("contact.hardness_limit",
                "mode static needs elastic contact, false, for a static.force_ratio above 0");
  still.fields = readFields(reader, still.forceRatio.size() * still.surface.profiles());
  return still;
}

/// A rolling case may be made static by one change, moving roughness frozen, sampled errors linear,
/// a law of friction another one with fewer keywords, the pressure free of the strength, fields
/// none, which has no depths and no instants: what the file says of them may stay then.
void refuseUnused(CaseReader &reader, Scope here)
{
  const bool isStatic = (here & (scope::lineStatic | scope::pointStatic)) != 0;
  if (isStatic && reader.has("thermal"))
    reader.word("thermal"); // off, as it is
  reader.refuseUnused([&](const std::string &name) {
    const std::string group = name.substr(0, name.find('.'));
    const bool newLaw = reader.isChanged("friction.law");
    if (reader.isChanged("mode") && (isStatic || group == "moving"))
      return true;
    if (group == "friction")
      return newLaw || reader.isChanged("contact.hardness_limit");
    if (group == "uncertainty")
      return newLaw || reader.isChanged("uncertainty.method");
    return (group == "depths" || name == "sequence.fields") && reader.isChanged("fields");
  });
}

/// What has been read, in the words of the physics.
/// \param path of the case file, beside which others may lie; empty: there is none
Case caseOf(CaseReader &reader, const std::string &path)
{
  const Scope here = scopeOf(reader);
  checkScope(reader, here);
  Case result;
  result.path = path;
  if (here & scope::point) {
    result.task = readPatch(reader, path);
    refuseUnused(reader, here);
    result.text = reader.configuration();
    return result;
  }
  const LineContactSpecification contact = readContact(reader);
  const SurfaceSpecification surface = readSurface(reader, path);
  CreepPhysics physics;
  physics.hardnessLimit = reader.flag("contact.hardness_limit");
  const LawChoice friction = readFriction(reader, path);
  physics.strength = readStrength(reader, friction, physics.hardnessLimit);
  const std::string mode = reader.word("mode");
  if (mode == "static")
    result.task = readStatic(reader, contact, surface, friction, physics);
  else
    result.task = readRolling(reader, mode, contact, surface, friction, physics);
  refuseUnused(reader, here);
  result.text = reader.configuration();
  return result;
}

Case changed(CaseReader &reader, const std::string &path, const YAML::Node &changes)
{
  for (const auto &pair : changes)
    reader.change(pair.first.as<std::string>(), pair.second);
  return caseOf(reader, path);
}

} // namespace

std::unique_ptr<CreepTask> Case::open() const
{
  return std::visit([](const auto &asked) { return taskOf(asked); }, task);
}

std::vector<std::string> Case::files() const
{
  const std::unique_ptr<CreepTask> opened = open();
  std::vector<std::string> files = opened->files();
  const std::vector<std::string> &ofLaw = opened->friction().files;
  files.insert(files.begin(), ofLaw.begin(), ofLaw.end());
  return files;
}

std::vector<std::string> Case::inputs() const
{
  std::vector<std::string> all = files();
  all.push_back(path);
  return all;
}

std::string Case::identity() const
{
  std::string identity = text;
  for (const std::string &file : files()) {
    const std::string content = readInputFile(file);
    identity += fmt::format("{}: {} bytes, {}\n", file, content.size(), checksum(content));
  }
  return identity;
}

Case readCase(const std::string &path, const std::vector<std::string> &changes)
{
  CaseReader reader(path);
  reader.readFile();
  for (const std::string &change : changes)
    reader.change(change);
  return caseOf(reader, path);
}

Case readChangedCase(const std::string &path, const YAML::Node &changes)
{
  CaseReader reader(path);
  reader.readFile();
  return changed(reader, path, changes);
}

Case caseOfText(const std::string &name, const std::string &text)
{
  CaseReader reader(name);
  reader.readText(text);
  return caseOf(reader, "");
}

Case caseOfTree(const std::string &name, const YAML::Node &tree, const YAML::Node &changes)
{
  CaseReader reader(name);
  reader.readTree(tree);
  return changed(reader, "", changes);
}

Case caseOfTree(const std::string &name, const YAML::Node &tree)
{
  return caseOfTree(name, tree, YAML::Node(YAML::NodeType::Map));
}

} // namespace wheelrail
