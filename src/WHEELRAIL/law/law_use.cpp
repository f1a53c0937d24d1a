// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/law_use.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>

namespace wheelrail {

namespace {

/// Does `used` pass `known` by more than `tolerance`, a share of the limit?
bool isOutside(const Range &used, const Range &known, double tolerance)
{
  return used[0] < (1.0 - tolerance) * known[0] || used[1] > (1.0 + tolerance) * known[1];
}

std::string shown(const Range &range)
{
  const std::string low = fmt::format("{:.4g}", range[0]), high = fmt::format("{:.4g}", range[1]);
  return low == high ? low : low + " to " + high;
}

} // namespace

void LawUse::include(const LawUse &other)
{
  if (ranges.empty())
    ranges = other.ranges;
  for (std::size_t k = 0; k < other.ranges.size(); ++k)
    ranges[k] = {std::min(ranges[k][0], other.ranges[k][0]),
                 std::max(ranges[k][1], other.ranges[k][1])};
}

Range loadedRange(const std::vector<double> &value, const std::vector<double> &load)
{
  std::vector<std::size_t> order(value.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return value[i] < value[j]; });
  const double limit = leftOutLoad * std::accumulate(load.begin(), load.end(), 0.0);
  const auto firstBeyond = [&](auto begin, auto end) {
    double sum = 0.0;
    for (auto it = begin; it != end; ++it)
      if ((sum += load[*it]) > limit)
        return value[*it];
    return value[*begin];
  };
  return {firstBeyond(order.begin(), order.end()), firstBeyond(order.rbegin(), order.rend())};
}

std::string outsideOf(const std::vector<LawInput> &inputs, const LawUse &use, double tolerance)
{
  std::vector<std::string> outside;
  for (std::size_t k = 0; k < use.ranges.size(); ++k)
    if (inputs[k].known && isOutside(use.ranges[k], *inputs[k].known, tolerance))
      outside.push_back(fmt::format("{} {} ({})", inputs[k].words, shown(use.ranges[k]),
                                    shown(*inputs[k].known)));
  return fmt::format("{}", fmt::join(outside, ", "));
}

std::string fitWarning(const std::string &name, const std::vector<LawInput> &inputs,
                       const LawUse &use)
{
  constexpr double margin = 0.1;
  const std::string outside = outsideOf(inputs, use, margin);
  if (outside.empty())
    return "";
  return fmt::format("friction.law {} is used outside of what it was fitted on (in brackets): {}; "
                     "wr_creep's page says what that may mean",
                     name, outside);
}

} // namespace wheelrail
