// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case_file.h"

#include "creep/case_parts.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {
namespace {

LineContactSpecification readContact(CaseReader &reader)
{
  reader.refuse({"contact.radii", "contact.curvatures", "contact.semi_axes", "contact.spin_point",
                 "lateral", "spin", "force", "sequence", "roughness.stretch", "roughness.boxes",
                 "roughness.unmeasured", "roughness.spacing", "roughness.height_unit",
                 "roughness.turn", "roughness.mirror", "moving.start", "static.shift", "fields",
                 "sensitivities"},
                "a line contact (contact.load_per_length)");
  for (const char *name :
       {"contact.load_per_length", "contact.youngs_modulus", "contact.poissons_ratio"})
    reader.require(name);
  LineContactSpecification contact;
  contact.load = reader.number("contact.load_per_length");
  if (reader.has("contact.period")) {
    reader.refuse({"contact.radius", "contact.domain"}, "contact.period: the surfaces are flat");
    contact.period = reader.number("contact.period");
    contact.radius = std::numeric_limits<double>::infinity();
  } else {
    contact.radius = reader.number("contact.radius");
    contact.domain = reader.number("contact.domain");
  }
  contact.youngsModulus = reader.single("contact.youngs_modulus");
  contact.poissonsRatio = reader.single("contact.poissons_ratio");
  contact.points = static_cast<int>(reader.single("points"));
  constexpr int fewestPoints = 32;
  if (contact.points < fewestPoints)
    reader.fail("points", fmt::format("'{}' is not in the allowed range of a line contact, [{}, "
                                      "16777216]",
                                      contact.points, fewestPoints));
  return contact;
}

void readMeasured(CaseReader &reader, const std::string &caseFile, SurfaceSpecification &surface)
{
  reader.refuse({"roughness.hurst", "roughness.rms_slope", "roughness.rms_height",
                 "roughness.wavelength_min", "roughness.wavelength_max", "roughness.seed"},
                "measured profiles (roughness.rail, roughness.wheel)");
  surface.kind = RoughnessKind::Measured;
  if (reader.has("roughness.rail"))
    surface.rail = reader.words("roughness.rail");
  if (reader.has("roughness.wheel"))
    surface.wheel = reader.words("roughness.wheel");
  if (!surface.rail.empty() && !surface.wheel.empty() &&
      surface.rail.size() != surface.wheel.size())
    reader.fail("roughness.wheel",
                fmt::format("{} files; as many as of roughness.rail, {}, are expected",
                            surface.wheel.size(), surface.rail.size()));
  for (auto *files : {&surface.rail, &surface.wheel})
    for (std::string &file : *files)
      file = besideCase(file, caseFile);
  if (reader.has("roughness.cutoff"))
    surface.cutoff = reader.number("roughness.cutoff");
  const std::vector<std::string> orders = choicesOf(*findKeyword("roughness.detrend"));
  const std::string order = reader.word("roughness.detrend");
  surface.detrend =
      static_cast<int>(std::find(orders.begin(), orders.end(), order) - orders.begin()) - 1;
}

void readFractal(CaseReader &reader, SurfaceSpecification &surface)
{
  reader.refuse({"roughness.cutoff", "roughness.detrend"}, "a generated profile");
  for (const char *name :
       {"roughness.hurst", "roughness.wavelength_min", "roughness.wavelength_max"})
    reader.require(name);
  surface.kind = RoughnessKind::Fractal;
  FractalSurface &fractal = surface.fractal;
  fractal.hurst = reader.number("roughness.hurst");
  if (reader.has("roughness.rms_slope") == reader.has("roughness.rms_height"))
    reader.fail("roughness", "one of rms_slope and rms_height is needed, not both");
  if (reader.has("roughness.rms_slope"))
    fractal.rmsSlope = reader.number("roughness.rms_slope");
  else
    fractal.rmsHeight = reader.number("roughness.rms_height");
  fractal.wavelengthMin = reader.number("roughness.wavelength_min");
  fractal.wavelengthMax = reader.number("roughness.wavelength_max");
  if (fractal.wavelengthMin > fractal.wavelengthMax)
    reader.fail("roughness.wavelength_min", "is above wavelength_max");
  for (double seed : reader.numbers("roughness.seed"))
    surface.seeds.push_back(static_cast<std::uint64_t>(seed));
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

SpreadSpecification readSpread(CaseReader &reader, const FrictionSpecification &friction)
{
  SpreadSpecification spread;
  if (friction.isConstant())
    return spread; // no covariance
  if (reader.word("uncertainty.method") == "linear")
    return spread;
  spread.method = UncertaintyMethod::Sampled;
  spread.samples = reader.integer("uncertainty.samples");
  spread.seed = static_cast<std::uint64_t>(reader.number("uncertainty.seed"));
  return spread;
}

CreepSpecification readRolling(CaseReader &reader, const std::string &mode,
                               const LineContactSpecification &contact,
                               const SurfaceSpecification &surface, const CreepPhysics &physics)
{
  reader.refuse({"contact.period"}, "mode " + mode + ": rolling needs a radius");
  CreepSpecification rolling;
  rolling.contact = contact;
  rolling.surface = surface;
  rolling.physics = physics;
  rolling.mode = mode == "moving" ? RollingMode::Moving : RollingMode::Frozen;
  rolling.physics.thermal = readThermal(reader);
  rolling.speed = reader.numbers("speed");
  rolling.creep = readSeries(reader, "creep");
  for (double creep : rolling.creep)
    if (creep < 0.0)
      reader.fail(
          reader.hasGroup("creep") ? "creep.from" : "creep",
          fmt::format("'{}' is not in the allowed range of a line contact, [0, 10]", creep));
  if (rolling.mode == RollingMode::Moving) {
    rolling.moving.passes = reader.integer("moving.passes");
    rolling.moving.referenceLength = reader.number("moving.reference_length");
  }
  rolling.spread = readSpread(reader, physics.friction);
  return rolling;
}

/// What rolling needs, temperature included, is left alone: nothing slides for long.
StaticSpecification readStatic(CaseReader &reader, const LineContactSpecification &contact,
                               const SurfaceSpecification &surface, const CreepPhysics &physics)
{
  StaticSpecification still{contact, surface, physics, {}};
  still.physics.thermal.model = ThermalModel::Off;
  reader.require("static.force_ratio");
  still.forceRatio = reader.numbers("static.force_ratio");
  if (physics.friction.local)
    reader.fail("friction.local",
                "mode static needs one friction coefficient for the whole contact: false");
  if (physics.hardnessLimit &&
      *std::max_element(still.forceRatio.begin(), still.forceRatio.end()) > 0.0)
    reader.fail("contact.hardness_limit",
                "mode static needs elastic contact, false, for a static.force_ratio above 0");
  return still;
}

} // namespace

namespace {

template<class Surfaces>
void append(std::vector<std::string> &files, const Surfaces &surfaces)
{
  files.insert(files.end(), surfaces.rail.begin(), surfaces.rail.end());
  files.insert(files.end(), surfaces.wheel.begin(), surfaces.wheel.end());
}

} // namespace

std::vector<std::string> Case::files() const
{
  std::vector<std::string> files = {friction().law};
  if (const auto *patch = std::get_if<PatchSpecification>(&task))
    append(files, patch->roughness);
  else if (const auto *rolling = std::get_if<CreepSpecification>(&task))
    append(files, rolling->surface);
  else
    append(files, std::get<StaticSpecification>(task).surface);
  return files;
}

const FrictionSpecification &Case::friction() const
{
  return std::visit(
      [](const auto &asked) -> const auto & { return asked.physics.friction; }, task);
}

Case readCase(const std::string &path, const std::vector<std::string> &changes)
{
  CaseReader reader(path);
  reader.readFile();
  for (const std::string &change : changes)
    reader.change(change);

  Case result;
  if (reader.has("contact.load")) {
    result.task = readPatch(reader, path);
    result.text = reader.configuration();
    return result;
  }
  const LineContactSpecification contact = readContact(reader);
  const SurfaceSpecification surface = readSurface(reader, path);
  CreepPhysics physics;
  physics.hardnessLimit = reader.flag("contact.hardness_limit");
  physics.friction = readFriction(reader, path);
  const std::string mode = reader.word("mode");
  if (mode == "static")
    result.task = readStatic(reader, contact, surface, physics);
  else
    result.task = readRolling(reader, mode, contact, surface, physics);
  result.text = reader.configuration();
  return result;
}

} // namespace wheelrail
