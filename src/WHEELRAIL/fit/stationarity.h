// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_STATIONARITY_H
#define WHEELRAIL_FIT_STATIONARITY_H

#include <cstddef>
#include <string>
#include <vector>

namespace wheelrail {

/// A series is sampled evenly: how far a step may differ from the first, as a share of it.
constexpr double spacingTolerance = 0.02;

/// Mean of a correlated series and what it is worth.
struct SeriesMean {
  double mean = 0.0;
  double standardError = 0.0;  ///< of the mean, with the autocorrelation accounted for
  double effectiveN = 0.0;     ///< number of independent samples of the same worth
  double correlationTime = 1.; ///< integrated autocorrelation time in samples, >= 1
  /// Degrees of freedom of `standardError`, >= 1: n/(2W + 1) of a sum up to lag W, since the
  /// relative variance of tau is 2 (2W + 1)/n (N. Madras and A. D. Sokal, J. Stat. Phys. 50 (1988)
  /// 109; U. Wolff, Comput. Phys. Commun. 156 (2004) 143).
  double freedom = 1.0;
  std::size_t n = 0; ///< samples
};

/// Mean of values[begin, end) with the standard error s sqrt(tau/n) from the integrated
/// autocorrelation time tau = 1 + 2 sum rho_k, summed over Geyer's initial monotone positive
/// sequence (C. J. Geyer, Statist. Sci. 7 (1992) 473) and corrected for the bias that comes from
/// subtracting the series' own mean. tau is at least 1 (a negative correlation is not credited) and
/// at most n/3: a series that short says so by effectiveN near 3.
/// \param begin, end indices with end - begin >= 4; otherwise the standard error is infinite
/// \throws std::invalid_argument for an empty range or an end beyond the series
SeriesMean seriesMean(const std::vector<double> &values, std::size_t begin, std::size_t end);

/// What the standard error has to be for mean +- 1.96 of it to hold the true mean in 95 of 100
/// series: Student's t of `freedom` in place of the normal quantile. A series that is short beside
/// its correlation knows its own error badly; the error is widened by as much.
double widenedError(const SeriesMean &mean);

/// MSER-5 (K. P. White, Simulation 69 (1997) 323): the start that minimises the squared standard
/// error of the mean of what is left, computed on means of 5 samples, looked for in the first half.
/// \return index of the first sample kept; values.size() when the minimum lies at the end of the
///         search range, that is, when the series had better be longer
std::size_t mser5(const std::vector<double> &values);

/// Fewer values than this have no p value: gewekeP and trendP throw std::invalid_argument.
constexpr std::size_t leastTested = 16;

/// Two-sided p value of Geweke's comparison of the first quarter with the second half of
/// values[begin, size): the difference of their means in units of its standard error, both parts
/// with the variance and autocorrelation of the second half about its own straight line (a drift
/// must not excuse itself by the variance that it makes), Student's t with its effective degrees of
/// freedom.
double gewekeP(const std::vector<double> &values, std::size_t begin);

/// What the least-squares line through values[begin, size) gains from their begin to their end.
/// \param begin with at least two values from there on
double drift(const std::vector<double> &values, std::size_t begin);

/// Two-sided p value of the slope of the least-squares line through values[begin, size), with the
/// variance and autocorrelation of what the line leaves.
double trendP(const std::vector<double> &values, std::size_t begin);

/// The stationary part of a series: values[start, size).
struct StationaryPart {
  bool found = false;
  std::size_t start = 0; ///< first sample of it; the middle of the series when none was found
  double p = 0.0;        ///< smaller p value of the two tests at `start`
  SeriesMean mean;       ///< of values[start, size), also when no stationary part was found
  std::string reason;    ///< why none was found; empty otherwise
};

/// Level of the two tests below which a part is taken to drift.
constexpr double driftLevel = 0.05;
/// Fewer samples than this are not searched for a stationary part.
constexpr std::size_t leastSamples = 40;
/// Fewer independent samples than this in the part that is kept do not show that it is stationary.
constexpr double leastEffective = 5.0;

/// MSER-5 proposes a start, the Geweke and the trend test confirm it or move it on by a twentieth
/// of the series at a time, up to the middle. No stationary part is found when the series has fewer
/// than `leastSamples` samples, when the start would come to lie beyond the middle, or when the
/// part that is left is worth fewer than `leastEffective` independent samples.
StationaryPart stationaryPart(const std::vector<double> &values);

} // namespace wheelrail

#endif
