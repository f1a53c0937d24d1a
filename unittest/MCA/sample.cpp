// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

using reference::Automaton;
using reference::ReferenceContact;
using reference::Sample;

mca::Material steel()
{
  mca::Material m;
  m.youngsModulus = 206000;
  m.poissonsRatio = 0.3;
  m.density = 0.0078;
  m.strength = 92;
  m.elasticLimit = 0.554;
  m.yieldStrength = 0.870;
  m.yieldStrain = 0.015;
  m.breakingStrain = 0.04;
  m.viscosity = 410;
  m.diameter = 2.5;
  return m;
}

double meanStressWeight(const mca::Material &m)
{
  return 3.0 * m.poissonsRatio / (1.0 + m.poissonsRatio);
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
      ReferenceContact c;
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

KernelRun::KernelRun(const mca::Kernel &kernel, const Sample &s, bool next)
    : evaluation_(2, &kernel), arrays_(s.automata.size())
{
  evaluation_.setLaws({s.laws, s.materials, s.thickness, mca::packing::hex});
  for (size_t i = 0; i < s.automata.size(); i++) {
    arrays_.types[i] = s.automata[i].type;
    arrays_.groups[i] |= s.automata[i].held ? StepArrays::held : 0;
    arrays_.groups[i] |= s.automata[i].heldSpin ? StepArrays::heldSpins : 0;
  }
  mca::LinkList &list = evaluation_.links();
  list.reset(static_cast<int>(s.contacts.size()));
  for (const auto &c : s.contacts) {
    const reference::State &state = next ? c.next : c.now;
    const double values[] = {state.kind, state.plastic, state.gamma, state.gammaTotal};
    list.add(s.owner[c.i], s.owner[c.j],
             evaluation_.laws().number(arrays_.types[c.i], arrays_.types[c.j]), values);
    list.setPlaces(c.i, c.j);
  }
  evaluation_.begin(s.owned, static_cast<int>(s.automata.size()), arrays_.types.data(), 0);
}

void KernelRun::step(Sample &s, double dt)
{
  for (size_t i = 0; i < s.automata.size(); i++) {
    const Automaton &a = s.automata[i];
    const double places[] = {a.x, a.y}, velocities[] = {a.vx, a.vy};
    std::copy_n(places, 2, arrays_.x()[i]);
    std::copy_n(velocities, 2, arrays_.v()[i]);
    arrays_.omega()[i][2] = a.omega;
    arrays_.kappa[i] = a.kappa;
    arrays_.kept[i] = a.kept;
  }
  evaluation_.run(arrays_.view(), dt, dt > 0.0);
  evaluation_.commit(arrays_.view());
  s.changed = static_cast<int>(evaluation_.changes().size());

  for (int i = 0; i < s.owned; i++) {
    Automaton &a = s.automata[i];
    const mca::Step::Automaton state = evaluation_.automaton(i);
    a.mean = state.mean;
    a.factor = evaluation_.factor(i);
    a.kappaNext = arrays_.kappa[i];
    a.keptNext = arrays_.kept[i];
    a.xx = state.stress.xx;
    a.yy = state.stress.yy;
    a.xy = state.stress.xy;
    a.zz = state.stress.zz;
    a.intensity = state.intensity;
    a.energy = state.energy;
    a.fx = evaluation_.force(i).x;
    a.fy = evaluation_.force(i).y;
    a.torque = evaluation_.torque(i).z;
  }
  for (size_t k = 0; k < s.contacts.size(); k++)
    for (const bool next : {false, true}) {
      double state[mca::LinkList::maxStateSize];
      evaluation_.links().getState(static_cast<int>(k), next, state);
      (next ? s.contacts[k].next : s.contacts[k].now) = {state[0], state[1], state[2], state[3]};
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
