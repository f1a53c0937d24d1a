// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case/common_groups.h"

#include "law/friction_laws.h"
#include "law/temperature_factor.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace wheelrail {

std::string besideCase(const std::string &path, const std::string &caseFile)
{
  const std::filesystem::path given(path);
  std::error_code ignored; // what cannot be looked at is named where it is read
  if (given.is_absolute() || std::filesystem::exists(given, ignored))
    return path;
  return (std::filesystem::path(caseFile).parent_path() / given).string();
}

void requireCellsInContact(const CaseReader &reader, int points, double domain)
{
  const double cells = 2.0 * points / domain;
  if (cells < fewestCellsAcross)
    reader.fail("cells",
                fmt::format("{} on a contact.domain of {} leave {:.3g} cells for the width of the "
                            "contact; at least {} are needed: {} cells, or a smaller domain",
                            points, domain, cells, fewestCellsAcross,
                            std::ceil(0.5 * fewestCellsAcross * domain)));
}

void requireFewPoints(const CaseReader &reader, double points)
{
  constexpr double most = 1e7;
  if (points > most)
    reader.fail(
        reader.hasGroup("creep") ? "creep.n" : "creep",
        fmt::format("all lists together make {:g} operating points; at most {:g} are allowed",
                    points, most));
}

std::array<double, 2> readPair(CaseReader &reader, const std::string &name, const char *meaning)
{
  std::vector<double> values = reader.numbers(name);
  if (values.size() != 2)
    reader.fail(name, fmt::format("{} values; {} are expected", values.size(), meaning));
  return {values[0], values[1]};
}

std::array<double, 2> readBodies(CaseReader &reader, const std::string &name)
{
  if (reader.numbers(name).size() == 1)
    return {reader.numbers(name)[0], reader.numbers(name)[0]};
  return readPair(reader, name, "one for both bodies, or [wheel, rail],");
}

ElasticBodies readElasticBodies(CaseReader &reader)
{
  for (const char *name : {"contact.youngs_modulus", "contact.poissons_ratio"})
    reader.require(name);
  const auto youngs = readBodies(reader, "contact.youngs_modulus");
  const auto poissons = readBodies(reader, "contact.poissons_ratio");
  return {ElasticBody{youngs[0], poissons[0]}, ElasticBody{youngs[1], poissons[1]}};
}

InterfacialLayer readLayer(CaseReader &reader)
{
  InterfacialLayer layer;
  if (!reader.hasGroup("layer"))
    return layer;
  for (const char *name : {"layer.thickness", "layer.shear_modulus"})
    reader.require(name);
  layer.thickness = reader.number("layer.thickness");
  layer.shearModulus = reader.number("layer.shear_modulus");
  if (reader.has("layer.yield_stress"))
    layer.yieldStress = reader.number("layer.yield_stress");
  return layer;
}

MeasuredSurfaces readMeasuredSurfaces(CaseReader &reader, const std::string &caseFile)
{
  MeasuredSurfaces surfaces;
  for (const auto &[name, files] :
       {std::pair{"roughness.rail", &surfaces.rail}, {"roughness.wheel", &surfaces.wheel}}) {
    if (reader.has(name))
      *files = reader.words(name);
    for (std::string &file : *files)
      file = besideCase(file, caseFile);
  }
  if (!surfaces.rail.empty() && !surfaces.wheel.empty() &&
      surfaces.rail.size() != surfaces.wheel.size())
    reader.fail("roughness.wheel",
                fmt::format("{} files; as many as of roughness.rail, {}, are expected",
                            surfaces.wheel.size(), surfaces.rail.size()));
  if (reader.has("roughness.cutoff"))
    surfaces.cutoff = reader.number("roughness.cutoff");
  const std::vector<std::string> orders = choicesOf(*findKeyword("roughness.detrend"));
  const std::string order = reader.word("roughness.detrend");
  surfaces.detrend =
      static_cast<int>(std::find(orders.begin(), orders.end(), order) - orders.begin());
  return surfaces;
}

/// The law times the factor of its temperature, where the case has one.
static LawChoice heated(LawChoice choice, CaseReader &reader)
{
  if (!reader.has("friction.hot_factor")) // its temperatures would change nothing
    return choice;
  const TemperatureFactor factor{reader.number("friction.hot_factor"),
                                 reader.number("friction.hot_start"),
                                 reader.number("friction.hot_end")};
  if (factor.end <= factor.start)
    reader.fail("friction.hot_end", fmt::format("{:g} K, allowed: above friction.hot_start, {:g} K",
                                                factor.end, factor.start));
  if (factor.hot == 1.0)
    return choice;
  const bool isStatic = reader.word("mode") == "static";
  if (isStatic || reader.has("thermal"))
    reader.fail("friction.hot_factor", fmt::format("does not go with {}, where nothing becomes hot",
                                                   isStatic ? "mode: static" : "thermal: off"));
  choice.read = [read = choice.read, factor] { return heatedLaw(read(), factor); };
  return choice;
}

LawChoice readFriction(CaseReader &reader, const std::string &caseFile)
{
  const std::string word = reader.word("friction.law");
  LawValues values{{word, besideCase(word, caseFile)}, {}};
  const LawForm &form = lawFormOf(values.name);
  for (const LawKeyword &keyword : lawKeywords())
    if (!*keyword.initial && !form.reads(keyword.name) && reader.has(keyword.name))
      reader.fail(keyword.name, fmt::format("goes with {} only", lawsWith(keyword.name)));
  for (const LawKeyword &keyword : form.keywords)
    values.numbers[keyword.name] = keyword.kind == LawKeyword::Kind::Switch
                                       ? double(reader.flag(keyword.name))
                                       : reader.number(keyword.name);
  return heated(form.choose(values), reader);
}

Strength readStrength(CaseReader &reader, const LawChoice &friction, bool hardnessLimit)
{
  const char *const cold = "friction.strength", *const vanishing = "friction.strength_temperature";
  if (friction.hasStrength) {
    for (const char *keyword : {cold, vanishing, "friction.modulus", "friction.density"})
      reader.refuse(keyword, "friction.law: the law file has those of its material");
    return {};
  }
  if (!hardnessLimit && !friction.takesStrength)
    return {reader.initial(cold), reader.initial(vanishing), nullptr};
  return {reader.number(cold), reader.number(vanishing), nullptr};
}

double readMemoryLength(CaseReader &reader)
{
  const char *const keyword = "friction.memory_length";
  return reader.has(keyword) ? reader.number(keyword) : 0.0;
}

ThermalSpecification readThermal(CaseReader &reader, bool rollsOnPoint)
{
  ThermalSpecification thermal;
  if (reader.has("thermal")) {
    reader.words("thermal");
    thermal.model = ThermalModel::Off;
    return thermal;
  }
  const auto conductivity = readBodies(reader, "thermal.conductivity"),
             density = readBodies(reader, "thermal.density"),
             heat = readBodies(reader, "thermal.specific_heat");
  const std::array<ThermalMaterial, 2> bodies = {
      ThermalMaterial{conductivity[0], density[0], heat[0]},
      ThermalMaterial{conductivity[1], density[1], heat[1]}};
  thermal.material = pairMaterial(bodies[0], bodies[1]);
  if (rollsOnPoint)
    thermal.bulk = bulkOfContact(bodies[0], bodies[1], readBodies(reader, "thermal.bulk"));
  const std::string model = reader.word("thermal.model");
  thermal.model = model == "local"            ? ThermalModel::Local
                  : model == "averaged_power" ? ThermalModel::AveragedPower
                                              : ThermalModel::Averaged;
  return thermal;
}

FieldSelection readFields(CaseReader &reader, std::size_t total)
{
  FieldSelection fields;
  const std::vector<std::string> words = reader.words("fields");
  const auto bad = [&](const std::string &word) {
    reader.fail(
        "fields",
        fmt::format(
            "'{}' is not allowed; none, last, all, or numbers of operating points from 1 on",
            word));
  };
  if (words.size() == 1 && (words[0] == "none" || words[0] == "last" || words[0] == "all")) {
    fields.kind = words[0] == "none"   ? FieldSelection::Kind::None
                  : words[0] == "last" ? FieldSelection::Kind::Last
                                       : FieldSelection::Kind::All;
    return fields;
  }
  fields.kind = FieldSelection::Kind::Numbers;
  for (const std::string &word : words) {
    if (word.empty() || word.size() > 9 ||
        word.find_first_not_of("0123456789") != std::string::npos || std::stoi(word) < 1)
      bad(word);
    fields.numbers.push_back(std::stoi(word));
    if (fields.numbers.back() > static_cast<int>(total))
      reader.fail("fields",
                  fmt::format("'{}' is above the number of operating points, {}", word, total));
  }
  return fields;
}

SpreadSpecification readSpread(CaseReader &reader, const LawChoice &friction)
{
  SpreadSpecification spread;
  if (!friction.mayHaveCovariance)
    return spread;
  if (reader.word("uncertainty.method") == "linear")
    return spread;
  spread.method = UncertaintyMethod::Sampled;
  spread.samples = reader.integer("uncertainty.samples");
  spread.seed = static_cast<std::uint64_t>(reader.number("uncertainty.seed"));
  return spread;
}

std::vector<double> readSeries(CaseReader &reader, const std::string &name)
{
  if (!reader.hasGroup(name))
    return reader.numbers(name);
  const double from = reader.number(name + ".from"), to = reader.number(name + ".to");
  const int n = reader.integer(name + ".n");
  const bool logarithmic = reader.word(name + ".spacing") == "log";
  const bool negative = from < 0.0 && to < 0.0; // a series away from 0 on that side
  if (n == 1 && to != from)
    reader.fail(name + ".to",
                fmt::format("'{}', allowed where {}.n is 1: {}.from, '{}'",
                            reader.word(name + ".to"), name, name, reader.word(name + ".from")));
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
    const double value = logarithmic ? from * std::pow(to / from, part) : from + part * (to - from);
    values.push_back(orZero(*findKeyword(name), value)); // as a typed one
  }
  values.back() = to;
  return values;
}

} // namespace wheelrail
