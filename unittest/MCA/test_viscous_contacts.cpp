// SPDX-License-Identifier: GPL-2.0-or-later
// Viscous contacts in time: the motion of a row of automata against the exact solution, and the
// order of its error in the step.
#include "sample.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

using reference::Sample;

namespace {

/// Unlinked automata in a row, all pressed together, with next to no elasticity.
Sample row(int n)
{
  mca::Material m = steel();
  m.youngsModulus = 1e-6;
  m.strength = 1e6; // nothing links
  Sample s = hexagonalBlock(m, n, 1, 0);
  s.laws.link = mca::Threshold::off();
  s.laws.steps = "corrected";
  for (int i = 0; i < n; i++)
    s.automata[i].x *= 0.99;
  return s;
}

double mass(const Sample &s)
{
  const mca::Material &m = s.materials[0];
  return mca::Cell{mca::packing::hex, m.diameter, s.thickness}.mass(m.density);
}

/// v' = -(c/m) L v of a row of contacts that all stay pressed, c = eta S/d; held automata keep v.
Eigen::VectorXd exact(const Sample &s, double time)
{
  const mca::Material &m = s.materials[0];
  const mca::Cell cell{mca::packing::hex, m.diameter, s.thickness};
  const double rate = m.viscosity * cell.contactArea() / m.diameter / mass(s);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(s.owned, s.owned);
  for (const auto &c : s.contacts)
    for (const auto &[me, other] : {std::pair{c.i, c.j}, std::pair{c.j, c.i}})
      if (!s.automata[me].held) {
        A(me, other) += rate;
        A(me, me) -= rate;
      }
  Eigen::VectorXd v(s.owned);
  for (int i = 0; i < s.owned; i++)
    v(i) = s.automata[i].vx;
  // the series of exp(A t), over parts of the time so short that 20 terms hold all digits (1/20!)
  const int parts = 1 + static_cast<int>(time * A.cwiseAbs().rowwise().sum().maxCoeff());
  for (int part = 0; part < parts; part++) {
    Eigen::VectorXd term = v;
    for (int k = 1; k <= 20; k++) {
      term = (time / parts / k) * (A * term);
      v += term;
    }
  }
  return v;
}

/// Velocity Verlet as fix nve/mca does it.
Eigen::VectorXd integrated(Sample s, double dt, int steps)
{
  KernelRun run(mca::bestKernel(2), s, false);
  auto kick = [&]() {
    for (auto &a : s.automata)
      a.vx += a.held ? 0.0 : 0.5 * dt * a.fx / mass(s);
  };
  run.step(s, dt);
  for (int k = 0; k < steps; k++) {
    kick();
    for (auto &a : s.automata)
      a.x += dt * a.vx;
    run.step(s, dt);
    kick();
  }
  Eigen::VectorXd v(s.owned);
  for (int i = 0; i < s.owned; i++)
    v(i) = s.automata[i].vx;
  return v;
}

double error(const Sample &s, double time, int steps)
{
  return (integrated(s, time / steps, steps) - exact(s, time)).norm();
}

} // namespace

TEST(ViscousContacts, AreOfSecondOrderInTheStep)
{
  for (const int n : {2, 5}) {
    Sample s = row(n);
    for (int i = 0; i < n; i++)
      s.automata[i].vx = -0.1 * i * i; // each one runs into the next
    const double time = 2e-4, coarse = error(s, time, 8), fine = error(s, time, 16);
    EXPECT_NEAR(coarse / fine, 4.0, 1.0) << n << " automata";
    EXPECT_LT(coarse, 0.02 * std::abs(s.automata[n - 1].vx)) << n << " automata";
  }
}

TEST(ViscousContacts, AHeldWallDoesNotAnswer)
{
  Sample s = row(3);
  s.automata[0].held = true;
  s.automata[1].vx = -0.1;
  s.automata[2].vx = -0.3;
  const double time = 2e-4, coarse = error(s, time, 8), fine = error(s, time, 16);
  EXPECT_NEAR(coarse / fine, 4.0, 1.0);
}

TEST(ViscousContacts, StepThatIsLongForOneContactDoesNotTurnItsVelocityRound)
{
  Sample s = row(2);
  s.automata[1].vx = -1.0;
  const double limit = 8.9e-5; // of six contacts, x = 1
  const double left = integrated(s, limit, 1)(1) - integrated(s, limit, 1)(0);
  EXPECT_LT(left, 0.0);
  EXPECT_GT(left, -1.0);
}
