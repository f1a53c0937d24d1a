// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/polach.h"

#include <cmath>

namespace wheelrail {

namespace {

constexpr double pi = 3.14159265358979323846;

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

double polachFriction(const PolachParameters &p, double slipSpeed)
{
  return p.mu0 * ((1.0 - p.A) * std::exp(-p.B * slipSpeed) + p.A);
}

PolachForce polachForce(const PolachParameters &p, const PolachContact &contact,
                        const PolachState &at)
{
  const double growth = std::cbrt(at.load / contact.load); // Hertz
  const double a = contact.a * growth, b = contact.b * growth;
  const double widened = at.lateral + at.spin * a;
  const double lateral = std::abs(widened) > std::abs(at.lateral) ? widened : at.lateral;
  const double length = std::hypot(at.creep, lateral);
  if (length == 0.0)
    return {};
  const double s = std::hypot(at.creep, at.lateral);
  const double bound = polachFriction(p, s * at.speed) * at.load;
  const KalkerCoefficients &C = contact.kalker;
  const double c = s > 0.0 ? std::hypot(C.c11 * at.creep, C.c22 * at.lateral) / s : 0.0;
  const double epsilon = contact.shearModulus * pi * a * b * c * length / (4.0 * bound);
  const double adhesion = p.kA * epsilon / (1.0 + std::pow(p.kA * epsilon, 2));
  const double force = 2.0 * bound / pi * (adhesion + std::atan(p.kS * epsilon));

  const double shape = 1.0 + 6.3 * (1.0 - std::exp(-a / b));
  const double reduction = 0.5 * (p.kA + p.kS);
  const double epsilonSpin = 8.0 / 3.0 * reduction * contact.shearModulus * b * std::sqrt(a * b) *
                             C.c23 * std::abs(lateral) / (bound * shape);
  const double spin = at.spin != 0.0 ? spinForce(a, bound, shape, epsilonSpin) * at.spin : 0.0;
  return {-force * at.creep / length, -(force * at.lateral + spin) / length};
}

} // namespace wheelrail
