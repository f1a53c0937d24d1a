// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/contact_friction.h"

#include "base/errors.h"
#include "law/friction_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wheelrail {

using Vector = Eigen::VectorXd;

double FrictionSpecification::strengthAt(double temperatureRise) const
{
  constexpr double weakest = 1e-3; // of the strength
  return strength * std::max(weakest, 1.0 - temperatureRise / strengthTemperature);
}

double FrictionSpecification::hardnessAt(double temperatureRise) const
{
  constexpr double hardnessOverStrength = 3.0;
  return hardnessOverStrength * strengthAt(temperatureRise);
}

double FallingFriction::operator()(double slidingSpeed) const
{
  return mu0 * ((1.0 - A) * std::exp(-B * slidingSpeed) + A);
}

bool FrictionSpecification::isTable() const
{
  constexpr std::string_view ending = ".csv";
  return law.size() > ending.size() &&
         law.compare(law.size() - ending.size(), ending.size(), ending) == 0;
}

FrictionLaw readLaw(const FrictionSpecification &friction)
{
  if (friction.isScaled())
    return readFrictionLaw(friction.law);
  FrictionLaw law;
  law.source = friction.law;
  if (friction.isTable())
    law.table = std::make_shared<const FrictionTable>(readFrictionTable(friction.law));
  else
    law.mu0 = friction.isFalling() ? friction.falling.mu0 : friction.mu;
  return law;
}

nlohmann::ordered_json toJson(const FrictionSpecification &friction, const FrictionLaw &law)
{
  constexpr double MPa = 1e6;
  if (friction.isFalling())
    return {{"format", "polach"},
            {"mu0", friction.falling.mu0},
            {"A", friction.falling.A},
            {"B_s_m", friction.falling.B}};
  if (!law.table)
    return toJson(law);
  const FrictionTable &table = *law.table;
  return {{"format", "table"},
          {"source", law.source},
          {"pressure_MPa", {table.pressure.front() / MPa, table.pressure.back() / MPa}},
          {"speed_m_s", {table.speed.front(), table.speed.back()}},
          {"mu", {table.mu.minCoeff(), table.mu.maxCoeff()}}};
}

Vector frictionCoefficient(const FrictionSpecification &friction, const FrictionLaw &law,
                           const Vector &pressure, double slidingSpeed, const Vector &temperature)
{
  const auto n = pressure.size();
  if (friction.isConstant())
    return Vector::Constant(n, friction.mu);
  if (friction.isFalling())
    return Vector::Constant(n, friction.falling(std::abs(slidingSpeed)));
  if (law.table) {
    Vector mu(n);
    for (Eigen::Index i = 0; i < n; ++i)
      mu[i] = (*law.table)(pressure[i], std::abs(slidingSpeed));
    return mu;
  }
  const double speed = friction.velocityTerm ? slidingSpeed : 0.0;
  const auto kappa1At = [&](double strength) {
    return kappa1(friction.density, friction.modulus, speed, strength);
  };
  Vector mu(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    // the mean over all pressures depends on temperature only, which mostly is one for all cells
    if (i > 0 && !friction.local && temperature[i] == temperature[i - 1]) {
      mu[i] = mu[i - 1];
      continue;
    }
    const double strength = friction.strengthAt(temperature[i]);
    mu[i] = friction.local
                ? law(kappa1At(strength), kappa2(pressure[i], friction.modulus, strength))
                : law.averaged(kappa1At(strength), friction.modulus, strength);
  }
  if (!(mu.minCoeff() > 0.0))
    throw Error(
        ExitCode::NotConverged,
        fmt::format("friction.law: mu = {:.4g} at a sliding speed of {:g} m/s; the law does "
                    "not hold that far from the points it was fitted to",
                    mu.minCoeff(), slidingSpeed));
  return mu;
}

} // namespace wheelrail
