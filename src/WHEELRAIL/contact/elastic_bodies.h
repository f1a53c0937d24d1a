// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_ELASTIC_BODIES_H
#define WHEELRAIL_CONTACT_ELASTIC_BODIES_H

#include <array>

namespace wheelrail {

/// One of the two bodies; Pa, > 0, and 0 to 1/2.
struct ElasticBody {
  double youngsModulus = 0.0, poissonsRatio = 0.0;
};

using ElasticBodies = std::array<ElasticBody, 2>; ///< wheel, rail

/// 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, Pa; of equal bodies E/(2 (1 - nu^2)).
double contactModulus(const ElasticBodies &bodies);

/// What couples pressure and traction of unlike half-planes (Dundurs' beta; Johnson, Contact
/// Mechanics, sec. 5.1): (E*/4) [(1 - 2 nu1)/G1 - (1 - 2 nu2)/G2], -1/2 to 1/2, above 0 where the
/// wheel is the softer one. 0 for equal bodies, as for some unlike ones; one that is rounding only
/// is 0.
double couplingOf(const ElasticBodies &bodies);

} // namespace wheelrail
#endif
