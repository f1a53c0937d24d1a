// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/statistics.h"
#include "fit/stationarity.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>

using namespace wheelrail;

namespace {

/// Stationary AR(1) series x_i = phi x_{i-1} + noise with unit variance.
std::vector<double> ar1(double phi, std::size_t n, std::mt19937_64 &generator)
{
  std::normal_distribution<double> normal;
  std::vector<double> values(n);
  double x = normal(generator);
  for (auto &value : values) {
    value = x;
    x = phi * x + std::sqrt(1.0 - phi * phi) * normal(generator);
  }
  return values;
}

/// Standard error of the mean from non-overlapping batches of a series that they divide: it reacts
/// more slowly to long correlations than seriesMean, but assumes less.
double batchMeansError(const std::vector<double> &values, std::size_t batches)
{
  const std::size_t size = values.size() / batches;
  std::vector<double> means(batches, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i)
    means[i / size] += values[i] / static_cast<double>(size);
  const auto k = static_cast<double>(batches);
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / k;
  double sum = 0.0;
  for (double x : means)
    sum += (x - mean) * (x - mean);
  return std::sqrt(sum / (k * (k - 1.0)));
}

/// Exact standard deviation of the mean of n samples of it.
double exactError(double phi, int n)
{
  double sum = 1.0;
  for (int k = 1; k < n; ++k)
    sum += 2.0 * (1.0 - static_cast<double>(k) / n) * std::pow(phi, k);
  return std::sqrt(sum / n);
}

} // namespace

// Root mean square of the estimated error over 200 series, and how often mean +- t error covers 0.
TEST(Stationarity, errorOfCorrelatedMeanIsTheKnownOne)
{
  std::mt19937_64 generator(1);
  constexpr int series = 200;
  constexpr int n = 2000;
  for (double phi : {0.0, 0.5, 0.8, 0.95}) {
    double squares = 0.0;
    double time = 0.0;
    int covered = 0;
    for (int i = 0; i < series; ++i) {
      const auto mean = seriesMean(ar1(phi, n, generator), 0, n);
      squares += mean.standardError * mean.standardError / series;
      time += mean.correlationTime / series;
      const double t = studentQuantile(0.975, mean.effectiveN - 1.0);
      covered += std::abs(mean.mean) < t * mean.standardError;
    }
    EXPECT_NEAR(std::sqrt(squares) / exactError(phi, n), 1.0, 0.05) << "phi " << phi;
    EXPECT_NEAR(time / ((1.0 + phi) / (1.0 - phi)), 1.0, 0.12) << "phi " << phi;
    // binomial: 0.95 +- 3 * 0.0154
    EXPECT_GT(covered, 0.90 * series) << "phi " << phi;
  }
}

// How often mean +- 1.96 of the error holds the true mean, where the series is 33, 11, 5 and 2.6 of
// its correlation times long: 92, 88, 83 and 73 of 100, widened by Student's t 95, 93, 92 and 88.
TEST(Stationarity, theErrorOfAShortSeriesIsWidened)
{
  std::mt19937_64 generator(8);
  constexpr int series = 2000;
  for (const auto &[n, phi, least] :
       {std::tuple{100, 0.5, 0.93}, {100, 0.8, 0.91}, {200, 0.95, 0.89}, {50, 0.9, 0.85}}) {
    int plain = 0, widened = 0;
    for (int i = 0; i < series; ++i) {
      const auto mean = seriesMean(ar1(phi, n, generator), 0, n);
      plain += std::abs(mean.mean) < 1.96 * mean.standardError;
      widened += std::abs(mean.mean) < 1.96 * widenedError(mean);
    }
    EXPECT_GT(widened, least * series) << n << " " << phi;
    EXPECT_LT(widened, 0.98 * series) << n << " " << phi;
    EXPECT_GT(widened, plain + 0.01 * series);
  }
  // of a long one it stays as it is
  const auto mean = seriesMean(ar1(0.5, 20000, generator), 0, 20000);
  EXPECT_LT(widenedError(mean), 1.01 * mean.standardError);
}

TEST(Stationarity, batchMeansAgree)
{
  std::mt19937_64 generator(2);
  double batches = 0.0, fast = 0.0;
  for (int i = 0; i < 100; ++i) {
    const auto values = ar1(0.5, 2000, generator);
    batches += std::pow(batchMeansError(values, 20), 2) / 100;
    fast += std::pow(seriesMean(values, 0, values.size()).standardError, 2) / 100;
  }
  // batches of 100 samples miss the correlation across their ends: about 1 % low, scatter 2 %
  EXPECT_NEAR(std::sqrt(batches / fast), 1.0, 0.06);
}

TEST(Stationarity, errorDoesNotDependOnOffsetAndScalesWithTheSeries)
{
  std::mt19937_64 generator(3);
  auto values = ar1(0.7, 500, generator);
  const auto before = seriesMean(values, 0, values.size());
  for (auto &x : values)
    x = 1000.0 - 1e-3 * x;
  const auto after = seriesMean(values, 0, values.size());
  EXPECT_NEAR(after.standardError, 1e-3 * before.standardError, 1e-9 * before.standardError);
  EXPECT_NEAR(after.mean, 1000.0 - 1e-3 * before.mean, 1e-9);
}

TEST(Stationarity, degenerateSeries)
{
  const auto constant = seriesMean(std::vector<double>(100, 0.3), 0, 100);
  EXPECT_EQ(constant.standardError, 0.0);
  EXPECT_NEAR(constant.mean, 0.3, 1e-15);
  EXPECT_TRUE(std::isinf(seriesMean({1, 2, 3}, 0, 3).standardError));
  EXPECT_THROW(seriesMean({1, 2}, 1, 1), std::invalid_argument);
  EXPECT_THROW(seriesMean({1, 2}, 0, 3), std::invalid_argument);
  for (double value : {0.3, 0.4159, 1.0 / 3.0})
    for (std::size_t n : {100, 1000, 12345}) {
      const std::vector<double> values(n, value);
      const auto part = stationaryPart(values);
      EXPECT_TRUE(part.found) << value << " " << n << " " << part.reason;
      EXPECT_EQ(part.mean.mean, value);
      EXPECT_EQ(part.mean.standardError, 0.0);
    }
  // alternating: negative correlation is not credited
  std::vector<double> alternating;
  for (int i = 0; i < 100; ++i)
    alternating.push_back(i % 2);
  EXPECT_EQ(seriesMean(alternating, 0, 100).correlationTime, 1.0);
}

TEST(Stationarity, stationarySeriesKeepsNearlyAll)
{
  std::mt19937_64 generator(4);
  int found = 0;
  double start = 0.0;
  constexpr int series = 200;
  for (int i = 0; i < series; ++i) {
    const auto part = stationaryPart(ar1(0.8, 1000, generator));
    found += part.found;
    start += static_cast<double>(part.start) / 1000 / series;
  }
  EXPECT_GE(found, 0.97 * series);
  EXPECT_LT(start, 0.05);
}

TEST(Stationarity, transientIsCutOff)
{
  std::mt19937_64 generator(5);
  int found = 0;
  double bias = 0.0;
  constexpr int series = 100;
  for (int i = 0; i < series; ++i) {
    auto values = ar1(0.9, 2000, generator);
    // grinding-in of the height of the mean, over a twentieth of the log
    for (int k = 0; k < 2000; ++k)
      values[k] = 0.5 + 0.1 * values[k] + 0.5 * std::exp(-k / 100.0);
    const auto part = stationaryPart(values);
    found += part.found;
    if (part.found)
      bias += (part.mean.mean - 0.5) / series;
  }
  EXPECT_GE(found, 95);
  // without the cut it would be 0.025; the error of one mean is 0.01
  EXPECT_LT(bias, 0.006);
}

TEST(Stationarity, driftIsRefused)
{
  std::mt19937_64 generator(6);
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    auto values = ar1(0.5, 2000, generator);
    for (int k = 0; k < 2000; ++k)
      values[k] = 0.1 * values[k] + 0.3 * k / 2000.0;
    found += stationaryPart(values).found;
  }
  EXPECT_LE(found, 5);
  auto slow = ar1(0.5, 2000, generator);
  for (int k = 0; k < 2000; ++k)
    slow[k] = 0.5 + 0.03 * slow[k] - 0.04 * k / 2000.0;
  const std::string said = "mu still drifts in the second half of the log, by -0.0";
  const auto reason = stationaryPart(slow).reason;
  ASSERT_EQ(reason.substr(0, said.size()), said);
  EXPECT_NEAR(std::stod(reason.substr(said.size() - 4)), -0.02, 0.008);
  const auto part = stationaryPart(std::vector<double>(20, 1.0));
  EXPECT_FALSE(part.found);
  EXPECT_EQ(part.reason, "the log is too short");
  EXPECT_EQ(part.start, 10u);
}

TEST(Stationarity, mserFindsAStep)
{
  std::vector<double> values(1000, 0.0);
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i)
    values[i] = normal(generator) + (i < 200 ? 5.0 : 0.0);
  const auto start = mser5(values);
  EXPECT_GE(start, 195u);
  EXPECT_LE(start, 250u);
}
