// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/forms/eq2.h"

#include "base/errors.h"
#include "law/strength_keywords.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wheelrail {

using Vector = Eigen::VectorXd;

std::vector<LawKeyword> Eq2Law::keywords()
{
  using Kind = LawKeyword::Kind;
  std::vector<LawKeyword> rows = {
      {"friction.local", Kind::Switch, "1", "false", 0, 0,
       "true: mu from the pressure at each place; false: mean over pressures 0 to 3 x strength"},
      {"friction.velocity_term", Kind::Switch, "1", "true", 0, 0,
       "false: kappa1 = 0 (Eqs. 5, 8); true: kappa1 from the sliding speed (Eqs. 2, 9)"}};
  for (const LawKeyword &keyword : strengthKeywords())
    rows.push_back(keyword);
  rows.push_back(
      {"friction.modulus", Kind::Quantity, "Pa", "206 GPa", 1, 1e15, "E of kappa1 and kappa2"});
  rows.push_back(
      {"friction.density", Kind::Quantity, "kg/m3", "7800 kg/m3", 1e-6, 1e9, "rho of kappa1"});
  return rows;
}

LawChoice Eq2Law::choose(const LawValues &values)
{
  Eq2Scale scale;
  scale.local = values["friction.local"] != 0.0;
  scale.velocityTerm = values["friction.velocity_term"] != 0.0;
  scale.strength = strengthFrom(values);
  scale.modulus = values["friction.modulus"];
  scale.density = values["friction.density"];
  const bool builtIn = values.name.word == word;
  const std::string name = builtIn ? word : values.name.path;
  LawChoice choice;
  choice.read = [=] {
    return std::make_shared<Eq2Law>(name, builtIn ? bucher2006() : readKappaLaw(name), scale);
  };
  if (!builtIn)
    choice.files = {name};
  choice.mayHaveCovariance = true;
  choice.takesStrength = true;
  if (scale.local)
    choice.cellwise = CellwiseMu{"friction.local", "false"};
  return choice;
}

Vector Eq2Law::mu(const FrictionState &state) const
{
  const double speed = scale_.velocityTerm ? state.slidingSpeed : 0.0;
  const Vector &pressure = state.pressure, &temperature = state.temperature;
  Vector mu(pressure.size());
  for (Eigen::Index i = 0; i < mu.size(); ++i) {
    // the mean over all pressures depends on temperature only, which mostly is one for all cells
    if (i > 0 && !scale_.local && temperature[i] == temperature[i - 1]) {
      mu[i] = mu[i - 1];
      continue;
    }
    const double strength = scale_.strength.at(temperature[i]);
    mu[i] = scale_.local
                ? law_(kappa1At(speed, strength), kappa2(pressure[i], scale_.modulus, strength))
                : law_.averaged(kappa1At(speed, strength), scale_.modulus, strength);
  }
  if (!(mu.array() > 0.0).all())
    throw Error(
        ExitCode::NotConverged,
        fmt::format("friction.law: mu = {:.4g} at a sliding speed of {:g} m/s; the law does "
                    "not hold that far from the conditions it was fitted to",
                    mu.minCoeff(), state.slidingSpeed));
  return mu;
}

std::vector<LawInput> Eq2Law::inputs() const
{
  return {{"kappa3", "E/sigma_0",
           law_.kappa3 ? std::optional<Range>({*law_.kappa3, *law_.kappa3}) : law_.kappa3Range},
          {"kappa1", "kappa1", law_.kappa1Range},
          {"kappa2", "kappa2", law_.kappa2Range}};
}

LawUse Eq2Law::use(const FrictionState &state) const
{
  std::vector<double> load, strength;
  for (Eigen::Index i = 0; i < state.pressure.size(); ++i)
    if (state.pressure[i] > 0.0) {
      load.push_back(state.pressure[i]);
      strength.push_back(scale_.strength.at(state.temperature[i]));
    }
  if (load.empty())
    return {};
  const auto [weakest, strongest] = std::minmax_element(strength.begin(), strength.end());
  const double E = scale_.modulus;
  const Range kappa3 = {E / *strongest, E / *weakest};
  const double speed = scale_.velocityTerm ? std::abs(state.slidingSpeed) : 0.0;
  const Range kappa1 = {kappa1At(speed, *strongest), kappa1At(speed, *weakest)};
  Range kappa2;
  if (scale_.local) {
    std::vector<double> kappa(load.size());
    for (std::size_t i = 0; i < load.size(); ++i)
      kappa[i] = wheelrail::kappa2(load[i], E, strength[i]);
    kappa2 = loadedRange(kappa, load);
  } else { // pressures uniform in 0 .. 3 sigma_0: those below p carry (p/3 sigma_0)^2 of the load
    const double hardest = wheelrail::kappa2(3.0 * *strongest, E, *strongest);
    const double softest = wheelrail::kappa2(3.0 * *weakest, E, *weakest);
    kappa2 = {hardest * std::sqrt(leftOutLoad), softest * std::sqrt(1.0 - leftOutLoad)};
  }
  return {{kappa3, kappa1, kappa2}};
}

std::string Eq2Law::warning(const LawUse &use) const
{
  return fitWarning(name_, inputs(), use);
}

nlohmann::ordered_json Eq2Law::json() const
{
  return toJson(law_);
}

LawPointer Eq2Law::changed(const Vector &change) const
{
  KappaLaw other = law_;
  other.mu0 += change[0];
  other.mu1 += change[1];
  other.mu2 += change[2];
  other.b += change[3];
  other.c += change[4];
  return std::make_shared<Eq2Law>(name_, other, scale_);
}

bool Eq2Law::isDefined() const
{
  return law_.b >= 0.0 && law_.c >= 0.0;
}

bool Eq2Law::isSound() const
{
  constexpr double anyPressure = 1e300;
  if (!isDefined())
    return false;
  // monotone in both: the corners are the extremes
  for (const double k1 : {0.0, law_.kappa1Range.value_or(Range{})[1]})
    for (const double k2 : {0.0, anyPressure})
      if (!(law_(k1, k2) > 0.0))
        return false;
  return true;
}

} // namespace wheelrail
