// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

using namespace mca;
using testing::HasSubstr;

namespace {

std::string problemOf(const std::vector<std::string> &words)
{
  return LawSet().parse(words);
}

LawSet parsed(const std::vector<std::string> &words)
{
  LawSet set;
  EXPECT_EQ(set.parse(words), "");
  return set;
}

void expectSame(const LawSet &a, const LawSet &b)
{
  EXPECT_EQ(a.words(), b.words());
}

// value of a keyword as its word
std::string wordOf(const LawSet &set, const std::string &keyword)
{
  const std::vector<std::string> words = set.words();
  const auto at = std::find(words.begin(), words.end(), keyword);
  return at == words.end() ? "no such keyword" : *(at + 1);
}

} // namespace

TEST(LawSet, Presets)
{
  const LawSet a = parsed({"preset", "a"}), b = parsed({"preset", "b"}),
               c = parsed({"preset", "c"}), d = parsed({});
  EXPECT_EQ(a.link.threshold().factor(), 2.35);
  EXPECT_TRUE(a.weld.isOff());
  EXPECT_TRUE(a.heal.isOff());
  EXPECT_TRUE(b.link.threshold().isOfMaterial());
  EXPECT_EQ(b.weld.threshold().factor(), 1.0);
  EXPECT_TRUE(b.heal.threshold().isOfMaterial());
  for (const auto &set : {a, b}) {
    EXPECT_TRUE(set.elasticity.is(Elasticity::ManyBody));
    EXPECT_TRUE(set.plasticity.is(Plasticity::Radial));
    EXPECT_EQ(set.fracture.word(), "strain");
    EXPECT_TRUE(set.flow.is(FlowLaw::Links));
    EXPECT_TRUE(set.viscosity.is(ViscosityLaw::Normal));
    EXPECT_TRUE(set.steps.is(Steps::Corrected));
    EXPECT_TRUE(set.plane.is(PlaneCondition::Strain));
    EXPECT_TRUE(set.linkWork.isOff());
    EXPECT_FALSE(set.needsLocal());
  }
  expectSame(parsed({"preset", "d"}), d);
  // c is b whose contacts flow, too, and resist slip, and whose welds break where they form
  LawSet same =
      parsed({"preset", "b", "flow", "contacts", "viscosity", "both", "weld", "elastic_limit"});
  same.preset = "c";
  expectSame(c, same);
  // d is c whose flow keeps the volume
  LawSet kept = parsed({"preset", "c", "plasticity", "isochoric"});
  kept.preset = "d";
  expectSame(d, kept);
  EXPECT_TRUE(c.plasticity.is(Plasticity::Radial));
  EXPECT_TRUE(c.flow.is(FlowLaw::Contacts));
  EXPECT_TRUE(c.resistsSlip());
}

TEST(LawSet, WordsOfRestartFilesAndLogs)
{
  const std::vector<std::string> b = {"preset",
                                      "b",
                                      "plane",
                                      "strain",
                                      "elasticity",
                                      "many-body",
                                      "plasticity",
                                      "radial",
                                      "fracture",
                                      "strain",
                                      "viscosity",
                                      "normal",
                                      "steps",
                                      "corrected",
                                      "link",
                                      "elastic_limit",
                                      "weld",
                                      "1",
                                      "heal",
                                      "hardness",
                                      "link_work",
                                      "none",
                                      "compressive_strength",
                                      "none"};
  EXPECT_EQ(parsed({"preset", "b"}).words(), b);
  EXPECT_EQ(parsed({"preset", "b", "worn", "never", "worn", "unloaded"}).words(), b);
  EXPECT_THAT(parsed({"worn", "never"}).words(), testing::IsSupersetOf({"worn", "never"}));
  EXPECT_EQ(parsed({"preset", "b", "flow", "contacts", "flow", "links"}).words(), b);
  EXPECT_THAT(parsed({}).words(), testing::IsSupersetOf({"flow", "contacts"}));
  EXPECT_THAT(parsed({"flow", "links"}).words(), testing::IsSupersetOf({"flow", "links"}));
}

TEST(LawSet, EachKeyword)
{
  const std::vector<std::vector<std::string>> choices = {
      {"elasticity", "pairwise"}, {"plasticity", "none"},  {"plasticity", "radial"},
      {"flow", "links"},          {"fracture", "stress"},  {"fracture", "none"},
      {"viscosity", "none"},      {"viscosity", "normal"}, {"steps", "plain"},
      {"link", "1.25"},           {"link", "none"},        {"weld", "0.554"},
      {"heal", "none"},           {"heal", "2.35"},        {"link_work", "0.5"},
      {"worn", "never"},          {"friction", "0.25"},    {"healed_strain", "yield_strain"},
      {"healed_strain", "0.02"}};
  for (const auto &pair : choices)
    EXPECT_EQ(wordOf(parsed(pair), pair[0]), pair[1]);
  EXPECT_EQ(parsed({"link", "1.25"}).link.threshold().factor(), 1.25);
  EXPECT_TRUE(parsed({"preset", "a", "link", "elastic_limit"}).link.threshold().isOfMaterial());
  EXPECT_TRUE(parsed({"heal", "2.35", "heal", "hardness"}).heal.threshold().isOfMaterial());
  EXPECT_EQ(wordOf(parsed({"plane", "stress", "plasticity", "none"}), "plane"), "stress");
  EXPECT_TRUE(parsed({"fracture", "equivalent"}).needsLocal());
  EXPECT_TRUE(parsed({"fracture", "drucker-prager", "compressive_strength", "3"}).needsLocal());
  EXPECT_TRUE(parsed({"link", "none", "link_work", "0.5"}).needsLocal());
}

TEST(LawSet, AnswersWhatFollowsFromTheWords)
{
  EXPECT_TRUE(parsed({}).flows());
  EXPECT_TRUE(parsed({}).returnsTwice());
  EXPECT_TRUE(parsed({}).centresViscosity());
  EXPECT_FALSE(parsed({"plasticity", "none"}).flows());
  EXPECT_FALSE(parsed({"plasticity", "none"}).returnsTwice());
  EXPECT_FALSE(parsed({"steps", "plain"}).returnsTwice());
  EXPECT_FALSE(parsed({"steps", "plain"}).centresViscosity());
  EXPECT_FALSE(parsed({"viscosity", "none"}).isViscous());
  EXPECT_FALSE(parsed({"viscosity", "none"}).centresViscosity());
  EXPECT_TRUE(parsed({"flow", "links"}).keepsVolume());
  EXPECT_FALSE(parsed({"plasticity", "radial"}).keepsVolume());
}

TEST(LawSet, OnlyPlaneStressIsOfThePlane)
{
  const LawSet stress = parsed({"plane", "stress", "plasticity", "none"});
  EXPECT_EQ(stress.notInDimension(2), "");
  EXPECT_EQ(stress.notInDimension(3), "plane stress");
  for (const std::vector<std::string> &words :
       std::vector<std::vector<std::string>>{{},
                                             {"plasticity", "radial"},
                                             {"flow", "contacts"},
                                             {"fracture", "equivalent"},
                                             {"link_work", "1"}})
    EXPECT_EQ(parsed(words).notInDimension(3), "");
}

TEST(LawSet, AnUnknownWordIsNotAssigned)
{
  LawSet set;
  set.plasticity = "radial";
  EXPECT_TRUE(set.plasticity.is(Plasticity::Radial));
  EXPECT_THROW(set.plasticity = "soft", std::invalid_argument);
  EXPECT_THROW(set.fracture = "soft", std::invalid_argument);
  EXPECT_TRUE(set.plasticity.is(Plasticity::Radial));
}

TEST(LawSet, APresetResetsWhatStandsBeforeIt)
{
  expectSame(parsed({"link", "7", "elasticity", "pairwise", "preset", "d"}), LawSet());
  EXPECT_EQ(parsed({"preset", "b", "link", "7"}).link.threshold().factor(), 7);
}

TEST(LawSet, BadValuesNameKeywordValueAndWhatIsAllowed)
{
  EXPECT_EQ(problemOf({"preset", "e"}), "keyword preset, value e, allowed: a, b, c, d");
  EXPECT_EQ(problemOf({"elasticity", "linear"}),
            "keyword elasticity, value linear, allowed: many-body, pairwise");
  EXPECT_EQ(problemOf({"plasticity", "x"}),
            "keyword plasticity, value x, allowed: isochoric, radial, none");
  EXPECT_THAT(problemOf({"fracture", "x"}), HasSubstr("allowed: strain, stress"));
  EXPECT_EQ(problemOf({"viscosity", "0"}),
            "keyword viscosity, value 0, allowed: both, normal, none");
  for (const char *keyword :
       {"link", "weld", "heal", "healed_strain", "link_work", "compressive_strength"})
    for (const char *value : {"0", "-1", "nan", "inf", "2x", "x", "1e999"})
      EXPECT_THAT(problemOf({keyword, value}),
                  HasSubstr(std::string("keyword ") + keyword + ", value " + value + ", allowed: "))
          << keyword << " " << value;
  for (const char *value : {"-1", "nan", "inf", "2x", "none", "1e999"})
    EXPECT_EQ(problemOf({"friction", value}),
              std::string("keyword friction, value ") + value + ", allowed: a coefficient >= 0");
  EXPECT_THAT(problemOf({"weld", "hardness"}), HasSubstr("> 0, elastic_limit, none"));
  EXPECT_THAT(problemOf({"heal", "elastic_limit"}), HasSubstr("> 0, hardness, none"));
  EXPECT_EQ(problemOf({"healed_strain", "hardness"}),
            "keyword healed_strain, value hardness, allowed: a strain > 0, yield_strain, none");
  EXPECT_EQ(problemOf({"link"}), "keyword link has no value");
}

TEST(LawSet, WordsThatDoNotGoTogether)
{
  EXPECT_THAT(problemOf({"plane", "stress"}), HasSubstr("value stress, needs plasticity none"));
  EXPECT_THAT(problemOf({"plane", "stress", "plasticity", "radial"}),
              HasSubstr("plasticity radial"));
  EXPECT_THAT(problemOf({"fracture", "drucker-prager"}), HasSubstr("need each other"));
  EXPECT_THAT(problemOf({"compressive_strength", "2"}), HasSubstr("need each other"));
  EXPECT_EQ(problemOf({"fracture", "drucker-prager", "compressive_strength", "0.5"}),
            "keyword compressive_strength, value 0.5, allowed: a multiple of the strength >= 1");
  EXPECT_EQ(problemOf({"compressive_strength", "2"}),
            "keyword compressive_strength and fracture drucker-prager or mohr-coulomb need each "
            "other");
  EXPECT_EQ(problemOf({"fracture", "mohr-coulomb"}),
            "keyword compressive_strength and fracture mohr-coulomb need each other");
  EXPECT_EQ(parsed({"fracture", "mohr-coulomb", "compressive_strength", "3"})
                .fracture.parameter("compressive_strength"),
            3.0);
}

TEST(LawSet, UnknownKeywordNamesTheNearest)
{
  const std::string line = problemOf({"fractur", "none"});
  EXPECT_THAT(line, HasSubstr("unknown keyword 'fractur'"));
  EXPECT_THAT(line, HasSubstr("nearest known one is 'fracture'"));
}

TEST(LawSet, HealingNeedsWelds)
{
  EXPECT_THAT(problemOf({"weld", "none"}), HasSubstr("heal needs welds"));
  EXPECT_EQ(problemOf({"weld", "none", "heal", "none"}), "");
  EXPECT_THAT(problemOf({"heal", "none", "healed_strain", "0.02"}),
              HasSubstr("healed_strain needs healing: give heal a value"));
}

TEST(LawSet, WordsReadBack)
{
  for (const std::vector<std::string> &words : std::vector<std::vector<std::string>>{
           {},
           {"preset", "a"},
           {"preset", "a", "link", "0.1"},
           {"preset", "c"},
           {"preset", "c", "flow", "links"},
           {"elasticity", "pairwise", "plasticity", "none", "fracture", "none", "viscosity",
            "none"},
           {"link", "2.35", "weld", "0.33333333333333331", "heal", "none"},
           {"heal", "1", "healed_strain", "0.017"},
           {"fracture", "stress", "link", "none"},
           {"plane", "stress", "plasticity", "none", "fracture", "equivalent"},
           {"fracture", "drucker-prager", "compressive_strength", "2.5", "link_work", "0.1"}}) {
    const LawSet set = parsed(words);
    expectSame(parsed(set.words()), set);
  }
}

TEST(LawSet, PairOfUnlikeMaterials)
{
  mca::Material strong = steel(), weak = steel();
  strong.strength = 200;
  strong.youngsModulus = 400000;
  strong.diameter = 3.5;
  strong.breakingStrain = 0.05;
  strong.viscosity = 10;
  weak.elasticLimit = 0.3;
  strong.yieldStrain = 0.02;
  const LawSet set = parsed({"healed_strain", "yield_strain"});
  const mca::PairLaw law = mca::makePairLaw(set, strong, weak, 2.0);
  EXPECT_DOUBLE_EQ(law.diameter, 3.0);
  EXPECT_DOUBLE_EQ(law.invDiameter, 1 / 3.0);
  EXPECT_DOUBLE_EQ(law.area, 3.0 * 2.0 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(law.twoGi, 2 * strong.shearModulus());
  EXPECT_DOUBLE_EQ(law.twoGj, 2 * weak.shearModulus());
  EXPECT_DOUBLE_EQ(law.Dj, meanStressWeight(weak));
  EXPECT_DOUBLE_EQ(law.viscosity, 210);
  EXPECT_EQ(law.limits.criterion, 0);
  EXPECT_DOUBLE_EQ(law.limits.fracture.value[0], 0.04 * 0.04); // the weaker one decides
  EXPECT_DOUBLE_EQ(law.limits.weldIntensity2, law.limits.linkPressure * law.limits.linkPressure);
  EXPECT_DOUBLE_EQ(law.limits.linkPressure, 0.3 * 92);
  EXPECT_DOUBLE_EQ(law.limits.healPressure, 3.0 * 0.870 * 92);
  EXPECT_DOUBLE_EQ(law.limits.healedIntensity2, weak.yieldStrain * weak.yieldStrain);
  EXPECT_EQ(law.limits.linkedKind, mca::link::weld);
  const mca::PairLaw turned = mca::makePairLaw(set, weak, strong, 2.0);
  EXPECT_EQ(turned.twoGi, law.twoGj);
  EXPECT_EQ(turned.limits.linkPressure, law.limits.linkPressure);
}

TEST(LawSet, SwitchedOffLawsHaveInfiniteLimits)
{
  const auto law = [](const std::vector<std::string> &words) {
    return mca::makePairLaw(parsed(words), steel(), steel(), 1.0);
  };
  EXPECT_EQ(law({"elasticity", "pairwise"}).Di, 0.0);
  EXPECT_EQ(law({"viscosity", "none"}).viscosity, 0.0);
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(law({"link", "none"}).limits.linkPressure, never);
  EXPECT_EQ(law({"heal", "none"}).limits.healPressure, never);
  EXPECT_EQ(law({}).limits.healedIntensity2, never);
  EXPECT_EQ(law({}).limits.healedKind, mca::link::bulk);
  EXPECT_EQ(law({"preset", "a"}).limits.linkedKind, mca::link::bulk);
  EXPECT_EQ(law({}).limits.linkWork, never);
  EXPECT_EQ(law({}).limits.countsWork, 0.0);
  EXPECT_EQ(law({"link_work", "0.5"}).limits.countsWork, 1.0);
  EXPECT_DOUBLE_EQ(law({"fracture", "stress"}).limits.fracture.value[0], 92.0 * 92.0);
  LinkLoad torn{};
  torn.eps = torn.gammaTotal = torn.sigma = torn.tau = 1e9;
  EXPECT_FALSE(bulkBreaks(law({"fracture", "none"}).limits, torn));
  EXPECT_TRUE(bulkBreaks(law({"fracture", "strain"}).limits, torn));
}
