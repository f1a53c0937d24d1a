// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_CASES_H
#define WHEELRAIL_CONTACT_CASES_H

#include "contact/elastic_bodies.h"
#include "contact/hertz.h"
#include "contact/line/contact_interval.h"
#include "contact/line/profile.h"
#include "contact/normal_contact.h"

#include <algorithm>
#include <cmath>

/// Contacts that several tests use.
namespace contact_cases {

/// Table 2 of the paper.
inline wheelrail::HertzContact table2()
{
  return wheelrail::hertzContact(4e6, 0.5,
                                 wheelrail::contactModulus({{{210e9, 0.3}, {210e9, 0.3}}}));
}

/// T/N in steady rolling of a smooth cylinder with constant friction (Carter 1926):
/// mu (1 - (1 - creep/creepMax)^2), full sliding from creepMax = mu a/R on.
inline double carter(const wheelrail::HertzContact &contact, double mu, double creep)
{
  const double stick = std::max(0.0, 1.0 - creep * contact.radius / (mu * contact.halfWidth));
  return mu * (1.0 - stick * stick);
}

/// Its cylinder on n cells over `domain` half-widths, rough if rmsSlope > 0 (H = 0.8, 0.1 to 10
/// mm).
inline wheelrail::NormalContactProblem cylinder(int n, double rmsSlope = 0.0,
                                                std::uint64_t seed = 1, double domain = 4.0)
{
  const wheelrail::HertzContact hertz = table2();
  const double h = domain * hertz.halfWidth / n;
  wheelrail::NormalContactProblem problem;
  problem.profile.resize(n);
  problem.load = hertz.load / (hertz.modulus * h);
  for (int i = 0; i < n; ++i)
    problem.profile[i] = std::pow((i + 0.5 - 0.5 * n) * h, 2) / (2.0 * hertz.radius * h);
  if (rmsSlope > 0.0) {
    wheelrail::FractalSurface surface;
    surface.rmsSlope = rmsSlope;
    surface.wavelengthMin = 0.1e-3;
    surface.wavelengthMax = 10e-3;
    surface.seed = seed;
    problem.profile -= wheelrail::fractalProfile(surface, n, n * h).height / h;
  }
  return problem;
}

} // namespace contact_cases
#endif
