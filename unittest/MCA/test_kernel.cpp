// SPDX-License-Identifier: GPL-2.0-or-later
// Every kernel that this processor runs, held against the slow reference and against what the
// equations say about exchange, mirror, rotation and momentum.
#include "sample.h"
#include "shared/pi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using reference::Automaton;
using reference::ReferenceContact;
using reference::Sample;

namespace {

struct Three {
  double fx, fy, torque;
};

/// Perturbed lattice of three unlike materials with pairs of all kinds, up to 1.9 diameters apart.
Sample randomSample(unsigned seed, int materials, const std::string &preset = "b")
{
  std::mt19937 random(seed);
  auto uniform = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  Sample s = hexagonalBlock(steel(), 12, 11, 0, 1.9);
  s.laws = mca::LawSet::named(preset);
  s.thickness = 1.7;
  mca::Material hard = steel(), soft = steel();
  hard.youngsModulus *= 10;
  hard.strength *= 6;
  hard.diameter *= 1.02;
  soft.poissonsRatio = 0.1;
  soft.breakingStrain = 0.05;
  soft.viscosity = 100;
  s.materials = {steel(), hard, soft};
  s.materials.resize(materials);
  for (auto &a : s.automata) {
    a.x += uniform(-0.04, 0.04);
    a.y += uniform(-0.04, 0.04);
    a.vx = uniform(-10, 10);
    a.vy = uniform(-10, 10);
    a.omega = uniform(-5, 5);
    a.kappa = uniform(0, 0.05);
    a.kept = uniform(0, 0.01);
    a.type = static_cast<int>(random() % materials);
    a.held = random() % 8 == 0;
    a.heldSpin = random() % 8 == 0;
  }
  for (auto &c : s.contacts) {
    const Automaton &a = s.automata[c.i], &b = s.automata[c.j];
    const bool near = std::hypot(b.x - a.x, b.y - a.y) < 1.2 * 2.5;
    for (reference::State *state : {&c.now, &c.next}) {
      state->kind = near ? static_cast<double>(random() % 4) - 1.0 : 0.0;
      state->plastic = near ? uniform(-0.03, 0.03) : 0.0;
      state->gamma = uniform(-2e-3, 2e-3) * (state->kind > 0); // unlinked: friction
      state->gammaTotal = uniform(-0.03, 0.03);
    }
  }
  return s;
}

void expectSame(const Sample &a, const Sample &b, double tolerance)
{
  double force = 0, stress = 0, energy = 0;
  for (int i = 0; i < a.owned; i++) {
    force = std::max({force, std::abs(b.automata[i].fx), std::abs(b.automata[i].fy)});
    stress = std::max(stress, b.automata[i].intensity);
    energy = std::max(energy, b.automata[i].energy);
  }
  ASSERT_GT(force, 0);
  for (int i = 0; i < a.owned; i++) {
    const Automaton &p = a.automata[i], &q = b.automata[i];
    const double near = tolerance * stress, pull = tolerance * force;
    EXPECT_NEAR(p.mean, q.mean, near);
    EXPECT_NEAR(p.xx, q.xx, near);
    EXPECT_NEAR(p.yy, q.yy, near);
    EXPECT_NEAR(p.xy, q.xy, near);
    EXPECT_NEAR(p.zz, q.zz, near);
    EXPECT_NEAR(p.intensity, q.intensity, near);
    EXPECT_NEAR(p.factor, q.factor, tolerance);
    EXPECT_NEAR(p.kappaNext, q.kappaNext, tolerance);
    EXPECT_NEAR(p.keptNext, q.keptNext, tolerance);
    EXPECT_NEAR(p.energy, q.energy, tolerance * energy);
    EXPECT_NEAR(p.fx, q.fx, pull);
    EXPECT_NEAR(p.fy, q.fy, pull);
    EXPECT_NEAR(p.torque, q.torque, pull * 2.5);
  }
  for (size_t k = 0; k < a.contacts.size(); k++) {
    const reference::State &p = a.contacts[k].now, &q = b.contacts[k].now;
    const reference::State &u = a.contacts[k].next, &w = b.contacts[k].next;
    EXPECT_EQ(p.kind, q.kind) << "contact " << k;
    EXPECT_EQ(u.kind, w.kind) << "contact " << k;
    EXPECT_NEAR(p.plastic, q.plastic, tolerance);
    EXPECT_NEAR(u.plastic, w.plastic, tolerance);
    EXPECT_NEAR(p.gamma, q.gamma, tolerance);
    EXPECT_NEAR(u.gamma, w.gamma, tolerance);
    EXPECT_NEAR(p.gammaTotal, q.gammaTotal, tolerance);
    EXPECT_NEAR(u.gammaTotal, w.gammaTotal, tolerance);
  }
  EXPECT_EQ(a.changed, b.changed);
}

class KernelTest : public testing::TestWithParam<const mca::Kernel *> {
 protected:
  void run(Sample &s, double dt) const { kernelStep(*GetParam(), s, dt); }
};

TEST_P(KernelTest, EqualsTheReference)
{
  for (const std::string preset : {"a", "b"})
    for (int materials : {1, 3})
      for (unsigned seed = 1; seed <= 10; seed++)
        for (double dt : {0.0, 5e-5}) {
          Sample slow = randomSample(seed, materials, preset);
          slow.laws.steps = seed % 2 ? "corrected" : "plain";
          Sample fast = slow;
          reference::step(slow, dt);
          run(fast, dt);
          expectSame(fast, slow, 1e-12);
          if (HasFailure())
            FAIL() << "preset " << preset << ", seed " << seed << ", dt " << dt;
        }
}

TEST_P(KernelTest, EqualsTheReferenceWithEachLawSwitched)
{
  std::vector<std::vector<std::string>> choices = {
      {"elasticity", "pairwise"},
      {"plasticity", "none"},
      {"viscosity", "none"},
      {"viscosity", "both"},
      {"viscosity", "both", "steps", "plain"},
      {"worn", "never"},
      {"worn", "never", "link_work", "0.001"},
      {"weld", "1"},
      {"preset", "b"},
      {"steps", "corrected"},
      {"steps", "corrected", "viscosity", "none"},
      {"steps", "corrected", "plasticity", "isochoric", "flow", "contacts", "link_work", "0.001"},
      {"heal", "none", "weld", "none"},
      {"link", "none"},
      {"link", "0.9"},
      {"weld", "0.3", "heal", "0.1"},
      {"heal", "0.1", "healed_strain", "yield_strain"},
      {"healed_strain", "0.02", "fracture", "stress", "plasticity", "isochoric"},
      {"plasticity", "isochoric", "flow", "contacts"},
      {"plasticity", "isochoric"},
      {"plasticity", "isochoric", "flow", "contacts", "steps", "plain"},
      {"flow", "contacts"},
      {"flow", "contacts", "viscosity", "both"},
      {"flow", "contacts", "steps", "plain"},
      {"flow", "contacts", "plasticity", "none"},
      {"link", "none", "link_work", "0.001"},
      {"plane", "stress", "plasticity", "none"},
      {"plane", "stress", "plasticity", "none", "elasticity", "pairwise"},
      {"plasticity", "isochoric", "flow", "contacts", "fracture", "drucker-prager",
       "compressive_strength", "2", "link_work", "0.001"}};
  for (const auto &criterion : fractureWords()) {
    choices.push_back(criterion);
    choices.push_back(criterion);
    choices.back().insert(choices.back().end(), {"link_work", "0.001"});
  }
  for (const int materials : {1, 3}) // one law, the vectorised way, and several
    for (const auto &choice : choices) {
      Sample slow = randomSample(7, materials);
      ASSERT_EQ(slow.laws.parse(choice), "");
      if (!slow.laws.healedStrain.isOff())
        healEverySecond(slow);
      Sample fast = slow;
      reference::step(slow, 5e-5);
      run(fast, 5e-5);
      expectSame(fast, slow, 1e-12);
      if (HasFailure())
        FAIL() << choice[0] << " " << choice[1] << ", materials " << materials;
    }
}

TEST_P(KernelTest, EveryTransitionOccursInTheComparison)
{
  int seen[4][4] = {}; // from worn, none, bulk, weld
  for (unsigned seed = 1; seed <= 20; seed++) {
    Sample s = randomSample(seed, 3);
    run(s, 5e-5);
    for (const auto &c : s.contacts)
      seen[static_cast<int>(c.now.kind) + 1][static_cast<int>(c.next.kind) + 1]++;
  }
  // a contact becomes a weld first, a bulk link never does, and what breaks is worn until it
  // is unloaded or heals
  const bool possible[4][4] = {{true, true, true, false},
                               {false, true, false, true},
                               {true, false, true, false},
                               {true, false, true, true}};
  for (int from = 0; from < 4; from++)
    for (int to = 0; to < 4; to++)
      EXPECT_EQ(seen[from][to] > 0, possible[from][to]) << from - 1 << " -> " << to - 1;
}

TEST_P(KernelTest, EveryTransitionOfHealedLinksOccurs)
{
  int from[4] = {}, to[4] = {}; // worn, none, bulk, weld; to and from healed
  int kept = 0;
  for (unsigned seed = 1; seed <= 20; seed++) {
    Sample s = randomSample(seed, 3);
    ASSERT_EQ(s.laws.parse({"heal", "0.1", "healed_strain", "yield_strain"}), "");
    healEverySecond(s);
    Sample slow = s;
    reference::step(slow, 5e-5);
    run(s, 5e-5);
    expectSame(s, slow, 1e-12);
    for (const auto &c : s.contacts) {
      const double now = c.now.kind, next = c.next.kind;
      if (now == mca::link::healed && next == mca::link::healed)
        kept++;
      else if (now == mca::link::healed)
        to[static_cast<int>(next) + 1]++;
      else if (next == mca::link::healed)
        from[static_cast<int>(now) + 1]++;
    }
  }
  EXPECT_GT(kept, 0);
  for (int kind = -1; kind <= 2; kind++) {
    EXPECT_EQ(to[kind + 1] > 0, kind == mca::link::worn) << kind;
    EXPECT_EQ(from[kind + 1] > 0, kind == mca::link::worn || kind == mca::link::weld) << kind;
  }
}

TEST_P(KernelTest, FollowsTheReferenceOverSteps)
{
  Sample slow = randomSample(3, 3);
  for (auto &c : slow.contacts)
    c.next = c.now;
  Sample fast = slow;
  const double dt = 1e-5;
  for (int k = 0; k < 20; k++) {
    for (auto *s : {&slow, &fast})
      for (auto &a : s->automata) {
        a.x += a.vx * dt;
        a.y += a.vy * dt;
      }
    reference::step(slow, dt);
    run(fast, dt);
    for (auto *s : {&slow, &fast})
      for (auto &a : s->automata)
        a.kappa = a.kappaNext;
  }
  expectSame(fast, slow, 1e-11);
}

// A linked block, so large that whole blocks of pairs stay elastic, that is sheared and torn apart
// at one end: links flow, break, touch and weld.
void tear(const mca::Kernel &kernel, const std::vector<std::string> &laws)
{
  Sample slow = hexagonalBlock(steel(), 40, 30, 1, 1.3);
  ASSERT_EQ(slow.laws.parse(laws), "");
  for (auto &c : slow.contacts) {
    const Automaton &a = slow.automata[c.i], &b = slow.automata[c.j];
    if (std::hypot(b.x - a.x, b.y - a.y) > 1.1 * 2.5)
      c.now.kind = c.next.kind = 0;
  }
  std::mt19937 random(4);
  for (auto &a : slow.automata) {
    a.vx = a.y > 60 ? 8 * (a.y - 60) * std::sin(0.3 * a.x) : 1e-3 * a.y;
    a.vy = a.y > 60 ? 5 * std::cos(0.5 * a.x) : 0;
    a.omega = a.y > 60 ? std::uniform_real_distribution<>(-5, 5)(random) : 0;
  }
  Sample fast = slow;
  KernelRun kept(kernel, fast, false);
  const double dt = 5e-5;
  int broken = 0, formed = 0, flowing = 0;
  for (int k = 0; k < 150; k++) {
    for (auto *s : {&slow, &fast})
      for (auto &a : s->automata) {
        a.x += a.vx * dt;
        a.y += a.vy * dt;
      }
    reference::step(slow, dt);
    kept.step(fast, dt);
    for (const auto &c : slow.contacts) {
      broken += c.now.kind > 0 && c.next.kind <= 0;
      formed += c.now.kind <= 0 && c.next.kind > 0;
    }
    for (auto *s : {&slow, &fast})
      for (auto &a : s->automata)
        a.kappa = a.kappaNext;
  }
  for (const auto &a : slow.automata)
    flowing += a.kappa > 0;
  EXPECT_GT(broken, 10);
  EXPECT_GT(formed, 0);
  EXPECT_GT(flowing, 50);
  EXPECT_LT(flowing, slow.owned / 2);
  expectSame(fast, slow, 1e-9);
}

TEST_P(KernelTest, KeptListFollowsTheReference)
{
  tear(*GetParam(), {});
  // links break in blocks in which nothing flows, and where they flow
  tear(*GetParam(), {"fracture", "drucker-prager", "compressive_strength", "3"});
}

TEST_P(KernelTest, LocalFlowIsAlikeInLongAndShortSteps)
{
  // one automaton is dragged through a linked block at 5 m/s: a strain of 1e-4 in a step of 5e-5
  auto force = [](double dt) {
    Sample s = hexagonalBlock(steel(), 9, 9, 1);
    s.laws.plasticity = "isochoric";
    s.laws.flow = "contacts";
    s.laws.steps = "corrected";
    Automaton &dragged = s.automata[40];
    dragged.vx = 5;
    KernelRun kept(*GetParam(), s, false);
    const int steps = static_cast<int>(std::round(4e-3 / dt)), half = steps / 2;
    double sum = 0, flow = 0;
    for (int k = 0; k < steps; k++) {
      dragged.x += dragged.vx * dt;
      kept.step(s, dt);
      for (auto &a : s.automata) {
        a.kappa = a.kappaNext;
        flow = std::max(flow, a.kappa);
      }
      sum += k < half ? 0.0 : dragged.fx;
    }
    EXPECT_GT(flow, 1e-3);
    return sum / (steps - half);
  };
  const double limit = force(1.5625e-6); // with one return only 9.4 and 4.9 % less
  EXPECT_NEAR(force(1e-4) / limit, 1.0, 0.025);
  EXPECT_NEAR(force(5e-5) / limit, 1.0, 0.012);
}

TEST_P(KernelTest, LargeShearFeignsNoTensionWithIsochoricFlow)
{
  // a simple shear of 0.08 keeps the area, but lengthens contacts by 3/16 of its square
  auto sheared = [](const std::string &plasticity) {
    Sample s = hexagonalBlock(steel(), 9, 9, 1);
    EXPECT_EQ(s.laws.parse({"plasticity", plasticity, "flow", "contacts", "fracture", "none"}), "");
    KernelRun kept(*GetParam(), s, false);
    const double dt = 1e-3;
    for (auto &a : s.automata)
      a.omega = -0.05; // half the shear rate
    for (int k = 0; k < 800; k++) {
      for (auto &a : s.automata) {
        a.vx = 0.1 * a.y;
        a.x += a.vx * dt;
      }
      kept.step(s, dt);
      for (auto &a : s.automata)
        a.kappa = a.kappaNext;
    }
    return s.automata[40];
  };
  const Automaton elastic = sheared("none"), flown = sheared("isochoric");
  EXPECT_NEAR(elastic.mean, steel().bulkModulus() * 3.0 / 8 * 0.08 * 0.08, 0.05 * elastic.mean);
  EXPECT_GT(flown.kappa, 0.04);
  EXPECT_LT(std::abs(flown.mean), 0.15 * elastic.mean);
}

TEST_P(KernelTest, ACollapsedLinkBreaks)
{
  // one pair of a block of bulk links, whose automata are pressed to 0.4 d
  Sample slow = hexagonalBlock(steel(), 8, 6, 1, 1.1);
  slow.laws.viscosity = "normal";
  const ReferenceContact &c = slow.contacts[60];
  slow.automata[c.j].x = slow.automata[c.i].x + 1.0;
  slow.automata[c.j].y = slow.automata[c.i].y;
  Sample fast = slow;
  reference::step(slow, 5e-5);
  run(fast, 5e-5);
  expectSame(fast, slow, 1e-12);
  EXPECT_EQ(fast.contacts[60].next.kind, -1);
  EXPECT_EQ(fast.automata[c.i].torque, 0.0); // none is sheared
}

TEST_P(KernelTest, ZeroStepLeavesThePresentState)
{
  Sample s = randomSample(5, 3);
  const Sample before = s;
  run(s, 0.0);
  for (size_t k = 0; k < s.contacts.size(); k++) {
    const reference::State &now = s.contacts[k].now, &was = before.contacts[k].now;
    EXPECT_EQ(now.kind, was.kind);
    EXPECT_EQ(now.plastic, was.plastic);
    if (was.kind <= 0)
      continue; // an unlinked pair has no shear to keep
    EXPECT_EQ(now.gamma, was.gamma);
    EXPECT_EQ(now.gammaTotal, was.gammaTotal);
  }
  Sample again = s; // and is a pure function of it
  run(again, 0.0);
  expectSame(again, s, 0.0);
}

TEST_P(KernelTest, ExchangeOfBothAutomataChangesNothing)
{
  Sample s = randomSample(11, 3), turned = s;
  for (auto &c : turned.contacts)
    std::swap(c.i, c.j);
  run(s, 5e-5);
  run(turned, 5e-5);
  expectSame(turned, s, 1e-13);
}

TEST_P(KernelTest, TranslationChangesNothing)
{
  Sample s = randomSample(12, 3), moved = s;
  for (auto &a : moved.automata) {
    a.x += 1024;
    a.y -= 512;
    a.vx += 3;
    a.vy -= 2;
  }
  run(s, 5e-5);
  run(moved, 5e-5);
  expectSame(moved, s, 1e-10); // positions of 1024 keep 13 digits of strains of about 0.02
}

TEST_P(KernelTest, MirrorTurnsShearAndTorqueRound)
{
  Sample s = randomSample(13, 3), mirrored = s;
  auto mirror = [](Sample &m) {
    for (auto &a : m.automata) {
      a.x = -a.x;
      a.vx = -a.vx;
      a.omega = -a.omega;
      a.xy = -a.xy;
      a.fx = -a.fx;
      a.torque = -a.torque;
    }
    for (auto &c : m.contacts)
      for (auto *state : {&c.now, &c.next}) {
        state->gamma = -state->gamma;
        state->gammaTotal = -state->gammaTotal;
      }
  };
  mirror(mirrored);
  run(s, 5e-5);
  run(mirrored, 5e-5);
  mirror(mirrored);
  expectSame(mirrored, s, 1e-13);
}

TEST_P(KernelTest, RotationTurnsTheForces)
{
  for (const double degrees : {60.0, 37.0}) {
    const double angle = degrees * mcawr::pi / 180;
    const double c = std::cos(angle), sn = std::sin(angle);
    auto turn = [&](double &x, double &y, double sign) {
      const double u = c * x - sign * sn * y, w = sign * sn * x + c * y;
      x = u;
      y = w;
    };
    Sample s = randomSample(14, 3), turned = s;
    for (auto &a : turned.automata) {
      turn(a.x, a.y, 1);
      turn(a.vx, a.vy, 1);
    }
    run(s, 5e-5);
    run(turned, 5e-5);
    double scale = 0;
    for (const auto &a : s.automata)
      scale = std::max(scale, std::hypot(a.fx, a.fy));
    for (size_t k = 0; k < s.automata.size(); k++) {
      Automaton &a = turned.automata[k];
      turn(a.fx, a.fy, -1);
      EXPECT_NEAR(a.fx, s.automata[k].fx, 1e-11 * scale);
      EXPECT_NEAR(a.fy, s.automata[k].fy, 1e-11 * scale);
      EXPECT_NEAR(a.torque, s.automata[k].torque, 1e-11 * scale);
      EXPECT_NEAR(a.energy, s.automata[k].energy, 1e-11 * s.automata[k].energy);
    }
  }
}

TEST_P(KernelTest, TotalForceAndTorqueVanish)
{
  Sample s = randomSample(15, 3);
  run(s, 5e-5);
  double fx = 0, fy = 0, torque = 0, scale = 0;
  for (const auto &a : s.automata) {
    fx += a.fx;
    fy += a.fy;
    torque += a.torque + a.x * a.fy - a.y * a.fx;
    scale = std::max(scale, std::hypot(a.fx, a.fy));
  }
  EXPECT_NEAR(fx, 0, 1e-12 * scale);
  EXPECT_NEAR(fy, 0, 1e-12 * scale);
  EXPECT_NEAR(torque, 0, 1e-11 * scale * 30);
}

TEST_P(KernelTest, SeparatedPairsFeelNothing)
{
  Sample s = hexagonalBlock(steel(), 6, 5, 0, 1.9);
  for (auto &a : s.automata) {
    a.x *= 1.05;
    a.y *= 1.05;
    a.vx = a.y;
  }
  run(s, 5e-5);
  EXPECT_EQ(s.changed, 0);
  for (const auto &a : s.automata) {
    EXPECT_EQ(a.fx, 0);
    EXPECT_EQ(a.fy, 0);
    EXPECT_EQ(a.torque, 0);
    EXPECT_EQ(a.mean, 0);
    EXPECT_EQ(a.factor, 1);
    EXPECT_EQ(a.energy, 0);
  }
}

TEST_P(KernelTest, ForceIsTheGradientOfTheEnergy)
{
  // stressed, sheared, elastic; moving one automaton by h in a step of 1 keeps the shear's history
  std::mt19937 random(21);
  auto uniform = [&](double a) { return std::uniform_real_distribution<>(-a, a)(random); };
  for (const std::string elasticity : {"many-body", "pairwise"}) {
    Sample start = hexagonalBlock(steel(), 5, 5, 1);
    start.laws.elasticity = elasticity;
    start.laws.plasticity = "none";
    for (auto &a : start.automata) {
      a.x += uniform(0.03);
      a.y += uniform(0.03);
    }
    for (auto &c : start.contacts) {
      c.now.gamma = c.next.gamma = uniform(0.01);
      c.now.plastic = c.next.plastic = uniform(0.01);
    }
    Sample here = start;
    run(here, 0.0);
    double scale = 0;
    for (const auto &a : here.automata)
      scale = std::max(scale, std::hypot(a.fx, a.fy));
    const double h = 1e-4;
    for (int k : {0, 7, 12, 24})
      for (int direction = 0; direction < 3; direction++) {
        double energy[2];
        for (int side = 0; side < 2; side++) {
          Sample there = start;
          Automaton &a = there.automata[k];
          const double move = side == 0 ? -h : h;
          (direction == 0 ? a.vx : direction == 1 ? a.vy : a.omega) = move;
          (direction == 0 ? a.x : direction == 1 ? a.y : a.kappa) += move;
          a.kappa = 0;
          run(there, 1.0);
          energy[side] = totalEnergy(there);
        }
        const Automaton &a = here.automata[k];
        const double force = direction == 0 ? a.fx : direction == 1 ? a.fy : a.torque;
        EXPECT_NEAR(-(energy[1] - energy[0]) / (2 * h), force, 1e-6 * scale)
            << elasticity << ", automaton " << k << ", direction " << direction;
      }
  }
}

TEST_P(KernelTest, UnlikeMaterialsFollowTheGradientToo)
{
  Sample start = hexagonalBlock(steel(), 5, 5, 1);
  mca::Material hard = steel();
  hard.youngsModulus *= 10;
  hard.poissonsRatio = 0.1;
  start.materials = {steel(), hard};
  start.laws.plasticity = "none";
  std::mt19937 random(22);
  for (auto &a : start.automata) {
    a.type = static_cast<int>(random() % 2);
    a.x += std::uniform_real_distribution<>(-0.03, 0.03)(random);
  }
  for (auto &c : start.contacts)
    c.now.gamma = c.next.gamma = std::uniform_real_distribution<>(-0.01, 0.01)(random);
  Sample here = start;
  run(here, 0.0);
  double scale = 0;
  for (const auto &a : here.automata)
    scale = std::max(scale, std::hypot(a.fx, a.fy));
  const double h = 1e-4;
  for (int k = 0; k < 25; k += 3) {
    double energy[2];
    for (int side = 0; side < 2; side++) {
      Sample there = start;
      there.automata[k].vx = side == 0 ? -h : h;
      there.automata[k].x += there.automata[k].vx;
      run(there, 1.0);
      energy[side] = totalEnergy(there);
    }
    EXPECT_NEAR(-(energy[1] - energy[0]) / (2 * h), here.automata[k].fx, 1e-6 * scale);
  }
}

INSTANTIATE_TEST_SUITE_P(AllSupported, KernelTest, testing::ValuesIn(mca::supportedKernels(2)),
                         [](const auto &kernel) { return kernelName(kernel.param); });

TEST(KernelChoice, BestIsTheLastSupported)
{
  const auto all = mca::supportedKernels(2);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(std::string(all.front()->name), "baseline");
  EXPECT_EQ(&mca::bestKernel(2), all.back());
}

} // namespace
