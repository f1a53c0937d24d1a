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

ReplicateGroup summarise(const std::vector<const FrictionPoint *> &members)
{
  ReplicateGroup group;
  group.n = static_cast<int>(members.size());
  group.kappa1 = members.front()->kappa1;
  group.kappa2 = members.front()->kappa2;
  for (const auto *p : members)
    group.mu += p->mu / group.n;
  double squares = 0.0;
  double errors = 0.0;
  for (const auto *p : members) {
    squares += std::pow(p->mu - group.mu, 2);
    errors += p->muSe * p->muSe;
  }
  group.scatter = std::sqrt(squares / (group.n - 1)) / group.mu;
  group.expected = std::sqrt(errors / group.n) / group.mu;
  return group;
}

} // namespace

std::vector<ReplicateGroup> replicateGroups(const std::vector<FrictionPoint> &points)
{
  std::vector<std::vector<const FrictionPoint *>> groups;
  for (const auto &p : points) {
    if (!p.leftOut.empty() || !std::isfinite(p.muSe))
      continue;
    const auto home = std::find_if(groups.begin(), groups.end(), [&](const auto &members) {
      return nearlyEqual(members.front()->kappa1, p.kappa1) &&
             nearlyEqual(members.front()->kappa2, p.kappa2);
    });
    if (home == groups.end())
      groups.push_back({&p});
    else
      home->push_back(&p);
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
