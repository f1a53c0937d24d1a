// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case_parts.h"

#include <cmath>
#include <filesystem>

namespace wheelrail {

std::string besideCase(const std::string &path, const std::string &caseFile)
{
  const std::filesystem::path given(path);
  if (given.is_absolute() || std::filesystem::exists(given))
    return path;
  return (std::filesystem::path(caseFile).parent_path() / given).string();
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

std::vector<double> readSeries(CaseReader &reader, const std::string &name)
{
  if (!reader.hasGroup(name))
    return reader.numbers(name);
  const double from = reader.number(name + ".from"), to = reader.number(name + ".to");
  const int n = reader.integer(name + ".n");
  const bool logarithmic = reader.word(name + ".spacing") == "log";
  const bool negative = from < 0.0 && to < 0.0; // a series away from 0 on that side
  if (n > 1 && to == from)
    reader.fail(name + ".to", "must be above " + name + ".from");
  if (negative ? logarithmic && to > from : to < from)
    reader.fail(name + ".to", negative ? "must be below " + name + ".from when spacing is log"
                                       : "must be above " + name + ".from");
  if (logarithmic && !negative && !(from > 0.0))
    reader.fail(name + ".from", "must be positive when spacing is log");
  std::vector<double> values;
  for (int i = 0; i < n; ++i) {
    const double part = n > 1 ? double(i) / (n - 1) : 0.0;
    values.push_back(logarithmic ? from * std::pow(to / from, part) : from + part * (to - from));
  }
  values.back() = n > 1 ? to : from;
  return values;
}

} // namespace wheelrail
