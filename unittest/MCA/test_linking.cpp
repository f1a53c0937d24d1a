// SPDX-License-Identifier: GPL-2.0-or-later
// The exact moment of each transition: at its threshold, just below it, just above it.
#include "sample.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace mca;

namespace {

const double strength = 92;

LinkLimits limitsOf(const std::vector<std::string> &words = {})
{
  LawSet set = LawSet::named("b");
  EXPECT_EQ(set.parse(words), "");
  return makePairLaw(set, steel(), steel(), 1.0).limits;
}

/// Kind after a step of a contact with these stresses and strains, by the criterion of the limits.
double nextOf(double kind, double sigma, double tau, double eps, double gammaTotal,
              const LinkLimits &limits, bool worked = false)
{
  LinkLoad load{};
  load.eps = eps;
  load.gammaTotal = gammaTotal;
  load.sigma = sigma;
  load.tau = tau;
  return nextKind(kind, sigma, tau, eps, bulkBreaks(limits, load), limits, worked, 0.0,
                  strainIntensity2(eps, gammaTotal) >= limits.healedIntensity2);
}

double below(double x)
{
  return x * (1 - 1e-14);
}
double above(double x)
{
  return x * (1 + 1e-14);
}

} // namespace

TEST(Linking, AContactBecomesAWeldAtTheElasticLimit)
{
  const LinkLimits b = limitsOf();
  const double y1 = steel().sigmaY1();
  EXPECT_EQ(nextOf(link::none, -below(y1), 0, -0.01, 0, b), link::none);
  EXPECT_EQ(nextOf(link::none, -y1, 0, -0.01, 0, b), link::weld);
  EXPECT_EQ(nextOf(link::none, -above(y1), 0, -0.01, 0, b), link::weld);
  EXPECT_EQ(nextOf(link::none, +1e6, 0, 0.01, 0, b), link::none);
  EXPECT_EQ(nextOf(link::none, -1e6, 0, -0.01, 0, b), link::weld); // heals one step later
}

TEST(Linking, WithOneKindAContactBecomesABulkLink)
{
  const LinkLimits a = limitsOf({"preset", "a"});
  const double s = 2.35 * strength;
  EXPECT_EQ(nextOf(link::none, -below(s), 0, -0.01, 0, a), link::none);
  EXPECT_EQ(nextOf(link::none, -s, 0, -0.01, 0, a), link::bulk);
  EXPECT_EQ(nextOf(link::none, -above(s), 0, -0.01, 0, a), link::bulk);
}

TEST(Linking, AWeldBreaksAtItsOwnIntensity)
{
  const LinkLimits b = limitsOf();
  EXPECT_EQ(nextOf(link::weld, below(strength), 0, 0.01, 0, b), link::weld);
  EXPECT_EQ(nextOf(link::weld, strength, 0, 0.01, 0, b), link::worn);
  EXPECT_EQ(nextOf(link::weld, above(strength), 0, 0.01, 0, b), link::worn);
  const double tau = strength / std::sqrt(3.0);
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(nextOf(link::weld, -5, sign * below(tau), 0, 0, b), link::weld);
    EXPECT_EQ(nextOf(link::weld, -5, sign * above(tau), 0, 0, b), link::worn);
  }
  // both together on the circle of radius sigma_0
  const double t = std::sqrt((strength * strength - 50.0 * 50.0) / 3);
  EXPECT_EQ(nextOf(link::weld, 50, below(t), 0, 0, b), link::weld);
  EXPECT_EQ(nextOf(link::weld, 50, above(t), 0, 0, b), link::worn);
  // strain does not break a weld
  EXPECT_EQ(nextOf(link::weld, 0, 0, 0.2, 0.2, b), link::weld);
}

TEST(Linking, AWeldHealsUnderPressure)
{
  const LinkLimits b = limitsOf();
  const double s = 3.0 * steel().sigmaY2();
  EXPECT_EQ(nextOf(link::weld, -below(s), 0, -0.01, 0, b), link::weld);
  EXPECT_EQ(nextOf(link::weld, -s, 0, -0.01, 0, b), link::bulk);
  EXPECT_EQ(nextOf(link::weld, -above(s), 0, -0.01, 0, b), link::bulk);
  // breaking goes before healing
  EXPECT_EQ(nextOf(link::weld, -2 * s, strength, -0.01, 0, b), link::worn);
}

TEST(Linking, ABulkLinkBreaksAtItsStrain)
{
  const LinkLimits b = limitsOf();
  const double c = steel().breakingStrain;
  EXPECT_EQ(nextOf(link::bulk, 0, 0, below(c), 0, b), link::bulk);
  EXPECT_EQ(nextOf(link::bulk, 0, 0, c, 0, b), link::worn);
  EXPECT_EQ(nextOf(link::bulk, 0, 0, above(c), 0, b), link::worn);
  EXPECT_EQ(nextOf(link::bulk, 0, 0, -0.3, 0, b), link::bulk);
  const double g = c * std::sqrt(0.75);
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(nextOf(link::bulk, 0, 0, -0.01, sign * below(g), b), link::bulk);
    EXPECT_EQ(nextOf(link::bulk, 0, 0, -0.01, sign * above(g), b), link::worn);
  }
  // stress does not, neither breaks nor welds it
  EXPECT_EQ(nextOf(link::bulk, 1e6, 1e6, 0.01, 0, b), link::bulk);
  EXPECT_EQ(nextOf(link::bulk, -1e6, 0, -0.01, 0, b), link::bulk);
}

TEST(Linking, ACollapsedBulkLinkBreaksAndDoesNotHeal)
{
  for (const char *fracture : {"strain", "stress", "none"}) {
    const LinkLimits b = limitsOf({"fracture", fracture});
    EXPECT_EQ(nextOf(link::bulk, -1e6, 0, -below(0.9), 0, b), link::bulk);
    EXPECT_EQ(nextOf(link::bulk, -1e6, 0, -0.9, 0, b), link::worn);
    EXPECT_EQ(nextOf(link::bulk, 0, 0, -above(0.9), 0, b), link::worn);
    EXPECT_EQ(nextOf(link::worn, -1e6, 0, -0.9, 0, b), link::worn);
    EXPECT_EQ(nextOf(link::weld, -1e6, 0, -0.9, 0, b), link::weld);
    EXPECT_EQ(nextOf(link::weld, -1e6, 0, -below(0.9), 0, b), link::bulk);
  }
}

TEST(Linking, NothingHealsThatWouldBreakAtOnce)
{
  const LinkLimits b = limitsOf();
  const double c = steel().breakingStrain, g = c * std::sqrt(0.75);
  for (double kind : {link::worn, link::weld}) {
    EXPECT_EQ(nextOf(kind, -1e6, 0, below(c), 0, b), link::bulk);
    EXPECT_EQ(nextOf(kind, -1e6, 0, above(c), 0, b), kind);
    EXPECT_EQ(nextOf(kind, -1e6, 0, 0, below(g), b), link::bulk);
    EXPECT_EQ(nextOf(kind, -1e6, 0, 0, above(g), b), kind);
    EXPECT_EQ(nextKind(kind, -1e6, 0, 0, true, b), kind); // whatever the criterion
  }
}

TEST(Linking, AHealedLinkBreaksAtItsOwnStrain)
{
  for (const char *word : {"yield_strain", "0.02"}) {
    const LinkLimits b = limitsOf({"healed_strain", word});
    const double c = *word == 'y' ? steel().yieldStrain : 0.02, g = c * std::sqrt(0.75);
    EXPECT_DOUBLE_EQ(b.healedIntensity2, c * c);
    EXPECT_EQ(nextOf(link::healed, 0, 0, below(c), 0, b), link::healed);
    EXPECT_EQ(nextOf(link::healed, 0, 0, above(c), 0, b), link::worn);
    for (const double sign : {-1.0, 1.0}) {
      EXPECT_EQ(nextOf(link::healed, 0, 0, -0.01, sign * below(g), b), link::healed);
      EXPECT_EQ(nextOf(link::healed, 0, 0, -0.01, sign * above(g), b), link::worn);
    }
    EXPECT_EQ(nextOf(link::healed, 1e6, 1e6, 0, 0, b), link::healed); // stress does not break it
    EXPECT_EQ(nextOf(link::healed, 0, 0, -0.9, 0, b), link::worn);    // collapse does
    // an original one bears what it did
    EXPECT_EQ(nextOf(link::bulk, 0, 0, below(steel().breakingStrain), 0, b), link::bulk);
    EXPECT_EQ(nextOf(link::bulk, 0, 0, above(steel().breakingStrain), 0, b), link::worn);
    // what heals becomes one, unless it would break at once
    for (double kind : {link::worn, link::weld}) {
      EXPECT_EQ(nextOf(kind, -1e6, 0, -0.01, below(g), b), link::healed);
      EXPECT_EQ(nextOf(kind, -1e6, 0, -0.01, above(g), b), kind);
    }
  }
  EXPECT_TRUE(link::isLinked(link::healed));
  EXPECT_TRUE(link::isKind(link::healed));
  // whatever the criterion of bulk links, which it obeys, too
  const LinkLimits none = limitsOf({"fracture", "none", "healed_strain", "0.02"});
  EXPECT_EQ(nextOf(link::healed, 0, 0, 0.021, 0, none), link::worn);
  EXPECT_EQ(nextOf(link::bulk, 0, 0, 0.5, 0, none), link::bulk);
  const LinkLimits tough = limitsOf({"healed_strain", "0.1"});
  EXPECT_EQ(nextOf(link::healed, 0, 0, 0.05, 0, tough), link::worn);
  // of a file, where no law makes any: a bulk link
  EXPECT_EQ(nextOf(link::healed, 0, 0, 0.039, 0, limitsOf()), link::healed);
  EXPECT_EQ(nextOf(link::healed, 0, 0, 0.041, 0, limitsOf()), link::worn);
}

TEST(Linking, ABulkLinkBreaksAtItsStress)
{
  const LinkLimits limits = limitsOf({"fracture", "stress"});
  EXPECT_EQ(nextOf(link::bulk, below(strength), 0, 0.3, 0.3, limits), link::bulk);
  EXPECT_EQ(nextOf(link::bulk, strength, 0, 0, 0, limits), link::worn);
  EXPECT_EQ(nextOf(link::bulk, above(strength), 0, 0, 0, limits), link::worn);
}

TEST(Linking, SwitchedOffTransitionsNeverAct)
{
  const LinkLimits none =
      limitsOf({"fracture", "none", "link", "none", "heal", "none", "weld", "none"});
  const double huge = 1e150;
  EXPECT_EQ(nextOf(link::none, -huge, 0, -0.4, 0, none), link::none);
  EXPECT_EQ(nextOf(link::bulk, huge, huge, 10, 10, none), link::bulk);
  EXPECT_EQ(nextOf(link::weld, huge, huge, 10, 10, none), link::weld);
  EXPECT_EQ(nextOf(link::weld, -huge, 0, -0.4, 0, none), link::weld);
}

TEST(Linking, AWornContactIsUnloadedBeforeItLinksAgain)
{
  const LinkLimits b = limitsOf();
  const double y1 = steel().sigmaY1();
  EXPECT_EQ(nextOf(link::worn, -above(y1), 0, -0.01, 0, b), link::worn);
  EXPECT_EQ(nextOf(link::worn, -y1, 0, -0.01, 0, b), link::worn);
  EXPECT_EQ(nextOf(link::worn, -below(y1), 0, -0.01, 0, b), link::none);
  EXPECT_EQ(nextOf(link::worn, 0, 0, 0.01, 0, b), link::none);
  const double heal = 3.0 * steel().sigmaY2();
  EXPECT_EQ(nextOf(link::worn, -below(heal), 0, -0.01, 0, b), link::worn);
  EXPECT_EQ(nextOf(link::worn, -heal, 0, -0.01, 0, b), link::bulk);
  EXPECT_FALSE(link::isLinked(link::worn));
  EXPECT_FALSE(link::isLinked(link::none));
  EXPECT_TRUE(link::isLinked(link::bulk));
  EXPECT_TRUE(link::isLinked(link::weld));
}

TEST(Linking, AWornContactThatNeverLinksIsForgottenAtTheBreakingStrain)
{
  const LinkLimits c = limitsOf({"worn", "never"});
  const double most = steel().breakingStrain;
  for (double sigma : {-1e6, -above(steel().sigmaY1()), 0.0}) {
    EXPECT_EQ(nextOf(link::worn, sigma, 0, -0.01, 0, c), link::worn);
    EXPECT_EQ(nextOf(link::worn, sigma, 0, below(most), 0, c), link::worn);
  }
  EXPECT_EQ(nextOf(link::worn, 0, 0, most, 0, c), link::none);
  EXPECT_EQ(nextOf(link::worn, -1e6, 0, most, 0, c), link::none); // pressed all the same
  EXPECT_EQ(nextOf(link::none, 0, 0, -0.01, 0, c), link::none);
}

TEST(Linking, LocalStressBreaksABulkLinkOnly)
{
  const LinkLimits limits = limitsOf({"fracture", "equivalent"});
  EXPECT_EQ(nextOf(link::bulk, 0, 0, 0.3, 0.3, limits), link::bulk); // strain does not
  EXPECT_EQ(nextKind(link::bulk, 0, 0, 0, true, limits), link::worn);
  EXPECT_EQ(nextKind(link::weld, 0, 0, 0, true, limits), link::weld);
  EXPECT_EQ(nextKind(link::none, 0, 0, 0, true, limits), link::none);
}

TEST(Linking, PlasticWorkLinksAsPressureDoes)
{
  const LinkLimits b = limitsOf({"link", "none", "link_work", "0.5"});
  const Material m = steel();
  EXPECT_DOUBLE_EQ(b.linkWork, 0.5 * YieldCurve(m).work(m.plasticStrainUltimate()));
  EXPECT_EQ(nextOf(link::none, -1e6, 0, -0.01, 0, b, false), link::none);
  EXPECT_EQ(nextOf(link::none, -1, 0, -0.01, 0, b, true), link::weld);
  EXPECT_EQ(nextOf(link::worn, -1, 0, -0.01, 0, b, true), link::worn);
  EXPECT_EQ(nextOf(link::worn, -1, 0, -0.01, 0, b, false), link::none);
  EXPECT_EQ(nextOf(link::bulk, -1, 0, -0.01, 0, b, true), link::bulk);
}
