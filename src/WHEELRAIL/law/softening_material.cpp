// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/softening_material.h"

#include "base/errors.h"
#include "base/quantity.h"
#include "base/text_lines.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace wheelrail {

namespace {

/// Units of a potential file in SI units.
struct FileUnits {
  const char *name;
  double stress;  ///< Pa
  double density; ///< kg/m3
};

constexpr std::array<FileUnits, 4> fileUnits = {
    {{"nano", 1e6, 1e6}, {"si", 1.0, 1.0}, {"micro", 1e3, 1e3}, {"cgs", 0.1, 1e3}}};

/// Values of a keyword, and where they stand.
struct Line {
  int number = 0;
  std::vector<double> values;
};

FileUnits unitsOf(const std::string &path, std::string_view head)
{
  std::istringstream words{std::string(head)};
  for (std::string word; words >> word;)
    if (word == "UNITS:" && words >> word)
      for (const FileUnits &units : fileUnits)
        if (word == units.name)
          return units;
  throw badInput(path, 1, "UNITS:", "is needed, with nano, si, micro or cgs");
}

Line valuesOf(const std::string &path, int number, const std::string &keyword,
              std::istringstream &words)
{
  Line line{number, {}};
  for (std::string word; words >> word;) {
    try {
      line.values.push_back(parseNumber(word));
    } catch (const std::invalid_argument &) {
      line.values.push_back(0.0);
    }
    constexpr double largest = 1e30; // in any unit no material comes near; products stay finite
    if (!(line.values.back() >= 1.0 / largest && line.values.back() <= largest))
      throw badInput(
          path, number, keyword,
          fmt::format("'{}' is not allowed, must be a number > 0, at most {:g}", word, largest));
  }
  return line;
}

/// Numbers in SI units, as many as there are temperatures.
std::vector<double> spread(const std::string &path, const std::string &keyword, const Line &line,
                           double unit, std::size_t count)
{
  if (line.number == 0)
    throw badInput(path, 0, keyword, "is missing");
  if (line.values.size() != 1 && line.values.size() != count)
    throw badInput(path, line.number, keyword,
                   fmt::format("{} values, must be 1 or {}, as many as of temperature",
                               line.values.size(), count));
  std::vector<double> all(count);
  for (std::size_t k = 0; k < count; ++k)
    all[k] = unit * line.values[line.values.size() == 1 ? 0 : k];
  return all;
}

} // namespace

double SofteningMaterial::temperatureOf(double sigma, double E) const
{
  constexpr double tolerance = 1e-3; // heads and plans have five digits or more
  const auto close = [](double x, double y) { return std::abs(x - y) <= tolerance * y; };
  for (std::size_t k = 0; k < temperature.size(); ++k) {
    if (close(strength[k], sigma) && close(modulus[k], E))
      return temperature[k];
    if (k + 1 == temperature.size())
      break;
    // linear in between: the share that the one which changes more has gone
    const double strengths = strength[k + 1] - strength[k], moduli = modulus[k + 1] - modulus[k];
    const bool byStrength = std::abs(strengths) * modulus[k] > std::abs(moduli) * strength[k];
    const double share = byStrength ? (sigma - strength[k]) / strengths : (E - modulus[k]) / moduli;
    if (share > 0.0 && share < 1.0 && close(strength[k] + share * strengths, sigma) &&
        close(modulus[k] + share * moduli, E))
      return temperature[k] + share * (temperature[k + 1] - temperature[k]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

SofteningMaterial readPotentialFile(const std::string &path)
{
  const std::string text = readTextFile(path);
  LineReader lines(text);
  std::string_view line;
  lines.next(line);
  const FileUnits units = unitsOf(path, line);
  std::map<std::string, Line> found = {
      {"temperature", {}}, {"strength", {}}, {"youngs_modulus", {}}, {"density", {}}};
  while (lines.next(line)) {
    std::istringstream words{std::string(line.substr(0, line.find('#')))};
    std::string keyword;
    words >> keyword;
    const auto known = found.find(keyword);
    if (known == found.end())
      continue;
    if (known->second.number != 0)
      throw badInput(path, lines.number(), keyword, "appears twice");
    known->second = valuesOf(path, lines.number(), keyword, words);
  }
  constexpr double room = 293.0; // K, of a file without temperatures
  SofteningMaterial material;
  material.name = path;
  const Line &temperature = found["temperature"];
  material.temperature = temperature.number ? temperature.values : std::vector<double>{room};
  for (std::size_t k = 1; k < material.temperature.size(); ++k)
    if (material.temperature[k] <= material.temperature[k - 1])
      throw badInput(path, temperature.number, "temperature", "must rise");
  const std::size_t count = material.temperature.size();
  material.strength = spread(path, "strength", found["strength"], units.stress, count);
  material.modulus = spread(path, "youngs_modulus", found["youngs_modulus"], units.stress, count);
  material.density = spread(path, "density", found["density"], units.density, 1).front();
  return material;
}

} // namespace wheelrail
