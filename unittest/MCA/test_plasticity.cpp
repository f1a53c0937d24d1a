// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample.h"

#include <gtest/gtest.h>

#include <random>

using namespace mca;

TEST(Plasticity, YieldCurveRunsThroughFig5)
{
  for (const double strength : {92.0, 250.0, 552.0}) {
    Material m = steel();
    m.strength = strength;
    const YieldCurve curve(m);
    EXPECT_DOUBLE_EQ(curve(0.0), 0.554 * strength);
    // total strain = plastic strain + stress/E
    const double k2 = 0.015 - 0.870 * strength / m.youngsModulus;
    const double k3 = 0.040 - strength / m.youngsModulus;
    EXPECT_NEAR(curve(k2), 0.870 * strength, 1e-11);
    EXPECT_NEAR(curve(k3), strength, 1e-11);
    EXPECT_NEAR(curve(k2 / 2), (0.554 + 0.870) / 2 * strength, 1e-11);
    EXPECT_NEAR(curve((k2 + k3) / 2), (0.870 + 1) / 2 * strength, 1e-11);
    EXPECT_NEAR(curve(1.0), strength, 1e-11);
    EXPECT_NEAR(curve(100.0), strength, 1e-11);
  }
}

TEST(Plasticity, YieldCurveRisesWithoutJumps)
{
  const YieldCurve curve(steel());
  double last = curve(0.0);
  for (double kappa = 0; kappa < 0.05; kappa += 1e-5) {
    const double now = curve(kappa);
    EXPECT_GE(now, last);
    EXPECT_LT(now - last, 0.1);
    last = now;
  }
}

TEST(Plasticity, FlatPieceIsAllowed)
{
  Material m = steel();
  m.elasticLimit = m.yieldStrength = 1.0;
  ASSERT_EQ(checkMaterial(m), "");
  const YieldCurve curve(m);
  for (const double kappa : {0.0, 0.01, 0.03, 1.0})
    EXPECT_DOUBLE_EQ(curve(kappa), m.strength);
}

TEST(Plasticity, WorkIsTheIntegralOfTheCurve)
{
  const YieldCurve curve(steel());
  double sum = 0, kappa = 0;
  const double step = 1e-5;
  EXPECT_EQ(curve.work(0), 0);
  for (int k = 0; k < 6000; k++) { // beyond all three pieces; kinks lie within a step
    sum += 0.5 * step * (curve(kappa) + curve(kappa + step));
    kappa += step;
    ASSERT_NEAR(curve.work(kappa), sum, 1e-7);
  }
  const Material m = steel();
  const double k2 = m.plasticStrainY2(), k3 = m.plasticStrainUltimate();
  const double exact =
      0.5 * (m.sigmaY1() + m.sigmaY2()) * k2 + 0.5 * (m.sigmaY2() + m.strength) * (k3 - k2);
  EXPECT_NEAR(curve.work(k3), exact, 1e-13);
  EXPECT_NEAR(curve.work(k3 + 1), exact + m.strength, 1e-12);
}

TEST(Plasticity, StressIntensityIsVonMises)
{
  EXPECT_DOUBLE_EQ(stressIntensity({100, 0, 0, 0}), 100);                // tension
  EXPECT_DOUBLE_EQ(stressIntensity({0, 0, 10, 0}), 10 * std::sqrt(3.0)); // shear
  EXPECT_DOUBLE_EQ(stressIntensity({-7, -7, 0, -7}), 0);                 // pressure
  std::mt19937 random(3);
  std::uniform_real_distribution<> u(-100, 100);
  for (int k = 0; k < 100; k++) {
    const StressTensor s{u(random), u(random), u(random), u(random)};
    const double p = (s.xx + s.yy + s.zz) / 3;
    const double J2 =
        ((s.xx - p) * (s.xx - p) + (s.yy - p) * (s.yy - p) + (s.zz - p) * (s.zz - p)) / 2 +
        s.xy * s.xy;
    EXPECT_NEAR(stressIntensity(s), std::sqrt(3 * J2), 1e-12 * 300);
    const StressTensor more{s.xx + 50, s.yy + 50, s.xy, s.zz + 50};
    EXPECT_NEAR(stressIntensity(more), stressIntensity(s), 1e-11);
  }
}

TEST(Plasticity, RadialReturnActsAboveTheYieldStressOnly)
{
  const double G = steel().shearModulus();
  const RadialReturn below = radialReturn(50, 51, G), at = radialReturn(51, 51, G);
  EXPECT_EQ(below.factor, 1.0);
  EXPECT_EQ(below.strain, 0.0);
  EXPECT_EQ(at.factor, 1.0);
  EXPECT_EQ(at.strain, 0.0);
  const RadialReturn above = radialReturn(std::nextafter(51.0, 52.0), 51, G);
  EXPECT_LT(above.factor, 1.0);
  EXPECT_GT(above.strain, 0.0);
  const RadialReturn far = radialReturn(102, 51, G);
  EXPECT_DOUBLE_EQ(far.factor, 0.5);
  EXPECT_DOUBLE_EQ(far.strain, 51 / (3 * G));
}

TEST(Plasticity, SecondReturnTakesWhatTheFirstShowsToBeNeeded)
{
  const double G = steel().shearModulus(), I = 60, Y = 51, first = radialReturn(I, Y, G).factor;
  // all flow alike: the first return is enough
  EXPECT_DOUBLE_EQ(secondReturn(first, I, Y, Y, G).factor, first);
  EXPECT_DOUBLE_EQ(secondReturn(first, I, Y, Y, G).strain, (I - Y) / (3 * G));
  // alone: contacts take half of it
  const RadialReturn alone = secondReturn(first, I, I - 0.5 * (I - Y), Y, G);
  EXPECT_DOUBLE_EQ(1 - alone.factor, 2 * (1 - first));
  EXPECT_DOUBLE_EQ(alone.strain, 2 * (I - Y) / (3 * G));
  // neighbours that load it instead: no more than twice
  EXPECT_DOUBLE_EQ(secondReturn(first, I, I + 5, Y, G).factor, alone.factor);
  // neighbours took three times as much as needed
  EXPECT_NEAR(1 - secondReturn(first, I, I - 3 * (I - Y), Y, G).factor, (1 - first) / 3, 1e-15);
  // at the yield stress, where the intensity of the second pass may round to less than it
  const RadialReturn least = secondReturn(1 - 1e-16, Y * (1 - 2e-16), Y * (1 - 2e-16), Y, G);
  EXPECT_NEAR(least.factor, 1, 1e-15);
  EXPECT_NEAR(least.strain, 0, 1e-15);
  // far above the yield stress no stress is turned round
  EXPECT_EQ(secondReturn(0.1, 10 * Y, 9 * Y, Y, G).factor, 0.0);
}

TEST(Plasticity, StrainOfWorkIsThatOfTheReturnInThePacking)
{
  // hexagonal contacts under a deviator: normal and shear stresses that have Hooke's directions
  const double G = steel().shearModulus(), I = 60, Y = 51, part = 1 - Y / I;
  const double shear = I / std::sqrt(3.0);
  double squares = 0;
  for (int k = 0; k < 6; k++) {
    const double angle = 0.3 + k * std::acos(0.5);
    squares += std::pow(shear * std::cos(2 * angle), 2) + std::pow(shear * std::sin(2 * angle), 2);
  }
  EXPECT_NEAR(strainOfWork(part, squares, I, G, 1.0 / 3), (I - Y) / (3 * G), 1e-15);
  EXPECT_EQ(strainOfWork(part, -1, I, G, 1.0 / 3), 0.0);
  // stresses that contacts hold against each other
  EXPECT_NEAR(strainOfWork(part, 100 * squares, I, G, 1.0 / 3), 1.5 * (I - Y) / (3 * G), 1e-15);
}

TEST(Plasticity, ReturnBringsTheIntensityToTheYieldStress)
{
  // what the factor does to a stress tensor: mean + M (sigma - mean)
  const StressTensor s{80, -30, 25, 10};
  const double mean = (s.xx + s.yy + s.zz) / 3;
  const RadialReturn back = radialReturn(stressIntensity(s), 51, steel().shearModulus());
  const double M = back.factor;
  const StressTensor returned{mean + M * (s.xx - mean), mean + M * (s.yy - mean), M * s.xy,
                              mean + M * (s.zz - mean)};
  EXPECT_NEAR(stressIntensity(returned), 51, 1e-12);
}
