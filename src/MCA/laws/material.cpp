// SPDX-License-Identifier: GPL-2.0-or-later
#include "material.h"

#include "shared/plain_number.h"

#include <algorithm>
#include <cmath>

namespace mca {

namespace {
// Products of a few do not overflow.
bool isPositive(double x)
{
  return x >= 1e-60 && x <= 1e60;
}
} // namespace

const std::vector<MaterialQuantity> &materialQuantities()
{
  static const std::vector<MaterialQuantity> table = {
      {"youngs_modulus", &Material::youngsModulus, "stress", "> 0, 1e-60 to 1e60"},
      {"poissons_ratio", &Material::poissonsRatio, "-", "> -1 and < 0.5"},
      {"density", &Material::density, "mass/volume", "> 0, 1e-60 to 1e60"},
      {"strength", &Material::strength, "stress", "> 0, 1e-60 to 1e60"},
      {"elastic_limit", &Material::elasticLimit, "of strength", "> 0 and <= yield_strength"},
      {"yield_strength", &Material::yieldStrength, "of strength", ">= elastic_limit and <= 1"},
      {"yield_strain", &Material::yieldStrain, "-",
       "> the elastic strain there and < breaking_strain"},
      {"breaking_strain", &Material::breakingStrain, "-", "> yield_strain and < 0.5"},
      {"viscosity", &Material::viscosity, "stress time", ">= 0, 0 or 1e-60 to 1e60"},
      {"diameter", &Material::diameter, "length", "> 0, 1e-60 to 1e60"},
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
    known.emplace_back(q.keyword);
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
    return std::string(keyword) + " is " + mcawr::numberWord(value) +
           ", allowed: " + findMaterialQuantity(keyword)->allowed;
  };
  for (const auto &q : materialQuantities())
    if (!std::isfinite(m.*q.value))
      return bad(q.keyword, m.*q.value);
  if (!isPositive(m.youngsModulus))
    return bad("youngs_modulus", m.youngsModulus);
  if (m.poissonsRatio <= -1 || m.poissonsRatio >= 0.5)
    return bad("poissons_ratio", m.poissonsRatio);
  if (!isPositive(m.density))
    return bad("density", m.density);
  if (!isPositive(m.strength))
    return bad("strength", m.strength);
  if (m.yieldStrength <= 0 || m.yieldStrength > 1)
    return bad("yield_strength", m.yieldStrength);
  if (m.elasticLimit <= 0 || m.elasticLimit > m.yieldStrength)
    return bad("elastic_limit", m.elasticLimit);
  if (m.breakingStrain >= 0.5)
    return bad("breaking_strain", m.breakingStrain);
  if (m.plasticStrainY2() <= 0)
    return bad("yield_strain", m.yieldStrain);
  if (m.plasticStrainUltimate() <= m.plasticStrainY2())
    return bad("breaking_strain", m.breakingStrain);
  if (m.viscosity != 0 && !isPositive(m.viscosity))
    return bad("viscosity", m.viscosity);
  if (!isPositive(m.diameter))
    return bad("diameter", m.diameter);
  return "";
}

} // namespace mca
