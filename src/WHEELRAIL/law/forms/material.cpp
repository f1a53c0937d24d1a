// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/forms/material.h"

#include "base/errors.h"
#include "law/kappa_law.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wheelrail {

namespace {

using Vector = Eigen::VectorXd;

std::optional<FittedLaw<Eigen::Dynamic>::Covariance> covarianceOf(const MaterialLaw &law)
{
  if (law.table) {
    const Vector errors = law.table->standardErrors();
    if (errors.isZero(0.0))
      return std::nullopt;
    return Eigen::MatrixXd(errors.cwiseAbs2().asDiagonal());
  }
  if (!law.covariance)
    return std::nullopt;
  return Eigen::MatrixXd(*law.covariance);
}

} // namespace

std::vector<LawKeyword> LawOfMaterial::keywords()
{
  return {{"friction.ambient", LawKeyword::Kind::Quantity, "K", "293 K", 1, 1e4,
           "temperature of the bodies away from the contact, for a law of a material"}};
}

LawChoice LawOfMaterial::choose(const LawValues &values)
{
  LawChoice choice;
  choice.read = [path = values.name.path, ambient = values["friction.ambient"]] {
    return std::make_shared<LawOfMaterial>(path, readMaterialLaw(path), ambient);
  };
  choice.files = {values.name.path};
  choice.mayHaveCovariance = true;
  choice.hasStrength = true;
  choice.cellwise = CellwiseMu{"friction.law", "no law of a material"};
  return choice;
}

LawOfMaterial::LawOfMaterial(std::string name, MaterialLaw law, double ambient)
    : FittedLaw(covarianceOf(law)), name_(std::move(name)), law_(std::move(law)), ambient_(ambient)
{
  const SofteningMaterial &material = law_.material;
  MonotoneCurve strength{material.temperature, material.strength};
  for (double &kelvin : strength.x)
    kelvin -= ambient_;
  modulus_ = {strength.x, material.modulus};
  strength_.cold = strength(0.0);
  strength_.vanishingTemperature = std::max(1.0, strength.x.back());
  strength_.table = std::make_shared<MonotoneCurve>(std::move(strength));
  if (law_.table)
    curves_.emplace(*law_.table);
}

Vector LawOfMaterial::mu(const FrictionState &state) const
{
  const double speed = std::abs(state.slidingSpeed);
  Vector mu(state.pressure.size());
  for (Eigen::Index i = 0; i < mu.size(); ++i) {
    const double rise = state.temperature[i], sigma = strength_.at(rise);
    const double p = state.pressure[i];
    if (curves_) {
      mu[i] = (*curves_)(p / sigma, ambient_ + rise, speed);
      continue;
    }
    const double E = modulus_(rise);
    const Kappas kappas = {kappa1(law_.material.density, E, speed, sigma), kappa2(p, E, sigma),
                           E / sigma};
    mu[i] = boundedMu(law_.parameters, kappas, kappas.kappa3 / law_.kappa3);
  }
  if (!(mu.array() > 0.0).all())
    throw Error(ExitCode::NotConverged,
                fmt::format("friction.law: mu = {:.4g} at a sliding speed of {:g} m/s; the law "
                            "does not hold that far from the runs it was fitted to",
                            mu.minCoeff(), state.slidingSpeed));
  return mu;
}

std::vector<LawInput> LawOfMaterial::inputs() const
{
  const std::vector<double> &known = law_.material.temperature;
  return {{"pressure_over_strength", "p/sigma_0", law_.pressureRange},
          {"temperature_K", "temperature in K",
           law_.temperatureRange.value_or(Range{known.front(), known.back()})},
          {"sliding_speed_m_s", "sliding speed in m/s", law_.speedRange}};
}

LawUse LawOfMaterial::use(const FrictionState &state) const
{
  std::vector<double> load, ratio, kelvin;
  for (Eigen::Index i = 0; i < state.pressure.size(); ++i)
    if (state.pressure[i] > 0.0) {
      load.push_back(state.pressure[i]);
      ratio.push_back(state.pressure[i] / strength_.at(state.temperature[i]));
      kelvin.push_back(ambient_ + state.temperature[i]);
    }
  if (load.empty())
    return {};
  const double speed = std::abs(state.slidingSpeed);
  return {{loadedRange(ratio, load), loadedRange(kelvin, load), {speed, speed}}};
}

std::string LawOfMaterial::warning(const LawUse &use) const
{
  return fitWarning(name_, inputs(), use);
}

nlohmann::ordered_json LawOfMaterial::json() const
{
  return toJson(law_);
}

LawPointer LawOfMaterial::changed(const Vector &change) const
{
  MaterialLaw other = law_;
  if (other.table)
    other.table = other.table->changed(change);
  else
    other.parameters += change;
  return std::make_shared<LawOfMaterial>(name_, std::move(other), ambient_);
}

bool LawOfMaterial::isDefined() const
{
  if (law_.table) {
    for (const MuTable::Row &row : law_.table->rows)
      if (*std::min_element(row.mu.begin(), row.mu.end()) <= 0.0)
        return false;
    return true;
  }
  const LawParameters &x = law_.parameters;
  return x[B] >= 0.0 && x[C] >= 0.0 && x.tail<allParameters - S>().minCoeff() >= 0.0 &&
         (x[S] == 0.0 || x[Q] >= roundestBend);
}

bool LawOfMaterial::isSound() const
{
  if (law_.table || !isDefined())
    return isDefined();
  // monotone in kappa1 and kappa2 as far as B goes, which alone can be negative: the corners, at
  // every temperature
  constexpr double anyPressure = 1e30; // Pa
  for (const double kelvin : law_.material.temperature)
    for (const double speed : {0.0, law_.speedRange.value_or(Range{})[1]})
      for (const double pressure : {0.0, anyPressure})
        if (!(law_(pressure, speed, kelvin) > 0.0))
          return false;
  return true;
}

} // namespace wheelrail
