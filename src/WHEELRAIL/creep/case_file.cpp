// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case_file.h"

#include "creep/case_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {
namespace {

LineContactSpecification readContact(CaseReader &reader)
{
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
  contact.youngsModulus = reader.number("contact.youngs_modulus");
  contact.poissonsRatio = reader.number("contact.poissons_ratio");
  contact.points = reader.integer("points");
  return contact;
}

/// Profile and law files are named from the folder of the case file.
std::string besideCase(const std::string &path, const std::string &caseFile)
{
  const std::filesystem::path given(path);
  if (given.is_absolute() || std::filesystem::exists(given))
    return path;
  return (std::filesystem::path(caseFile).parent_path() / given).string();
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

FrictionSpecification readFriction(CaseReader &reader, const std::string &caseFile)
{
  FrictionSpecification friction;
  friction.law = reader.word("friction.law");
  if (friction.isConstant()) {
    friction.mu = reader.number("friction.mu");
  } else {
    if (reader.has("friction.mu"))
      reader.fail("friction.mu", "goes with 'law: constant' only");
    friction.local = reader.flag("friction.local");
    friction.velocityTerm = reader.flag("friction.velocity_term");
    friction.modulus = reader.number("friction.modulus");
    friction.density = reader.number("friction.density");
    if (!isBuiltinLaw(friction.law))
      friction.law = besideCase(friction.law, caseFile);
  }
  friction.strength = reader.number("friction.strength");
  friction.strengthTemperature = reader.number("friction.strength_temperature");
  return friction;
}

ThermalSpecification readThermal(CaseReader &reader)
{
  ThermalSpecification thermal;
  if (reader.has("thermal")) {
    reader.words("thermal");
    thermal.model = ThermalModel::Off;
    return thermal;
  }
  thermal.material = {reader.number("thermal.conductivity"), reader.number("thermal.density"),
                      reader.number("thermal.specific_heat")};
  const std::string model = reader.word("thermal.model");
  thermal.model = model == "local"            ? ThermalModel::Local
                  : model == "averaged_power" ? ThermalModel::AveragedPower
                                              : ThermalModel::Averaged;
  return thermal;
}

std::vector<double> readCreeps(CaseReader &reader)
{
  if (!reader.hasGroup("creep"))
    return reader.numbers("creep");
  const double from = reader.number("creep.from"), to = reader.number("creep.to");
  const int n = reader.integer("creep.n");
  const bool logarithmic = reader.word("creep.spacing") == "log";
  if (to < from || (n > 1 && to == from))
    reader.fail("creep.to", "must be above creep.from");
  if (logarithmic && !(from > 0.0))
    reader.fail("creep.from", "must be positive when spacing is log");
  std::vector<double> creeps;
  for (int i = 0; i < n; ++i) {
    const double part = n > 1 ? double(i) / (n - 1) : 0.0;
    creeps.push_back(logarithmic ? from * std::pow(to / from, part) : from + part * (to - from));
  }
  creeps.back() = n > 1 ? to : from;
  return creeps;
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
  rolling.creep = readCreeps(reader);
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

const SurfaceSpecification &Case::surface() const
{
  return std::visit(
      [](const auto &asked) -> const auto & { return asked.surface; }, task);
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

  const LineContactSpecification contact = readContact(reader);
  const SurfaceSpecification surface = readSurface(reader, path);
  CreepPhysics physics;
  physics.hardnessLimit = reader.flag("contact.hardness_limit");
  physics.friction = readFriction(reader, path);
  Case result;
  const std::string mode = reader.word("mode");
  if (mode == "static")
    result.task = readStatic(reader, contact, surface, physics);
  else
    result.task = readRolling(reader, mode, contact, surface, physics);
  result.text = reader.configuration();
  return result;
}

} // namespace wheelrail
