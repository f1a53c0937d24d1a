// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/material_file.h"

#include "files/units.h"
#include "shared/nearest_word.h"
#include "shared/plain_number.h"
#include "shared/plain_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace mca {

using mcawr::numberWord;

namespace {

const char *const TEMPERATURE = "temperature";

const MaterialQuantity &quantityNamed(const std::string &keyword, const std::string &where)
{
  if (const auto *q = findMaterialQuantity(keyword))
    return *q;
  std::vector<std::string> known = materialKeywords();
  known.emplace_back(TEMPERATURE);
  throw MaterialError(where + mcawr::unknownWord("keyword", keyword, known));
}

double finiteNumber(const MaterialQuantity &q, const std::string &value, const std::string &where)
{
  const auto number = mcawr::plainNumber(value);
  if (!number)
    throw MaterialError(where + q.keyword + " is '" + value + "', allowed: a finite number " +
                        q.allowed + " [" + q.dimension + "]");
  return *number;
}

// factor from the given units to common ones, of a dimension of the table of quantities
double unitFactor(const std::string &dimension, const Units &units)
{
  if (dimension == "-" || dimension == "of strength")
    return 1.0;
  if (dimension == "stress")
    return units.stress;
  if (dimension == "mass/volume")
    return units.density();
  if (dimension == "stress time")
    return units.viscosity();
  if (dimension == "length")
    return units.length;
  throw std::logic_error("no unit of the dimension " + dimension);
}

double temperatureFrom(const std::string &value, const std::string &where)
{
  const auto number = mcawr::plainNumber(value);
  if (!number || *number <= 0.0)
    throw MaterialError(where + TEMPERATURE + " is '" + value +
                        "', allowed: a finite number > 0 [temperature]");
  return *number;
}

// One line of the file: a value, or one for each temperature.
struct Line {
  int number;
  std::vector<double> values;
};

// The lines after the first one, by their keywords; of each at least one value.
std::map<std::string, Line> linesOf(std::istream &text, const std::string &name)
{
  std::map<std::string, Line> found;
  std::string line;
  for (int number = 2; std::getline(text, line); number++) {
    const std::string where = name + ":" + std::to_string(number) + ": ";
    std::istringstream words(line.substr(0, line.find('#')));
    std::string keyword, value;
    if (!(words >> keyword))
      continue;
    const bool isTemperature = keyword == TEMPERATURE;
    const MaterialQuantity *q = isTemperature ? nullptr : &quantityNamed(keyword, where);
    Line read{number, {}};
    while (words >> value)
      read.values.push_back(q ? finiteNumber(*q, value, where) : temperatureFrom(value, where));
    if (read.values.empty())
      throw MaterialError(where + keyword + " has no value, allowed: " + (q ? q->allowed : "> 0"));
    if (!found.emplace(keyword, std::move(read)).second)
      throw MaterialError(where + keyword + " appears twice");
  }
  return found;
}

void checkTemperatures(const Line &line, const std::string &name)
{
  const std::string where = name + ":" + std::to_string(line.number) + ": ";
  if (line.values.size() < 2)
    throw MaterialError(where + "temperature has one value, allowed: at least two that rise");
  for (size_t k = 1; k < line.values.size(); k++)
    if (line.values[k] <= line.values[k - 1])
      throw MaterialError(where + "temperature " + numberWord(line.values[k]) + " stands after " +
                          numberWord(line.values[k - 1]) + ", allowed: values that rise");
}

// The first and the last of values that rise.
std::string rangeWords(const std::vector<double> &table)
{
  return numberWord(table.front()) + " to " + numberWord(table.back());
}

// Where in the table the temperature lies: between the columns `below` and below + 1, `share` of
// the way from the one to the other.
struct Place {
  size_t below;
  double share;
};

Place placeOf(double temperature, const std::vector<double> &table, const std::string &name)
{
  if (temperature < table.front() || temperature > table.back())
    throw MaterialError("keyword temperature is " + numberWord(temperature) + ", allowed with " +
                        name + ": " + rangeWords(table));
  const auto above = std::upper_bound(table.begin() + 1, table.end() - 1, temperature);
  const size_t below = static_cast<size_t>(above - table.begin()) - 1;
  return {below, (temperature - table[below]) / (table[below + 1] - table[below])};
}

// The material of one column of the table, or of a place between two.
Material materialAt(const std::map<std::string, Line> &lines, const Place &place)
{
  Material material;
  for (const auto &q : materialQuantities()) {
    const std::vector<double> &values = lines.at(q.keyword).values;
    const double first = values.size() > 1 ? values[place.below] : values[0];
    // the value itself at the ends, to the last bit
    material.*q.value = values.size() > 1 && place.share > 0.0
                            ? (1.0 - place.share) * first + place.share * values[place.below + 1]
                            : first;
  }
  return material;
}

} // namespace

Material readMaterial(const std::string &bytes, const std::string &name, const std::string &units,
                      std::optional<double> temperature)
{
  const mcawr::PlainText plain = mcawr::plainText(bytes);
  if (!plain.problem.empty())
    throw MaterialError(name + ": " + plain.problem);
  std::istringstream lines(plain.text);
  std::string line;
  if (!std::getline(lines, line))
    throw MaterialError(name + ": the file is empty");

  const auto tag = line.find("UNITS:");
  std::string fileUnits;
  if (tag != std::string::npos)
    std::istringstream(line.substr(tag + 6)) >> fileUnits;
  if (fileUnits.empty())
    throw MaterialError(name + ":1: no UNITS: in the first line, allowed: UNITS: " + units);
  const Units *from = findUnits(fileUnits), *to = findUnits(units);
  if (units == "electron" || (fileUnits != units && (!from || !to)))
    throw MaterialError(name + ":1: UNITS is " + fileUnits + " and the input script has units " +
                        units +
                        ", allowed: any two of nano, si, cgs, micro, metal, real, or lj "
                        "in both");

  const std::map<std::string, Line> found = linesOf(lines, name);
  const auto table = found.find(TEMPERATURE);
  const size_t columns = table == found.end() ? 1 : table->second.values.size();
  if (table != found.end())
    checkTemperatures(table->second, name);
  for (const auto &q : materialQuantities()) {
    const auto own = found.find(q.keyword);
    if (own == found.end())
      throw MaterialError(name + ": " + q.keyword + " is missing");
    const size_t count = own->second.values.size();
    if (count != 1 && count != columns)
      throw MaterialError(name + ":" + std::to_string(own->second.number) + ": " + q.keyword +
                          " has " + std::to_string(count) + " values, allowed: " +
                          (columns == 1
                               ? "one, or a line temperature with as many"
                               : "1 or " + std::to_string(columns) + ", as many as temperature"));
  }
  const auto checked = [&](Material material, const std::string &where) {
    if (fileUnits != units)
      for (const auto &q : materialQuantities())
        material.*q.value *= unitFactor(q.dimension, *from) / unitFactor(q.dimension, *to);
    const std::string problem = checkMaterial(material);
    if (!problem.empty())
      throw MaterialError(where + problem);
    return material;
  };
  if (columns == 1) {
    if (temperature)
      throw MaterialError("keyword temperature needs a file with a line temperature, which " +
                          name + " has not");
    return checked(materialAt(found, {0, 0.0}), name + ": ");
  }
  const std::vector<double> &temperatures = table->second.values;
  for (size_t k = 0; k < columns; k++)
    checked(materialAt(found, {k, 0.0}),
            name + ": at " + TEMPERATURE + " " + numberWord(temperatures[k]) + ": ");
  if (!temperature)
    throw MaterialError("keyword temperature is missing, allowed with " + name + ": " +
                        rangeWords(temperatures));
  return checked(materialAt(found, placeOf(*temperature, temperatures, name)), name + ": ");
}

std::optional<double> takeTemperature(std::vector<std::string> &words)
{
  std::optional<double> temperature;
  for (size_t k = 0; k < words.size();) {
    if (words[k] != TEMPERATURE) {
      k += 2;
      continue;
    }
    if (k + 1 == words.size())
      throw MaterialError("keyword temperature has no value");
    temperature = temperatureFrom(words[k + 1], "");
    words.erase(words.begin() + k, words.begin() + k + 2);
  }
  return temperature;
}

Material overrideMaterial(Material material, const std::vector<std::string> &words)
{
  for (size_t k = 0; k < words.size(); k += 2) {
    const auto &q = quantityNamed(words[k], "");
    if (k + 1 == words.size())
      throw MaterialError("keyword " + words[k] + " has no value");
    material.*q.value = finiteNumber(q, words[k + 1], "");
  }
  const std::string problem = checkMaterial(material);
  if (!problem.empty())
    throw MaterialError(problem);
  return material;
}

} // namespace mca
