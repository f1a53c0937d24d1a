// SPDX-License-Identifier: GPL-2.0-or-later
#include "slip_viscosity.h"

#include <algorithm>

namespace mca {

// Vectors of rows: in the plane z of places and velocities is 0, and spins and torques are along z.
static Vector inPlaneOrSpace(const double *values, int dimension)
{
  return {values[0], values[1], dimension == 2 ? 0.0 : values[2]};
}

static Vector aboutAxes(const double *values, int dimension)
{
  return dimension == 2 ? Vector{0.0, 0.0, values[0]} : Vector{values[0], values[1], values[2]};
}

// Contacts are written in their place: copies of whole ones would wait for their parts.
void SlipViscosity::begin(const Pairs &p, ViscousPairs::Range viscous, const Surfaces &surfaces)
{
  contacts_.resize(viscous.size());
  Contact *c = contacts_.data();
  for (const int k : viscous) {
    const PairLaw &law = surfaces.laws[p.law[k]];
    c->pair = k;
    c->i = p.i[k];
    c->j = p.j[k];
    c->law = p.law[k];
    c->viscosity = law.viscosity * law.invDiameter;
    c->area = law.area;
    c->arm = surfaces.arm(p, k);
    c->normal = surfaces.normal(p, k);
    c->slip = surfaces.slip(p, k);
    c->force = {0.0, 0.0, 0.0};
    c++;
  }
}

void SlipViscosity::centre(const ViscousContacts::Conditions &step)
{
  const int dimension = step.kernel->dimension;
  const RowLayout::Force &at = step.kernel->rows.force;
  const double half = 0.5 * step.dt;
  for (Contact &c : contacts_) {
    const double *rowI = step.forces + static_cast<size_t>(c.i) * at.length;
    const double *rowJ = step.forces + static_cast<size_t>(c.j) * at.length;
    const double halfI = half * step.follows(c.i), halfJ = half * step.follows(c.j);
    const PairLaw &law = step.laws[c.law];
    const double moveI = halfI * law.invMassI, moveJ = halfJ * law.invMassJ;
    const double turnI = halfI * law.invInertiaI, turnJ = halfJ * law.invInertiaJ;
    const Vector moved = moveJ * inPlaneOrSpace(rowJ + at.force, dimension) -
                         moveI * inPlaneOrSpace(rowI + at.force, dimension);
    const Vector turned = turnI * aboutAxes(rowI + at.torque, dimension) +
                          turnJ * aboutAxes(rowJ + at.torque, dimension);
    const double damping =
        law.centring * c.viscosity * c.area * (moveI + moveJ + c.arm * c.arm * (turnI + turnJ));
    c.slip = centred(c.slip, slipOf(c.normal, moved, turned, c.arm), damping);
  }
}

// A template, since loops over axes take three times as long.
template<int Dimension>
void SlipViscosity::addForces(const RowLayout::Force &at, double *forces)
{
  for (Contact &c : contacts_) {
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

void SlipViscosity::addForces(const Kernel &kernel, double *forces)
{
  if (kernel.dimension == 2)
    addForces<2>(kernel.rows.force, forces);
  else
    addForces<3>(kernel.rows.force, forces);
}

Vector SlipViscosity::stress(int k) const
{
  const auto found = std::lower_bound(contacts_.begin(), contacts_.end(), k,
                                      [](const Contact &c, int pair) { return c.pair < pair; });
  return found != contacts_.end() && found->pair == k ? found->viscosity * found->slip
                                                      : Vector{0.0, 0.0, 0.0};
}

} // namespace mca
