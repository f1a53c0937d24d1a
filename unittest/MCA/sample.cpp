#include "sample.h"

#include "core/further_laws.h"
#include "link_list.h"
#include "viscous_contacts.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

using reference::Automaton;
using reference::Contact;
using reference::Sample;

mca::Material steel()
{
  mca::Material m;
  m.youngs_modulus = 206000;
  m.poissons_ratio = 0.3;
  m.density = 0.0078;
  m.strength = 92;
  m.elastic_limit = 0.554;
  m.yield_strength = 0.870;
  m.yield_strain = 0.015;
  m.breaking_strain = 0.04;
  m.viscosity = 410;
  m.diameter = 2.5;
  return m;
}

std::string steelText()
{
  std::ostringstream text;
  text.precision(17);
  text << "# UNITS: nano DATE: 2026-11-21 CITATION: test\n";
  for (const auto &q : mca::materialQuantities())
    text << q.keyword << " " << steel().*q.value << "\n";
  return text.str();
}

std::vector<std::vector<std::string>> fractureWords()
{
  std::vector<std::vector<std::string>> all;
  for (const auto &criterion : mca::FractureLaw::criteria()) {
    all.push_back({"fracture", criterion.keyword});
    if (criterion.parameter)
      all.back().insert(all.back().end(), {criterion.parameter, "3"});
  }
  return all;
}

static void place(Sample &s, const mca::Material &m, int columns, int rows)
{
  s.materials = {m};
  for (int row = 0; row < rows; row++)
    for (int column = 0; column < columns; column++) {
      Automaton a;
      a.x = m.diameter * (column + 0.5 * (row % 2));
      a.y = m.diameter * std::sqrt(0.75) * row;
      s.add(a);
    }
}

static void connect(Sample &s, double reach, double kind)
{
  for (int i = 0; i < s.owned; i++)
    for (int j = i + 1; j < static_cast<int>(s.automata.size()); j++) {
      if (s.owner[j] < i || s.owner[j] == i)
        continue; // each pair of originals once
      const Automaton &a = s.automata[i], &b = s.automata[j];
      if (std::hypot(b.x - a.x, b.y - a.y) > reach * s.materials[0].diameter)
        continue;
      Contact c;
      c.i = i;
      c.j = j;
      c.now.kind = c.next.kind = kind;
      s.contacts.push_back(c);
    }
}

Sample hexagonalBlock(const mca::Material &m, int columns, int rows, double kind, double reach)
{
  Sample s;
  place(s, m, columns, rows);
  connect(s, reach, kind);
  return s;
}

Sample periodicBlock(const mca::Material &m, int columns, int rows, double kind)
{
  Sample s;
  place(s, m, columns, rows);
  const double width = columns * m.diameter, height = rows * m.diameter * std::sqrt(0.75);
  for (int i = 0; i < s.owned; i++)
    for (int a = -1; a <= 1; a++)
      for (int b = -1; b <= 1; b++)
        if (a != 0 || b != 0)
          s.addImage(i, a * width, b * height);
  connect(s, 1.1, kind);
  return s;
}

static void clear(mca::AlignedArray &array, int n)
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

KernelRun::KernelRun(const mca::Kernel &chosen, const Sample &s, bool next)
    : kernel(chosen), twice(s.laws.returnsTwice()), centres(s.laws.centresViscosity()),
      j2(s.laws.strainsAcross(2)), needsLocal(s.laws.needsLocal())
{
  const int types = static_cast<int>(s.materials.size());
  for (const auto &a : s.materials) {
    own.push_back(mca::makeAutomatonLaw(s.laws, a));
    for (const auto &b : s.materials)
      table.push_back(mca::makePairLaw(s.laws, a, b, s.thickness));
  }
  list.reset(static_cast<int>(s.contacts.size()));
  for (const auto &c : s.contacts) {
    const reference::State &state = next ? c.next : c.now;
    const double values[] = {state.kind, state.plastic, state.gamma, state.gammaTotal};
    list.add(c.i, c.j, s.automata[c.i].type * types + s.automata[c.j].type, values);
  }
}

void KernelRun::step(Sample &s, double dt)
{
  const int n = static_cast<int>(s.automata.size());
  const bool oneLaw = s.materials.size() == 1;
  if (dt > 0.0)
    list.advance();
  std::vector<double> spin, kappa, kappaNext(s.owned), elasticZ, elasticZNext(s.owned);
  std::vector<int> type, groups; // 1: all, 2: held
  mca::AlignedArray motion, strains, stresses, response, taken, local, forces, centred;
  clear(local, n * mca::planeRows.local.length);
  clear(motion, n * mca::planeRows.motion.length);
  clear(strains, n * mca::planeRows.strain.length);
  clear(stresses, n * mca::planeRows.stress.length);
  clear(response, n * mca::planeRows.response.length);
  clear(forces, n * mca::planeRows.force.length);
  for (int i = 0; i < n; i++) {
    const Automaton &a = s.automata[i];
    const double values[] = {a.x, a.y, a.vx, a.vy};
    spin.push_back(a.omega);
    groups.push_back(a.held ? 3 : 1);
    std::copy_n(values, 4, motion.get() + mca::planeRows.motion.length * i);
    if (i >= s.owned)
      continue;
    kappa.push_back(a.kappa);
    elasticZ.push_back(a.elasticZ);
    type.push_back(a.type);
  }

  const mca::Pairs &p = list.pairs();
  kernel.strain(p, dt, dt > 0.0, table.data(), motion.get(), spin.data(), strains.get());
  addUp(s, strains, mca::planeRows.strain.length);
  kernel.mean(s.owned, type.data(), own.data(), oneLaw, strains.get(), response.get());
  if (j2)
    mca::addElasticZ(s.owned, type.data(), own.data(), elasticZ.data(), response.get());
  passOn(s, response, mca::planeRows.response.length);
  kernel.stress(p, table.data(), response.get(), stresses.get());
  addUp(s, stresses, mca::planeRows.stress.length);
  kernel.yield(s.owned, type.data(), own.data(), oneLaw, strains.get(), stresses.get(),
               kappa.data(), kappaNext.data(), response.get());
  passOn(s, response, mca::planeRows.response.length);
  if (twice) {
    clear(taken, n * mca::planeRows.stress.length);
    kernel.returns(p, table.data(), response.get(), taken.get());
    addUp(s, taken, mca::planeRows.stress.length);
    kernel.yieldAgain(s.owned, type.data(), own.data(), stresses.get(), taken.get(), kappa.data(),
                      kappaNext.data(), response.get());
    passOn(s, response, mca::planeRows.response.length);
  }
  if (j2)
    mca::flowElasticZ(s.owned, type.data(), own.data(), strains.get(), stresses.get(),
                      response.get(), elasticZ.data(), elasticZNext.data());
  if (needsLocal)
    mca::showLocal(kernel.rows, s.owned, type.data(), own.data(), stresses.get(), response.get(),
                   kappa.data(), kappaNext.data(), local.get());
  passOn(s, local, mca::planeRows.local.length);
  s.changed = static_cast<int>(kernel.force(p, table.data(), response.get(),
                                            needsLocal ? local.get() : nullptr, forces.get()));
  addUp(s, forces, mca::planeRows.force.length);
  clear(centred, n * mca::planeRows.force.length);
  if (centres) {
    passOn(s, forces, mca::planeRows.force.length);
    mca::ViscousContacts viscous;
    viscous.add(p, {&kernel, dt, table.data(), response.get(), forces.get(), groups.data(), 1, 2});
    viscous.addForces(kernel, centred.get());
    addUp(s, centred, mca::planeRows.force.length);
  }

  for (int i = 0; i < s.owned; i++) {
    Automaton &a = s.automata[i];
    const double *row = stresses.get() + mca::planeRows.stress.length * i;
    const double *f = forces.get() + mca::planeRows.force.length * i;
    const mca::AutomatonLaw &law = own[a.type];
    a.mean = response.get()[mca::planeRows.response.length * i];
    a.factor = response.get()[mca::planeRows.response.length * i + 1];
    a.kappaNext = kappaNext[i];
    a.elasticZNext = elasticZNext[i];
    const mca::StressTensor t = mca::automatonStress(row[0], row[1], row[2], a.mean);
    a.xx = t.xx;
    a.yy = t.yy;
    a.xy = t.xy;
    a.zz = t.zz;
    a.intensity = mca::stressIntensity(t);
    a.energy = (mca::energyDensity(row[3], a.mean, law.shearModulus, law.bulkModulus, law.D) +
                law.shearModulus * elasticZ[i] * elasticZ[i]) *
               mca::Cell{mca::packing::hex, s.materials[a.type].diameter, s.thickness}.cellVolume();
    a.fx = f[0] + centred.get()[mca::planeRows.force.length * i];
    a.fy = f[1] + centred.get()[mca::planeRows.force.length * i + 1];
    a.torque = f[2];
  }
  for (int k = 0; k < p.n; k++) {
    Contact &c = s.contacts[k];
    for (const bool next : {false, true}) {
      double state[mca::LinkList::maxStateSize];
      list.getState(k, next, state);
      (next ? c.next : c.now) = {state[0], state[1], state[2], state[3]};
    }
  }
}

void kernelStep(const mca::Kernel &kernel, Sample &s, double dt)
{
  KernelRun(kernel, s, dt > 0.0).step(s, dt);
}

double totalEnergy(const Sample &s)
{
  double sum = 0;
  for (int i = 0; i < s.owned; i++)
    sum += s.automata[i].energy;
  return sum;
}

std::string kernelName(const mca::Kernel *kernel)
{
  return kernel->name;
}

void mca::PrintTo(const Kernel *kernel, std::ostream *out)
{
  *out << kernel->name;
}

void mca::PrintTo(const Packing &packing, std::ostream *out)
{
  *out << packing.name;
}
