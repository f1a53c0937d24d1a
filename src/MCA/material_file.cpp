// SPDX-License-Identifier: GPL-2.0-or-later
#include "material_file.h"

#include "shared/nearest_word.h"
#include "shared/plain_number.h"
#include "units.h"

#include <cmath>
#include <set>
#include <sstream>

namespace mca {

static const MaterialQuantity &quantityNamed(const std::string &keyword, const std::string &where)
{
  if (const auto *q = findMaterialQuantity(keyword))
    return *q;
  throw MaterialError(where + mcawr::unknownWord("keyword", keyword, materialKeywords()));
}

static double finiteNumber(const MaterialQuantity &q, const std::string &value,
                           const std::string &where)
{
  const auto number = mcawr::plainNumber(value);
  if (!number)
    throw MaterialError(where + q.keyword + " is '" + value + "', allowed: a finite number " +
                        q.allowed + " [" + q.dimension + "]");
  return *number;
}

// factor from the given units to common ones, of a dimension of the table of quantities
static double unitFactor(const std::string &dimension, const Units &units)
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

Material readMaterial(const std::string &text, const std::string &name, const std::string &units)
{
  std::istringstream lines(text);
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

  Material material;
  std::set<std::string> seen;
  for (int number = 2; std::getline(lines, line); number++) {
    const std::string where = name + ":" + std::to_string(number) + ": ";
    std::istringstream words(line.substr(0, line.find('#')));
    std::string keyword, value, more;
    if (!(words >> keyword))
      continue;
    const auto &q = quantityNamed(keyword, where);
    if (!(words >> value))
      throw MaterialError(where + keyword + " has no value, allowed: " + q.allowed);
    if (words >> more)
      throw MaterialError(where + keyword + " has more than one value: '" + more + "'");
    if (!seen.insert(keyword).second)
      throw MaterialError(where + keyword + " appears twice");
    material.*q.value = finiteNumber(q, value, where);
  }
  for (const auto &q : materialQuantities())
    if (!seen.count(q.keyword))
      throw MaterialError(name + ": " + q.keyword + " is missing");
  if (fileUnits != units)
    for (const auto &q : materialQuantities())
      material.*q.value *= unitFactor(q.dimension, *from) / unitFactor(q.dimension, *to);
  const std::string problem = checkMaterial(material);
  if (!problem.empty())
    throw MaterialError(name + ": " + problem);
  return material;
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
