// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_analysis.h"
#include "fit/fit_condition.h"
#include "fit/seed_scatter.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace wheelrail;

namespace {

FrictionRun runAt(double kappa1, double kappa2, double mu, double muSe, long seed)
{
  FrictionRun run;
  run.kappa1 = kappa1;
  run.kappa2 = kappa2;
  run.kappa3 = 2239.0;
  run.mu = mu;
  run.muSe = muSe;
  run.head.seed = static_cast<double>(seed);
  run.tStart = 0.0;
  run.head.strength = 92.0;
  run.condition = {{"material", "steel"}, {"timestep", "5e-05"}};
  run.madeBy = {{"laws.preset", "b"}};
  return run;
}

} // namespace

TEST(FitCondition, ReplicasAreOnePointWithTheScatterOfTheSeeds)
{
  std::vector<FrictionRun> runs = {runAt(1, 10, 0.40, 0.003, 1), runAt(2, 10, 0.50, 0.003, 1),
                                   runAt(1, 10, 0.44, 0.004, 2), runAt(1, 10, 0.9, 0.1, 3)};
  runs[3].leftOut = "no stationary part";
  const auto conditions = conditionsOf(runs);
  ASSERT_EQ(conditions.size(), 2u);
  EXPECT_EQ(conditions[0].runs, (std::vector<std::size_t>{0, 2}));
  EXPECT_DOUBLE_EQ(conditions[0].mean.mu, 0.42);
  EXPECT_DOUBLE_EQ(conditions[0].ownError, 0.0025); // sqrt(0.003^2 + 0.004^2)/2
  EXPECT_NEAR(conditions[0].scatter, 0.02, 1e-15);  // of two: half their difference
  EXPECT_EQ(conditions[0].mean.muSe, conditions[0].scatter);
  EXPECT_EQ(conditions[1].mean.muSe, 0.003);
  EXPECT_TRUE(std::isnan(conditions[1].scatter));
  // seeds that agree by chance do not make the mean surer than the runs are
  runs[2].mu = runs[0].mu;
  EXPECT_EQ(conditionsOf(runs)[0].mean.muSe, 0.0025);
}

// 200 conditions of three seeds, whose mu differ by 4 % beyond the runs' own errors of 1 to 3 %.
TEST(SeedScatter, IsWhatSeedsDifferByBeyondTheirOwnErrors)
{
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  for (const double share : {0.0, 0.04}) {
    std::vector<FrictionRun> runs;
    for (int k = 0; k < 600; ++k) {
      const double mu = 0.3 + 0.001 * (k / 3), own = (0.01 + 0.01 * (k % 3)) * mu;
      runs.push_back(
          runAt(k / 3 + 1, 10, mu + std::hypot(own, share * mu) * normal(generator), own, k % 3));
      runs.back().muOwn = own;
    }
    const SeedScatter found = seedScatters(runs, conditionsOf(runs)).at(0);
    EXPECT_EQ(found.conditions, 200);
    EXPECT_EQ(found.freedom, 400);
    // 400 degrees of freedom know a variance to 7 %; 0.005 is a sixteenth of the own variance
    EXPECT_NEAR(found.share, share, share > 0.0 ? 0.003 : 0.005);
    addSeedScatter(runs, found);
    EXPECT_NEAR(runs[0].t95, 1.966, 1e-3); // of 400
    EXPECT_NEAR(runs[0].muSe, std::hypot(runs[0].muOwn, found.share * runs[0].mu), 1e-15);
  }
}

TEST(SeedScatter, OfOneRunEachNothingIsKnown)
{
  std::vector<FrictionRun> runs = {runAt(1, 10, 0.40, 0.003, 1), runAt(2, 10, 0.50, 0.003, 1)};
  for (FrictionRun &run : runs)
    run.muOwn = run.muSe;
  const SeedScatter none = seedScatters(runs, conditionsOf(runs)).at(0);
  EXPECT_EQ(none.conditions, 0);
  addSeedScatter(runs, none);
  EXPECT_EQ(runs[1].muSe, 0.003);
  EXPECT_EQ(runs[1].t95, normal95);
}

TEST(SeedScatter, OtherLawsAndOtherPackingsHaveTheirOwn)
{
  for (const bool laws : {true, false}) {
    std::vector<FrictionRun> runs;
    for (const long seed : {1, 2, 3}) {
      runs.push_back(runAt(1, 10, 0.40 + 0.02 * static_cast<double>(seed), 0.001, seed));
      runs.push_back(runAt(1, 10, 0.50 + 0.0001 * static_cast<double>(seed), 0.001, seed));
      if (laws)
        runs.back().madeBy["laws.preset"] = "a";
      else {
        runs.back().packing = "fcc";
        runs.back().condition["geometry"] = "packing: fcc";
      }
    }
    for (FrictionRun &run : runs)
      run.muOwn = run.muSe;
    const auto found = seedScatters(runs, conditionsOf(runs));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[1].runs, (std::vector<std::size_t>{1, 3, 5}));
    EXPECT_NEAR(found[0].share, 0.02 / 0.44, 0.002);
    EXPECT_EQ(found[1].share, 0.0);
    EXPECT_NEAR(found[1].t95(), 4.3027, 1e-4); // of 2
  }
}

TEST(FitCondition, AnotherMaterialLawOrStepIsAnotherCondition)
{
  for (const char *what : {"kappa3", "material", "timestep", "laws"}) {
    std::vector<FrictionRun> runs = {runAt(1, 10, 0.4, 0.003, 1), runAt(1, 10, 0.4, 0.003, 2)};
    ASSERT_EQ(conditionsOf(runs).size(), 1u);
    if (std::string(what) == "kappa3")
      runs[1].kappa3 = 2000.0;
    else if (std::string(what) == "laws")
      runs[1].madeBy["laws.preset"] = "a";
    else
      runs[1].condition[what] = "other";
    EXPECT_EQ(conditionsOf(runs).size(), 2u) << what;
  }
}

// 36 conditions on Eq. 3, each with a deviation of 6 % of its own that all of its seeds share, and
// 5 % between the seeds; the runs' own errors are 0.5 %. Counted as independent conditions the four
// seeds make the parameters look nearly twice as sure as they are.
TEST(FitConditionLong, StandardErrorsHoldTheScatterOfSeedsAndConditions)
{
  const KappaLaw truth = bucher2006();
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  constexpr int campaigns = 120, seeds = 4;
  double spread = 0.0, stated = 0.0, statedOfRuns = 0.0;
  int fitted = 0;
  for (int campaign = 0; campaign < campaigns; ++campaign) {
    std::vector<FrictionRun> runs;
    std::vector<ConditionMean> separately;
    for (double k1 : {0.02, 0.3, 1.0, 3.0, 8.0, 19.0})
      for (double k2 : {2.0, 20.0, 80.0, 200.0, 400.0, 633.0}) {
        const double shared = 1.0 + 0.06 * normal(generator);
        for (int seed = 1; seed <= seeds; ++seed) {
          const double mu = truth(k1, k2) * shared * (1.0 + 0.05 * normal(generator));
          runs.push_back(runAt(k1, k2, mu, 0.005 * mu, seed));
          separately.push_back({k1, k2, mu, 0.005 * mu, 2239.0});
        }
      }
    std::vector<ConditionMean> conditions;
    for (const FitCondition &condition : conditionsOf(runs))
      conditions.push_back(condition.mean);
    ASSERT_EQ(conditions.size(), 36u);
    const LawFit fit = fitLaw(LawModel::Full, conditions, 0.0);
    const LawFit ofRuns = fitLaw(LawModel::Full, separately, 0.0);
    // mu of the law at a usual place: the parameters themselves go with each other
    const auto error = [](const LawFit &f) {
      const double g1 = 1.0 / (1.0 + f.law.b), g2 = 1.0 / (1.0 + f.law.c * 200.0);
      Eigen::Matrix<double, 5, 1> d;
      d << 1.0, g1, g2, -f.law.mu1 * g1 * g1, -f.law.mu2 * 200.0 * g2 * g2;
      return std::sqrt(d.dot(*f.law.covariance * d));
    };
    spread += std::pow(fit.law(1.0, 200.0) - truth(1.0, 200.0), 2);
    stated += error(fit);
    statedOfRuns += error(ofRuns);
    ++fitted;
  }
  spread = std::sqrt(spread / fitted);
  EXPECT_NEAR(stated / fitted / spread, 1.0, 0.2); // 120 campaigns: +- 6.5 %
  EXPECT_LT(statedOfRuns / fitted, 0.75 * spread);
}

TEST(FitCondition, TheAnalysisFitsConditions)
{
  const KappaLaw truth = bucher2006();
  std::vector<FrictionRun> runs;
  for (double k1 : {0.02, 1.0, 8.0})
    for (double k2 : {2.0, 80.0, 633.0})
      for (long seed : {1, 2})
        runs.push_back(runAt(k1, k2, truth(k1, k2) * (seed == 1 ? 0.98 : 1.02), 0.002, seed));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].firstStep = {1};
    runs[i].firstMu = {runs[i].mu};
  }
  const FitAnalysis analysis = analyseRuns(runs, {});
  ASSERT_TRUE(analysis.fit) << analysis.whyNot;
  EXPECT_EQ(analysis.conditions.size(), 9u);
  EXPECT_EQ(analysis.fit->law.n, 9);
  EXPECT_EQ(analysis.fit->residuals.size(), 9u);
  EXPECT_NEAR(analysis.fit->law(1.0, 80.0), truth(1.0, 80.0), 1e-6);
  EXPECT_GT(std::sqrt((*analysis.fit->law.covariance)(0, 0)), 0.0);
  EXPECT_EQ(*analysis.fit->law.kappa3Range, (Range{2239.0, 2239.0}));
}
