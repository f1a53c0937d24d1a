// SPDX-License-Identifier: GPL-2.0-or-later
#include "viscous_contacts.h"

#include <algorithm>

namespace mca {

// No block of bulk links that none leaves has one.
void ViscousPairs::find(const Pairs &p)
{
  numbers_.clear();
  for (int first = 0; first < p.n; first += blockLength) {
    const Block &block = p.blocks[first / blockLength];
    if (block.bulk && !block.changes)
      continue;
    const double *const next = block.changes ? p.next.kind : p.now.kind;
    block.busy.each([&](int in) {
      const int k = first + in;
      if (!(link::isLinked(p.now.kind[k]) && link::isLinked(next[k])) &&
          isPressed(p.eps[k] - p.now.plastic[k]))
        numbers_.push_back(k);
    });
  }
}

ViscousPairs::Range ViscousPairs::before(int pair) const
{
  return {all().first, std::lower_bound(all().first, all().last, pair)};
}

ViscousPairs::Range ViscousPairs::from(int pair) const
{
  return {before(pair).last, all().last};
}

void ViscousContacts::add(const Pairs &p, ViscousPairs::Range viscous, const Conditions &step)
{
  const double half = 0.5 * step.dt;
  size_t number = changes_.size();
  changes_.resize(number + viscous.size());
  for (const int k : viscous) {
    const PairLaw &law = step.laws[p.law[k]];
    const int i = p.i[k], j = p.j[k];
    const double moveI = half * law.invMassI * step.follows(i);
    const double moveJ = half * law.invMassJ * step.follows(j);
    const Vector normal = normalOf(p, k, step.rows.isPlane());
    const double kick = dot(normal, moveJ * step.rows.force(j) - moveI * step.rows.force(i));
    const double damping =
        law.centring * law.viscosity * law.area * law.invDiameter * (moveI + moveJ);
    const double before = p.separation[k], now = centredSeparation(before, kick, damping);
    p.separation[k] = now;

    const double sigma = viscousStress(law, p.now.kind[k], p.eps[k], p.now.plastic[k],
                                       step.rows.answer(i), step.rows.answer(j));
    const double inverse = viscousInverse(law, p.ratio[k]);
    const double more = unlinkedStress(sigma, law.viscosity, now, inverse, law.keepsEnergy) -
                        unlinkedStress(sigma, law.viscosity, before, inverse, law.keepsEnergy);
    const double area = actingAreas(law, p.ratio[k]).normal;
    Change &c = changes_[number++];
    c.i = i;
    c.j = j;
    for (int m = 0; m < step.rows.layout->dimension; m++)
      c.force[m] = more * area * p.normal[m][k];
  }
}

void ViscousContacts::addForces(const RowLayout &rows, double *forces) const
{
  const size_t stride = rows.force.length;
  double *const push = forces + rows.force.force;
  for (const Change &c : changes_)
    for (int m = 0; m < rows.dimension; m++) {
      push[c.i * stride + m] += c.force[m];
      push[c.j * stride + m] -= c.force[m];
    }
}

} // namespace mca
