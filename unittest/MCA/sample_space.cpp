#include "sample_space.h"

#include "core/further_laws.h"
#include "viscous_contacts.h"

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
          s.shift.push_back(Vector3d::Zero());
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
        Contact c;
        c.i = i;
        c.j = j;
        c.now.kind = c.next.kind = kind;
        s.contacts.push_back(c);
      }
  return s;
}

static void clear(mca::AlignedArray &array, size_t n)
{
  array.reserve(n);
  std::fill_n(array.get(), n, 0.0);
}

// what images collected goes to their originals, what these answer to the images
static void addUp(const Sample &s, const mca::AlignedArray &array, int row)
{
  for (size_t i = s.owned; i < s.automata.size(); i++)
    for (int m = 0; m < row; m++)
      array.get()[row * s.owner[i] + m] += array.get()[row * i + m];
}

static void passOn(const Sample &s, const mca::AlignedArray &array, int row)
{
  for (size_t i = s.owned; i < s.automata.size(); i++)
    std::copy_n(array.get() + row * s.owner[i], row, array.get() + row * i);
}

SpaceRun::SpaceRun(const mca::Kernel &chosen, const Sample &s, bool next)
    : kernel(chosen), twice(s.laws.returnsTwice()), centres(s.laws.centresViscosity()),
      needsLocal(s.laws.needsLocal()), list(3)
{
  const int types = static_cast<int>(s.materials.size());
  for (const auto &a : s.materials) {
    own.push_back(mca::makeAutomatonLaw(s.laws, a, s.packing));
    for (const auto &b : s.materials)
      table.push_back(mca::makePairLaw(s.laws, a, b, 1.0, s.packing));
  }
  list.reset(static_cast<int>(s.contacts.size()));
  for (const auto &c : s.contacts) {
    const State &state = next ? c.next : c.now;
    const Vector3d &g = state.gamma, &t = state.gammaTotal;
    const double values[] = {state.kind, state.plastic, g.x(), g.y(), g.z(), t.x(), t.y(), t.z()};
    list.add(c.i, c.j, s.automata[c.i].type * types + s.automata[c.j].type, values);
  }
}

void SpaceRun::step(Sample &s, double dt)
{
  const size_t n = s.automata.size();
  const mca::RowLayout &row = kernel.rows;
  const bool oneLaw = s.materials.size() == 1;
  if (dt > 0.0)
    list.advance();
  std::vector<double> kappa, kappaNext(s.owned), spin;
  std::vector<int> type, groups; // 1: all, 2: held
  mca::AlignedArray motion, strains, stresses, response, taken, local, forces, centred;
  clear(motion, n * row.motion.length);
  clear(strains, n * row.strain.length);
  clear(stresses, n * row.stress.length);
  clear(response, n * row.response.length);
  clear(forces, n * row.force.length);
  for (size_t i = 0; i < n; i++) {
    const Automaton &a = s.automata[i];
    const double values[] = {a.x.x(), a.x.y(), a.x.z(),     a.v.x(),
                             a.v.y(), a.v.z(), a.omega.x(), a.omega.y()};
    std::copy_n(values, row.motion.length, motion.get() + row.motion.length * i);
    spin.push_back(a.omega.z());
    groups.push_back(a.held ? 3 : 1);
    kappa.push_back(a.kappa);
    type.push_back(a.type);
  }

  const mca::Pairs &p = list.pairs();
  kernel.strain(p, dt, dt > 0.0, table.data(), motion.get(), spin.data(), strains.get());
  addUp(s, strains, row.strain.length);
  kernel.mean(s.owned, type.data(), own.data(), oneLaw, strains.get(), response.get());
  passOn(s, response, row.response.length);
  kernel.stress(p, table.data(), response.get(), stresses.get());
  addUp(s, stresses, row.stress.length);
  kernel.yield(s.owned, type.data(), own.data(), oneLaw, strains.get(), stresses.get(),
               kappa.data(), kappaNext.data(), response.get());
  passOn(s, response, row.response.length);
  if (twice) {
    clear(taken, n * row.stress.length);
    kernel.returns(p, table.data(), response.get(), taken.get());
    addUp(s, taken, row.stress.length);
    kernel.yieldAgain(s.owned, type.data(), own.data(), stresses.get(), taken.get(), kappa.data(),
                      kappaNext.data(), response.get());
    passOn(s, response, row.response.length);
  }
  clear(local, n * row.local.length);
  if (needsLocal)
    mca::showLocal(row, s.owned, type.data(), own.data(), stresses.get(), response.get(),
                   kappa.data(), kappaNext.data(), local.get());
  passOn(s, local, row.local.length);
  s.changed = static_cast<int>(kernel.force(p, table.data(), response.get(),
                                            needsLocal ? local.get() : nullptr, forces.get()));
  addUp(s, forces, row.force.length);
  clear(centred, n * row.force.length);
  if (centres) {
    passOn(s, forces, row.force.length);
    mca::ViscousContacts viscous;
    viscous.add(p, {&kernel, dt, table.data(), response.get(), forces.get(), groups.data(), 1, 2});
    viscous.addForces(kernel, centred.get());
    addUp(s, centred, row.force.length);
  }

  for (int i = 0; i < s.owned; i++) {
    Automaton &a = s.automata[i];
    const double *sums = stresses.get() + row.stress.length * i,
                 *f = forces.get() + row.force.length * i;
    const mca::AutomatonLaw &law = own[a.type];
    a.mean = response.get()[row.response.length * i];
    a.factor = response.get()[row.response.length * i + 1];
    a.kappaNext = kappaNext[i];
    const mca::StressTensor t = mca::weighted(sums, law.weight);
    a.stress << t.xx, t.xy, t.xz, t.xy, t.yy, t.yz, t.xz, t.yz, t.zz;
    a.intensity = mca::stressIntensity(t);
    a.energy =
        mca::energyDensity(sums[6], a.mean, law.shearModulus, law.bulkModulus, law.D, law.weight) *
        mca::Cell{s.packing, s.materials[a.type].diameter}.cellVolume();
    const double *more = centred.get() + row.force.length * i;
    a.force = Vector3d(f[0] + more[0], f[1] + more[1], f[2] + more[2]);
    a.torque = Vector3d(f[3], f[4], f[5]);
  }
  for (int k = 0; k < p.n; k++)
    for (const bool next : {false, true}) {
      double v[mca::LinkList::maxStateSize];
      list.getState(k, next, v);
      (next ? s.contacts[k].next : s.contacts[k].now) = {v[0], v[1], Vector3d(v[2], v[3], v[4]),
                                                         Vector3d(v[5], v[6], v[7])};
    }
}

void kernelStep(const mca::Kernel &kernel, Sample &s, double dt)
{
  SpaceRun(kernel, s, dt > 0.0).step(s, dt);
}
