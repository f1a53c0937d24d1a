// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample.h"

#include "shared/nearest_word.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

using mca::Material;
using testing::HasSubstr;

namespace {

std::string checked(double Material::*value, double number)
{
  Material m = steel();
  m.*value = number;
  return mca::checkMaterial(m);
}

} // namespace

TEST(Material, SteelOfTableOneIsGood)
{
  EXPECT_EQ(mca::checkMaterial(steel()), "");
  for (const double strength : {92.0, 200.0, 552.0})
    EXPECT_EQ(checked(&Material::strength, strength), "");
}

TEST(Material, DerivedModuliAreThoseOfElasticity)
{
  const Material m = steel();
  const double G = m.shearModulus(), K = m.bulkModulus();
  EXPECT_NEAR(9 * K * G / (3 * K + G), m.youngsModulus, 1e-9);
  EXPECT_NEAR((3 * K - 2 * G) / (6 * K + 2 * G), m.poissonsRatio, 1e-15);
}

TEST(Material, ThreePointsOfFig5)
{
  const Material m = steel(); // Table 1: 51 MPa, 80 MPa at 1.5 %, 92 MPa at 4 %
  EXPECT_NEAR(m.sigmaY1(), 51.0, 0.05);
  EXPECT_NEAR(m.sigmaY2(), 80.0, 0.05);
  EXPECT_NEAR(m.plasticStrainY2() + m.sigmaY2() / m.youngsModulus, 0.015, 1e-16);
  EXPECT_NEAR(m.plasticStrainUltimate() + m.strength / m.youngsModulus, 0.04, 1e-16);
}

TEST(Material, EachRangeIsChecked)
{
  const double eps = 1e-12;
  struct Limit {
    const char *keyword;
    std::vector<double> good, bad;
  };
  const Material m = steel();
  const double elastic2 = m.sigmaY2() / m.youngsModulus, elastic3 = m.strength / m.youngsModulus;
  const double shortest = m.plasticStrainY2() + elastic3; // breaking strain of no last piece
  const std::vector<Limit> limits = {
      {"youngs_modulus", {1e12}, {0.0, -1.0}},
      {"poissons_ratio", {-0.999, 0.0, 0.499}, {-1.0, 0.5, 0.7, -3.0}},
      {"density", {1e-9}, {0.0, -0.0078}},
      {"strength", {1.0}, {0.0, -92.0}},
      {"elastic_limit", {0.870, 0.01}, {0.0, -0.1, 0.870 + eps}},
      {"yield_strength", {0.554, 1.0}, {0.0, -1.0, 1.0 + eps}},
      {"yield_strain", {elastic2 + 1e-6}, {elastic2 - eps, 0.0, -0.015}},
      {"breaking_strain", {shortest + 1e-6, 0.4999}, {shortest - eps, 0.5, 0.0, -0.04}},
      {"viscosity", {0.0, 1e6}, {-1e-12}},
      {"diameter", {1e-9}, {0.0, -2.5}},
  };
  ASSERT_EQ(limits.size(), mca::materialQuantities().size()) << "a quantity without a test";
  for (const auto &limit : limits) {
    const auto *q = mca::findMaterialQuantity(limit.keyword);
    ASSERT_NE(q, nullptr);
    for (const double good : limit.good)
      EXPECT_EQ(checked(q->value, good), "") << limit.keyword << " " << good;
    auto bad = limit.bad;
    for (const double never : {std::nan(""), HUGE_VAL, -HUGE_VAL})
      bad.push_back(never);
    for (const double value : bad) {
      const std::string line = checked(q->value, value);
      EXPECT_THAT(line, HasSubstr(limit.keyword)) << value;
      EXPECT_THAT(line, HasSubstr(std::string("allowed: ") + q->allowed)) << value;
    }
  }
}

TEST(Material, YieldStrengthBelowTheElasticLimitIsRefused)
{
  EXPECT_NE(checked(&Material::yieldStrength, 0.5), "");
}

TEST(Material, NearestKeywordOfAMisspelling)
{
  EXPECT_EQ(mcawr::nearestWord("young_modulus", mca::materialKeywords()), "youngs_modulus");
  EXPECT_EQ(mcawr::nearestWord("viscocity", mca::materialKeywords()), "viscosity");
  EXPECT_EQ(mcawr::nearestWord("poisson_ratio", mca::materialKeywords()), "poissons_ratio");
  EXPECT_EQ(mcawr::nearestWord("Diameter", mca::materialKeywords()), "diameter");
  for (const auto &q : mca::materialQuantities())
    EXPECT_EQ(mcawr::nearestWord(q.keyword, mca::materialKeywords()), q.keyword);
  EXPECT_EQ(mca::findMaterialQuantity("viscocity"), nullptr);
}

TEST(Material, EqualityLooksAtEveryQuantity)
{
  for (const auto &q : mca::materialQuantities()) {
    Material m = steel();
    EXPECT_TRUE(m == steel());
    m.*q.value *= 1.0 + 1e-15;
    EXPECT_FALSE(m == steel()) << q.keyword;
  }
}
