// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/law_spread.h"

#include "base/errors.h"
#include "base/random_number.h"
#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;
constexpr double differencePart = 0.1; ///< of a parameter's standard error
constexpr int mostDrawsPerSample = 50;

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

LawSpread::LawSpread(const SpreadSpecification &specification, const LawPointer &law)
    : method_(specification.method), variants_{law}
{
  if (law->standardErrors().size() == 0)
    return;
  if (method_ == UncertaintyMethod::Linear)
    addNeighbours();
  else
    addSamples(specification.samples, specification.seed);
}

void LawSpread::addNeighbours()
{
  const LawPointer law = variants_.front();
  const Vector step = differencePart * law->standardErrors();
  distances_ = Vector::Zero(step.size());
  for (Eigen::Index k = 0; k < step.size(); ++k)
    for (const double sign : {1.0, -1.0}) {
      LawPointer near;
      if (step[k] > 0.0)
        near = law->changed(sign * step[k] * Vector::Unit(step.size(), k));
      const bool isLaw = near && near->isDefined();
      variants_.push_back(isLaw ? near : law);
      distances_[k] += isLaw ? step[k] : 0.0;
    }
}

std::string LawSpread::warning() const
{
  const FrictionLaw &law = *variants_.front();
  Eigen::Index leftOut = 0;
  for (Eigen::Index k = 0; k < distances_.size(); ++k)
    leftOut += distances_[k] == 0.0 && law.standardErrors()[k] > 0.0;
  if (leftOut == 0)
    return "";
  return fmt::format("uncertainty.method: the linear band leaves out {} of the law's {} "
                     "parameters: neither above nor below them is a law ({})",
                     leftOut, distances_.size(), law.soundness());
}

void LawSpread::addSamples(int samples, std::uint64_t seed)
{
  const LawPointer law = variants_.front();
  const LawDraws drawn = law->draws();
  Vector normal(law->standardErrors().size());
  const auto parameters = static_cast<std::uint64_t>(normal.size());
  std::uint64_t draws = 0;
  while (static_cast<int>(variants_.size()) <= samples) {
    if (draws >= static_cast<std::uint64_t>(samples) * mostDrawsPerSample)
      throw Error(
          ExitCode::NotConverged,
          fmt::format("uncertainty.method: of {} draws from the law's covariance only {} are "
                      "laws ({}); 'linear' still works",
                      draws, variants_.size() - 1, law->soundness()));
    for (std::uint64_t k = 0; k < parameters; ++k)
      normal[static_cast<Eigen::Index>(k)] = normalNumber(seed, draws * parameters + k);
    ++draws;
    if (const LawPointer draw = drawn(normal); draw->isSound())
      variants_.push_back(draw);
  }
  redrawnShare_ = 1.0 - double(samples) / double(draws);
}

// Linear: the standard error is sqrt(d.C d), d the differences by the parameters and C the
// covariance, so that correlated parameters may make up for each other, as they do in a fit.
Band LawSpread::band(const std::vector<double> &results) const
{
  const double value = results.front();
  if (!any())
    return {0.0, value, value};
  if (method_ == UncertaintyMethod::Linear) {
    const FrictionLaw &law = *variants_.front();
    Vector derivative = Vector::Zero(distances_.size());
    for (Eigen::Index k = 0; k < derivative.size(); ++k) {
      const auto up = static_cast<std::size_t>(1 + 2 * k);
      if (distances_[k] > 0.0)
        derivative[k] = (results[up] - results[up + 1]) / distances_[k];
    }
    const double error = std::sqrt(std::max(0.0, law.variance(derivative)));
    const double reach = normal95 * error;
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
