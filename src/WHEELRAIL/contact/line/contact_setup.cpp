// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/line/contact_setup.h"

#include "base/errors.h"

#include <limits>

namespace wheelrail {

using Vector = Eigen::VectorXd;

Vector ContactSetup::bound(const Vector &mu, const Vector &pressure) const
{
  return mu.cwiseProduct(pressure).cwiseMin(yieldStress) / hertz.modulus;
}

double ContactSetup::meanFriction(const Vector &mu, const Vector &pressure) const
{
  return bound(mu, pressure).sum() * hertz.modulus / pressure.sum();
}

Vector ContactSetup::gap(int travel) const
{
  const Vector &roughness = surface.roughness;
  Vector gap(cells);
  for (int i = 0; i < cells; ++i) {
    const double x = position(i);
    gap[i] = x * x / (2.0 * hertz.radius);
    if (roughness.size() > 0)
      gap[i] -= roughness[(i + travel) % roughness.size()];
  }
  return gap / cellSize;
}

int ContactSetup::longestTravel() const
{
  if (surface.periodic)
    return std::numeric_limits<int>::max();
  return static_cast<int>(surface.roughness.size()) - cells;
}

NormalContactProblem ContactSetup::problem(double limit, int travel) const
{
  NormalContactProblem problem;
  problem.profile = gap(travel);
  problem.load = hertz.load / (hertz.modulus * cellSize);
  problem.pressureLimit = limit / hertz.modulus;
  problem.pascals = hertz.modulus;
  return problem;
}

double ContactSetup::nominalMean(const Vector &values) const
{
  double sum = 0.0;
  int inside = 0;
  for (int i = 0; i < cells; ++i) {
    if (!isNominal(i))
      continue;
    sum += values[i];
    ++inside;
  }
  return sum / inside;
}

double ContactSetup::realContactLength() const
{
  return contactLength(contactIntervals(normal, boundary)) * cellSize;
}

void checkInsideDomain(const Vector &pressure)
{
  if (pressure[0] > 0.0 || pressure[pressure.size() - 1] > 0.0)
    throw Error(ExitCode::BadInput,
                "contact.domain: the contact reaches the ends of the computed length; increase it");
}

ContactSetup prepareContact(const LineContactSpecification &contact,
                            const SurfaceSpecification &surface, std::size_t index,
                            double pressureLimit, bool travels)
{
  ContactSetup setup;
  const double modulus = contactModulus(contact.bodies);
  setup.coupling = couplingOf(contact.bodies);
  setup.cells = contact.points;
  if (contact.period > 0.0) {
    setup.boundary = Boundary::Periodic;
    setup.hertz = {contact.load, contact.radius, modulus, 0.5 * contact.period,
                   contact.load / contact.period};
    setup.cellSize = contact.period / contact.points;
  } else {
    setup.hertz = hertzContact(contact.load, contact.radius, modulus);
    setup.cellSize = contact.domain * setup.hertz.halfWidth / contact.points;
  }
  setup.layer = contact.layer.compliance() * modulus / setup.cellSize;
  setup.yieldStress = contact.layer.yieldStress;
  setup.surface = prepareSurface(surface, index, setup.cells, setup.cellSize, travels);
  HalfPlane halfPlane(setup.cells, setup.boundary);
  setup.normal = solveNormalContact(halfPlane, setup.problem(pressureLimit));
  if (setup.boundary == Boundary::Free)
    checkInsideDomain(setup.normal.pressure);
  return setup;
}

} // namespace wheelrail
