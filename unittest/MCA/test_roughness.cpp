// SPDX-License-Identifier: GPL-2.0-or-later
#include "laws/roughness.h"
#include "shared/pi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using mca::RoughProfile;

namespace {

const double length = 250, correlation = 5;

std::vector<double> sampled(const RoughProfile &h, int n)
{
  std::vector<double> all;
  for (int k = 0; k < n; k++)
    all.push_back(h(length * k / n));
  return all;
}

} // namespace

TEST(Roughness, IsPeriodic)
{
  const RoughProfile h(length, 3.0, correlation, 7);
  for (double x = 0; x < length; x += 11.3)
    EXPECT_NEAR(h(x), h(x + length), 1e-10);
}

TEST(Roughness, LargestDeviationIsTheAmplitude)
{
  for (unsigned seed = 1; seed <= 20; seed++) {
    const auto all = sampled(RoughProfile(length, 3.25, correlation, seed), 100000);
    double largest = 0;
    for (const double v : all)
      largest = std::max(largest, std::abs(v));
    EXPECT_NEAR(largest, 3.25, 0.002 * 3.25) << "seed " << seed;
  }
}

TEST(Roughness, MeanIsZero)
{
  for (const double v : {0.0, 3.25}) {
    const auto all = sampled(RoughProfile(length, v, correlation, 3), 4096);
    double sum = 0;
    for (const double x : all)
      sum += x;
    EXPECT_NEAR(sum / 4096, 0.0, 1e-12);
  }
}

TEST(Roughness, AutocorrelationIsGaussian)
{
  // sum of a_k^2 cos(q_k x): exact for each profile, whatever its phases; the wave k = 0, which
  // has half the weight of the others, is left out of the sum
  const RoughProfile h(length, 1.0, correlation, 5);
  const int n = 8192;
  const auto all = sampled(h, n);
  auto at = [&](int shift) {
    double sum = 0;
    for (int k = 0; k < n; k++)
      sum += all[k] * all[(k + shift) % n];
    return sum / n;
  };
  const double missing = std::sqrt(mcawr::pi) * correlation / length;
  for (int shift : {50, 100, 164, 300, 500, 2000}) {
    const double x = length * shift / n, expected = std::exp(-x * x / correlation / correlation);
    EXPECT_NEAR(at(shift) / at(0), (expected - missing) / (1 - missing), 1e-3) << "x = " << x;
  }
}

TEST(Roughness, SameSeedSameProfile)
{
  const RoughProfile a(length, 3, correlation, 42), b(length, 3, correlation, 42);
  const RoughProfile other(length, 3, correlation, 43);
  double difference = 0;
  for (double x = 0; x < length; x += 1.7) {
    EXPECT_EQ(a(x), b(x));
    difference = std::max(difference, std::abs(a(x) - other(x)));
  }
  EXPECT_GT(difference, 0.5);
}

TEST(Roughness, ShortPeriodStillHasAWave)
{
  const RoughProfile h(1.0, 2.0, 10.0, 1);
  double largest = 0;
  for (int k = 0; k < 1000; k++)
    largest = std::max(largest, std::abs(h(k / 1000.0)));
  EXPECT_NEAR(largest, 2.0, 0.05);
}

// the sum of the page, term by term
TEST(Roughness, IsTheSumOfItsWaves)
{
  for (const double l : {5.0, 0.5}) {
    const unsigned seed = 3;
    std::mt19937_64 random(seed);
    using mcawr::pi;
    const int waves = static_cast<int>(8.0 * length / (2.0 * pi * l));
    std::vector<double> phase(waves);
    for (double &p : phase)
      p = 2.0 * pi * std::ldexp(static_cast<double>(random() >> 11), -53);
    const auto slow = [&](double x) {
      double sum = 0.0;
      for (int k = 1; k <= waves; k++) {
        const double q = 2.0 * pi * k / length;
        sum += std::exp(-q * l * q * l / 8.0) * std::cos(q * x + phase[k - 1]);
      }
      return sum;
    };
    const RoughProfile fast(length, 1.0, l, seed);
    const double scale = fast(1.0) / slow(1.0);
    for (double x = 0; x < length; x += 9.7)
      EXPECT_NEAR(fast(x), scale * slow(x), 1e-11) << x; // round-off of `waves` terms of one
  }
}
