// SPDX-License-Identifier: GPL-2.0-or-later
#include "viscous_contacts.h"

namespace mca {

void ViscousContacts::add(const Pairs &p, const Conditions &step)
{
  const int dimension = step.kernel->dimension;
  const RowLayout &rows = step.kernel->rows;
  const double half = 0.5 * step.dt;
  eachViscous(p, [&](int k) {
    const PairLaw &law = step.laws[p.law[k]];
    const int i = p.i[k], j = p.j[k];
    const double moveI = half * law.invMassI * step.follows(i);
    const double moveJ = half * law.invMassJ * step.follows(j);
    const double *const forceI = step.forces + static_cast<size_t>(i) * rows.force.length;
    const double *const forceJ = step.forces + static_cast<size_t>(j) * rows.force.length;
    double kick = 0.0;
    for (int m = 0; m < dimension; m++)
      kick += p.normal[m][k] * (moveJ * forceJ[m] - moveI * forceI[m]);
    const double damping =
        law.centring * law.viscosity * law.area * law.invDiameter * (moveI + moveJ);
    const double before = p.separation[k], now = centredSeparation(before, kick, damping);
    p.separation[k] = now;

    const double sigma = viscousStress(law, p.now.kind[k], p.eps[k], p.now.plastic[k],
                                       step.answer(i), step.answer(j));
    const double more = unlinkedStress(sigma, law.viscosity, now, law.invDiameter) -
                        unlinkedStress(sigma, law.viscosity, before, law.invDiameter);
    Contact c = {i, j, {}};
    for (int m = 0; m < dimension; m++)
      c.force[m] = more * law.area * p.normal[m][k];
    contacts_.push_back(c);
  });
}

void ViscousContacts::addForces(const Kernel &kernel, double *forces) const
{
  const size_t stride = kernel.rows.force.length;
  for (const Contact &c : contacts_)
    for (int m = 0; m < kernel.dimension; m++) {
      forces[c.i * stride + m] += c.force[m];
      forces[c.j * stride + m] -= c.force[m];
    }
}

} // namespace mca
