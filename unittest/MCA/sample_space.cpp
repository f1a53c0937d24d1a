// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample_space.h"

#include <algorithm>

using namespace reference::space;

Sample block(const mca::Packing &packing, const mca::Material &m, int n, double kind, bool periodic,
             double reach)
{
  Sample s;
  s.materials = {m};
  s.packing = packing;
  const mca::Lattice lattice = mca::latticeOf(packing);
  auto vector = [&](const mca::Lattice::Point &p) {
    return Vector3d(m.diameter * Vector3d(p.x, p.y, p.z));
  };
  auto place = [&](int a, int b, int c) {
    return Vector3d(a * vector(lattice.edges[0]) + b * vector(lattice.edges[1]) +
                    c * vector(lattice.edges[2]));
  };
  for (int a = 0; a < n; a++)
    for (int b = 0; b < n; b++)
      for (int c = 0; c < n; c++)
        for (const auto &p : lattice.basis) {
          s.owner.push_back(s.owned++);
          s.shift.emplace_back(Vector3d::Zero());
          s.automata.emplace_back().x = place(a, b, c) + vector(p);
        }
  for (int image = 0; periodic && image < 27; image++) {
    const Vector3d shift = n * place(image / 9 - 1, image / 3 % 3 - 1, image % 3 - 1);
    for (int i = 0; i < s.owned && image != 13; i++) {
      s.owner.push_back(i);
      s.shift.push_back(shift);
      s.automata.push_back(s.automata[i]);
      s.automata.back().x += shift;
    }
  }
  for (int i = 0; i < s.owned; i++)
    for (int j = i + 1; j < static_cast<int>(s.automata.size()); j++)
      if (s.owner[j] > i && // each pair of originals once
          (s.automata[j].x - s.automata[i].x).norm() < reach * m.diameter) {
        ReferenceContact c;
        c.i = i;
        c.j = j;
        c.now.kind = c.next.kind = kind;
        s.contacts.push_back(c);
      }
  return s;
}

SpaceRun::SpaceRun(const mca::Kernel &kernel, const Sample &s, bool next)
    : evaluation_(3, &kernel), arrays_(s.automata.size())
{
  evaluation_.setLaws({s.laws, s.materials, 1.0, s.packing});
  for (size_t i = 0; i < s.automata.size(); i++) {
    arrays_.types[i] = s.automata[i].type;
    arrays_.groups[i] |= s.automata[i].held ? StepArrays::held : 0;
    arrays_.groups[i] |= s.automata[i].heldSpin ? StepArrays::heldSpins : 0;
  }
  mca::LinkList &list = evaluation_.links();
  list.reset(static_cast<int>(s.contacts.size()));
  for (const auto &c : s.contacts) {
    const State &state = next ? c.next : c.now;
    const Vector3d &g = state.gamma, &t = state.gammaTotal;
    const double values[] = {state.kind, state.plastic, g.x(), g.y(), g.z(), t.x(), t.y(), t.z()};
    list.add(s.owner[c.i], s.owner[c.j],
             evaluation_.laws().number(arrays_.types[c.i], arrays_.types[c.j]), values);
    list.setPlaces(c.i, c.j);
  }
  evaluation_.begin(s.owned, static_cast<int>(s.automata.size()), arrays_.types.data(), 0);
}

static Vector3d vectorOf(const mca::Vector &v)
{
  return {v.x, v.y, v.z};
}

void SpaceRun::step(Sample &s, double dt)
{
  for (size_t i = 0; i < s.automata.size(); i++) {
    const Automaton &a = s.automata[i];
    std::copy_n(a.x.data(), 3, arrays_.x()[i]);
    std::copy_n(a.v.data(), 3, arrays_.v()[i]);
    std::copy_n(a.omega.data(), 3, arrays_.omega()[i]);
    arrays_.kappa[i] = a.kappa;
    arrays_.kept[i] = a.kept;
  }
  evaluation_.run(arrays_.view(), dt, dt > 0.0);
  evaluation_.commit(arrays_.view());
  s.changed = static_cast<int>(evaluation_.changes().size());

  for (int i = 0; i < s.owned; i++) {
    Automaton &a = s.automata[i];
    const mca::Step::Automaton state = evaluation_.automaton(i);
    const mca::StressTensor &t = state.stress;
    a.mean = state.mean;
    a.factor = evaluation_.factor(i);
    a.kappaNext = arrays_.kappa[i];
    a.keptNext = arrays_.kept[i];
    a.stress << t.xx, t.xy, t.xz, t.xy, t.yy, t.yz, t.xz, t.yz, t.zz;
    a.intensity = state.intensity;
    a.energy = state.energy;
    a.force = vectorOf(evaluation_.force(i));
    a.torque = vectorOf(evaluation_.torque(i));
  }
  for (size_t k = 0; k < s.contacts.size(); k++)
    for (const bool next : {false, true}) {
      double v[mca::LinkList::maxStateSize];
      evaluation_.links().getState(static_cast<int>(k), next, v);
      (next ? s.contacts[k].next : s.contacts[k].now) = {v[0], v[1], Vector3d(v[2], v[3], v[4]),
                                                         Vector3d(v[5], v[6], v[7])};
    }
}

void kernelStep(const mca::Kernel &kernel, Sample &s, double dt)
{
  SpaceRun(kernel, s, dt > 0.0).step(s, dt);
}
