// SPDX-License-Identifier: GPL-2.0-or-later
// The book-keeping of a contact's energy against closed forms.
#include "laws/energy.h"
#include "laws/law_set.h"
#include "sample.h"

#include <gtest/gtest.h>

namespace {

const mca::PairLaw law = mca::makePairLaw(mca::LawSet(), steel(), steel(), 1.0);
const double twoG = 2.0 * steel().shearModulus();

TEST(Energy, ElasticStepsLoseNothing)
{
  // a contact without mean stress is a spring: both halves of a step's losses cancel
  const double e0 = -1e-3, e1 = 2e-3, g0 = 5e-4, g1 = -1e-4;
  const mca::ElasticStrain moved = {e1 - e0, g1 - g0}, first = {e0, g0}, last = {e1, g1};
  const double none[2] = {0.0, 0.0};
  const double loss = mca::stepLoss(law, twoG * e0, twoG * g0, first, none, moved, moved) +
                      mca::stepLoss(law, twoG * e1, twoG * g1, last, none, moved, moved);
  EXPECT_NEAR(loss, 0.0, 1e-12 * twoG * 1e-6);
}

TEST(Energy, BreakingSetsTheElasticEnergyFree)
{
  const double e = 2e-3, g = 1e-3;
  const double none[2] = {0.0, 0.0};
  EXPECT_DOUBLE_EQ(mca::changeLoss(law, {e, g}, {0.0, 0.0}, none, none),
                   0.5 * twoG * (e * e + g * g));
  EXPECT_EQ(mca::changeLoss(law, {e, g}, {e, g}, none, none), 0.0);
}

TEST(Energy, MeanStressBelongsToTheGradient)
{
  const double e = -1e-3, before[2] = {-300.0, -100.0}, after[2] = {-50.0, -30.0};
  EXPECT_NEAR(mca::changeLoss(law, {e, 0.0}, {0.0, 0.0}, before, after),
              0.5 * (twoG * e + 0.5 * law.Di * (-300.0 - 100.0 - 50.0 - 30.0)) * e, 1e-9);
}

TEST(Energy, ViscousContactDissipatesForceTimesWay)
{
  const double none[2] = {0.0, 0.0};
  const mca::ElasticStrain moved = {-1e-4, 3e-4}, still = {0.0, 0.0};
  EXPECT_DOUBLE_EQ(mca::stepLoss(law, -80.0, 0.0, {0.0, 0.0}, none, moved, still),
                   0.5 * 80.0 * 1e-4);
}

TEST(Energy, StrainOfAnOpenGapDoesNotCount)
{
  EXPECT_EQ(mca::touchingStrain(false, 0.01), 0.0);
  EXPECT_EQ(mca::touchingStrain(false, -0.01), -0.01);
  EXPECT_EQ(mca::touchingStrain(true, 0.01), 0.01);
}

TEST(Energy, LeapfrogEnergyOfAnOscillatorIsExactlyConserved)
{
  // x(n+1) = x(n) + dt v(n+1/2), v(n+1/2) = v(n-1/2) - dt w^2 x(n), for steps near the critical 2/w
  const double w = 3.0, dt = 0.6, mass = 2.0;
  double x = 1.0, v = 0.7; // at the same time
  const double start =
      mca::leapfrogEnergy(mass, v, -0.5 * dt * w * w * x) + 0.5 * mass * w * w * x * x;
  for (int k = 0; k < 1000; k++) {
    v -= 0.5 * dt * w * w * x;
    x += dt * v;
    v -= 0.5 * dt * w * w * x;
    const double now =
        mca::leapfrogEnergy(mass, v, -0.5 * dt * w * w * x) + 0.5 * mass * w * w * x * x;
    EXPECT_NEAR(now, start, 1e-11 * start);
  }
}

} // namespace
