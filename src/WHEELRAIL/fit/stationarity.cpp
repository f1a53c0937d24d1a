// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/stationarity.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace wheelrail {

namespace {

/// Exact for a constant series, which must not seem to drift by its rounding: summed from its first
/// value on.
double meanOf(const std::vector<double> &values, std::size_t begin, std::size_t end)
{
  double sum = 0.0;
  for (std::size_t i = begin; i < end; ++i)
    sum += values[i] - values[begin];
  return values[begin] + sum / static_cast<double>(end - begin);
}

/// Autocovariance at a lag, with 1/n (so that the sequence is positive definite).
double autocovariance(const std::vector<double> &deviations, std::size_t lag)
{
  double sum = 0.0;
  for (std::size_t i = 0; i + lag < deviations.size(); ++i)
    sum += deviations[i] * deviations[i + lag];
  return sum / static_cast<double>(deviations.size());
}

/// A sum of autocorrelations.
struct Correlation {
  double time = 0.0;      ///< 1 + 2 sum rho_k
  std::size_t window = 0; ///< the largest k
};

/// Over Geyer's initial monotone positive sequence: sums of neighbouring autocovariances of a
/// reversible process are positive and fall; noise begins where they do not.
Correlation correlationOf(const std::vector<double> &deviations, double variance)
{
  Correlation result;
  double sum = 0.0;
  double previous = std::numeric_limits<double>::infinity();
  for (std::size_t lag = 0; lag + 1 < deviations.size(); lag += 2) {
    const double pair = (lag == 0 ? variance : autocovariance(deviations, lag)) +
                        autocovariance(deviations, lag + 1);
    if (pair <= 0.0)
      break;
    previous = std::min(previous, pair);
    sum += previous;
    result.window = lag + 1;
  }
  result.time = (2.0 * sum - variance) / variance;
  return result;
}

/// The straight line through values[begin, end) by least squares: its slope per sample, what is
/// left of the values, and sum (i - mean i)^2.
struct Line {
  double slope = 0.0;
  double spread = 0.0;
  std::vector<double> residuals;
};

Line fitLine(const std::vector<double> &values, std::size_t begin, std::size_t end)
{
  Line line;
  const double mean = meanOf(values, begin, end);
  const double middle = 0.5 * static_cast<double>(end - begin - 1);
  for (std::size_t i = begin; i < end; ++i) {
    const double x = static_cast<double>(i - begin) - middle;
    line.slope += x * (values[i] - mean);
    line.spread += x * x;
  }
  line.slope /= line.spread;
  for (std::size_t i = begin; i < end; ++i)
    line.residuals.push_back(values[i] - mean -
                             line.slope * (static_cast<double>(i - begin) - middle));
  return line;
}

/// Two-sided p value of a deviation, given the standard error that `noise` measured; the straight
/// line that was taken off cost it two degrees of freedom.
double pValue(double deviation, double error, const SeriesMean &noise)
{
  if (error == 0.0)
    return deviation == 0.0 ? 1.0 : 0.0;
  return 2.0 * studentCdf(-std::abs(deviation) / error, std::max(1.0, noise.effectiveN - 2.0));
}

constexpr std::size_t mserBatch = 5;

} // namespace

SeriesMean seriesMean(const std::vector<double> &values, std::size_t begin, std::size_t end)
{
  if (begin >= end || end > values.size())
    throw std::invalid_argument("seriesMean: the range is empty or longer than the series");
  SeriesMean result;
  result.n = end - begin;
  result.mean = meanOf(values, begin, end);
  const auto n = static_cast<double>(result.n);
  if (result.n < 4) {
    result.standardError = std::numeric_limits<double>::infinity();
    return result;
  }
  std::vector<double> deviations(values.begin() + begin, values.begin() + end);
  for (auto &x : deviations)
    x -= result.mean;
  const double variance = autocovariance(deviations, 0);
  // constant up to rounding: no error to be seen
  constexpr double rounding = 1e-13;
  if (variance <= std::pow(rounding * result.mean, 2)) {
    result.effectiveN = result.freedom = n;
    return result;
  }
  const Correlation correlation = correlationOf(deviations, variance);
  result.correlationTime = std::clamp(correlation.time, 1.0, n / 3.0);
  result.freedom = std::max(1.0, n / (2.0 * static_cast<double>(correlation.window) + 1.0));
  result.effectiveN = n / result.correlationTime;
  // the variance about the series' own mean is too small by the variance of that mean
  const double unbiased = variance / (1.0 - 1.0 / result.effectiveN);
  result.standardError = std::sqrt(unbiased / result.effectiveN);
  return result;
}

double widenedError(const SeriesMean &mean)
{
  constexpr double upper = 0.975;
  return mean.standardError * studentQuantile(upper, mean.freedom) / normal95;
}

std::size_t mser5(const std::vector<double> &values)
{
  const std::size_t count = values.size() / mserBatch;
  if (count < 4)
    return values.size();
  std::vector<double> batch(count);
  for (std::size_t i = 0; i < count; ++i)
    batch[i] = meanOf(values, i * mserBatch, (i + 1) * mserBatch);
  // sums over what is left, from the end to the beginning (Welford)
  double mean = 0.0;
  double squares = 0.0;
  double least = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t i = count; i-- > 0;) {
    const auto n = static_cast<double>(count - i);
    const double delta = batch[i] - mean;
    mean += delta / n;
    squares += delta * (batch[i] - mean);
    if (i <= count / 2 && squares / (n * n) <= least) {
      least = squares / (n * n);
      best = i;
    }
  }
  return best == count / 2 ? values.size() : best * mserBatch;
}

double gewekeP(const std::vector<double> &values, std::size_t begin)
{
  const std::size_t n = values.size() - begin;
  const std::size_t endOfFirst = begin + n / 4;
  const std::size_t beginOfSecond = begin + n / 2;
  if (n < leastTested)
    throw std::invalid_argument("gewekeP: at least 16 samples are needed");
  const double difference =
      meanOf(values, begin, endOfFirst) - meanOf(values, beginOfSecond, values.size());
  const auto line = fitLine(values, beginOfSecond, values.size());
  const auto noise = seriesMean(line.residuals, 0, line.residuals.size());
  const double ratio = static_cast<double>(noise.n) / static_cast<double>(endOfFirst - begin);
  return pValue(difference, noise.standardError * std::sqrt(1.0 + ratio), noise);
}

double drift(const std::vector<double> &values, std::size_t begin)
{
  const auto line = fitLine(values, begin, values.size());
  return line.slope * static_cast<double>(values.size() - begin);
}

double trendP(const std::vector<double> &values, std::size_t begin)
{
  if (values.size() < begin + leastTested)
    throw std::invalid_argument("trendP: at least 16 samples are needed");
  const auto line = fitLine(values, begin, values.size());
  const auto noise = seriesMean(line.residuals, 0, line.residuals.size());
  // the error of a slope is that of the mean times sqrt(n / spread)
  const double error = noise.standardError * std::sqrt(static_cast<double>(noise.n) / line.spread);
  return pValue(line.slope, error, noise);
}

// MSER-5 weighs the bias of an early start against the variance of a late one, but knows nothing of
// autocorrelation: its start may lie within a slow drift. So two tests that do know have to agree,
// one that sees a step (the first quarter against the second half), one that sees a slope; until
// they do, the start moves on. Beyond the middle nothing is found: what is left would be too short
// for the tests to object to anything.
StationaryPart stationaryPart(const std::vector<double> &values)
{
  if (values.empty())
    throw std::invalid_argument("stationaryPart: the series is empty");
  StationaryPart part;
  const std::size_t middle = values.size() / 2;
  const std::size_t stride = std::max<std::size_t>(1, values.size() / 20);
  const auto giveUp = [&](std::string reason) {
    part.reason = std::move(reason);
    part.start = middle;
    part.mean = seriesMean(values, middle, values.size());
    return part;
  };
  if (values.size() < leastSamples)
    return giveUp("the log is too short");
  part.start = mser5(values);
  if (part.start > middle)
    return giveUp("the mean gets better up to the middle of the log");
  const auto smallerP = [&] {
    return std::min(gewekeP(values, part.start), trendP(values, part.start));
  };
  while ((part.p = smallerP()) < driftLevel) {
    part.start += stride;
    if (part.start > middle)
      return giveUp(fmt::format("mu still drifts in the second half of the log, by {:+.2g} over it",
                                drift(values, middle)));
  }
  part.mean = seriesMean(values, part.start, values.size());
  if (part.mean.effectiveN < leastEffective)
    return giveUp("what is left is worth too few independent samples");
  part.found = true;
  return part;
}

} // namespace wheelrail
