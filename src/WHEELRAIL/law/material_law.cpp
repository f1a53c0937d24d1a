// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/material_law.h"

#include "base/errors.h"
#include "base/si.h"
#include "base/text_lines.h"
#include "law/kappa_law.h"
#include "law/law_file.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <regex>

namespace wheelrail {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char *format = "mca-friction-law 2";

/// The keys of a table, in the order of a file; its speed has a group of its own.
struct RangeKey {
  const char *key;
  std::optional<Range> MaterialLaw::*range;
};
constexpr RangeKey rangeKeys[] = {{"pressure_range", &MaterialLaw::pressureRange},
                                  {"temperature_range", &MaterialLaw::temperatureRange},
                                  {"velocity_range", &MaterialLaw::speedRange}};

/// A parameter in the file, where n counts conditions.
const char *keyOf(int parameter)
{
  return parameter == N ? "kappa3_exponent" : parameterNames[parameter];
}

/// What is of a table alone; all but the first three may be left out.
constexpr const char *tableKeys[] = {"table_temperature", "table_pressure",    "table_mu",
                                     "table_mu_se",       "speed_exponent",    "speed_exponent_se",
                                     "speed_pressure",    "reference_velocity"};

std::vector<std::string> keys()
{
  std::vector<std::string> all = {"format",      "checksum", "material",       "density",
                                  "temperature", "strength", "youngs_modulus", "kappa3",
                                  "covariance",  "n",        "rms_relative",   "fitted_on",
                                  "source",      "report"};
  for (int k = 0; k < allParameters; ++k)
    all.emplace_back(keyOf(k));
  for (const RangeKey &row : rangeKeys)
    all.emplace_back(row.key);
  all.insert(all.end(), std::begin(tableKeys), std::end(tableKeys));
  return all;
}

std::vector<double> scaled(std::vector<double> values, double unit)
{
  for (double &value : values)
    value *= unit;
  return values;
}

/// Numbers > 0, a value for each temperature.
std::vector<double> positiveNumbers(const LawFile &file, const std::string &key, std::size_t count)
{
  std::vector<double> values = file.numbers(key);
  if (values.size() != count)
    file.fail(key, fmt::format("{} numbers, must be {}, as many as of temperature", values.size(),
                               count));
  for (const double value : values)
    if (!(value > 0.0))
      file.fail(key, fmt::format("{:g} is not allowed, must be > 0", value));
  return values;
}

void checkRising(const LawFile &file, const std::string &key, const std::vector<double> &values)
{
  if (values.empty())
    file.fail(key, "has no number, must have at least one");
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!(values[k] > (k == 0 ? 0.0 : values[k - 1])))
      file.fail(key, fmt::format("{:g} is not allowed, numbers must be > 0 and rise", values[k]));
}

SofteningMaterial readMaterial(const LawFile &file)
{
  SofteningMaterial material;
  material.name = file.has("material") ? file.string("material") : "";
  material.density = file.positive("density");
  material.temperature = file.numbers("temperature");
  checkRising(file, "temperature", material.temperature);
  const std::size_t count = material.temperature.size();
  material.strength = scaled(positiveNumbers(file, "strength", count), MPa);
  material.modulus = scaled(positiveNumbers(file, "youngs_modulus", count), MPa);
  return material;
}

/// The power of the speed: lists over p/sigma_0, or one number for all.
MuTable::SpeedPower readSpeedPower(const LawFile &file, const std::optional<Range> &speeds)
{
  MuTable::SpeedPower speed;
  if (!file.has("speed_exponent"))
    return speed;
  const bool lists = file.has("speed_pressure"), known = file.has("speed_exponent_se");
  speed.ratio = lists ? file.numbers("speed_pressure") : std::vector<double>{1.0};
  checkRising(file, "speed_pressure", speed.ratio);
  const auto read = [&](const char *key) {
    std::vector<double> values = lists ? file.numbers(key) : std::vector<double>{file.number(key)};
    if (values.size() != speed.ratio.size())
      file.fail(key, fmt::format("{} numbers, must be {}, as many as of speed_pressure",
                                 values.size(), speed.ratio.size()));
    return values;
  };
  speed.exponent = read("speed_exponent");
  speed.exponentSe =
      known ? read("speed_exponent_se") : std::vector<double>(speed.ratio.size(), 0.0);
  for (const double error : speed.exponentSe)
    if (!(error >= 0.0))
      file.fail("speed_exponent_se", fmt::format("{:g} is not allowed, must be >= 0", error));
  speed.reference = file.positive("reference_velocity");
  if (!speeds || !((*speeds)[0] > 0.0))
    file.fail("speed_exponent", "needs a velocity_range above 0");
  speed.range = *speeds;
  return speed;
}

MuTable readTable(const LawFile &file, const std::optional<Range> &speeds)
{
  MuTable table;
  const std::vector<double> temperature = file.numbers("table_temperature");
  checkRising(file, "table_temperature", temperature);
  const auto listsOf = [&](const char *key) {
    std::vector<std::vector<double>> lists = file.lists(key);
    if (lists.size() != temperature.size())
      file.fail(key, fmt::format("{} lists, must be {}, as many as of table_temperature",
                                 lists.size(), temperature.size()));
    return lists;
  };
  const auto ratio = listsOf("table_pressure"), mu = listsOf("table_mu");
  const auto error = file.has("table_mu_se") ? listsOf("table_mu_se")
                                             : std::vector<std::vector<double>>(temperature.size());
  for (std::size_t k = 0; k < temperature.size(); ++k) {
    MuTable::Row row{temperature[k], ratio[k], mu[k], error[k]};
    checkRising(file, "table_pressure", row.ratio);
    if (row.muSe.empty())
      row.muSe.assign(row.mu.size(), 0.0);
    for (const auto &[key, values] : {std::pair{"table_mu", &row.mu}, {"table_mu_se", &row.muSe}}) {
      if (values->size() != row.ratio.size())
        file.fail(key, fmt::format("{} numbers at {:g} K, must be {}, as many as of table_pressure",
                                   values->size(), row.temperature, row.ratio.size()));
      for (const double value : *values)
        if (!(value > 0.0) && !(values == &row.muSe && value == 0.0))
          file.fail(key, fmt::format("{:g} is not allowed, must be > 0", value));
    }
    table.rows.push_back(std::move(row));
  }
  table.speed = readSpeedPower(file, speeds);
  return table;
}

void readForm(const LawFile &file, MaterialLaw &law)
{
  for (int k = 0; k < allParameters; ++k) {
    const char *name = keyOf(k);
    const bool needed = k == Mu0;
    if (needed || file.has(name))
      law.parameters[k] = k == B || k == C || k >= S ? file.nonNegative(name) : file.number(name);
  }
  if (law.parameters[S] > 0.0 && !(law.parameters[Q] > 0.0))
    file.fail("s", "needs q, a number > 0");
  if (file.has("kappa3"))
    law.kappa3 = file.positive("kappa3");
  else if (law.parameters[N] != 0.0)
    file.fail(keyOf(N), "needs kappa3, the E/sigma_0 at which its power is 1");
  if (const auto covariance =
          file.covariance("covariance", {parameterNames.begin(), parameterNames.end()}))
    law.covariance = *covariance;
}

/// A key of the form that the file does not have would change nothing in silence.
void refuseOtherForm(const LawFile &file)
{
  if (!file.has("table_temperature")) {
    for (const char *key : tableKeys)
      if (file.has(key))
        file.fail(key, "goes with a table only, table_temperature is missing");
    return;
  }
  const auto refuse = [&file](const char *key) {
    if (file.has(key))
      file.fail(key, "does not go with a table, table_temperature");
  };
  for (int k = 0; k < allParameters; ++k)
    refuse(keyOf(k));
  refuse("kappa3");
  refuse("covariance");
  for (const char *key : {"speed_exponent_se", "speed_pressure"})
    if (file.has(key) && !file.has("speed_exponent"))
      file.fail(key, "needs speed_exponent");
}

} // namespace

Kappas MaterialLaw::kappas(double pressure, double speed, double kelvin) const
{
  const double sigma = material.strengthAt(kelvin), E = material.modulusAt(kelvin);
  return {kappa1(material.density, E, speed, sigma), kappa2(pressure, E, sigma), E / sigma};
}

double MaterialLaw::operator()(double pressure, double speed, double kelvin) const
{
  if (table)
    return (*table)(pressure / material.strengthAt(kelvin), kelvin, std::abs(speed));
  const Kappas asked = kappas(pressure, speed, kelvin);
  return boundedMu(parameters, asked, asked.kappa3 / kappa3);
}

bool MaterialLaw::dependsOnSpeed() const
{
  if (!table)
    return parameters[Mu1] != 0.0 || parameters[S1] != 0.0;
  const std::vector<double> &powers = table->speed.exponent;
  return std::any_of(powers.begin(), powers.end(), [](double m) { return m != 0.0; });
}

bool isMaterialLaw(const std::string &path)
{
  try {
    static const std::regex stated(fmt::format(R"("format"\s*:\s*"{}")", format));
    return std::regex_search(readTextFile(path), stated);
  } catch (const Error &) {
    return false;
  }
}

MaterialLaw readMaterialLaw(const std::string &path)
{
  const LawFile file(path, keys());
  if (const auto found = file.string("format"); found != format)
    file.fail("format", fmt::format("'{}' cannot be read, must be '{}'", found, format));
  refuseOtherForm(file);
  MaterialLaw law;
  law.material = readMaterial(file);
  for (const RangeKey &row : rangeKeys)
    if (file.has(row.key))
      law.*row.range = file.range(row.key);
  if (file.has("table_temperature"))
    law.table = readTable(file, law.speedRange);
  else
    readForm(file, law);
  law.n = file.has("n") ? file.count("n") : 0;
  law.rmsRelative = file.has("rms_relative") ? file.nonNegative("rms_relative") : 0.0;
  if (file.has("fitted_on"))
    law.fittedOn = file.ranges("fitted_on", {fittedQuantities.begin(), fittedQuantities.end()});
  law.source = file.has("source") ? file.string("source") : path;
  law.note = file.note();
  return law;
}

Json toJson(const MaterialLaw &law)
{
  Json json;
  json["format"] = format;
  if (law.table) {
    const MuTable &table = *law.table;
    for (const MuTable::Row &row : table.rows) {
      json["table_temperature"].push_back(row.temperature);
      json["table_pressure"].push_back(row.ratio);
      json["table_mu"].push_back(row.mu);
      json["table_mu_se"].push_back(row.muSe);
    }
    if (!table.speed.ratio.empty()) {
      json["speed_pressure"] = table.speed.ratio;
      json["speed_exponent"] = table.speed.exponent;
      json["speed_exponent_se"] = table.speed.exponentSe;
    }
    if (table.speed.reference > 0.0)
      json["reference_velocity"] = table.speed.reference;
  } else {
    for (int k = 0; k < allParameters; ++k)
      json[keyOf(k)] = law.parameters[k];
    json["kappa3"] = law.kappa3;
    json["covariance"] = nullptr;
    if (law.covariance) {
      json["covariance"] = Json::array();
      for (int i = 0; i < allParameters; ++i) {
        Json row = Json::array();
        for (int j = 0; j < allParameters; ++j)
          row.push_back((*law.covariance)(i, j));
        json["covariance"].push_back(row);
      }
    }
  }
  json["material"] = law.material.name;
  json["density"] = law.material.density;
  json["temperature"] = law.material.temperature;
  json["strength"] = scaled(law.material.strength, 1.0 / MPa);
  json["youngs_modulus"] = scaled(law.material.modulus, 1.0 / MPa);
  json["n"] = law.n;
  json["rms_relative"] = law.rmsRelative;
  for (const RangeKey &row : rangeKeys)
    if (law.*row.range)
      json[row.key] = *(law.*row.range);
  for (const char *quantity : fittedQuantities)
    if (const auto found = law.fittedOn.find(quantity); found != law.fittedOn.end())
      json["fitted_on"][quantity] = found->second;
  json["source"] = law.source;
  return json;
}

} // namespace wheelrail
