// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_step.h"

#include "room.h"

#include <algorithm>
#include <limits>

namespace mca {

// By what the mean stress enters a contact's force [stress]: D K of the laws, and what resists lack
// of room where that acts.
static double meanStressModulus(const LawSet &laws, const Material &m)
{
  const ElasticModuli moduli = elasticModuli(laws, m);
  return (moduli.D + (laws.keepsVolume() ? roomStiffness : 0.0)) * moduli.bulk;
}

// A packing with contacts of this shear modulus, D K and viscosity, of automata that have the
// diameter of the contact and mass and moment of inertia of `side`.
static CriticalStep stepOf(const LawSet &laws, const Material &side, double shearModulus, double DK,
                           double viscosity, double diameter, const Packing &packing)
{
  Packing turning = packing; // J/(m d^2) with the contact's d
  const double ratio = side.diameter / diameter;
  turning.inertia *= ratio * ratio;
  Material m = side;
  m.diameter = diameter;
  m.density =
      Cell{packing, side.diameter}.mass(side.density) / Cell{packing, diameter}.cellVolume();
  m.poissonsRatio = 0.0; // E = 2G, and K enters with D only
  m.youngsModulus = 2.0 * shearModulus;
  CriticalStep limit = criticalStep(m, DK / m.bulkModulus(), viscosity, turning, laws.resistsSlip(),
                                    laws.keepsVolume());
  if (!laws.flows()) // nothing is pressed that far
    limit.pressed = std::numeric_limits<double>::infinity();
  return limit;
}

CriticalStep contactStep(const LawSet &laws, const Material &i, const Material &j,
                         const Packing &packing, const Interface &interface)
{
  const double shearModulus = 0.5 * (i.shearModulus() + j.shearModulus());
  const double DK = std::max(meanStressModulus(laws, i), meanStressModulus(laws, j));
  const double viscosity = contactViscosity(laws, i, j, interface);
  const double diameter = 0.5 * (i.diameter + j.diameter);
  const CriticalStep a = stepOf(laws, i, shearModulus, DK, viscosity, diameter, packing);
  if (i == j)
    return a;
  const CriticalStep b = stepOf(laws, j, shearModulus, DK, viscosity, diameter, packing);
  return longestStep(laws, a) < longestStep(laws, b) ? a : b;
}

double longestStep(const LawSet &laws, const CriticalStep &limit)
{
  return std::min(laws.centresViscosity() ? limit.centred() : limit.plain(), limit.pressed);
}

} // namespace mca
