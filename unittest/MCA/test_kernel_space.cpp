// SPDX-License-Identifier: GPL-2.0-or-later
// Every kernel in space that this processor runs, held against the slow reference and against what
// the equations say about elasticity, exchange, mirror, rotation, momentum and energy.
#include "sample.h"
#include "sample_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace reference::space;
using Eigen::AngleAxisd;

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine_); }
  int whole(int n) { return static_cast<int>(engine_() % n); }
  Vector3d vector(double size)
  {
    const double x = number(-size, size), y = number(-size, size), z = number(-size, size);
    return {x, y, z};
  }

 private:
  std::mt19937 engine_;
};

/// Perturbed lattice of unlike materials with pairs of all kinds, up to 1.5 diameters apart, that
/// has just made a step dt.
Sample randomSample(const mca::Packing &packing, unsigned seed, int materials, double dt,
                    const std::string &preset = "b")
{
  Random random(seed);
  Sample s = block(packing, steel(), packing.coordination == 6 ? 5 : 4, 0, false, 1.5);
  s.laws = mca::LawSet::named(preset);
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
    a.x += random.vector(0.04);
    a.v = random.vector(10);
    a.omega = random.vector(5);
    a.kappa = random.number(0, 0.05);
    a.kept = random.number(0, 0.01);
    a.type = random.whole(materials);
    a.held = random.whole(8) == 0;
    a.heldSpin = random.whole(8) == 0;
  }
  for (auto &c : s.contacts) {
    const Automaton &a = s.automata[c.i], &b = s.automata[c.j];
    const Vector3d old = b.x - a.x - dt * (b.v - a.v);
    const bool near = old.norm() < 1.2 * 2.5;
    for (State *state : {&c.now, &c.next}) {
      state->kind = near ? random.whole(4) - 1.0 : 0.0;
      state->plastic = near ? random.number(-0.03, 0.03) : 0.0;
      state->gamma = old.normalized().cross(random.vector(5e-4)) * (state->kind > 0);
      state->gammaTotal = old.normalized().cross(random.vector(0.03));
    }
  }
  return s;
}

void expectSame(const Sample &a, const Sample &b, double tolerance)
{
  double force = 0, stress = 0;
  for (int i = 0; i < a.owned; i++) {
    force = std::max(force, b.automata[i].force.norm());
    stress = std::max(stress, b.automata[i].intensity);
  }
  ASSERT_GT(force, 0);
  for (int i = 0; i < a.owned; i++) {
    const Automaton &p = a.automata[i], &q = b.automata[i];
    EXPECT_NEAR(p.mean, q.mean, tolerance * stress);
    EXPECT_LE((p.stress - q.stress).norm(), tolerance * stress);
    EXPECT_NEAR(p.intensity, q.intensity, tolerance * stress);
    EXPECT_NEAR(p.factor, q.factor, tolerance);
    EXPECT_NEAR(p.kappaNext, q.kappaNext, tolerance);
    EXPECT_NEAR(p.keptNext, q.keptNext, tolerance);
    EXPECT_NEAR(p.energy, q.energy, tolerance * std::abs(q.energy));
    EXPECT_LE((p.force - q.force).norm(), tolerance * force);
    EXPECT_LE((p.torque - q.torque).norm(), tolerance * force * 2.5);
  }
  for (size_t k = 0; k < a.contacts.size(); k++)
    for (const bool next : {false, true}) {
      const State &p = next ? a.contacts[k].next : a.contacts[k].now;
      const State &q = next ? b.contacts[k].next : b.contacts[k].now;
      EXPECT_EQ(p.kind, q.kind) << "contact " << k;
      EXPECT_NEAR(p.plastic, q.plastic, tolerance);
      EXPECT_LE((p.gamma - q.gamma).norm(), tolerance);
      EXPECT_LE((p.gammaTotal - q.gammaTotal).norm(), tolerance);
    }
  EXPECT_EQ(a.changed, b.changed);
}

class SpaceKernelTest : public testing::TestWithParam<const mca::Kernel *> {
 protected:
  void run(Sample &s, double dt) const { kernelStep(*GetParam(), s, dt); }
};

} // namespace

TEST_P(SpaceKernelTest, EqualsTheReference)
{
  for (const mca::Packing &packing : {mca::packing::fcc, mca::packing::hcp, mca::packing::sc})
    for (const std::string preset : {"a", "b"})
      for (int materials : {1, 3})
        for (unsigned seed = 1; seed <= 3; seed++)
          for (double dt : {0.0, 5e-5}) {
            Sample slow = randomSample(packing, seed, materials, dt, preset);
            slow.laws.steps = seed % 2 ? "corrected" : "plain";
            Sample fast = slow;
            step(slow, dt);
            run(fast, dt);
            expectSame(fast, slow, 1e-12);
            if (HasFailure())
              FAIL() << packing.name << ", preset " << preset << ", seed " << seed << ", dt " << dt;
          }
}

TEST_P(SpaceKernelTest, EqualsTheReferenceWithEachLawSwitched)
{
  std::vector<std::vector<std::string>> choices = {
      {"elasticity", "pairwise"},
      {"plasticity", "none"},
      {"plasticity", "isochoric"},
      {"plasticity", "isochoric", "flow", "contacts"},
      {"plasticity", "isochoric", "flow", "contacts", "link_work", "0.001"},
      {"flow", "contacts"},
      {"flow", "contacts", "viscosity", "both"},
      {"viscosity", "none"},
      {"viscosity", "both"},
      {"viscosity", "both", "steps", "plain"},
      {"worn", "never"},
      {"worn", "never", "link_work", "0.001"},
      {"weld", "1"},
      {"preset", "b"},
      {"heal", "none", "weld", "none"},
      {"link", "none"},
      {"link", "0.9"},
      {"weld", "0.3", "heal", "0.1"},
      {"heal", "0.1", "healed_strain", "yield_strain"},
      {"healed_strain", "0.02", "fracture", "stress", "plasticity", "isochoric"},
      {"link", "none", "link_work", "0.001"},
      {"steps", "plain", "link_work", "0.001"}};
  for (const auto &criterion : fractureWords()) {
    choices.push_back(criterion);
    choices.push_back(criterion);
    choices.back().insert(choices.back().end(), {"link_work", "0.001"});
  }
  for (const int materials : {1, 3}) // one law, the vectorised way, and several
    for (const auto &choice : choices) {
      Sample slow = randomSample(mca::packing::fcc, 7, materials, 5e-5);
      ASSERT_EQ(slow.laws.parse(choice), "");
      if (!slow.laws.healedStrain.isOff())
        healEverySecond(slow);
      Sample fast = slow;
      step(slow, 5e-5);
      run(fast, 5e-5);
      expectSame(fast, slow, 1e-12);
      if (HasFailure())
        FAIL() << choice[0] << " " << choice[1] << ", materials " << materials;
    }
}

TEST_P(SpaceKernelTest, EveryTransitionOccursInTheComparison)
{
  int seen[4][4] = {}; // from worn, none, bulk, weld
  for (unsigned seed = 1; seed <= 60; seed++) {
    Sample s = randomSample(mca::packing::fcc, seed, 3, 5e-5);
    run(s, 5e-5);
    for (const auto &c : s.contacts)
      seen[static_cast<int>(c.now.kind) + 1][static_cast<int>(c.next.kind) + 1]++;
  }
  const bool possible[4][4] = {{true, true, true, false},
                               {false, true, false, true},
                               {true, false, true, false},
                               {true, false, true, true}};
  for (int from = 0; from < 4; from++)
    for (int to = 0; to < 4; to++)
      EXPECT_EQ(seen[from][to] > 0, possible[from][to]) << from - 1 << " -> " << to - 1;
}

TEST_P(SpaceKernelTest, BulkBlocksEqualTheReference)
{
  // all bulk links of one law: elastic, flowing, breaking, and both; after flow and without
  const double dt = 5e-5;
  for (const double strength : {1e6, 92.0})
    for (const double breaking : {0.4, 0.03})
      for (const bool flowed : {false, true}) {
        Random random(8);
        Sample slow = block(mca::packing::fcc, steel(), 5, 1, false);
        slow.materials[0].strength = strength;
        slow.materials[0].breakingStrain = breaking;
        slow.materials[0].yieldStrain = 0.4 * breaking;
        for (auto &a : slow.automata) {
          a.x += random.vector(0.02);
          a.v = random.vector(10);
          a.omega = random.vector(5);
        }
        for (auto &c : slow.contacts) {
          const Automaton &a = slow.automata[c.i], &b = slow.automata[c.j];
          const Vector3d old = b.x - a.x - dt * (b.v - a.v);
          c.next.gammaTotal = old.normalized().cross(random.vector(0.02));
          c.next.gamma = flowed ? old.normalized().cross(random.vector(1e-3)) : c.next.gammaTotal;
        }
        Sample fast = slow;
        step(slow, dt);
        run(fast, dt);
        expectSame(fast, slow, 1e-12);
        EXPECT_EQ(slow.changed > 0, breaking < 0.1);
        EXPECT_EQ(slow.automata[60].factor < 1, strength < 1000);
      }
}

TEST_P(SpaceKernelTest, ACollapsedLinkBreaks)
{
  Sample slow = block(mca::packing::fcc, steel(), 3, 1, false);
  for (auto &a : slow.automata)
    a.x *= 0.99;
  const ReferenceContact &c = slow.contacts[40];
  slow.automata[c.j].x = slow.automata[c.i].x + Vector3d(0.4, 0.8, 0.4);
  Sample fast = slow;
  step(slow, 5e-5);
  run(fast, 5e-5);
  expectSame(fast, slow, 1e-12);
  EXPECT_EQ(fast.contacts[40].next.kind, -1);
}

TEST_P(SpaceKernelTest, FollowsTheReferenceOverSteps)
{
  Sample slow = randomSample(mca::packing::fcc, 3, 3, 0);
  for (auto &c : slow.contacts)
    c.next = c.now;
  Sample fast = slow;
  SpaceRun run(*GetParam(), fast, false);
  const double dt = 1e-5;
  for (int k = 0; k < 20; k++) {
    for (auto *s : {&slow, &fast})
      for (auto &a : s->automata)
        a.x += a.v * dt;
    step(slow, dt);
    run.step(fast, dt);
    for (auto *s : {&slow, &fast})
      for (auto &a : s->automata)
        a.kappa = a.kappaNext;
  }
  expectSame(fast, slow, 1e-11);
}

TEST_P(SpaceKernelTest, ZeroStepLeavesThePresentState)
{
  Sample s = randomSample(mca::packing::fcc, 5, 3, 0);
  const Sample before = s;
  run(s, 0.0);
  for (size_t k = 0; k < s.contacts.size(); k++) {
    const State &now = s.contacts[k].now, &was = before.contacts[k].now;
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

TEST_P(SpaceKernelTest, ExchangeOfBothAutomataTurnsTheShearRound)
{
  Sample s = randomSample(mca::packing::fcc, 11, 3, 5e-5), turned = s;
  auto turn = [](Sample &sample) {
    for (auto &c : sample.contacts) {
      std::swap(c.i, c.j);
      for (auto *state : {&c.now, &c.next}) {
        state->gamma = -state->gamma;
        state->gammaTotal = -state->gammaTotal;
      }
    }
  };
  turn(turned);
  run(s, 5e-5);
  run(turned, 5e-5);
  turn(turned);
  expectSame(turned, s, 1e-13);
}

TEST_P(SpaceKernelTest, TranslationChangesNothing)
{
  Sample s = randomSample(mca::packing::fcc, 12, 3, 5e-5), moved = s;
  for (auto &a : moved.automata) {
    a.x += Vector3d(1024, -512, 256);
    a.v += Vector3d(3, -2, 1);
  }
  run(s, 5e-5);
  run(moved, 5e-5);
  expectSame(moved, s, 1e-10); // positions of 1024 keep 13 digits of strains of about 0.02
}

TEST_P(SpaceKernelTest, MirrorAndRotationTurnEverything)
{
  Matrix3d mirror = Vector3d(-1, 1, 1).asDiagonal();
  const Matrix3d rotation = AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  for (const Matrix3d &map : {mirror, rotation, Matrix3d(rotation * mirror)}) {
    const double hand = map.determinant(); // axial vectors turn round in a mirror
    auto apply = [&](Sample &m, const Matrix3d &a) {
      for (auto &b : m.automata) {
        b.x = a * b.x;
        b.v = a * b.v;
        b.omega = hand * a * b.omega;
        b.force = a * b.force;
        b.torque = hand * a * b.torque;
        b.stress = a * b.stress * a.transpose();
      }
      for (auto &c : m.contacts)
        for (auto *state : {&c.now, &c.next}) {
          state->gamma = a * state->gamma;
          state->gammaTotal = a * state->gammaTotal;
        }
    };
    Sample s = randomSample(mca::packing::fcc, 13, 3, 5e-5), mapped = s;
    apply(mapped, map);
    run(s, 5e-5);
    run(mapped, 5e-5);
    apply(mapped, map.transpose());
    expectSame(mapped, s, 1e-11);
  }
}

TEST_P(SpaceKernelTest, TotalForceAndTorqueVanish)
{
  Sample s = randomSample(mca::packing::fcc, 15, 3, 5e-5);
  run(s, 5e-5);
  Vector3d force(0, 0, 0), torque(0, 0, 0);
  double scale = 0;
  for (const auto &a : s.automata) {
    force += a.force;
    torque += a.torque + a.x.cross(a.force);
    scale = std::max(scale, a.force.norm());
  }
  EXPECT_LT(force.norm(), 1e-12 * scale);
  EXPECT_LT(torque.norm(), 1e-11 * scale * 10);
}

TEST_P(SpaceKernelTest, HomogeneousStrainGivesHookesTensorEverywhere)
{
  const double nu = 0.3;
  Random random(16);
  for (const mca::Packing &packing : {mca::packing::fcc, mca::packing::hcp, mca::packing::sc})
    for (int sample = 0; sample < 3; sample++) {
      Sample s = block(packing, steel(), 4, 1, true);
      s.laws.plasticity = "none";
      s.materials[0].poissonsRatio = nu;
      Matrix3d eps;
      const Vector3d a = random.vector(1e-7), b = random.vector(1e-7);
      eps << a.x(), b.x(), b.y(), b.x(), a.y(), b.z(), b.y(), b.z(), a.z();
      for (auto &at : s.automata) {
        at.v = eps * at.x;
        at.x += at.v;
      }
      run(s, 1.0);
      const double E = s.materials[0].youngsModulus, G = E / 2 / (1 + nu);
      const double lambda = E * nu / (1 + nu) / (1 - 2 * nu);
      const Matrix3d hooke = lambda * eps.trace() * Matrix3d::Identity() + 2 * G * eps;
      for (int i = 0; i < s.owned; i++) {
        const Automaton &at = s.automata[i];
        EXPECT_LT((at.stress - hooke).norm(), 1e-6 * hooke.norm()) << packing.name;
        EXPECT_NEAR(at.mean, hooke.trace() / 3, 1e-6 * hooke.norm()) << packing.name;
        EXPECT_LT(at.force.norm(), 1e-6 * hooke.norm() * 2.5 * 2.5) << packing.name;
        const double density = 0.5 * (hooke.transpose() * eps).trace();
        const mca::Cell cell{packing, 2.5};
        EXPECT_NEAR(at.energy, density * cell.cellVolume(), 1e-6 * at.energy) << packing.name;
      }
    }
}

TEST_P(SpaceKernelTest, ForceIsTheGradientOfTheEnergy)
{
  // stressed, sheared, elastic; moving one automaton by h in a step of 1 keeps the shear's history
  for (const std::string elasticity : {"many-body", "pairwise"}) {
    Random random(21);
    Sample start = block(mca::packing::fcc, steel(), 3, 1, false);
    start.laws.elasticity = elasticity;
    start.laws.plasticity = "none";
    start.laws.fracture = "none";
    mca::Material hard = steel();
    hard.youngsModulus *= 10;
    hard.poissonsRatio = 0.1;
    start.materials.push_back(hard);
    for (auto &a : start.automata) {
      a.x += random.vector(0.03);
      a.type = random.whole(2);
    }
    for (auto &c : start.contacts) {
      const Vector3d n = (start.automata[c.j].x - start.automata[c.i].x).normalized();
      c.now.gamma = c.next.gamma = n.cross(random.vector(0.01));
      c.now.plastic = c.next.plastic = random.number(-0.01, 0.01);
    }
    Sample here = start;
    run(here, 0.0);
    double scale = 0;
    for (const auto &a : here.automata)
      scale = std::max(scale, a.force.norm());
    const double h = 1e-4;
    for (int k : {0, 13, 26})
      for (int direction = 0; direction < 6; direction++) {
        double energy[2];
        for (int side = 0; side < 2; side++) {
          Sample there = start;
          Automaton &a = there.automata[k];
          const double move = side == 0 ? -h : h;
          (direction < 3 ? a.v : a.omega)(direction % 3) = move;
          a.x += a.v;
          run(there, 1.0);
          energy[side] = 0;
          for (int i = 0; i < there.owned; i++)
            energy[side] += there.automata[i].energy;
        }
        const Automaton &a = here.automata[k];
        const double force = (direction < 3 ? a.force : a.torque)(direction % 3);
        EXPECT_NEAR(-(energy[1] - energy[0]) / (2 * h), force, 2e-6 * scale)
            << elasticity << ", automaton " << k << ", direction " << direction;
      }
  }
}

TEST_P(SpaceKernelTest, StressedBlockTurnedRigidlyKeepsItsStress)
{
  // sheared and stretched within the elastic limit, then turned about any axis in many steps
  Sample s = block(mca::packing::fcc, steel(), 4, 1, false);
  Matrix3d eps;
  eps << 1e-5, 5e-5, -3e-5, 5e-5, -2e-5, 4e-5, -3e-5, 4e-5, 0;
  for (auto &a : s.automata) {
    a.v = eps * a.x;
    a.x += a.v;
  }
  SpaceRun run(*GetParam(), s, false);
  run.step(s, 1.0);
  const Sample start = s;
  for (auto &a : s.automata)
    ASSERT_EQ(a.factor, 1);
  const Vector3d axis = Vector3d(0.3, -0.8, 0.5).normalized();
  const int steps = 1000;
  const double dt = 1.0, total = 2.0;
  std::vector<Vector3d> before;
  for (int k = 1; k <= steps; k++) {
    const Matrix3d turn = AngleAxisd(total * k / steps, axis).toRotationMatrix();
    for (size_t i = 0; i < s.automata.size(); i++) {
      Automaton &a = s.automata[i];
      const Vector3d there = turn * start.automata[i].x;
      a.v = (there - a.x) / dt;
      a.x = there;
      a.omega = total / steps / dt * axis;
    }
    run.step(s, dt);
  }
  const Matrix3d turn = AngleAxisd(total, axis).toRotationMatrix();
  double scale = 0, forces = 0;
  for (const auto &a : start.automata) {
    scale = std::max(scale, a.stress.norm());
    forces = std::max(forces, a.force.norm());
  }
  for (size_t i = 0; i < s.automata.size(); i++) {
    const Automaton &a = s.automata[i], &b = start.automata[i];
    EXPECT_LT((a.stress - turn * b.stress * turn.transpose()).norm(), 1e-8 * scale);
    EXPECT_LT((a.force - turn * b.force).norm(), 1e-8 * forces);
  }
}

TEST_P(SpaceKernelTest, SimpleShearInThePlaneTurnsAsThePlanesLaw)
{
  // one linked pair in the plane z = 0 has the plane's shear
  Sample s;
  s.materials = {steel()};
  s.automata.resize(2);
  s.owned = 2;
  s.owner = {0, 1};
  s.shift.resize(2, Vector3d::Zero());
  s.automata[1].v = Vector3d(0.001, 0.02, 0);
  s.automata[1].x = Vector3d(2.5, 0, 0) + s.automata[1].v;
  s.automata[0].omega = Vector3d(0, 0, 0.003);
  ReferenceContact c;
  c.j = 1;
  c.now.kind = c.next.kind = 1;
  s.contacts.push_back(c);
  run(s, 1.0);
  const double gamma = mca::shearIncrement(mca::axisRotation(0.02 / 2.501), 0.003);
  EXPECT_NEAR(s.contacts[0].now.gamma.norm(), gamma, 1e-12);
}

TEST_P(SpaceKernelTest, FlowOfAllAlikeKeepsTheVolume)
{
  // a periodic block is drawn and sheared; its elastic twin has the same strains and never flows
  for (const std::string plasticity : {"radial", "isochoric"})
    for (const bool sheared : {false, true}) {
      Sample s = block(mca::packing::fcc, steel(), 4, 1, true), twin = s;
      s.laws.plasticity = plasticity;
      s.laws.flow = "contacts";
      twin.laws.plasticity = "none";
      Matrix3d rate = Matrix3d::Zero();
      if (sheared)
        rate(0, 1) = 1e-4;
      else
        rate = Vector3d(1e-4, -5e-5, -5e-5).asDiagonal();
      SpaceRun run(*GetParam(), s, false), elastic(*GetParam(), twin, false);
      for (int k = 0; k < 80; k++) { // the stretch of shear takes a part of a stress in a step
        for (auto *sample : {&s, &twin})
          for (auto &a : sample->automata) {
            a.v = rate * a.x;
            a.x += a.v;
          }
        run.step(s, 1.0);
        elastic.step(twin, 1.0);
        for (int i = 0; i < s.owned; i++)
          s.automata[i].kappa = s.automata[i].kappaNext;
      }
      const double yieldStress = reference::yieldStress(s.materials[0], s.automata[0].kappa);
      for (int i = 0; i < s.owned; i++) {
        const Automaton &a = s.automata[i], &b = twin.automata[i];
        EXPECT_LT(a.factor, 1);
        EXPECT_GT(a.kappa, 1e-3);
        EXPECT_GT(b.intensity, 3 * a.intensity);
        EXPECT_NEAR(a.stress.trace() / 3, a.mean, 1e-9 * yieldStress);
        if (plasticity == "isochoric") // and takes off what contacts lengthen as they rotate
          EXPECT_LT(std::abs(a.mean), 0.15 * b.mean);
        else
          EXPECT_NEAR(a.mean, b.mean, 1e-9 * yieldStress);
      }
    }
}

TEST_P(SpaceKernelTest, FlowOfAnySampleKeepsTheSumOfItsStrains)
{
  // automata that flow beside others that do not, with welds and open contacts among their links
  for (const std::string steps : {"corrected", "plain"}) {
    Sample s = randomSample(mca::packing::fcc, 9, 1, 5e-5);
    s.laws.fracture = "none"; // a link that breaks may forget its offset
    s.laws.steps = steps;
    run(s, 5e-5);
    int flowing = 0;
    for (int i = 0; i < s.owned; i++)
      flowing += s.automata[i].factor < 1;
    EXPECT_GT(flowing, 10);
    EXPECT_LT(flowing, s.owned);
    double sum = 0, size = 0;
    for (const auto &c : s.contacts)
      if (c.now.kind == 1) {
        sum += c.next.plastic - c.now.plastic;
        size += std::abs(c.next.plastic - c.now.plastic);
      }
    EXPECT_GT(size, 1e-3);
    EXPECT_NEAR(sum, 0, 1e-12 * size);
  }
}

INSTANTIATE_TEST_SUITE_P(AllSupported, SpaceKernelTest, testing::ValuesIn(mca::supportedKernels(3)),
                         [](const auto &kernel) { return kernelName(kernel.param); });
