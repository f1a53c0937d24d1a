// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/law_use.h"

#include "law/friction_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>
#include <vector>

namespace wheelrail {

namespace {

using Vector = Eigen::VectorXd;

constexpr double MPa = 1e6;
constexpr double leftOut = 0.005; ///< of the load, at either end
constexpr double margin = 0.1;    ///< of a limit of a fitted law

void widen(Range &range, const Range &other)
{
  range = {std::min(range[0], other[0]), std::max(range[1], other[1])};
}

/// The values between which all of the load is carried but for `leftOut` at either end.
Range loadedRange(const std::vector<double> &value, const std::vector<double> &load)
{
  std::vector<std::size_t> order(value.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return value[i] < value[j]; });
  const double limit = leftOut * std::accumulate(load.begin(), load.end(), 0.0);
  const auto firstBeyond = [&](auto begin, auto end) {
    double sum = 0.0;
    for (auto it = begin; it != end; ++it)
      if ((sum += load[*it]) > limit)
        return value[*it];
    return value[*begin];
  };
  return {firstBeyond(order.begin(), order.end()), firstBeyond(order.rbegin(), order.rend())};
}

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
  if (!other.any)
    return;
  if (!any) {
    *this = other;
    return;
  }
  widen(kappa1, other.kappa1);
  widen(kappa2, other.kappa2);
  widen(kappa3, other.kappa3);
  widen(pressure, other.pressure);
  widen(speed, other.speed);
}

LawUse lawUse(const FrictionSpecification &friction, const Vector &pressure, double slidingSpeed,
              const Vector &temperature)
{
  LawUse use;
  if (friction.isConstant() || friction.isFalling())
    return use;
  std::vector<double> load, strength;
  for (Eigen::Index i = 0; i < pressure.size(); ++i)
    if (pressure[i] > 0.0) {
      load.push_back(pressure[i]);
      strength.push_back(friction.strengthAt(temperature[i]));
    }
  if (load.empty())
    return use;
  use.any = true;
  const double speed = std::abs(slidingSpeed);
  if (friction.isTable()) {
    use.pressure = loadedRange(load, load);
    use.speed = {speed, speed};
    return use;
  }
  const auto [weakest, strongest] = std::minmax_element(strength.begin(), strength.end());
  const double E = friction.modulus;
  use.kappa3 = {E / *strongest, E / *weakest};
  const auto kappa1At = [&](double sigma) {
    return friction.velocityTerm ? kappa1(friction.density, E, speed, sigma) : 0.0;
  };
  use.kappa1 = {kappa1At(*strongest), kappa1At(*weakest)};
  if (friction.local) {
    std::vector<double> kappa(load.size());
    for (std::size_t i = 0; i < load.size(); ++i)
      kappa[i] = kappa2(load[i], E, strength[i]);
    use.kappa2 = loadedRange(kappa, load);
  } else { // pressures uniform in 0 .. 3 sigma_0: those below p carry (p/3 sigma_0)^2 of the load
    const double hardest = kappa2(3.0 * *strongest, E, *strongest);
    const double softest = kappa2(3.0 * *weakest, E, *weakest);
    use.kappa2 = {hardest * std::sqrt(leftOut), softest * std::sqrt(1.0 - leftOut)};
  }
  return use;
}

std::string lawWarning(const FrictionSpecification &friction, const FrictionLaw &law,
                       const LawUse &use)
{
  if (!use.any)
    return "";
  std::vector<std::string> outside;
  const auto compare = [&](const char *what, const Range &used, const std::optional<Range> &known,
                           double tolerance, double unit) {
    if (known && isOutside(used, *known, tolerance))
      outside.push_back(fmt::format("{} {} ({})", what, shown({used[0] / unit, used[1] / unit}),
                                    shown({(*known)[0] / unit, (*known)[1] / unit})));
  };
  if (law.table) {
    const FrictionTable &table = *law.table;
    constexpr double rounding = 1e-9;
    compare("pressure in MPa", use.pressure, Range{table.pressure.front(), table.pressure.back()},
            rounding, MPa);
    compare("sliding speed in m/s", use.speed, Range{table.speed.front(), table.speed.back()},
            rounding, 1.0);
    if (outside.empty())
      return "";
    return fmt::format("friction.law {}: the contact needs more than the table has (in brackets): "
                       "{}; beyond it the values of its border are taken",
                       friction.law, fmt::join(outside, ", "));
  }
  compare("E/sigma_0", use.kappa3,
          law.kappa3 ? std::optional<Range>({*law.kappa3, *law.kappa3}) : law.kappa3Range, margin,
          1.0);
  compare("kappa1", use.kappa1, law.kappa1Range, margin, 1.0);
  compare("kappa2", use.kappa2, law.kappa2Range, margin, 1.0);
  if (outside.empty())
    return "";
  return fmt::format("friction.law {} is used outside of what it was fitted on (in brackets): {}; "
                     "wr_creep's page says what that may mean",
                     friction.law, fmt::join(outside, ", "));
}

nlohmann::ordered_json toJson(const FrictionSpecification &friction, const LawUse &use)
{
  if (friction.isTable())
    return {{"pressure_MPa", {use.pressure[0] / MPa, use.pressure[1] / MPa}},
            {"sliding_speed_m_s", use.speed}};
  return {{"kappa1", use.kappa1}, {"kappa2", use.kappa2}, {"kappa3", use.kappa3}};
}

} // namespace wheelrail
