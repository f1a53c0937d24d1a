// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "creep/sweep/law_spread.h"
#include "law/forms/eq2.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace wheelrail;

namespace {

/// In each cell; a strength and a modulus of 1 Pa make kappa2 the pressure, a density of 1 kappa1
/// the square of the speed.
const Eq2Scale scale{true, true, {1.0, 1.0}, 1.0, 1.0};

LawPointer lawOf(const KappaLaw &law)
{
  return std::make_shared<Eq2Law>(law.source, law, scale);
}

LawPointer lawWith(const LawCovariance &covariance)
{
  KappaLaw law = bucher2006();
  law.covariance = covariance;
  return lawOf(law);
}

double muAt(const FrictionLaw &law, double kappa1, double kappa2)
{
  const Eigen::VectorXd pressure = Eigen::VectorXd::Constant(1, kappa2);
  return law.mu({pressure, std::sqrt(kappa1), Eigen::VectorXd::Zero(1)})[0];
}

SpreadSpecification by(UncertaintyMethod method, int samples = 2000)
{
  return {method, samples, 1};
}

std::vector<double> muOf(const LawSpread &spread, double kappa2)
{
  std::vector<double> results;
  for (const LawPointer &law : spread.laws())
    results.push_back(muAt(*law, 0.1, kappa2));
  return results;
}

} // namespace

TEST(LawSpread, NoCovarianceNoBand)
{
  const LawSpread spread(by(UncertaintyMethod::Sampled), lawOf(bucher2006()));
  EXPECT_FALSE(spread.any());
  const Band band = spread.band({0.3});
  EXPECT_EQ(band.low, 0.3);
  EXPECT_EQ(band.high, 0.3);
}

TEST(LawSpread, BothMethodsGiveTheErrorOfALinearResult)
{
  // mu at kappa2 = 0 and kappa1 = 0.1 depends on mu0 + mu2 and a little on mu1
  LawCovariance covariance = LawCovariance::Zero();
  covariance.diagonal() << 4e-4, 1e-8, 9e-4, 0.0, 0.0;
  covariance(0, 2) = covariance(2, 0) = -0.9 * 0.02 * 0.03;
  const double error = std::sqrt(4e-4 + 9e-4 - 2 * 0.9 * 0.02 * 0.03);
  for (auto method : {UncertaintyMethod::Linear, UncertaintyMethod::Sampled}) {
    const LawSpread spread(by(method), lawWith(covariance));
    const Band band = spread.band(muOf(spread, 0.0));
    EXPECT_NEAR(band.standardError / error, 1.0, 0.05); // 2000 samples: +-1.6 %
    EXPECT_NEAR((band.high - band.low) / (2 * 1.959964 * error), 1.0, 0.06);
    EXPECT_EQ(spread.redrawn(), 0.0);
  }
}

TEST(LawSpread, ALawThatChangesNothingIsTheLawItself)
{
  // two parameters are known to an error, and below c there is no law
  KappaLaw law = bucher2006();
  law.c = 1e-5;
  law.covariance = LawCovariance::Zero();
  law.covariance->diagonal() << 1e-4, 0.0, 0.0, 0.0, 1e-6;
  const LawSpread spread(by(UncertaintyMethod::Linear), lawOf(law));
  const std::vector<LawPointer> &laws = spread.laws();
  EXPECT_EQ(std::count(laws.begin(), laws.end(), laws.front()), 8);
  EXPECT_EQ(laws.size(), 11U);
  law.covariance = LawCovariance::Zero();
  EXPECT_TRUE(LawSpread(by(UncertaintyMethod::Linear), lawOf(law)).any());
}

TEST(LawSpread, DifferencesStayWithLaws)
{
  // b and c near 0, known badly: a tenth of their errors below them there is no law
  KappaLaw law = bucher2006();
  law.b = 0.01;
  law.c = 1e-5;
  law.covariance = LawCovariance::Zero();
  law.covariance->diagonal() << 0.0, 0.0, 0.0, 0.04, 1e-6;
  const LawSpread spread(by(UncertaintyMethod::Linear), lawOf(law));
  for (const LawPointer &near : spread.laws())
    EXPECT_TRUE(near->isSound());
  EXPECT_EQ(spread.warning(), "");
  KappaLaw above = law;
  above.c += 1e-4; // a tenth of its error
  std::vector<double> mu = muOf(spread, 100.0);
  const double error = 10.0 * (muAt(*lawOf(above), 0.1, 100.0) - mu[0]);
  EXPECT_NEAR(spread.band(mu).standardError, std::abs(error), 1e-3 * std::abs(error));
}

TEST(LawSpread, NamesWhatTheLinearBandLeavesOut)
{
  KappaLaw law = bucher2006();
  law.covariance = 1e-6 * LawCovariance::Identity();
  law.b = -1.0;
  const LawSpread spread(by(UncertaintyMethod::Linear), lawOf(law));
  EXPECT_NE(spread.warning().find("leaves out 5 of the law's 5 parameters"), std::string::npos);
  EXPECT_EQ(spread.band(muOf(spread, 1.0)).standardError, 0.0);
}

TEST(LawSpread, SamplesSeeWhatIsNotLinear)
{
  // c known to 60 %: mu = mu0 + mu2/(1 + c kappa2) is skew, and c < 0 is drawn again
  LawCovariance covariance = LawCovariance::Zero();
  covariance(4, 4) = std::pow(0.6 * 0.00212, 2);
  const LawSpread spread(by(UncertaintyMethod::Sampled), lawWith(covariance));
  const auto mu = muOf(spread, 1500.0);
  const Band band = spread.band(mu);
  EXPECT_GT(band.high - mu[0], 1.5 * (mu[0] - band.low));
  EXPECT_NEAR(spread.redrawn(), 0.0478, 0.015); // of a normal distribution below -1/0.6
  for (const LawPointer &law : spread.laws())
    EXPECT_TRUE(law->isSound());
}

TEST(LawSpread, TheSeedAloneDecides)
{
  const LawCovariance covariance = 1e-6 * LawCovariance::Identity();
  SpreadSpecification input = by(UncertaintyMethod::Sampled, 50);
  const LawSpread first(input, lawWith(covariance)), again(input, lawWith(covariance));
  input.seed = 2;
  const LawSpread other(input, lawWith(covariance));
  ASSERT_EQ(first.laws().size(), 51u);
  for (std::size_t k = 1; k < first.laws().size(); ++k) {
    const auto mu = [&](const LawSpread &spread) { return muAt(*spread.laws()[k], 0.1, 100.0); };
    EXPECT_EQ(mu(first), mu(again));
    EXPECT_NE(mu(first), mu(other));
  }
}

TEST(LawSpread, RefusesACovarianceWithHardlyAnyLaw)
{
  KappaLaw law = bucher2006();
  law.covariance = 1e-6 * LawCovariance::Identity();
  law.mu0 = -0.01; // mu < 0 at high pressure, ten standard errors from a law
  try {
    const LawSpread spread(by(UncertaintyMethod::Sampled, 100), lawOf(law));
    FAIL() << "was accepted";
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::NotConverged);
    EXPECT_NE(std::string(error.what()).find("(b, c >= 0, mu > 0)"), std::string::npos);
  }
}
