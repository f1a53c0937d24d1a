// SPDX-License-Identifier: GPL-2.0-or-later
#include "laws/fracture_criteria.h"
#include "sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <string>

// strains of 1e-3 beside an offset of 3e-3 keep about 15 digits
#define EXPECT_CLOSE(a, b) EXPECT_NEAR(a, b, 1e-9)

using namespace mca;

namespace {

PairLaw noTransitions(const Material &a, const Material &b,
                      const std::string &plasticity = "isochoric")
{
  LawSet set;
  EXPECT_EQ(set.parse({"flow", "links", "link", "none", "weld", "1e9", "heal", "none", "plasticity",
                       plasticity}),
            "");
  return makePairLaw(set, a, b, 1.0);
}

const PairLaw law = noTransitions(steel(), steel());
/// A contact below all limits of transition, without shear history.
ContactStress of(const PairLaw &pair, double kind, double e, double gamma, double separation,
                 double meanI, double factorI, double meanJ, double factorJ)
{
  const double plastic = 0.003; // shifts the strain, nothing else
  return contactStress<FractureByStrain>(pair,
                                         {kind, 1.0, e + plastic, plastic, gamma, 0.0, separation},
                                         {meanI, factorI, meanI}, {meanJ, factorJ, meanJ});
}

const double twoG = 2 * steel().shearModulus(), D = meanStressWeight(steel());

} // namespace

/// The numbers of the worked link at the top of laws/contact.h, "NAME = WORDS = NUMBER".
static std::map<std::string, std::string> workedLink()
{
  std::ifstream in(PROJECT_SOURCE "/src/MCA/laws/contact.h");
  const std::regex line(R"(///     (\w+) +=.* = ([-0-9.e]+) .*|///     (\w+) +=.* = ([-0-9.e]+))");
  std::map<std::string, std::string> numbers;
  std::smatch found;
  for (std::string text; std::getline(in, text);)
    if (std::regex_match(text, found, line))
      numbers[found[1].str() + found[3].str()] = found[2].str() + found[4].str();
  return numbers;
}

TEST(Contact, TheWorkedLinkIsWhatTheLawsGive)
{
  const PairLaw pair = makePairLaw(LawSet(), steel(), steel(), 1.0);
  Contact c{};
  c.kind = link::bulk;
  c.eps = 5e-4;
  c.ratio = std::exp(c.eps);
  c.plastic = 1e-4;
  c.gamma = c.gammaTotal = 2e-4;
  const Answer i = {30, 0.8, 30}, j = {20, 1, 20};
  const ContactStress s = contactStress<FractureByStrain>(pair, c, i, j);
  const double left = returnedShare(i, j);
  const ShearAnswer<double> shear = shearAnswer(pair, c.gamma, c.gamma, s, left);
  const NextState<double> next = nextState(pair, c, s, c.gamma, c.gammaTotal, shear.left);
  const PlaneForce f = contactForce(pair, s.normal, shear.acting, c.ratio, PlaneVector{1, 0});
  const std::map<std::string, double> computed = {
      {"trial", s.trial},    {"sigma", s.sigma},        {"left", left},
      {"tau", s.tau},        {"kind", s.kindNext},      {"Fn", f.x},
      {"Ft", f.y},           {"torque", f.torque},      {"offset", next.plastic},
      {"shear", next.gamma}, {"total", next.gammaTotal}};
  const std::map<std::string, std::string> written = workedLink();
  EXPECT_EQ(written.size(), computed.size());
  for (const auto &[name, value] : computed) {
    ASSERT_TRUE(written.count(name)) << name;
    EXPECT_NEAR(std::stod(written.at(name)), value, 5e-5 * std::abs(value)) << name; // five digits
  }
  EXPECT_NEAR(pair.area, 1.4434, 5e-5);
  EXPECT_NEAR(pair.twoG, 158461.5, 0.05);
  EXPECT_NEAR(pair.Di, 9.0 / 13.0, 1e-12);
  // the next step begins where this one has led to
  EXPECT_NEAR(elasticStress(pair, c.eps - next.plastic, i.mean, j.mean), s.sigma, 1e-9);
}

TEST(Contact, OpenUnlinkedPairsCarryNothing)
{
  const ContactStress s = of(law, link::none, 1e-9, 0.0, -5, 100, 0.5, -100, 0.7);
  EXPECT_EQ(s.sigma, 0.0);
  EXPECT_EQ(s.tau, 0.0);
  EXPECT_EQ(s.normal, 0.0);
}

TEST(Contact, RoundOffPressesNothing)
{
  const double approach = -1e3; // far more viscous stress than elastic
  for (double e : {-1e-15, -1e-10})
    EXPECT_EQ(of(law, link::none, e, 0, approach, -100, 1, -100, 1).normal, 0.0) << e;
  EXPECT_LT(of(law, link::none, -1e-8, 0, approach, -100, 1, -100, 1).normal, -100.0 * D);
}

TEST(Contact, UnlinkedPairsCarryCompressionAndViscosity)
{
  const double e = -0.001, mean = -30;
  const ContactStress s = of(law, link::none, e, 0.0, -0.2, mean, 0.5, mean, 0.5);
  EXPECT_CLOSE(s.sigma, twoG * e + D * mean); // elastic, whatever its automata do
  EXPECT_EQ(s.tau, 0.0);
  EXPECT_CLOSE(s.normal, s.sigma - 410 * 0.2 / 2.5);
  // never tensile by the viscosity; by the mean stress, where the energy is kept, while it touches
  EXPECT_EQ(of(law, link::none, e, 0, 1e6, mean, 1, mean, 1).normal, 0.0);
  const ContactStress pulled = of(law, link::none, e, 0, 1e6, 1e4, 1, 1e4, 1);
  EXPECT_CLOSE(pulled.normal, twoG * e + D * 1e4);
  EXPECT_EQ(pulled.viscous, 0.0);
  EXPECT_LT(of(law, link::none, e, 0, -1e3, 1e4, 1, 1e4, 1).viscous, 0.0);
  const PairLaw radial = noTransitions(steel(), steel(), "radial");
  EXPECT_EQ(of(radial, link::none, e, 0, 0, 1e4, 1, 1e4, 1).normal, 0.0);
}

TEST(Contact, ElasticBulkLinksAnswerHookesLaw)
{
  const ContactStress s = of(law, link::bulk, 0.0001, 0.0002, 3.0, 10, 1, 20, 1);
  EXPECT_CLOSE(s.trial, twoG * 0.0001 + D * 15);
  EXPECT_CLOSE(s.sigma, s.trial);
  EXPECT_CLOSE(s.normal, s.trial); // no viscosity in links
  EXPECT_CLOSE(s.tau, twoG * 0.0002);
}

TEST(Contact, YieldingAutomataReturnTheirBulkLinks)
{
  const double meanI = 10, meanJ = 20, MI = 0.6, MJ = 0.9;
  const ContactStress s = of(law, link::bulk, 0.001, 0.0002, 0, meanI, MI, meanJ, MJ);
  EXPECT_CLOSE(s.sigma,
               s.trial - ((1 - MI) * (s.trial - meanI) + (1 - MJ) * (s.trial - meanJ)) / 2);
  EXPECT_CLOSE(s.tau, (MI + MJ) / 2 * twoG * 0.0002);
  // NOLINTNEXTLINE(readability-suspicious-call-argument): the contact seen from the other end
  const ContactStress turned = of(law, link::bulk, 0.001, 0.0002, 0, meanJ, MJ, meanI, MI);
  EXPECT_CLOSE(turned.sigma, s.sigma);
  EXPECT_CLOSE(turned.tau, s.tau);
}

TEST(Contact, FlowOfAnUnlinkedContactEndsAtTheBreakingStrainAndAtCollapse)
{
  LawSet radial;
  ASSERT_EQ(radial.parse({"plasticity", "radial"}), "");
  const double most = steel().breakingStrain, e = -1e-4;
  // its automata pull, or press it by more than its own strain does
  for (const LawSet &set : {radial, LawSet()})
    for (const double mean : {1e3, 1e4, -1e3, -1e4})
      for (const double plastic :
           {-0.95, -0.9, -0.899, -0.01, 0.01, 0.999 * most, most, 1.01 * most}) {
        const PairLaw flows = makePairLaw(set, steel(), steel(), 1.0);
        const Answer side = {mean, 0.2, mean};
        Contact c{};
        c.kind = link::none;
        c.eps = plastic + e;
        c.ratio = std::exp(c.eps);
        c.plastic = plastic;
        const ContactStress s = contactStress<FractureByStrain>(flows, c, side, side);
        const double next = nextState(flows, c, s, 0.0, 0.0, 1.0).plastic;
        EXPECT_LE(next, std::max(plastic, most) * (1 + 1e-12)) << mean << ", " << plastic;
        EXPECT_GE(next, std::min(plastic, -0.9) * (1 + 1e-12)) << mean << ", " << plastic;
        EXPECT_LE(std::abs(s.sigma), std::abs(s.trial) + (mean < 0 ? 0.8 * std::abs(mean) : 0.0));
        EXPECT_LE(s.normal, set.keepsVolume() ? std::max(0.0, s.trial) : 0.0);
      }
}

TEST(Contact, WeldsAreElastic)
{
  const ContactStress s = of(law, link::weld, 0.001, 0.0002, 7.0, 10, 0.1, 20, 0.2);
  EXPECT_CLOSE(s.sigma, twoG * 0.001 + D * 15);
  EXPECT_CLOSE(s.normal, s.sigma);
  EXPECT_CLOSE(s.tau, twoG * 0.0002);
}

TEST(Contact, UnlikeMaterialsAnswerWithTheMeanOfBothSides)
{
  Material hard = steel();
  hard.youngsModulus *= 10;
  const PairLaw pair = noTransitions(steel(), hard);
  const ContactStress s = of(pair, link::bulk, 0.001, 0.0, 0, 0, 1, 0, 1);
  EXPECT_CLOSE(s.sigma, 0.5 * (twoG + 10 * twoG) * 0.001);
}

TEST(Contact, ALinkThatBreaksCarriesNoMore)
{
  const PairLaw b = makePairLaw(LawSet(), steel(), steel(), 1.0);
  // torn and sheared off: open, it carries nothing; pressed, only what an unlinked contact does
  const ContactStress torn = contactStress<FractureByStrain>(
      b, {link::bulk, 1.0, 0.05, 0, 1e-4, 0.05, 0}, {0, 1, 0}, {0, 1, 0});
  EXPECT_EQ(torn.kindNext, link::worn);
  EXPECT_EQ(torn.normal, 0.0);
  EXPECT_EQ(torn.shear, 0.0);
  EXPECT_GT(torn.tau, 0.0);
  const ContactStress pressed = contactStress<FractureByStrain>(
      b, {link::bulk, 1.0, -1e-4, 0, 1e-4, 0.05, 0}, {-5, 1, -5}, {-5, 1, -5});
  EXPECT_EQ(pressed.kindNext, link::worn);
  EXPECT_EQ(pressed.shear, 0.0);
  EXPECT_CLOSE(pressed.normal, twoG * -1e-4 + D * -5);
}

TEST(Contact, WhatHoldsCarriesItsElasticStress)
{
  const PairLaw b = makePairLaw(LawSet(), steel(), steel(), 1.0);
  const ContactStress s = contactStress<FractureByStrain>(b, {link::weld, 1.0, 1e-4, 0, 1e-4, 0, 9},
                                                          {1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(s.kindNext, link::weld);
  EXPECT_EQ(s.shear, s.tau);
  EXPECT_EQ(s.normal, s.sigma);
}
