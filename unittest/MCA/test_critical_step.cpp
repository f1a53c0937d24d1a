// SPDX-License-Identifier: GPL-2.0-or-later
// The critical step against brute force: eigenvalues of a finite periodic lattice whose stiffness
// is measured with the kernel, and integrated lattices just below and just above the limit.
#include "laws/contact_step.h"
#include "laws/fracture.h"

#include "sample.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <random>

using reference::Automaton;
using reference::Sample;

namespace {

const mca::Kernel &kernel = mca::bestKernel(2);

mca::Material material(double poissonsRatio)
{
  mca::Material m = steel();
  m.poissonsRatio = poissonsRatio;
  return m;
}

double criticalElastic(const Sample &s)
{
  const mca::Material &m = s.materials[0];
  const bool many = s.laws.elasticity.is(mca::Elasticity::ManyBody);
  return mca::criticalStep(m, many ? meanStressWeight(m) : 0.0, 0.0).elastic;
}

/// 2/omega_max of the dense dynamical matrix in displacements times sqrt(mass).
double bruteForce(const Sample &start)
{
  const double h = 1e-7;
  const int n = start.owned;
  auto massOf = [&](int freedom) {
    const mca::Material &m = start.materials[start.automata[freedom / 3].type];
    const mca::Cell cell{mca::packing::hex, m.diameter, start.thickness};
    return freedom % 3 == 2 ? cell.inertia(m.density) : cell.mass(m.density);
  };
  Eigen::MatrixXd matrix(3 * n, 3 * n);
  for (int c = 0; c < 3 * n; c++) {
    Sample moved = start;
    Automaton &a = moved.automata[c / 3];
    (c % 3 == 0 ? a.vx : c % 3 == 1 ? a.vy : a.omega) = h;
    if (c % 3 == 0)
      a.x += h;
    if (c % 3 == 1)
      a.y += h;
    moved.updateImages();
    kernelStep(kernel, moved, 1.0);
    for (int r = 0; r < 3 * n; r++) {
      const Automaton &b = moved.automata[r / 3];
      const double force = r % 3 == 0 ? b.fx : r % 3 == 1 ? b.fy : b.torque;
      matrix(r, c) = -force / h / std::sqrt(massOf(r) * massOf(c));
    }
  }
  const Eigen::MatrixXd symmetric = 0.5 * (matrix + matrix.transpose());
  EXPECT_LT((matrix - symmetric).norm(), 1e-5 * matrix.norm());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
  return 2 / std::sqrt(solver.eigenvalues().maxCoeff());
}

/// Velocity Verlet as fix nve/mca does it: the forces see the velocities of the half step.
/// \return largest speed after the first 20 steps over the largest speed within them
double growth(Sample s, double dt, int steps)
{
  const mca::Material &m = s.materials[0];
  const mca::Cell cell{mca::packing::hex, m.diameter, s.thickness};
  const double mass = cell.mass(m.density), inertia = cell.inertia(m.density);
  const Sample lattice = s;
  std::mt19937 random(1);
  std::uniform_real_distribution<> u(-1e-9, 1e-9);
  for (int i = 0; i < s.owned; i++) {
    s.automata[i].x += u(random);
    s.automata[i].y += u(random);
  }
  auto kick = [&]() {
    for (int i = 0; i < s.owned; i++) {
      Automaton &a = s.automata[i];
      a.vx += 0.5 * dt * a.fx / mass;
      a.vy += 0.5 * dt * a.fy / mass;
      a.omega += 0.5 * dt * a.torque / inertia;
    }
  };
  s.updateImages();
  kernelStep(kernel, s, 0.0);
  double first = 0, second = 0;
  for (int k = 0; k < steps; k++) {
    kick();
    for (int i = 0; i < s.owned; i++) {
      s.automata[i].x += dt * s.automata[i].vx;
      s.automata[i].y += dt * s.automata[i].vy;
    }
    s.updateImages();
    kernelStep(kernel, s, dt);
    kick();
    double &largest = k < 20 ? first : second;
    for (int i = 0; i < s.owned; i++)
      largest = std::max({largest, std::abs(s.automata[i].vx), std::abs(s.automata[i].vy),
                          std::abs(m.diameter * s.automata[i].omega)});
  }
  return second / first;
}

} // namespace

// Mixtures in any order vibrate no faster than the worst two materials say; a pair that hardly ever
// meets may make that much lower, but a mixture of like shares does not.
TEST(ContactStep, BoundsTheVibrationsOfMixtures)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<> exponent(-1.0, 1.0), ratio(0.0, 0.45);
  double closest = 0.0;
  for (int sample = 0; sample < 24; sample++) {
    Sample s = periodicBlock(steel(), 6, 6, 1);
    s.laws.elasticity = sample % 4 == 0 ? "pairwise" : "many-body";
    s.laws.plasticity = "none";
    s.materials.resize(2, s.materials[0]);
    for (mca::Material &m : s.materials) {
      m.youngsModulus *= std::pow(10.0, exponent(random));
      m.density *= std::pow(10.0, exponent(random));
      m.poissonsRatio = ratio(random);
    }
    // stripes, single automata in a matrix, or any order
    for (int i = 0; i < s.owned; i++)
      s.automata[i].type = sample % 3 == 0   ? i / 6 % 2
                           : sample % 3 == 1 ? (i == 14 ? 1 : 0)
                                             : static_cast<int>(random() % 2);
    for (size_t i = s.owned; i < s.automata.size(); i++)
      s.automata[i].type = s.automata[s.owner[i]].type;
    double bound = HUGE_VAL;
    for (int i = 0; i < 2; i++)
      for (int j = 0; j <= i; j++)
        bound = std::min(
            bound,
            mca::contactStep(s.laws, s.materials[i], s.materials[j], mca::packing::hex).elastic);
    const double exact = bruteForce(s);
    EXPECT_GE(exact, bound * (1.0 - 1e-6)) << sample;
    closest = std::max(closest, bound / exact);
  }
  EXPECT_GT(closest, 0.9);
}

TEST(ContactStep, OfOneMaterialIsTheCriticalStep)
{
  mca::LawSet laws;
  ASSERT_EQ(laws.parse({"plasticity", "none"}), "");
  const mca::Material m = steel();
  const auto pair = mca::contactStep(laws, m, m, mca::packing::hex);
  const auto one =
      mca::criticalStep(m, meanStressWeight(m), m.viscosity, mca::packing::hex, laws.resistsSlip());
  EXPECT_NEAR(pair.elastic, one.elastic, 1e-12 * one.elastic);
  EXPECT_NEAR(pair.viscous, one.viscous, 1e-12 * one.viscous);
}

// the mean viscosity acts on the lighter mass: twice the mean over the heavier one's
TEST(ContactStep, OfUnlikeMaterialsIsThatOfTheLighterMass)
{
  const mca::LawSet laws;
  mca::Material heavy = steel(), light = steel();
  light.density *= 0.1;
  light.viscosity = 0.0;
  const double own = mca::contactStep(laws, heavy, heavy, mca::packing::hex).viscous;
  const double pair = mca::contactStep(laws, heavy, light, mca::packing::hex).viscous;
  EXPECT_NEAR(pair, 0.1 * 2.0 * own, 1e-12 * own);
  EXPECT_EQ(pair, mca::contactStep(laws, light, heavy, mca::packing::hex).viscous);
}

TEST(CriticalStep, EqualsTheEigenvaluesOfAFiniteLattice)
{
  for (const char *elasticity : {"many-body", "pairwise"})
    for (const double nu : {0.0, 0.3, 0.45}) {
      // 6 x 6 holds the zone's corners and the middles of its sides
      Sample s = periodicBlock(material(nu), 6, 6, 1);
      s.laws.elasticity = elasticity;
      s.laws.plasticity = "none";
      const double exact = bruteForce(s), fast = criticalElastic(s);
      EXPECT_LE(fast, exact * (1 + 1e-5)) << elasticity << ", nu " << nu; // never beyond
      EXPECT_GE(fast, exact * 0.98) << elasticity << ", nu " << nu;
    }
}

TEST(CriticalStep, LatticeIsStableBelowAndUnstableAbove)
{
  Sample s = periodicBlock(steel(), 6, 6, 1);
  s.laws.plasticity = "none";
  s.laws.fracture = "none"; // the mode that grows turns the automata
  const double limit = criticalElastic(s);
  EXPECT_LT(growth(s, 0.99 * limit, 3000), 3.0);
  EXPECT_GT(growth(s, 1.02 * limit, 3000), 100.0);
}

TEST(CriticalStep, CompressedUnlinkedLatticeIsStableBelow)
{
  // all six contacts damped and elastic, none linked
  mca::Material m = steel();
  m.strength = 1e5;
  m.breakingStrain = 0.49;
  Sample s = periodicBlock(m, 6, 6, 0);
  s.laws.link = mca::Threshold::off();
  const double width = 6 * m.diameter, height = width * std::sqrt(0.75), squeeze = 0.99;
  for (int i = 0; i < s.owned; i++) {
    s.automata[i].x *= squeeze;
    s.automata[i].y *= squeeze;
  }
  for (size_t k = s.owned; k < s.automata.size(); k++) {
    s.shiftX[k] = std::round(s.shiftX[k] / width) * width * squeeze;
    s.shiftY[k] = std::round(s.shiftY[k] / height) * height * squeeze;
  }
  const double turned = 1 / (squeeze * squeeze); // arms are shorter
  for (const bool slips : {false, true})
    for (const double eta : {0.0, 41.0, 100.0, 150.0, 410.0}) {
      s.materials[0].viscosity = eta;
      s.laws.viscosity = slips ? "both" : "normal";
      const mca::CriticalStep limit =
          mca::criticalStep(m, meanStressWeight(m), eta, mca::packing::hex, slips);
      s.laws.steps = "plain";
      EXPECT_LT(growth(s, 0.99 * limit.plain(), 3000), 3.0) << "viscosity " << eta;
      s.laws.steps = "corrected";
      EXPECT_LT(growth(s, 0.99 * limit.centred(), 3000), 3.0) << "viscosity " << eta;
      if (!slips || eta < 410.0)
        continue;
      // what turns has no other stiffness: 8/lambda; with shorter arms a little more is centred
      EXPECT_GT(growth(s, 1.04 * turned * 4 * limit.viscous, 3000), 100.0);
      s.laws.steps = "plain";
      EXPECT_GT(growth(s, 1.02 * turned * limit.viscous, 3000), 100.0);
    }
}

TEST(CriticalStep, PressedLinkIsStableBelowAndUnstableAbove)
{
  // just before its collapse, without normal stress: all of it has flowed
  Sample s = hexagonalBlock(steel(), 2, 1, 1);
  s.laws.plasticity = "none";
  const double r = 1.0001 * (1.0 + mca::collapseStrain);
  s.automata[1].x = s.automata[0].x + r * s.materials[0].diameter;
  ASSERT_EQ(s.contacts.size(), 1u);
  s.contacts[0].now.plastic = s.contacts[0].next.plastic = r - 1.0;
  const double limit = mca::criticalStep(s.materials[0], 0.0, 0.0).pressed;
  EXPECT_LT(growth(s, 0.99 * limit, 3000), 3.0);
  EXPECT_GT(growth(s, 1.02 * limit, 3000), 100.0);
}

TEST(CriticalStep, ScalesLikeDiameterOverSpeedOfSound)
{
  const mca::Material m = steel();
  mca::Material other = m;
  other.diameter *= 3;
  other.density *= 4;
  const double D = meanStressWeight(m);
  EXPECT_NEAR(mca::criticalStep(other, D, 0).elastic, 6 * mca::criticalStep(m, D, 0).elastic,
              1e-14);
  EXPECT_EQ(mca::criticalStep(m, D, 0).plain(), mca::criticalStep(m, D, 0).elastic);
  EXPECT_EQ(mca::criticalStep(m, D, 0).centred(), mca::criticalStep(m, D, 0).elastic);
  EXPECT_TRUE(std::isinf(mca::criticalStep(m, D, 0).viscous));
}

TEST(CriticalStep, ViscousLimitOfThePapersSteel)
{
  const mca::Material m = steel(); // physics: 0.059 ps
  const mca::CriticalStep limit = mca::criticalStep(m, meanStressWeight(m), m.viscosity);
  EXPECT_NEAR(limit.viscous, 5.9e-5, 0.1e-5);
  EXPECT_LT(limit.plain(), limit.viscous);
  EXPECT_NEAR(limit.centred(), 1.5 * limit.viscous, 1e-12); // a contact's own part is a third
}

TEST(CriticalStep, SlipIsDampedByTheSmallMomentOfInertia)
{
  // a disc has J = m d^2/8: lambda = 24 c/m; a ball m d^2/10, and two thirds of 12 contacts
  const mca::Material m = steel();
  const double D = meanStressWeight(m), eta = m.viscosity;
  for (const auto &[packing, faster, own] :
       {std::tuple{mca::packing::hex, 4.0, 0.25}, std::tuple{mca::packing::fcc, 5.0, 0.175}}) {
    EXPECT_NEAR(packing.ownSlipShare(), own, 1e-15);
    const auto normal = mca::criticalStep(m, D, eta, packing);
    const auto both = mca::criticalStep(m, D, eta, packing, true);
    EXPECT_NEAR(both.viscous, normal.viscous / faster, 1e-12 * normal.viscous);
    EXPECT_LT(both.centred(), 4 * both.viscous); // where elasticity lets it
    EXPECT_GT(both.centred(), 3.7 * both.viscous);
    EXPECT_EQ(both.elastic, normal.elastic);
  }
}
