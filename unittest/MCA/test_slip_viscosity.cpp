// SPDX-License-Identifier: GPL-2.0-or-later
// Viscosity along both directions: what slips and what does not, where the energy goes, and the
// motion of pairs against the exact solution.
#include "laws/energy.h"
#include "laws/law_set.h"
#include "sample.h"
#include "sample_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

const mca::Vector n = {0.6, 0.0, 0.8};

TEST(Slip, RigidRotationOfAPairLeavesNone)
{
  // about any axis, at any distance: v = omega x r
  const double r = 2.3;
  const mca::Vector omega = {0.3, -0.5, 0.7}, velocity = mca::cross(omega, r * n);
  EXPECT_NEAR(mca::length(mca::slipOf(n, velocity, 2.0 * omega, 0.5 * r)), 0.0, 1e-15);
}

TEST(Slip, IsPerpendicularAndLeavesApproachOut)
{
  EXPECT_NEAR(mca::length(mca::slipOf(n, -3.0 * n, {0.0, 0.0, 0.0}, 1.25)), 0.0, 1e-15);
  EXPECT_NEAR(mca::dot(n, mca::slipOf(n, {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, 1.25)), 0.0, 1e-14);
}

TEST(Slip, LossIsStressTimesWayPerDiameterAndHalf)
{
  const mca::PairLaw law = mca::makePairLaw(mca::LawSet(), steel(), steel(), 1.0);
  EXPECT_DOUBLE_EQ(mca::slipLoss(law, {3.0, 0.0, 1.0}, {0.2, 7.0, 0.0}), 0.5 * 0.6 / 2.5);
}

/// A block whose pairs are partly linked, moving at random, without elasticity to speak of.
reference::Sample moving(unsigned seed)
{
  std::mt19937 random(seed);
  auto uniform = [&](double a) { return std::uniform_real_distribution<>(-a, a)(random); };
  reference::Sample s = hexagonalBlock(steel(), 9, 8, 0, 1.2);
  s.laws.steps = "plain";
  for (auto &a : s.automata) {
    a.x += uniform(0.05);
    a.y += uniform(0.05);
    a.vx = uniform(10);
    a.vy = uniform(10);
    a.omega = uniform(8);
  }
  for (auto &c : s.contacts)
    c.now.kind = c.next.kind = static_cast<double>(random() % 3);
  return s;
}

TEST(Slip, ResistanceTakesEnergyAndKeepsBothMomenta)
{
  for (unsigned seed = 1; seed <= 5; seed++) {
    reference::Sample both = moving(seed), normal = both;
    normal.laws.viscosity = "normal";
    kernelStep(mca::bestKernel(2), normal, 0.0);
    kernelStep(mca::bestKernel(2), both, 0.0);
    double power = 0, fx = 0, fy = 0, torque = 0, scale = 0, lost = 0;
    for (int i = 0; i < both.owned; i++) {
      const auto &a = both.automata[i], &b = normal.automata[i];
      const double x = a.fx - b.fx, y = a.fy - b.fy, t = a.torque - b.torque;
      power += x * a.vx + y * a.vy + t * a.omega;
      fx += x;
      fy += y;
      torque += t + a.x * y - a.y * x;
      scale = std::max({scale, std::abs(x), std::abs(y)});
    }
    // S eta/d slip^2 of all contacts that are pressed and unlinked
    const mca::Cell cell{mca::packing::hex, steel().diameter, both.thickness};
    for (const auto &c : both.contacts) {
      const auto &a = both.automata[c.i], &b = both.automata[c.j];
      const double x = b.x - a.x, y = b.y - a.y, r = std::hypot(x, y);
      if (c.now.kind * c.next.kind > 0 || r > 2.5)
        continue;
      const double slip = ((b.vy - a.vy) * x - (b.vx - a.vx) * y) / r - r / 2 * (a.omega + b.omega);
      lost += cell.contactArea() * 410 / 2.5 * slip * slip;
    }
    EXPECT_GT(lost, 0);
    EXPECT_NEAR(power, -lost, 1e-11 * lost) << "seed " << seed;
    EXPECT_NEAR(fx, 0, 1e-12 * scale);
    EXPECT_NEAR(fy, 0, 1e-12 * scale);
    EXPECT_NEAR(torque, 0, 1e-11 * scale * 30);
  }
}

/// Calls use(kernel) with the first set's kernel, whose viscous contacts go through each set's
/// passes in turn.
template<class Use>
void withViscousPassesOfEachSet(int dimension, const Use &use)
{
  const std::vector<const mca::Kernel *> all = mca::supportedKernels(dimension);
  for (const mca::Kernel *of : all) {
    mca::Kernel kernel = *all.front(), keepsVolume = *kernel.keepsVolume;
    kernel.viscous = of->viscous;
    keepsVolume.viscous = of->keepsVolume->viscous;
    kernel.keepsVolume = &keepsVolume;
    use(kernel);
  }
}

TEST(Slip, IsTheSameToTheLastBitByAllInstructionSets)
{
  for (const char *plasticity : {"radial", "isochoric"})
    for (const bool unlike : {false, true}) {
      reference::Sample start = moving(1);
      start.laws.steps = "corrected";
      start.laws.plasticity = plasticity;
      if (unlike) {
        start.materials.push_back(steel());
        start.materials.back().viscosity *= 2;
        for (int i = 0; i < start.owned; i += 3)
          start.automata[i].type = 1;
      }
      std::vector<reference::Sample> found;
      withViscousPassesOfEachSet(2, [&](const mca::Kernel &kernel) {
        found.push_back(start);
        KernelRun(kernel, start, false).step(found.back(), 5e-5);
      });
      for (const reference::Sample &s : found)
        for (int i = 0; i < s.owned; i++) {
          const auto &a = s.automata[i], &b = found[0].automata[i];
          EXPECT_EQ(a.fx, b.fx);
          EXPECT_EQ(a.fy, b.fy);
          EXPECT_EQ(a.torque, b.torque);
        }
    }
}

TEST(Slip, IsTheSameInSpaceByAllInstructionSets)
{
  using reference::space::Vector3d;
  for (const char *plasticity : {"radial", "isochoric"}) {
    auto start = block(mca::packing::fcc, steel(), 4, mca::link::none, false);
    start.laws.steps = "corrected";
    start.laws.plasticity = plasticity;
    std::mt19937 random(1);
    auto uniform = [&](double a) { return std::uniform_real_distribution<>(-a, a)(random); };
    for (auto &a : start.automata) {
      a.x += Vector3d(uniform(0.05), uniform(0.05), uniform(0.05));
      a.v = Vector3d(uniform(10), uniform(10), uniform(10));
      a.omega = Vector3d(uniform(8), uniform(8), uniform(8));
    }
    std::vector<reference::space::Sample> found;
    withViscousPassesOfEachSet(3, [&](const mca::Kernel &kernel) {
      found.push_back(start);
      SpaceRun(kernel, start, false).step(found.back(), 5e-5);
    });
    for (const auto &s : found)
      for (int i = 0; i < s.owned; i++) {
        EXPECT_EQ(s.automata[i].force, found[0].automata[i].force);
        EXPECT_EQ(s.automata[i].torque, found[0].automata[i].torque);
      }
  }
}

mca::Material loose() // next to no elasticity, nothing links
{
  mca::Material m = steel();
  m.youngsModulus = 1e-6;
  m.strength = 1e6;
  return m;
}

/// Slip of a pressed pair after a time, by Verlet's steps, over the slip at the beginning.
/// \param held,heldSpin  of the first automaton
double leftInThePlane(double time, int steps, bool held, bool heldSpin)
{
  reference::Sample s = hexagonalBlock(loose(), 2, 1, 0);
  s.laws.link = mca::Threshold::off();
  s.laws.viscosity = "both";
  s.automata[1].x *= 0.99;
  s.automata[0].held = held;
  s.automata[0].heldSpin = heldSpin;
  s.automata[1].vy = 0.03;
  s.automata[1].omega = -0.02;
  const mca::Cell cell{mca::packing::hex, steel().diameter, s.thickness};
  const double mass = cell.mass(steel().density), inertia = cell.inertia(steel().density);
  const double dt = time / steps;
  auto slip = [&]() {
    const auto &a = s.automata[0], &b = s.automata[1];
    return b.vy - a.vy - 0.99 * 1.25 * (a.omega + b.omega);
  };
  auto kick = [&]() {
    for (auto &a : s.automata) {
      const double half = a.held ? 0.0 : 0.5 * dt;
      a.vx += half * a.fx / mass;
      a.vy += half * a.fy / mass;
      a.omega += a.heldSpin ? 0.0 : 0.5 * dt * a.torque / inertia;
    }
  };
  const double before = slip();
  KernelRun run(mca::bestKernel(2), s, false);
  run.step(s, dt);
  for (int k = 0; k < steps; k++) {
    kick();
    for (auto &a : s.automata) {
      a.x += dt * a.vx;
      a.y += dt * a.vy;
    }
    run.step(s, dt);
    kick();
  }
  return slip() / before;
}

TEST(Slip, OfAPairDecaysAsTheExactOneToSecondOrder)
{
  const mca::Cell cell{mca::packing::hex, steel().diameter};
  const double c = steel().viscosity * cell.contactArea() / steel().diameter;
  const double arm = 0.99 * 1.25, time = 4e-5;
  for (const auto &[held, heldSpin] :
       {std::pair(false, false), std::pair(true, true), std::pair(true, false)}) {
    const double rate = c * ((held ? 1 : 2) / cell.mass(steel().density) +
                             (heldSpin ? 1 : 2) * arm * arm / cell.inertia(steel().density));
    const double exact = std::exp(-rate * time);
    const double coarse = std::abs(leftInThePlane(time, 8, held, heldSpin) - exact);
    const double fine = std::abs(leftInThePlane(time, 16, held, heldSpin) - exact);
    EXPECT_NEAR(coarse / fine, 4.0, 0.5) << "held: " << held << ", in rotation: " << heldSpin;
    EXPECT_LT(coarse, 0.015 * exact); // neighbours are centred that a pair does not have
  }
}

TEST(Slip, PairInSpaceDecaysAsTheExactOne)
{
  using reference::space::Vector3d;
  auto s = block(mca::packing::fcc, loose(), 1, 0, false);
  ASSERT_EQ(s.owned, 1);
  s.owner.push_back(s.owned++);
  s.shift.emplace_back(Vector3d::Zero());
  const Vector3d axis = Vector3d(1, 2, -2) / 3;
  s.automata.push_back(s.automata[0]);
  s.automata[1].x += 0.99 * 2.5 * axis;
  s.automata[1].v = Vector3d(0.03, -0.02, 0.05);
  s.automata[1].omega = Vector3d(0.02, 0.03, 0.01);
  s.contacts.emplace_back().j = 1;
  s.laws.link = mca::Threshold::off();
  s.laws.viscosity = "both";
  const mca::Cell cell{mca::packing::fcc, steel().diameter};
  const double mass = cell.mass(steel().density), inertia = cell.inertia(steel().density);
  const double arm = 0.99 * 1.25, time = 2e-5;
  const double rate = 2 * steel().viscosity * cell.contactArea() / steel().diameter *
                      (1 / mass + arm * arm / inertia);
  auto slip = [&]() {
    const auto &a = s.automata[0], &b = s.automata[1];
    const Vector3d v = b.v - a.v;
    return Vector3d(v - v.dot(axis) * axis - arm * (a.omega + b.omega).cross(axis));
  };
  const Vector3d before = slip();
  const int steps = 16;
  const double dt = time / steps;
  SpaceRun run(mca::bestKernel(3), s, false);
  run.step(s, dt);
  for (int k = 0; k < steps; k++)
    for (const bool second : {false, true}) {
      for (auto &a : s.automata) {
        a.v += 0.5 * dt / mass * a.force;
        a.omega += 0.5 * dt / inertia * a.torque;
        if (!second)
          a.x += dt * a.v;
      }
      if (!second)
        run.step(s, dt);
    }
  const Vector3d exact = std::exp(-rate * time) * before;
  EXPECT_LT((slip() - exact).norm(), 1e-3 * exact.norm());
  EXPECT_GT((exact - before).norm(), 0.3 * before.norm());
}

} // namespace
