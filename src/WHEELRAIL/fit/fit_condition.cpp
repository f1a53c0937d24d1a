// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_condition.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail {

namespace {

bool isSameCondition(const FrictionRun &a, const FrictionRun &b)
{
  return a.kappa1 == b.kappa1 && a.kappa2 == b.kappa2 && a.kappa3 == b.kappa3 &&
         a.condition == b.condition && a.madeBy == b.madeBy;
}

void summarise(FitCondition &condition, const std::vector<FrictionRun> &runs)
{
  const auto n = static_cast<double>(condition.runs.size());
  const FrictionRun &first = runs[condition.runs.front()];
  double mean = 0.0, errors = 0.0, squares = 0.0;
  for (const std::size_t k : condition.runs) {
    mean += runs[k].mu / n;
    errors += runs[k].muSe * runs[k].muSe;
  }
  for (const std::size_t k : condition.runs)
    squares += std::pow(runs[k].mu - mean, 2);
  condition.ownError = std::sqrt(errors) / n;
  condition.scatter = condition.runs.size() > 1 ? std::sqrt(squares / (n - 1.0) / n)
                                                : std::numeric_limits<double>::quiet_NaN();
  const double error = std::fmax(condition.ownError, condition.scatter); // passes over a nan
  condition.mean = {first.kappa1, first.kappa2, mean, error, first.kappa3, first.ductility()};
}

} // namespace

std::vector<FitCondition> conditionsOf(const std::vector<FrictionRun> &runs)
{
  std::vector<FitCondition> conditions;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].leftOut.empty())
      continue;
    const auto home =
        std::find_if(conditions.begin(), conditions.end(), [&](const FitCondition &condition) {
          return isSameCondition(runs[condition.runs.front()], runs[i]);
        });
    if (home == conditions.end())
      conditions.push_back({{i}, {}, 0.0, 0.0});
    else
      home->runs.push_back(i);
  }
  for (FitCondition &condition : conditions)
    summarise(condition, runs);
  return conditions;
}

} // namespace wheelrail
