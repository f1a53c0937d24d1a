// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_friction.h"

#include "laws/coulomb.h"
#include "laws/pair_motion.h"

#include <algorithm>
#include <utility>

namespace mca {

using Spring = LinkList::Spring;

// The shear of a link between the same two automata would have moved on likewise.
static void moveOn(Spring &s, const Pairs &p, const RowView &rows, double dt)
{
  const int i = p.placeI[s.pair], j = p.placeJ[s.pair];
  const Vector distance = rows.place(j) - rows.place(i),
               velocity = rows.velocity(j) - rows.velocity(i);
  const Vector spins = rows.spin(i) + rows.spin(j);
  if (rows.isPlane()) {
    s.now[0] += shearGrowth(pairMotion(PlaneVector{distance.x, distance.y},
                                       PlaneVector{velocity.x, velocity.y}, spins.z, dt, 1.0));
    return;
  }
  const PairMotion motion =
      pairMotion(distance, 1.0 / length(distance), dt * velocity, 0.5 * dt * spins);
  const Vector shear = carriedShear(motion, vectorOf(s.now)) + shearGrowth(motion);
  s.now[0] = shear.x;
  s.now[1] = shear.y;
  s.now[2] = shear.z;
}

// What a contact that touches holds of its spring.
static void hold(Spring &s, const Pairs &p, const RowView &rows, const PairLaw &law)
{
  const int k = s.pair;
  const bool moves = p.blocks[k / blockLength].moves;
  const double kindNext = moves ? p.next.kind[k] : p.now.kind[k];
  Contact c{}; // unlinked: without shear
  c.kind = p.now.kind[k];
  c.ratio = p.ratio[k];
  c.eps = p.eps[k];
  c.plastic = p.now.plastic[k];
  c.separation = p.separation[k];
  const ContactStress stress =
      contactStress(law, c, rows.answer(p.i[k]), rows.answer(p.j[k]), kindNext);
  const double held =
      heldShare(law, length(vectorOf(s.now)), frictionLimit(law, stress.normal, c.ratio));
  for (int m = 0; m < maxShears; m++)
    s.next[m] = held * s.now[m];
  if (!link::isLinked(kindNext))
    return;
  for (int m = 0; m < (rows.isPlane() ? 1 : maxShears); m++)
    p.next.gamma[m][k] = p.next.gammaTotal[m][k] = s.next[m];
}

void ContactFriction::find(LinkList &links, const ViscousContacts &touching, const RowView &rows,
                           const PairLaw *laws, int own, double dt, bool moves)
{
  const Pairs p = links.part(0, links.size());
  const std::vector<Spring> &before = links.springs();
  std::vector<Spring> springs;
  springs.reserve(std::max(before.size(), static_cast<std::size_t>(touching.size())));
  auto old = before.begin();
  const auto letGo = [&](int upTo) {
    for (; old != before.end() && old->pair < upTo; ++old) {
      springs.push_back(*old);
      if (moves)
        moveOn(springs.back(), p, rows, dt);
      std::fill_n(springs.back().next, maxShears, 0.0);
    }
  };
  for (const int k : touching) {
    letGo(k);
    const PairLaw &law = laws[p.law[k]];
    if (link::isLinked(p.now.kind[k]) || law.friction == 0.0)
      continue;
    const bool known = old != before.end() && old->pair == k;
    springs.push_back(known ? *old++ : Spring{k, {}, {}});
    if (moves)
      moveOn(springs.back(), p, rows, dt);
    hold(springs.back(), p, rows, law);
  }
  letGo(p.n);
  links.setSprings(std::move(springs));

  energies_.assign(own, 0.0);
  for (const Spring &s : links.springs()) {
    const PairLaw &law = laws[p.law[s.pair]];
    const Vector shear = vectorOf(s.now);
    for (const int i : {p.i[s.pair], p.j[s.pair]})
      if (i < own)
        energies_[i] += 0.25 * law.twoG * dot(shear, shear) * law.area * law.diameter;
  }
}

Vector springOf(const LinkList &links, int k, bool plane, bool next)
{
  const Spring *const s = links.spring(k);
  if (!s)
    return {0.0, 0.0, 0.0};
  const double *const shear = next ? s->next : s->now;
  if (!plane)
    return vectorOf(shear);
  const Vector n = normalOf(links.pairs(), k, true);
  return {-shear[0] * n.y, shear[0] * n.x, 0.0};
}

void ContactFriction::addForces(const LinkList &links, const RowLayout &rows, const PairLaw *laws,
                                double *forces) const
{
  const Pairs &p = links.pairs();
  const bool plane = rows.dimension == 2;
  const int torques = plane ? 1 : 3;
  for (const Spring &s : links.springs()) {
    const int k = s.pair;
    const PairLaw &law = laws[p.law[k]];
    const SpaceForce on = contactForce(law, 0.0, law.twoG * springOf(links, k, plane, true),
                                       p.ratio[k], normalOf(p, k, plane));
    const double force[] = {on.force.x, on.force.y, on.force.z};
    const double torque[] = {on.torque.x, on.torque.y, on.torque.z};
    for (const auto &[row, sign] : {std::pair(p.i[k], 1.0), std::pair(p.j[k], -1.0)}) {
      double *const values = forces + static_cast<std::size_t>(row) * rows.force.length;
      for (int m = 0; m < rows.dimension; m++)
        values[rows.force.force + m] += sign * force[m];
      for (int m = 0; m < torques; m++) // the same on both
        values[rows.force.torque + m] += torque[3 - torques + m];
    }
  }
}

} // namespace mca
