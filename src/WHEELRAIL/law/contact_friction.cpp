// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/contact_friction.h"

#include "base/errors.h"

#include <algorithm>
#include <fmt/format.h>

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

FrictionLaw readLaw(const FrictionSpecification &friction)
{
  if (!friction.isConstant())
    return readFrictionLaw(friction.law);
  FrictionLaw law;
  law.mu0 = friction.mu;
  law.source = friction.law;
  return law;
}

Vector frictionCoefficient(const FrictionSpecification &friction, const FrictionLaw &law,
                           const Vector &pressure, double slidingSpeed, const Vector &temperature)
{
  const auto n = pressure.size();
  if (friction.isConstant())
    return Vector::Constant(n, friction.mu);
  const double speed = friction.velocityTerm ? slidingSpeed : 0.0;
  const auto kappa1At = [&](double strength) {
    return kappa1(friction.density, friction.modulus, speed, strength);
  };
  Vector mu(n);
  for (Eigen::Index i = 0; i < n; ++i) {
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
