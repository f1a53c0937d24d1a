// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/seed_scatter.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace wheelrail {

namespace {

double errorWith(const FrictionRun &run, double share)
{
  return std::hypot(run.muOwn, share * run.mu);
}

/// Squared deviations from the condition's weighted mean, in units of the errors.
double deviationsOf(const FitCondition &condition, const std::vector<FrictionRun> &runs,
                    double share)
{
  double weights = 0.0, mean = 0.0, sum = 0.0;
  for (const std::size_t k : condition.runs) {
    const double weight = std::pow(errorWith(runs[k], share), -2);
    weights += weight;
    mean += weight * runs[k].mu;
  }
  mean /= weights;
  for (const std::size_t k : condition.runs)
    sum += std::pow((runs[k].mu - mean) / errorWith(runs[k], share), 2);
  return sum;
}

/// Does each run have an error of its own? A constant series has none.
bool tells(const FitCondition &condition, const std::vector<FrictionRun> &runs)
{
  return condition.runs.size() > 1 &&
         std::all_of(condition.runs.begin(), condition.runs.end(),
                     [&](std::size_t k) { return runs[k].muOwn > 0.0; });
}

/// What seeds differ by in conditions with the same laws, program and packing.
SeedScatter scatterOf(const std::vector<const FitCondition *> &conditions,
                      const std::vector<FrictionRun> &runs)
{
  SeedScatter scatter;
  std::vector<const FitCondition *> telling;
  for (const FitCondition *condition : conditions) {
    scatter.runs.insert(scatter.runs.end(), condition->runs.begin(), condition->runs.end());
    if (!tells(*condition, runs))
      continue;
    telling.push_back(condition);
    scatter.freedom += static_cast<int>(condition->runs.size()) - 1;
  }
  std::sort(scatter.runs.begin(), scatter.runs.end());
  scatter.conditions = static_cast<int>(telling.size());
  const auto excess = [&](double share) {
    double sum = -scatter.freedom;
    for (const FitCondition *condition : telling)
      sum += deviationsOf(*condition, runs, share);
    return sum;
  };
  if (telling.empty() || excess(0.0) <= 0.0)
    return scatter;
  double low = 0.0, high = 1.0; // the sum falls with the share
  while (excess(high) > 0.0)
    high *= 2.0;
  constexpr int halvings = 60; // to the last digit
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  scatter.share = high;
  return scatter;
}

} // namespace

double SeedScatter::t95() const
{
  constexpr double upper = 0.975;
  return freedom > 0 ? studentQuantile(upper, freedom) : normal95;
}

std::vector<SeedScatter> seedScatters(const std::vector<FrictionRun> &runs,
                                      const std::vector<FitCondition> &conditions)
{
  std::vector<std::vector<const FitCondition *>> groups;
  const auto kindOf = [&](const FitCondition &condition) {
    const FrictionRun &run = runs[condition.runs.front()];
    return std::tie(run.madeBy, run.packing);
  };
  for (const FitCondition &condition : conditions) {
    const auto home = std::find_if(groups.begin(), groups.end(), [&](const auto &group) {
      return kindOf(*group.front()) == kindOf(condition);
    });
    if (home == groups.end())
      groups.push_back({&condition});
    else
      home->push_back(&condition);
  }
  std::vector<SeedScatter> scatters;
  for (const auto &group : groups)
    scatters.push_back(scatterOf(group, runs));
  return scatters;
}

void addSeedScatter(std::vector<FrictionRun> &runs, const SeedScatter &scatter)
{
  for (const std::size_t k : scatter.runs) {
    runs[k].muSe = errorWith(runs[k], scatter.share);
    runs[k].t95 = scatter.t95();
  }
}

} // namespace wheelrail
