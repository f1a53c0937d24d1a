// SPDX-License-Identifier: GPL-2.0-or-later
// What two types have of their own where they meet, against what follows from both materials.
#include "core/law_tables.h"
#include "files/restart_format.h"
#include "laws/contact_step.h"
#include "laws/interface_words.h"
#include "sample.h"

#include <gtest/gtest.h>

namespace {

using mca::Interface;

Interface parsed(const std::vector<std::string> &words, const mca::LawSet &laws = {})
{
  Interface interface;
  EXPECT_EQ(readInterface(words, laws, interface), "");
  return interface;
}

mca::LawSet laws(const std::vector<std::string> &words)
{
  mca::LawSet set;
  EXPECT_EQ(set.parse(words), "");
  return set;
}

TEST(Interface, takesThePlaceOfWhatFollowsFromBoth)
{
  const mca::LawSet set = laws({"fracture", "stress", "weld", "0.5"});
  mca::Material stiff = steel();
  stiff.youngsModulus *= 2.0;
  stiff.strength *= 3.0;
  const auto plain = makePairLaw(set, steel(), stiff, 1.0);
  const Interface own = parsed({"strength", "20", "breaking_strain", "0.3", "viscosity", "7"}, set);
  const auto law = makePairLaw(set, steel(), stiff, 1.0, mca::packing::hex, own);
  EXPECT_DOUBLE_EQ(law.limits.fracture.value[0], 400.0);
  EXPECT_DOUBLE_EQ(law.limits.weldIntensity2, 100.0);
  EXPECT_DOUBLE_EQ(law.limits.linkPressure, 20.0 * steel().elasticLimit);
  EXPECT_DOUBLE_EQ(law.limits.healPressure, 60.0 * steel().yieldStrength);
  EXPECT_EQ(law.limits.breakingStrain, 0.3);
  EXPECT_EQ(law.viscosity, 7.0);
  // moduli, flow and size stay those of the materials
  EXPECT_EQ(law.twoG, plain.twoG);
  EXPECT_EQ(law.Di, plain.Di);
  EXPECT_EQ(law.contactsFlow, plain.contactsFlow);
  EXPECT_EQ(law.area, plain.area);
  // nothing given, nothing changed
  const auto same = makePairLaw(set, steel(), stiff, 1.0, mca::packing::hex, Interface());
  EXPECT_EQ(same.limits.fracture.value[0], plain.limits.fracture.value[0]);
  EXPECT_EQ(same.limits.linkPressure, plain.limits.linkPressure);
  EXPECT_EQ(same.viscosity, plain.viscosity);
}

TEST(Interface, hasLawsOfLinksOfItsOwn)
{
  const Interface own = parsed({"link", "2", "weld", "none", "heal", "none", "worn", "never"});
  const auto law = makePairLaw({}, steel(), steel(), 1.0, mca::packing::hex, own);
  EXPECT_DOUBLE_EQ(law.limits.linkPressure, 2.0 * steel().strength);
  EXPECT_EQ(law.limits.linkedKind, mca::link::bulk);
  EXPECT_EQ(law.limits.unloads, 0.0);
  EXPECT_TRUE(std::isinf(law.limits.healPressure));
  // and viscosity none is without any, whatever the interface says
  const Interface viscous = parsed({"viscosity", "7"});
  EXPECT_EQ(
      makePairLaw(laws({"viscosity", "none"}), steel(), steel(), 1.0, mca::packing::hex, viscous)
          .viscosity,
      0.0);
}

TEST(Interface, tablesKnowItByTypes)
{
  const std::vector<mca::Material> materials(4, steel());
  const mca::Interfaces interfaces = {{{1, 2}, parsed({"viscosity", "7"})},
                                      {{3, 3}, parsed({"viscosity", "8"})},
                                      {{1, 3}, parsed({"viscosity", "7"})}};
  const mca::LawTables tables({}, materials, 1.0, mca::packing::hex, interfaces);
  const auto eta = [&](int i, int j) { return tables.pairs[tables.number(i, j)].viscosity; };
  EXPECT_EQ(eta(1, 2), 7.0);
  EXPECT_EQ(eta(2, 1), 7.0);
  EXPECT_EQ(eta(3, 3), 8.0);
  EXPECT_EQ(eta(2, 3), steel().viscosity);
  EXPECT_EQ(eta(1, 1), steel().viscosity);
  EXPECT_EQ(tables.number(1, 2), tables.number(3, 1)); // equal ones share a law
  EXPECT_EQ(tables.pairs.size(), 3u);
  EXPECT_TRUE(tables.oneMaterial);
}

TEST(Interface, theCriticalStepKnowsItsViscosity)
{
  const Interface own = parsed({"viscosity", "1e5"});
  const auto usual = mca::contactStep({}, steel(), steel(), mca::packing::hex);
  const auto limit = mca::contactStep({}, steel(), steel(), mca::packing::hex, own);
  EXPECT_NEAR(limit.viscous * 1e5, usual.viscous * steel().viscosity, 1e-12 * limit.viscous * 1e5);
  EXPECT_EQ(limit.elastic, usual.elastic);
}

TEST(Interface, whatIsNotAllowed)
{
  struct Case {
    std::vector<std::string> words, laws;
    std::string part;
  };
  for (const Case &c : std::vector<Case>{
           {{"strength", "0"}, {}, "strength is '0', allowed: > 0"},
           {{"strength", "x"}, {}, "strength is 'x'"},
           {{"breaking_strain", "0.5"}, {}, "> 0 and < 0.5"},
           {{"viscosity", "-1"}, {}, ">= 0"},
           {{"viscosity"}, {}, "viscosity has no value"},
           {{"youngs_modulus", "1"}, {}, "youngs_modulus"},
           {{"link", "some"}, {}, "keyword link, value some"},
           {{"weld", "none"}, {}, "heal needs welds"},
           {{"strength", "1"}, {}, "give it, too"},
           {{"breaking_strain", "0.1"}, {"fracture", "stress"}, "give it, too"},
       }) {
    Interface interface;
    EXPECT_NE(readInterface(c.words, laws(c.laws), interface).find(c.part), std::string::npos)
        << c.part;
    EXPECT_TRUE(interface.empty());
  }
}

TEST(Interface, readsBackFromRestartFiles)
{
  const mca::Interfaces all = {
      {{1, 2}, parsed({"strength", "0.1", "breaking_strain", "0.33333333333333331"})},
      {{2, 2}, parsed({"link", "none", "weld", "0.7"})}};
  const std::string text = mca::textOfInterfaces(all);
  EXPECT_TRUE(mca::interfacesIn(text, 2, {}) == all);
  EXPECT_TRUE(mca::interfacesIn("", 2, {}).empty());
  for (const char *bad :
       {"1 3 0 ", "2 1 0 ", "0 1 0 ", "1 2 x ", "1 2 2 strength nan ", "1 2", "1 2 2 link "})
    EXPECT_THROW(mca::interfacesIn(bad, 2, {}), mca::RestartError) << bad;
}

} // namespace
