// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/polach_forces.h"

#include "law/forms/polach.h"
#include "shared/pi.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {

namespace {

using mcawr::pi;

/// Force of pure spin in units of phi/s_C, at most of the order of mu N a (Polach 1999).
double spinForce(double a, double bound, double shape, double epsilon)
{
  const double square = epsilon * epsilon;
  const double delta = (square - 1.0) / (square + 1.0);
  const double rest = std::pow(std::max(0.0, 1.0 - delta * delta), 1.5);
  const double K = epsilon * (delta * delta * (0.5 - delta / 3.0) - 1.0 / 6.0) + rest / 3.0;
  return 9.0 / 16.0 * a * bound * shape * K;
}

} // namespace

double polachFriction(const PolachParameters &parameters, double slipSpeed)
{
  return FallingFriction{parameters.mu0, parameters.A, parameters.B}(slipSpeed);
}

PolachForce polachForce(const PolachParameters &parameters, const PolachContact &contact,
                        const PolachState &state)
{
  // s_yC = eta + phi a, unless the spin makes the lateral creep smaller: then eta alone. s_C has it
  // in place of eta (Polach 1999); friction goes by the slip without spin.
  const double growth = std::cbrt(state.load / contact.load); // Hertz
  const double a = contact.a * growth, b = contact.b * growth;
  const double widened = state.lateral + state.spin * a;
  const double lateral = std::abs(widened) > std::abs(state.lateral) ? widened : state.lateral;
  const double length = std::hypot(state.creep, lateral);
  if (length == 0.0)
    return {};
  const double s = std::hypot(state.creep, state.lateral);
  const double bound = polachFriction(parameters, s * state.speed) * state.load;
  const KalkerCoefficients &C = contact.kalker;
  const double c = s > 0.0 ? std::hypot(C.c11 * state.creep, C.c22 * state.lateral) / s : 0.0;
  const double epsilon = contact.shearModulus * pi * a * b * c * length / (4.0 * bound);
  const double adhesion = parameters.kA * epsilon / (1.0 + std::pow(parameters.kA * epsilon, 2));
  const double force = 2.0 * bound / pi * (adhesion + std::atan(parameters.kS * epsilon));

  const double shape = 1.0 + 6.3 * (1.0 - std::exp(-a / b));
  const double reduction = 0.5 * (parameters.kA + parameters.kS);
  const double epsilonSpin = 8.0 / 3.0 * reduction * contact.shearModulus * b * std::sqrt(a * b) *
                             C.c23 * std::abs(lateral) / (bound * shape);
  const double spin =
      state.spin != 0.0 ? spinForce(a, bound, shape, epsilonSpin) * state.spin : 0.0;
  return {-force * state.creep / length, -(force * state.lateral + spin) / length};
}

} // namespace wheelrail
