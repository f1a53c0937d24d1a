// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/statistics.h"
#include "fit/law_fit.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <stdexcept>

using namespace wheelrail;

namespace {

/// A design like the paper's 36 runs: kappa1 0.02 .. 19, kappa2 2 .. 633, with Eq. 3's mu.
std::vector<ConditionMean> paperDesign()
{
  const auto law = bucher2006();
  std::vector<ConditionMean> means;
  for (double k1 : {0.02, 0.3, 1.0, 3.0, 8.0, 19.0})
    for (double k2 : {2.0, 20.0, 80.0, 200.0, 400.0, 633.0})
      means.push_back({k1, k2, law(k1, k2), 0.0});
  return means;
}

/// The paper's design with kappa3 varied about 2000 and mu in proportion to kappa3^0.3.
std::vector<ConditionMean> designWithKappa3()
{
  auto means = paperDesign();
  const std::array<double, 5> factors = {1.0, 0.4, 2.5, 0.6, 1.7};
  for (size_t i = 0; i < means.size(); ++i) {
    means[i].kappa3 = 2000.0 * factors[i % factors.size()];
    means[i].mu *= std::pow(factors[i % factors.size()], 0.3);
  }
  return means;
}

std::array<double, lawParameters> valuesOf(const KappaLaw &law)
{
  return {law.mu0, law.mu1, law.mu2, law.b, law.c};
}

} // namespace

TEST(LawFit, exactPointsGiveTheLawBack)
{
  const auto fit = fitLaw(LawModel::Full, paperDesign());
  const auto truth = valuesOf(bucher2006());
  const auto found = valuesOf(fit.law);
  for (int k = 0; k < lawParameters; ++k)
    EXPECT_NEAR(found[k] / truth[k], 1.0, 1e-6) << parameterNames[k];
  EXPECT_LT(fit.law.rmsRelative, 1e-9);
  EXPECT_EQ(fit.freedom, 31);
  EXPECT_EQ(fit.law.kappa2Range, (std::array<double, 2>{2.0, 633.0}));
  EXPECT_EQ(fit.notIdentifiable, "");
}

TEST(LawFit, powerOfKappa3)
{
  const auto means = designWithKappa3();
  const auto fit = fitLaw(LawModel::Kappa3, means, 0.95, 2000.0);
  const auto truth = valuesOf(bucher2006());
  const auto found = valuesOf(fit.law);
  for (int k = 0; k < lawParameters; ++k)
    EXPECT_NEAR(found[k] / truth[k], 1.0, 1e-6) << parameterNames[k];
  EXPECT_NEAR(fit.parameters[N], 0.3, 1e-7);
  EXPECT_EQ(fit.freedom, 30);
  EXPECT_LT(fit.law.rmsRelative, 1e-9);
  // another reference: the same law times the power
  const auto other = valuesOf(fitLaw(LawModel::Kappa3, means, 0.95, 500.0).law);
  const double factor = std::pow(0.25, 0.3);
  for (int k : {0, 1, 2})
    EXPECT_NEAR(other[k] / (factor * truth[k]), 1.0, 1e-6) << parameterNames[k];
  for (int k : {3, 4})
    EXPECT_NEAR(other[k] / truth[k], 1.0, 1e-6) << parameterNames[k];
  // none given: the geometric mean
  double mean = 0.0;
  for (const auto &p : means)
    mean += std::log(p.kappa3) / static_cast<double>(means.size());
  EXPECT_NEAR(fitLaw(LawModel::Kappa3, means).reference / std::exp(mean), 1.0, 1e-12);
}

TEST(LawFit, powerOfTheDuctility)
{
  // kappa3 is another number, which plays no part
  auto means = designWithKappa3();
  for (auto &p : means)
    p.ductility = 90.0 * p.kappa3 / 2000.0;
  for (std::size_t i = 0; i < means.size(); ++i)
    means[i].kappa3 = 500.0 + 100.0 * static_cast<double>(i);
  const auto fit = fitLaw(LawModel::Ductility, means, 0.95, 90.0);
  EXPECT_NEAR(fit.parameters[N], 0.3, 1e-6);
  EXPECT_EQ(fit.reference, 90.0);
  EXPECT_EQ(fit.law.ductility, 90.0);
  EXPECT_FALSE(fit.law.kappa3);
  EXPECT_LT(fit.law.rmsRelative, 1e-6);
  EXPECT_GT(fitLaw(LawModel::Kappa3, means).law.rmsRelative, 0.05);
  means[3].ductility = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(obstacleTo(LawModel::Ductility, means).reason.find("breaking strain"),
            std::string::npos);
}

TEST(LawFit, powerOfKappa3WithoutPressure)
{
  auto means = designWithKappa3();
  for (auto &p : means)
    p.mu = (0.43 + 0.0053 * p.kappa1 / (1.0 + 0.02 * p.kappa1)) * std::pow(p.kappa3 / 2000.0, 0.12);
  const auto fit = fitLaw(LawModel::VelocityKappa3, means, 0.95, 2000.0);
  const std::array<double, lawParameters> truth = {0.43, 0.0053, 0.0, 0.02, 0.0};
  const auto found = valuesOf(fit.law);
  for (int k = 0; k < lawParameters; ++k)
    EXPECT_NEAR(found[k], truth[k], 1e-6 * (truth[k] + 1e-3)) << parameterNames[k];
  EXPECT_NEAR(fit.parameters[N], 0.12, 1e-7);
  EXPECT_EQ(fit.law.kappa3, 2000.0);
  EXPECT_EQ(fit.freedom, 32);
  EXPECT_EQ(fit.notIdentifiable, "");
  EXPECT_LT(fit.aicc, fitLaw(LawModel::Velocity, means, 0.0).aicc);
}

TEST(LawFitLong, intervalOfTheExponentCovers)
{
  std::mt19937_64 generator(11);
  std::normal_distribution<double> normal;
  constexpr int fits = 100;
  int covered = 0, preferred = 0;
  double error = 0.0, spread = 0.0;
  for (int i = 0; i < fits; ++i) {
    auto means = designWithKappa3();
    for (auto &p : means)
      p.mu *= 1.0 + 0.09 * normal(generator);
    const auto fit = fitLaw(LawModel::Kappa3, means, 0.95, 2000.0);
    covered += fit.intervals[5].lower <= 0.3 && 0.3 <= fit.intervals[5].upper;
    error += std::sqrt(fit.covariance(N, N)) / fits;
    spread += std::pow(fit.parameters[N] - 0.3, 2) / fits;
    preferred += fit.aicc < fitLaw(LawModel::Full, means, 0.0).aicc;
  }
  EXPECT_GE(covered, 0.88 * fits);
  EXPECT_LE(covered, 99);
  EXPECT_NEAR(error / std::sqrt(spread), 1.0, 0.2);
  EXPECT_EQ(preferred, fits);
}

TEST(LawFit, exponentNeedsDifferentKappa3)
{
  const auto obstacle = obstacleTo(LawModel::Kappa3, paperDesign()); // kappa3 = 1 everywhere
  EXPECT_NE(obstacle.reason.find("kappa3"), std::string::npos);
  EXPECT_FALSE(obstacle.tooFew);
  auto means = designWithKappa3();
  means[3].kappa3 = 0.0;
  EXPECT_THROW(fitLaw(LawModel::Kappa3, means), std::invalid_argument);
}

// Eq. 3 with 9 % noise, errors of the runs themselves about 2 %: the 95 % intervals must cover the
// true values in 95 % of the fits. 150 fits: binomial standard deviation 1.8 %.
TEST(LawFitLong, intervalsCoverAtTheirLevel)
{
  const auto truth = valuesOf(bucher2006());
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  constexpr int fits = 150;
  std::array<int, lawParameters> covered{};
  double scatter = 0.0;
  double rms = 0.0;
  int fullIsBetter = 0;
  for (int i = 0; i < fits; ++i) {
    auto means = paperDesign();
    for (auto &p : means) {
      p.muSe = 0.02 * p.mu * std::exp(0.5 * normal(generator));
      p.mu *= 1.0 + 0.09 * normal(generator);
    }
    const auto fit = fitLaw(LawModel::Full, means);
    ASSERT_EQ(fit.notIdentifiable, "");
    for (int k = 0; k < lawParameters; ++k)
      covered[k] += truth[k] >= fit.intervals[k].lower && truth[k] <= fit.intervals[k].upper;
    scatter += fit.scatter / fits;
    rms += fit.law.rmsRelative / fits;
    fullIsBetter += fit.aicc < fitLaw(LawModel::Pressure, means, 0.0).aicc;
  }
  for (int k = 0; k < lawParameters; ++k) {
    EXPECT_GE(covered[k], 0.89 * fits) << parameterNames[k];
    EXPECT_LE(covered[k], 0.995 * fits) << parameterNames[k];
  }
  EXPECT_NEAR(scatter, std::sqrt(0.09 * 0.09 - 0.02 * 0.02), 0.006);
  EXPECT_NEAR(rms, 0.09 * std::sqrt(31.0 / 36.0), 0.006);
  EXPECT_EQ(fullIsBetter, fits);
}

TEST(LawFit, scatterIsZeroWhenTheErrorsExplainAll)
{
  std::mt19937_64 generator(8);
  std::normal_distribution<double> normal;
  auto means = paperDesign();
  for (auto &p : means) {
    p.muSe = 0.03;
    p.mu += 0.01 * normal(generator);
  }
  const auto fit = fitLaw(LawModel::Full, means, 0.0);
  EXPECT_EQ(fit.scatter, 0.0);
  EXPECT_LT(fit.chiSquared, fit.freedom);
}

TEST(LawFit, preciseRunsWeighMore)
{
  auto means = paperDesign();
  for (auto &p : means)
    p.muSe = 1e-3;
  means[17].mu = 1.0; // far off, but its own error says so
  means[17].muSe = 0.5;
  const auto fit = fitLaw(LawModel::Full, means, 0.0);
  EXPECT_NEAR(fit.law.mu2, 0.3243, 1e-3);
  EXPECT_LT(std::abs(fit.studentised[17]), outlierLimit);
  means[17].muSe = 1e-3;
  const auto outlier = fitLaw(LawModel::Full, means, 0.0);
  EXPECT_GT(outlier.studentised[17], outlierLimit);
}

// chi^2 is the degrees of freedom, here 1: no residual of a fit can be worth more than its root
TEST(LawFit, parameterAtItsBoundDoesNotMakeOutliers)
{
  std::vector<ConditionMean> means;
  const double kappa1[] = {0.02, 1.0, 8.0, 19.0, 3.0, 0.3};
  const double kappa2[] = {20.0, 400.0, 80.0, 633.0, 200.0, 300.0};
  const double noise[] = {1.03, 0.97, 1.02, 0.98, 0.99, 1.01};
  for (int i = 0; i < 6; ++i) {
    KappaLaw law = bucher2006();
    law.mu0 = -0.05;
    means.push_back({kappa1[i], kappa2[i], noise[i] * law(kappa1[i], kappa2[i]), 1e-4});
  }
  const auto fit = fitLaw(LawModel::Full, means, 0.0);
  ASSERT_TRUE(fit.atBound[0]);
  for (double value : fit.studentised)
    EXPECT_LT(std::abs(value), 1.1 * std::sqrt(fit.chiSquared));
}

// The profile of chi^2 along the bound: the interval of mu1 is its standard error times Student's
// t.
TEST(LawFit, errorsAlongABoundAreThoseOfTheProfile)
{
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  auto means = paperDesign();
  for (auto &p : means) {
    KappaLaw law = bucher2006();
    law.mu0 = -0.1;
    p.mu = law(p.kappa1, p.kappa2) + 0.01 * normal(generator);
    p.muSe = 0.01;
  }
  const auto fit = fitLaw(LawModel::Full, means);
  ASSERT_TRUE(fit.atBound[0]);
  EXPECT_EQ(fit.covariance(0, 0), 0.0);
  EXPECT_GT(fit.intervals[0].upper, 0.0);
  const double t = studentQuantile(0.975, fit.freedom);
  for (const int k : {1, 2}) {
    const double half = 0.5 * (fit.intervals[k].upper - fit.intervals[k].lower);
    EXPECT_NEAR(half / (t * std::sqrt(fit.covariance(k, k))), 1.0, 0.1) << parameterNames[k];
  }
}

TEST(LawFit, orderOfPointsDoesNotMatter)
{
  auto means = paperDesign();
  std::mt19937_64 generator(9);
  std::normal_distribution<double> normal;
  for (auto &p : means)
    p.mu *= 1.0 + 0.05 * normal(generator);
  const auto before = valuesOf(fitLaw(LawModel::Full, means, 0.0).law);
  std::shuffle(means.begin(), means.end(), generator);
  const auto after = valuesOf(fitLaw(LawModel::Full, means, 0.0).law);
  for (int k = 0; k < lawParameters; ++k)
    EXPECT_NEAR(after[k] / before[k], 1.0, 1e-6);
}

TEST(LawFit, modelsLeaveTermsOut)
{
  auto means = paperDesign();
  for (auto &p : means)
    p.mu = bucher2006().staticPart(p.kappa2);
  const auto fit = fitLaw(LawModel::Pressure, means);
  EXPECT_EQ(fit.law.mu1, 0.0);
  EXPECT_NEAR(fit.law.c, 0.00212, 1e-8);
  EXPECT_EQ((*fit.law.covariance)(1, 1), 0.0);
  EXPECT_EQ(fitLaw(LawModel::Constant, means, 0.0).freedom, 35);
}

TEST(LawFit, tooFewAndCollinearPointsAreNamed)
{
  auto means = paperDesign();
  const std::vector<ConditionMean> few(means.begin(), means.begin() + 5);
  auto obstacle = obstacleTo(LawModel::Full, few);
  EXPECT_TRUE(obstacle.tooFew);
  EXPECT_EQ(obstacle.reason, "5 conditions for the 5 parameters of eq2, at least 6 are needed");
  EXPECT_THROW(fitLaw(LawModel::Full, few), Error);

  for (auto &p : means)
    p.kappa1 = 1.0;
  obstacle = obstacleTo(LawModel::Full, means);
  EXPECT_FALSE(obstacle.tooFew);
  EXPECT_EQ(obstacle.reason,
            "the conditions have only 1 different kappa1 (1 to 1), at least 3 are needed");
  EXPECT_EQ(obstacleTo(LawModel::Pressure, means).reason, "");

  // kappa1 and kappa2 on one line, with mu a straight function of them: nothing tells mu1 from mu2
  std::vector<ConditionMean> line;
  for (int i = 1; i <= 12; ++i)
    line.push_back({0.01 * i, 100.0 * i, 0.4, 0.01});
  const auto fit = fitLaw(LawModel::Full, line);
  EXPECT_NE(fit.notIdentifiable, "");
}

TEST(LawFit, valuesThatAreNoNumbersAreRefused)
{
  for (int field = 0; field < 4; ++field) {
    auto means = paperDesign();
    double *values[] = {&means[3].kappa1, &means[3].kappa2, &means[3].mu, &means[3].muSe};
    *values[field] = std::nan("");
    EXPECT_THROW(fitLaw(LawModel::Full, means), std::invalid_argument);
  }
}
