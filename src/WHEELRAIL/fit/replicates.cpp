// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/replicates.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {

namespace {

bool nearlyEqual(double a, double b)
{
  constexpr double tolerance = 1e-3;
  return std::abs(a - b) <= tolerance * std::max(a, b);
}

ReplicateGroup summarise(const std::vector<const FrictionRun *> &members)
{
  ReplicateGroup group;
  group.n = static_cast<int>(members.size());
  group.kappa1 = members.front()->kappa1;
  group.kappa2 = members.front()->kappa2;
  for (const auto *run : members)
    group.mu += run->mu / group.n;
  double squares = 0.0;
  double errors = 0.0;
  for (const auto *run : members) {
    squares += std::pow(run->mu - group.mu, 2);
    errors += run->muSe * run->muSe;
  }
  group.scatter = std::sqrt(squares / (group.n - 1)) / group.mu;
  group.expected = std::sqrt(errors / group.n) / group.mu;
  return group;
}

} // namespace

std::vector<ReplicateGroup> replicateGroups(const std::vector<FrictionRun> &runs)
{
  std::vector<std::vector<const FrictionRun *>> groups;
  for (const auto &run : runs) {
    if (!run.leftOut.empty() || !std::isfinite(run.muSe))
      continue;
    const auto home = std::find_if(groups.begin(), groups.end(), [&](const auto &members) {
      return nearlyEqual(members.front()->kappa1, run.kappa1) &&
             nearlyEqual(members.front()->kappa2, run.kappa2);
    });
    if (home == groups.end())
      groups.push_back({&run});
    else
      home->push_back(&run);
  }
  std::vector<ReplicateGroup> result;
  for (const auto &members : groups)
    if (members.size() > 1)
      result.push_back(summarise(members));
  std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) {
    return a.kappa1 != b.kappa1 ? a.kappa1 < b.kappa1 : a.kappa2 < b.kappa2;
  });
  return result;
}

} // namespace wheelrail
