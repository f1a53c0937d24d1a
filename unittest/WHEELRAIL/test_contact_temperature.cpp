// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/contact_temperature.h"
#include "contact_cases.h"
#include "shared/pi.h"

#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {
const ThermalMaterial steel{50.0, 7800.0, 450.0};
}

TEST(MeanTemperature, GivesTheTable)
{
  const HertzContact hertz = contact_cases::table2();
  const double table[][4] = {{10, 0.01, 11.32175, 16.42396},
                             {20, 0.05, 80.05686, 116.13497},
                             {40, 0.10, 226.43499, 328.47930}};
  for (const auto &[speed, creep, mean, highest] : table) {
    const double rise = meanTemperatureRise(0.3 * creep * speed, hertz.hertzPressure,
                                            hertz.halfWidth, speed, steel);
    EXPECT_NEAR(rise, mean, 1e-5);
    EXPECT_NEAR(rise * maximumOverMeanTemperature(), highest, 2e-5);
  }
}

TEST(FlashTemperature, HertzianHeatGivesTheExactCoefficients)
{
  const HertzContact hertz = contact_cases::table2();
  const double speed = 20.0, slidingSpeed = 1.0, mu = 0.3;
  const int n = 4096; // cells on the contact
  const double h = 2.0 * hertz.halfWidth / n;
  Vector heat(n);
  for (int i = 0; i < n; ++i) { // exact mean of sqrt(1 - x^2) over the cell
    const auto integral = [](double x) {
      return 0.5 * (x * std::sqrt(1.0 - x * x) + std::asin(x));
    };
    const double left = std::max(-1.0, -1.0 + i * 2.0 / n), right = std::min(1.0, left + 2.0 / n);
    heat[i] = mu * hertz.hertzPressure * slidingSpeed * (integral(right) - integral(left)) * n / 2;
  }
  FlashTemperature flash(n, h, speed, steel);
  const Vector rise = flash.rise(heat);
  const double unit = mu * hertz.hertzPressure * slidingSpeed *
                      std::sqrt(hertz.halfWidth / (50.0 * 7800.0 * 450.0 * speed));
  EXPECT_NEAR(rise.mean() / unit, 0.42553843, 1e-5);
  Vector::Index place;
  EXPECT_NEAR(rise.maxCoeff(&place) / unit, 0.61730992, 1e-5);
  EXPECT_NEAR(1.0 - (place + 0.5) / n, 0.8261, 1e-3); // from the leading edge
}

TEST(FlashTemperature, IsThatOfAHalfSpaceAtALargePecletNumber)
{
  // Jaeger's moving source, exact: exp(L t) K0(L |t|) at the distance t behind it, -2 .. 2 of the
  // half-widths, has (2 - |t|)/2 as its share in the mean over a uniform strip
  const auto mean = [](double peclet) {
    const int n = 20000;
    double sum = 0.0;
    for (const double side : {-1.0, 1.0})
      for (int k = 0; k < n; ++k) { // t = w^2 takes the singularity away
        const double w = std::sqrt(2.0) * (k + 0.5) / n, t = w * w;
        sum += 2.0 * w * std::exp(side * peclet * t) * std::cyl_bessel_k(0.0, peclet * t) *
               (1.0 - 0.5 * t) * std::sqrt(2.0) / n;
      }
    return sum / mcawr::pi; // of q a/lambda
  };
  for (const auto &[peclet, ratio] : {std::pair{1.0, 0.9405}, {10.0, 0.9857}, {100.0, 0.9983}}) {
    const int n = 400;
    FlashTemperature flash(n, 2.0 / n, 2.0 * peclet, {1.0, 1.0, 1.0});
    const Vector heat = Vector::Constant(n, 2.0); // half of it into this body
    EXPECT_NEAR(pecletNumber(1.0, 2.0 * peclet, {1.0, 1.0, 1.0}), peclet, 1e-12);
    EXPECT_NEAR(flash.rise(heat).mean() / mean(peclet), ratio, 1e-3) << peclet;
  }
}

TEST(FlashTemperature, HasNoBiasOfTheOrderOfRootH)
{
  // Uniform heat on a strip: Theta = q sqrt(d/(pi lambda rho c v)) at distance d, exact per cell
  for (int n : {10, 40, 160, 2000}) {
    FlashTemperature flash(n, 1.0 / n, 1.0, {1.0, 1.0, 1.0});
    const Vector rise = flash.rise(Vector::Ones(n));
    EXPECT_NEAR(rise.mean(), 2.0 / 3.0 / std::sqrt(mcawr::pi), 1e-9) << n;
  }
}

TEST(TravellingHeat, SteadyHeatGivesTheFlashTemperature)
{
  const int n = 60;
  FlashTemperature flash(n, 1e-5, 20.0, steel);
  TravellingHeat travelling(n, 1e-5, 20.0, steel);
  Vector heat = Vector::Zero(n);
  for (int i = 10; i < 40; ++i)
    heat[i] = 1e9 * (1.0 + std::sin(0.3 * i));
  for (int step = 0; step < 2 * n; ++step)
    travelling.step(heat);
  const Vector rise = flash.rise(heat);
  for (int i = 0; i < n; ++i)
    EXPECT_NEAR(travelling.rise(i), rise[i], 1e-10 * rise.maxCoeff()) << i;
}

TEST(TravellingHeat, BelongsToTheMaterial)
{
  // One step's heat on one cell travels with the material and fades
  TravellingHeat travelling(20, 1e-5, 20.0, steel);
  travelling.step(1e9 * Vector::Unit(20, 15));
  double last = travelling.rise(15);
  EXPECT_GT(last, 0.0);
  for (int step = 1; step <= 15; ++step) {
    travelling.step(Vector::Zero(20));
    for (int i = 0; i < 20; ++i)
      EXPECT_EQ(travelling.rise(i) > 0.0, i == 15 - step) << i;
    EXPECT_LT(travelling.rise(15 - step), last);
    last = travelling.rise(15 - step);
  }
  travelling.step(Vector::Zero(20)); // out at the trailing end; new material is cold
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(travelling.rise(i), 0.0);
}

TEST(FlashTemperature, HeatsOnlyBehindTheSource)
{
  FlashTemperature flash(64, 1.0, 1.0, steel);
  const Vector rise = flash.rise(Vector::Unit(64, 20));
  for (int i = 0; i < 64; ++i)
    if (i > 20)
      EXPECT_NEAR(rise[i], 0.0, 1e-16);
    else
      EXPECT_GT(rise[i], 1e-8);
}
