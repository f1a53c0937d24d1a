#include "sample.h"

#include <gmock/gmock.h>

using mca::LawSet;
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
  EXPECT_EQ(a.preset, b.preset);
  EXPECT_EQ(a.plane, b.plane);
  EXPECT_EQ(a.elasticity, b.elasticity);
  EXPECT_EQ(a.plasticity, b.plasticity);
  EXPECT_EQ(a.fracture, b.fracture);
  EXPECT_EQ(a.viscosity, b.viscosity);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.link, b.link);
  EXPECT_EQ(a.weld, b.weld);
  EXPECT_EQ(a.heal, b.heal);
  EXPECT_EQ(a.link_work, b.link_work);
  EXPECT_EQ(a.compressive_strength, b.compressive_strength);
}

} // namespace

TEST(LawSet, Presets)
{
  const LawSet a = parsed({"preset", "a"}), b = parsed({});
  EXPECT_EQ(a.link, 2.35);
  EXPECT_EQ(a.weld, LawSet::off);
  EXPECT_EQ(a.heal, LawSet::off);
  EXPECT_EQ(b.link, LawSet::atElasticLimit);
  EXPECT_EQ(b.weld, 1.0);
  EXPECT_EQ(b.heal, LawSet::atHardness);
  for (const auto &set : {a, b}) {
    EXPECT_EQ(set.elasticity, "many-body");
    EXPECT_EQ(set.plasticity, "radial");
    EXPECT_EQ(set.fracture, "strain");
    EXPECT_EQ(set.viscosity, "normal");
    EXPECT_EQ(set.steps, "corrected");
    EXPECT_EQ(set.plane, "strain");
    EXPECT_EQ(set.link_work, LawSet::off);
    EXPECT_FALSE(set.needsLocal());
  }
  expectSame(parsed({"preset", "b"}), b);
}

TEST(LawSet, EachKeyword)
{
  EXPECT_EQ(parsed({"elasticity", "pairwise"}).elasticity, "pairwise");
  EXPECT_EQ(parsed({"plasticity", "none"}).plasticity, "none");
  EXPECT_EQ(parsed({"fracture", "stress"}).fracture, "stress");
  EXPECT_EQ(parsed({"fracture", "none"}).fracture, "none");
  EXPECT_EQ(parsed({"viscosity", "none"}).viscosity, "none");
  EXPECT_EQ(parsed({"steps", "plain"}).steps, "plain");
  EXPECT_EQ(parsed({"link", "1.25"}).link, 1.25);
  EXPECT_EQ(parsed({"link", "none"}).link, LawSet::off);
  EXPECT_EQ(parsed({"preset", "a", "link", "elastic_limit"}).link, LawSet::atElasticLimit);
  EXPECT_EQ(parsed({"weld", "0.554"}).weld, 0.554);
  EXPECT_EQ(parsed({"heal", "none"}).heal, LawSet::off);
  EXPECT_EQ(parsed({"heal", "2.35"}).heal, 2.35);
  EXPECT_EQ(parsed({"heal", "2.35", "heal", "hardness"}).heal, LawSet::atHardness);
  EXPECT_EQ(parsed({"plane", "stress", "plasticity", "none"}).plane, "stress");
  EXPECT_EQ(parsed({"plasticity", "j2"}).plasticity, "j2");
  EXPECT_TRUE(parsed({"fracture", "equivalent"}).needsLocal());
  EXPECT_TRUE(parsed({"fracture", "drucker-prager", "compressive_strength", "3"}).needsLocal());
  EXPECT_TRUE(parsed({"link", "none", "link_work", "0.5"}).needsLocal());
}

TEST(LawSet, APresetResetsWhatStandsBeforeIt)
{
  expectSame(parsed({"link", "7", "elasticity", "pairwise", "preset", "b"}), LawSet());
  EXPECT_EQ(parsed({"preset", "b", "link", "7"}).link, 7);
}

TEST(LawSet, BadValuesNameKeywordValueAndWhatIsAllowed)
{
  EXPECT_EQ(problemOf({"preset", "c"}), "keyword preset, value c, allowed: a, b");
  EXPECT_EQ(problemOf({"elasticity", "linear"}),
            "keyword elasticity, value linear, allowed: many-body, pairwise");
  EXPECT_EQ(problemOf({"plasticity", "x"}),
            "keyword plasticity, value x, allowed: radial, j2, none");
  EXPECT_THAT(problemOf({"fracture", "x"}), HasSubstr("allowed: strain, stress"));
  EXPECT_EQ(problemOf({"viscosity", "0"}), "keyword viscosity, value 0, allowed: normal, none");
  for (const char *keyword : {"link", "weld", "heal", "link_work", "compressive_strength"})
    for (const char *value : {"0", "-1", "nan", "inf", "2x", "x", "1e999"})
      EXPECT_THAT(problemOf({keyword, value}),
                  HasSubstr(std::string("keyword ") + keyword + ", value " + value + ", allowed: "))
          << keyword << " " << value;
  EXPECT_THAT(problemOf({"weld", "elastic_limit"}), HasSubstr("keyword weld"));
  EXPECT_THAT(problemOf({"heal", "elastic_limit"}), HasSubstr("> 0, hardness, none"));
  EXPECT_EQ(problemOf({"link"}), "keyword link has no value");
}

TEST(LawSet, WordsThatDoNotGoTogether)
{
  EXPECT_THAT(problemOf({"plane", "stress"}), HasSubstr("value stress, needs plasticity none"));
  EXPECT_THAT(problemOf({"plane", "stress", "plasticity", "j2"}), HasSubstr("plasticity j2"));
  EXPECT_THAT(problemOf({"fracture", "drucker-prager"}), HasSubstr("need each other"));
  EXPECT_THAT(problemOf({"compressive_strength", "2"}), HasSubstr("need each other"));
  EXPECT_EQ(problemOf({"fracture", "drucker-prager", "compressive_strength", "0.5"}),
            "keyword compressive_strength, value 0.5, allowed: a multiple of the strength >= 1");
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
}

TEST(LawSet, WordsReadBack)
{
  for (const std::vector<std::string> &words : std::vector<std::vector<std::string>>{
           {},
           {"preset", "a"},
           {"preset", "a", "link", "0.1"},
           {"elasticity", "pairwise", "plasticity", "none", "fracture", "none", "viscosity",
            "none"},
           {"link", "2.35", "weld", "0.33333333333333331", "heal", "none"},
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
  strong.youngs_modulus = 400000;
  strong.diameter = 3.5;
  strong.breaking_strain = 0.05;
  strong.viscosity = 10;
  weak.elastic_limit = 0.3;
  const LawSet set;
  const mca::PairLaw law = mca::makePairLaw(set, strong, weak, 2.0);
  EXPECT_DOUBLE_EQ(law.diameter, 3.0);
  EXPECT_DOUBLE_EQ(law.invDiameter, 1 / 3.0);
  EXPECT_DOUBLE_EQ(law.area, 3.0 * 2.0 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(law.twoGi, 2 * strong.shearModulus());
  EXPECT_DOUBLE_EQ(law.twoGj, 2 * weak.shearModulus());
  EXPECT_DOUBLE_EQ(law.Dj, weak.meanStressWeight());
  EXPECT_DOUBLE_EQ(law.viscosity, 210);
  EXPECT_DOUBLE_EQ(law.limits.bulkStrain2, 0.04 * 0.04); // the weaker one decides
  EXPECT_DOUBLE_EQ(law.limits.weldIntensity2, 92.0 * 92.0);
  EXPECT_DOUBLE_EQ(law.limits.linkPressure, 0.3 * 92);
  EXPECT_DOUBLE_EQ(law.limits.healPressure, 3.0 * 0.870 * 92);
  EXPECT_EQ(law.limits.linkedKind, mca::link::weld);
  EXPECT_EQ(law.limits.bulkIntensity2, LawSet::off);
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
  EXPECT_EQ(law({"link", "none"}).limits.linkPressure, LawSet::off);
  EXPECT_EQ(law({"heal", "none"}).limits.healPressure, LawSet::off);
  EXPECT_EQ(law({"preset", "a"}).limits.linkedKind, mca::link::bulk);
  const auto none = law({"fracture", "none"}).limits, stress = law({"fracture", "stress"}).limits;
  EXPECT_EQ(none.bulkStrain2, LawSet::off);
  EXPECT_EQ(none.bulkIntensity2, LawSet::off);
  EXPECT_EQ(none.bulkStress.limit, LawSet::off);
  EXPECT_EQ(none.linkWork, LawSet::off);
  EXPECT_EQ(stress.bulkStrain2, LawSet::off);
  EXPECT_DOUBLE_EQ(stress.bulkIntensity2, 92.0 * 92.0);
}
