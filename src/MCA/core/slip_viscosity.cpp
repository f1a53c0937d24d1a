// SPDX-License-Identifier: GPL-2.0-or-later
#include "slip_viscosity.h"

#include <algorithm>

namespace mca {

// Contacts are written in their place: copies of whole ones would wait for their parts.
void SlipViscosity::begin(const Pairs &p, ViscousPairs::Range viscous, const RowView &rows,
                          const PairLaw *laws)
{
  contacts_.resize(viscous.size());
  Sliding *c = contacts_.data();
  for (const int k : viscous) {
    const PairLaw &law = laws[p.law[k]];
    const int i = p.placeI[k], j = p.placeJ[k];
    c->pair = k;
    c->i = p.i[k];
    c->j = p.j[k];
    c->law = p.law[k];
    c->viscosity = law.viscosity * law.invDiameter;
    c->area = law.area;
    c->arm = 0.5 * law.diameter * p.ratio[k];
    c->normal = normalOf(p, k, rows.isPlane());
    c->slip =
        slipOf(c->normal, rows.velocity(j) - rows.velocity(i), rows.spin(i) + rows.spin(j), c->arm);
    c->force = {0.0, 0.0, 0.0};
    c++;
  }
}

void SlipViscosity::centre(const ViscousContacts::Conditions &step)
{
  const double half = 0.5 * step.dt;
  for (Sliding &c : contacts_) {
    const double halfI = half * step.follows(c.i), halfJ = half * step.follows(c.j);
    const PairLaw &law = step.laws[c.law];
    const double moveI = halfI * law.invMassI, moveJ = halfJ * law.invMassJ;
    const double turnI = halfI * law.invInertiaI, turnJ = halfJ * law.invInertiaJ;
    const Vector moved = moveJ * step.rows.force(c.j) - moveI * step.rows.force(c.i);
    const Vector turned = turnI * step.rows.torque(c.i) + turnJ * step.rows.torque(c.j);
    const double damping =
        law.centring * c.viscosity * c.area * (moveI + moveJ + c.arm * c.arm * (turnI + turnJ));
    c.slip = centred(c.slip, slipOf(c.normal, moved, turned, c.arm), damping);
  }
}

// A template, since loops over axes take three times as long.
template<int Dimension>
void SlipViscosity::addForces(const RowLayout::Force &at, double *forces)
{
  for (Sliding &c : contacts_) {
    const Vector force = c.area * (c.viscosity * c.slip), more = force - c.force;
    const Vector torque = c.arm * cross(c.normal, more); // the same on both
    c.force = force;
    const auto add = [&](int row, double sign) {
      double *const values = forces + static_cast<size_t>(row) * at.length;
      double *const push = values + at.force, *const turn = values + at.torque;
      push[0] += sign * more.x;
      push[1] += sign * more.y;
      if constexpr (Dimension == 2)
        turn[0] += torque.z;
      else {
        push[2] += sign * more.z;
        turn[0] += torque.x;
        turn[1] += torque.y;
        turn[2] += torque.z;
      }
    };
    add(c.i, 1.0);
    add(c.j, -1.0);
  }
}

void SlipViscosity::addForces(const RowLayout &rows, double *forces)
{
  if (rows.dimension == 2)
    addForces<2>(rows.force, forces);
  else
    addForces<3>(rows.force, forces);
}

Vector SlipViscosity::stress(int k) const
{
  const auto found = std::lower_bound(contacts_.begin(), contacts_.end(), k,
                                      [](const Sliding &c, int pair) { return c.pair < pair; });
  return found != contacts_.end() && found->pair == k ? found->viscosity * found->slip
                                                      : Vector{0.0, 0.0, 0.0};
}

} // namespace mca
