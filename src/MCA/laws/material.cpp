#include "material.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mca {

const std::vector<MaterialQuantity> &materialQuantities()
{
  static const std::vector<MaterialQuantity> table = {
      {"youngs_modulus", &Material::youngs_modulus, "stress", "> 0"},
      {"poissons_ratio", &Material::poissons_ratio, "-", "> -1 and < 0.5"},
      {"density", &Material::density, "mass/volume", "> 0"},
      {"strength", &Material::strength, "stress", "> 0"},
      {"elastic_limit", &Material::elastic_limit, "of strength", "> 0 and <= yield_strength"},
      {"yield_strength", &Material::yield_strength, "of strength", ">= elastic_limit and <= 1"},
      {"yield_strain", &Material::yield_strain, "-",
       "> the elastic strain there and < breaking_strain"},
      {"breaking_strain", &Material::breaking_strain, "-", "> yield_strain and < 0.5"},
      {"viscosity", &Material::viscosity, "stress time", ">= 0"},
      {"diameter", &Material::diameter, "length", "> 0"},
  };
  return table;
}

const MaterialQuantity *findMaterialQuantity(const std::string &keyword)
{
  for (const auto &q : materialQuantities())
    if (keyword == q.keyword)
      return &q;
  return nullptr;
}

std::vector<std::string> materialKeywords()
{
  std::vector<std::string> known;
  for (const auto &q : materialQuantities())
    known.push_back(q.keyword);
  return known;
}

bool Material::operator==(const Material &other) const
{
  const auto &table = materialQuantities();
  return std::all_of(table.begin(), table.end(),
                     [&](const auto &q) { return this->*q.value == other.*q.value; });
}

std::string checkMaterial(const Material &m)
{
  auto bad = [](const char *keyword, double value) {
    std::ostringstream line;
    line << keyword << " is " << value << ", allowed: " << findMaterialQuantity(keyword)->allowed;
    return line.str();
  };
  for (const auto &q : materialQuantities())
    if (!std::isfinite(m.*q.value))
      return bad(q.keyword, m.*q.value);
  if (m.youngs_modulus <= 0)
    return bad("youngs_modulus", m.youngs_modulus);
  if (m.poissons_ratio <= -1 || m.poissons_ratio >= 0.5)
    return bad("poissons_ratio", m.poissons_ratio);
  if (m.density <= 0)
    return bad("density", m.density);
  if (m.strength <= 0)
    return bad("strength", m.strength);
  if (m.yield_strength <= 0 || m.yield_strength > 1)
    return bad("yield_strength", m.yield_strength);
  if (m.elastic_limit <= 0 || m.elastic_limit > m.yield_strength)
    return bad("elastic_limit", m.elastic_limit);
  if (m.breaking_strain >= 0.5)
    return bad("breaking_strain", m.breaking_strain);
  if (m.plasticStrainY2() <= 0)
    return bad("yield_strain", m.yield_strain);
  if (m.plasticStrainUltimate() <= m.plasticStrainY2())
    return bad("breaking_strain", m.breaking_strain);
  if (m.viscosity < 0)
    return bad("viscosity", m.viscosity);
  if (m.diameter <= 0)
    return bad("diameter", m.diameter);
  return "";
}

} // namespace mca
