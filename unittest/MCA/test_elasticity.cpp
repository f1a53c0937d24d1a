// SPDX-License-Identifier: GPL-2.0-or-later
#include "laws/contact.h"
#include "sample.h"
#include "shared/pi.h"

#include <gtest/gtest.h>

#include <random>

using namespace mca;

namespace {

struct Tensor {
  double xx, yy, xy;
};

/// Stress of an automaton whose six contacts all see the same strain.
StressTensor homogeneous(const Material &m, const Tensor &strain, double turned, double &mean)
{
  const PairLaw law = makePairLaw(LawSet(), m, m, 1.0);
  double e[6], gamma[6], nx[6], ny[6], sum = 0;
  for (int k = 0; k < 6; k++) {
    const double angle = turned + k * mcawr::pi / 3;
    nx[k] = std::cos(angle);
    ny[k] = std::sin(angle);
    const double ex = strain.xx * nx[k] + strain.xy * ny[k];
    const double ey = strain.xy * nx[k] + strain.yy * ny[k];
    e[k] = ex * nx[k] + ey * ny[k];
    gamma[k] = -ex * ny[k] + ey * nx[k];
    sum += e[k];
  }
  mean = meanStress(sum, m.bulkModulus());
  Tensor s{0, 0, 0};
  for (int k = 0; k < 6; k++) {
    const StressTensor share =
        stressShare(elasticStress(law, e[k], mean, mean), law.twoG * gamma[k], nx[k], ny[k]);
    s.xx += share.xx;
    s.yy += share.yy;
    s.xy += share.xy;
  }
  return automatonStress(s.xx, s.yy, s.xy, mean);
}

} // namespace

TEST(Elasticity, HomogeneousStrainGivesHookesTensorInPlaneStrain)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<> strain(-0.01, 0.01), nu(-0.9, 0.49), angle(0, 6.3);
  for (int sample = 0; sample < 200; sample++) {
    Material m = steel();
    m.poissonsRatio = nu(random);
    const Tensor eps{strain(random), strain(random), strain(random)};
    double mean;
    const StressTensor s = homogeneous(m, eps, angle(random), mean);
    const double E = m.youngsModulus, v = m.poissonsRatio;
    const double lambda = E * v / (1 + v) / (1 - 2 * v), G = E / 2 / (1 + v);
    const double trace = eps.xx + eps.yy, scale = (std::abs(lambda) + 2 * G) * 0.01 * 1e-12;
    EXPECT_NEAR(s.xx, lambda * trace + 2 * G * eps.xx, scale);
    EXPECT_NEAR(s.yy, lambda * trace + 2 * G * eps.yy, scale);
    EXPECT_NEAR(s.xy, 2 * G * eps.xy, scale);
    EXPECT_NEAR(s.zz, v * (s.xx + s.yy), scale);
    EXPECT_NEAR(mean, (s.xx + s.yy + s.zz) / 3, scale);
  }
}

TEST(Elasticity, EnergyDensityIsHalfStressTimesStrain)
{
  const Material m = steel();
  const Tensor eps{0.002, -0.001, 0.0007};
  double mean, squares = 0;
  const StressTensor s = homogeneous(m, eps, 0.3, mean);
  for (int k = 0; k < 6; k++) {
    const double a = 0.3 + k * mcawr::pi / 3, x = std::cos(a), y = std::sin(a);
    const double ex = eps.xx * x + eps.xy * y, ey = eps.xy * x + eps.yy * y;
    squares += ex * ex + ey * ey;
  }
  const double half = 0.5 * (s.xx * eps.xx + s.yy * eps.yy + 2 * s.xy * eps.xy);
  EXPECT_NEAR(energyDensity(squares, mean, m.shearModulus(), m.bulkModulus(), meanStressWeight(m)),
              half, 1e-13 * half);
}

TEST(Elasticity, PairwiseLawHasNoPlanePoissonsRatio)
{
  Material m = steel();
  LawSet set;
  set.elasticity = "pairwise";
  const PairLaw law = makePairLaw(set, m, m, 1.0);
  EXPECT_EQ(elasticStress(law, 0.001, 1e6, -1e6), 2 * m.shearModulus() * 0.001);
  EXPECT_EQ(law.Di, 0.0);
}

TEST(Elasticity, AxisRotationIsTheAngleBetweenBothPositions)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<> step(-0.03, 0.03);
  for (int k = 0; k < 1000; k++) {
    const double r = 2.5, n = step(random), t = step(random);
    EXPECT_NEAR(axisRotation(t / (r - n)), std::atan2(t, r - n), 1e-16 + 1e-15 * std::abs(t));
  }
  EXPECT_EQ(axisRotation(0.0), 0.0);
}

TEST(Elasticity, RigidRotationLeavesNoShear)
{
  // 90 degrees in 10000 steps, at any distance
  for (const double r : {2.4, 2.5, 2.7}) {
    const int steps = 10000;
    const double turn = mcawr::pi / 2 / steps;
    double gamma = 0;
    for (int k = 0; k < steps; k++) {
      // chord of the pair's axis seen in its new frame
      const double stepN = r * (1 - std::cos(turn)), stepT = r * std::sin(turn);
      gamma += shearIncrement(axisRotation(stepT / (r - stepN)), 2 * turn);
    }
    EXPECT_NEAR(gamma, 0.0, 1e-13);
  }
}

TEST(Elasticity, ShearIncrementIsTheAxisLessTheMeanOfBothTurns)
{
  EXPECT_DOUBLE_EQ(shearIncrement(0.01, 0.003 + 0.007), 0.005);
  EXPECT_DOUBLE_EQ(shearIncrement(0.01, 0.02), 0.0);
}
