// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/law_spread.h"

#include "base/errors.h"
#include "base/random_number.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Parameters = Eigen::Matrix<double, lawParameters, 1>;

constexpr double differencePart = 0.1; ///< of a parameter's standard error
constexpr int mostDrawsPerSample = 50;

FrictionLaw shifted(const FrictionLaw &law, const Parameters &change)
{
  FrictionLaw other = law;
  other.mu0 += change[0];
  other.mu1 += change[1];
  other.mu2 += change[2];
  other.b += change[3];
  other.c += change[4];
  return other;
}

double differenceStep(const LawCovariance &covariance, int parameter)
{
  return differencePart * std::sqrt(covariance(parameter, parameter));
}

bool isLaw(const FrictionLaw &law)
{
  constexpr double anyPressure = 1e300;
  if (law.b < 0.0 || law.c < 0.0)
    return false;
  for (double k1 : {0.0, law.kappa1Range.value_or(
                             Range{})[1]}) // monotone in both: the corners are the extremes
    for (double k2 : {0.0, anyPressure})
      if (!(law(k1, k2) > 0.0))
        return false;
  return true;
}

/// Standard normal numbers (Box, Muller) that depend on (seed, index) only.
double normalNumber(std::uint64_t seed, std::uint64_t index)
{
  constexpr double twoPi = 6.283185307179586;
  const double radius = std::sqrt(-2.0 * std::log1p(-uniformNumber(seed, 2 * index)));
  return radius * std::cos(twoPi * uniformNumber(seed, 2 * index + 1));
}

/// Linear interpolation between order statistics.
double quantile(const std::vector<double> &sorted, double level)
{
  const double place = level * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

} // namespace

LawSpread::LawSpread(const SpreadSpecification &specification, const FrictionLaw &law)
    : method_(specification.method), variants_{law}
{
  if (!law.covariance)
    return;
  if (method_ == UncertaintyMethod::Linear)
    addNeighbours();
  else
    addSamples(specification.samples, specification.seed);
}

void LawSpread::addNeighbours()
{
  const FrictionLaw law = variants_.front();
  for (int k = 0; k < lawParameters; ++k)
    for (double sign : {1.0, -1.0})
      variants_.push_back(
          shifted(law, sign * differenceStep(*law.covariance, k) * Parameters::Unit(k)));
}

void LawSpread::addSamples(int samples, std::uint64_t seed)
{
  const FrictionLaw law = variants_.front();
  // Parameters differ by orders of magnitude: the root is taken of the correlation matrix.
  const Parameters deviation = law.covariance->diagonal().cwiseSqrt();
  LawCovariance correlation = LawCovariance::Identity();
  for (int i = 0; i < lawParameters; ++i)
    for (int j = 0; j < lawParameters; ++j)
      if (i != j && deviation[i] > 0.0 && deviation[j] > 0.0)
        correlation(i, j) = (*law.covariance)(i, j) / (deviation[i] * deviation[j]);
  const Eigen::SelfAdjointEigenSolver<LawCovariance> eigen(correlation);
  const LawCovariance root =
      deviation.asDiagonal() * eigen.eigenvectors() *
      eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal().toDenseMatrix();

  std::uint64_t draws = 0;
  while (static_cast<int>(variants_.size()) <= samples) {
    if (draws >= static_cast<std::uint64_t>(samples) * mostDrawsPerSample)
      throw Error(
          ExitCode::NotConverged,
          fmt::format("uncertainty.method: of {} draws from the law's covariance only {} are "
                      "laws (b, c >= 0, mu > 0); 'linear' still works",
                      draws, variants_.size() - 1));
    Parameters normal;
    for (int k = 0; k < lawParameters; ++k)
      normal[k] = normalNumber(seed, draws * lawParameters + static_cast<std::uint64_t>(k));
    ++draws;
    const FrictionLaw draw = shifted(law, root * normal);
    if (isLaw(draw))
      variants_.push_back(draw);
  }
  redrawnShare_ = 1.0 - double(samples) / double(draws);
}

// Linear: the standard error is sqrt(d.C d), d the central differences by the parameters and C the
// covariance, so that correlated parameters may make up for each other, as they do in a fit.
Band LawSpread::band(const std::vector<double> &results) const
{
  const double value = results.front();
  if (!any())
    return {0.0, value, value};
  if (method_ == UncertaintyMethod::Linear) {
    const LawCovariance &covariance = *variants_.front().covariance;
    Parameters derivative;
    for (int k = 0; k < lawParameters; ++k) {
      const double step = 2.0 * differenceStep(covariance, k);
      derivative[k] = step > 0.0 ? (results[1 + 2 * k] - results[2 + 2 * k]) / step : 0.0;
    }
    const double error = std::sqrt(std::max(0.0, derivative.dot(covariance * derivative)));
    const double reach = error * boost::math::quantile(boost::math::normal(), 0.975);
    return {error, value - reach, value + reach};
  }
  std::vector<double> sorted(results.begin() + 1, results.end());
  std::sort(sorted.begin(), sorted.end());
  const Eigen::Map<const Eigen::ArrayXd> samples(sorted.data(),
                                                 static_cast<Eigen::Index>(sorted.size()));
  const double variance =
      (samples - samples.mean()).square().sum() / (static_cast<double>(sorted.size()) - 1.0);
  return {std::sqrt(variance), quantile(sorted, 0.025), quantile(sorted, 0.975)};
}

} // namespace wheelrail
