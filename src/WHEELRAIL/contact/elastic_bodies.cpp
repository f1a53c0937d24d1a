// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/elastic_bodies.h"

#include <cmath>

namespace wheelrail {

double contactModulus(const ElasticBodies &bodies)
{
  const auto planeModulus = [](const ElasticBody &body) {
    return body.youngsModulus / (1.0 - body.poissonsRatio * body.poissonsRatio);
  };
  const double first = planeModulus(bodies[0]), second = planeModulus(bodies[1]);
  return first / (1.0 + first / second); // exactly half of each where they are equal
}

double couplingOf(const ElasticBodies &bodies)
{
  constexpr double rounding = 1e-9;
  // (1 - 2 nu)/G
  const auto ofBody = [](const ElasticBody &body) {
    return 2.0 * (1.0 + body.poissonsRatio) * (1.0 - 2.0 * body.poissonsRatio) / body.youngsModulus;
  };
  const double beta = 0.25 * contactModulus(bodies) * (ofBody(bodies[0]) - ofBody(bodies[1]));
  return std::abs(beta) > rounding ? beta : 0.0;
}

} // namespace wheelrail
