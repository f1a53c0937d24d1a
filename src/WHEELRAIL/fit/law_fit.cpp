// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/law_fit.h"

#include "base/errors.h"
#include "base/statistics.h"
#include "fit/law_problem.h"
#include "shared/pi.h"

#include <Eigen/Dense>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace wheelrail {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd deviations(const std::vector<ConditionMean> &means, const VectorXd &fitted, double scatter)
{
  VectorXd sigma(means.size());
  for (size_t i = 0; i < means.size(); ++i)
    sigma[i] = std::hypot(means[i].muSe, scatter * fitted[i]);
  return sigma;
}

VectorXd fittedMu(const VectorXd &x, const std::vector<ConditionMean> &means, const PowerOf &power)
{
  VectorXd mu(means.size());
  for (size_t i = 0; i < means.size(); ++i)
    mu[i] = modelMu(x, means[i], power);
  return mu;
}

double geometricMean(ThirdNumber number, const std::vector<ConditionMean> &means)
{
  double sum = 0.0;
  for (const auto &mean : means)
    sum += std::log(valueOf(number, mean));
  return std::exp(sum / static_cast<double>(means.size()));
}

double chiSquared(const std::vector<ConditionMean> &means, const VectorXd &fitted, double scatter)
{
  const VectorXd sigma = deviations(means, fitted, scatter);
  double sum = 0.0;
  for (size_t i = 0; i < means.size(); ++i)
    sum += std::pow((means[i].mu - fitted[i]) / sigma[i], 2);
  return sum;
}

// residuals of exact data are rounding errors: no smaller scatter than this is told from none
constexpr double leastScatter = 1e-9;

/// The scatter at which chi^2 is `target`: chi^2 falls with it.
double scatterFor(const std::vector<ConditionMean> &means, const VectorXd &fitted, double target)
{
  const bool haveErrors = std::all_of(means.begin(), means.end(),
                                      [](const ConditionMean &mean) { return mean.muSe > 0.0; });
  const double least = haveErrors ? 0.0 : leastScatter;
  if (chiSquared(means, fitted, least) <= target)
    return least;
  // in the logarithm, over which chi^2 falls from far above the target to far below
  const auto excess = [&](double logScatter) {
    return chiSquared(means, fitted, std::exp(logScatter)) - target;
  };
  if (excess(std::log(leastScatter)) <= 0.0)
    return leastScatter;
  double high = 1.0;
  while (chiSquared(means, fitted, high) > target && high < 1e6)
    high *= 2.0;
  if (excess(std::log(high)) > 0.0)
    return high;
  std::uintmax_t steps = 100;
  const auto bracket =
      boost::math::tools::toms748_solve(excess, std::log(leastScatter), std::log(high),
                                        boost::math::tools::eps_tolerance<double>(), steps);
  return std::exp(0.5 * (bracket.first + bracket.second));
}

/// -2 ln likelihood of normal residuals, at the scatter that maximises it.
double minusTwoLogLikelihood(const std::vector<ConditionMean> &means, const VectorXd &fitted)
{
  // Profile likelihood: the fitted mu stay, the scatter is chosen anew. The fit's own scatter makes
  // chi^2 equal to the degrees of freedom; the likelihood, which AICc compares, has its maximum at
  // a somewhat smaller one.
  const auto value = [&](double logScatter) {
    const VectorXd sigma = deviations(means, fitted, std::exp(logScatter));
    double sum = 0.0;
    for (size_t i = 0; i < means.size(); ++i)
      sum += std::log(2.0 * mcawr::pi * sigma[i] * sigma[i]) +
             std::pow((means[i].mu - fitted[i]) / sigma[i], 2);
    return sum;
  };
  constexpr int bits = std::numeric_limits<double>::digits / 2; // a minimum is known to no more
  return boost::math::tools::brent_find_minima(value, std::log(leastScatter), std::log(10.0), bits)
      .second;
}

int countParameters(LawModel model)
{
  const auto free = parametersOf(model);
  return static_cast<int>(std::count(free.begin(), free.end(), true));
}

/// Number of values that differ by more than a thousandth.
int countDifferent(std::vector<double> values)
{
  constexpr double tolerance = 1e-3;
  std::sort(values.begin(), values.end());
  int count = 0;
  double last = -1.0;
  for (double v : values)
    if (count == 0 || v - last > tolerance * v) {
      ++count;
      last = v;
    }
  return count;
}

void checkMeans(const std::vector<ConditionMean> &means)
{
  for (const auto &mean : means)
    if (!(std::isfinite(mean.kappa1) && mean.kappa1 >= 0.0 && std::isfinite(mean.kappa2) &&
          mean.kappa2 >= 0.0 && std::isfinite(mean.mu) && std::isfinite(mean.muSe) &&
          mean.muSe >= 0.0 && std::isfinite(mean.kappa3) && mean.kappa3 > 0.0))
      throw std::invalid_argument("fitLaw: a number of a condition is not finite or negative");
}

Range rangeOf(const std::vector<ConditionMean> &means, double ConditionMean::*number)
{
  const auto [least, largest] = std::minmax_element(
      means.begin(), means.end(), [&](const ConditionMean &mean, const ConditionMean &other) {
        return mean.*number < other.*number;
      });
  return {*least.*number, *largest.*number};
}

std::string explainWeakness(const LawFit &fit, const VectorXd &x, const Identifiability &analysis,
                            const LeastSquaresProblem &problem)
{
  for (int k : {B, C, D}) {
    const bool atUpper = fit.atBound[k] && x[k] > 0.5 * problem.upper[k];
    if (atUpper)
      return fmt::format(
          "{} runs to its bound of {:.3g}: its term is constant over all the conditions",
          parameterNames[k], problem.upper[k]);
  }
  const auto free = parametersOf(fit.model);
  if (free[S] && fit.atBound[S])
    return "s runs to its bound: no condition feels the limit of the shear strength";
  if (free[S1] && fit.atBound[S1])
    return "s1 runs to 0: the limit of the shear strength does not rise with kappa1";
  if (free[C] && fit.atBound[C])
    return "c runs to 0: mu does not depend on kappa2, mu0 and mu2 cannot be told apart";
  if (analysis.conditionNumber <= worstCondition)
    return "";
  std::string names;
  for (int k = 0; k < fitParameters; ++k)
    if (std::abs(analysis.weakDirection[k]) > 0.3)
      names += (names.empty() ? "" : ", ") + std::string(parameterNames[k]);
  return fmt::format(
      "{} cannot be told apart (condition number {:.3g}, at most {:.0e} is accepted)", names,
      analysis.conditionNumber, worstCondition);
}

/// The hat matrix' diagonal h_i = j_i C j_i', the share of condition i in its own fitted value,
/// takes that much variance off the residual: sigma_i^2 (1 - h_i).
void fillResiduals(LawFit &fit, const std::vector<ConditionMean> &means, const VectorXd &fitted,
                   const VectorXd &sigma, const MatrixXd &jacobian, const MatrixXd &covariance)
{
  double sum = 0.0;
  for (size_t i = 0; i < means.size(); ++i) {
    const double mu = fitted[i];
    const Eigen::RowVectorXd row = jacobian.row(i);
    const double hat = std::clamp((row * covariance * row.transpose()).value(), 0.0, 1.0);
    const double spread = sigma[i] * std::sqrt(std::max(1.0 - hat, 1e-12));
    fit.residuals.push_back((means[i].mu - mu) / mu);
    fit.studentised.push_back((means[i].mu - mu) / spread);
    fit.leverage.push_back(hat);
    sum += fit.residuals.back() * fit.residuals.back();
  }
  fit.law.rmsRelative = std::sqrt(sum / static_cast<double>(means.size()));
}

} // namespace

Obstacle obstacleTo(LawModel model, const std::vector<ConditionMean> &means)
{
  const auto free = parametersOf(model);
  const int parameters = countParameters(model);
  const int n = static_cast<int>(means.size());
  if (n < parameters + 1)
    return {fmt::format("{} condition{} for the {} parameters of {}, at least {} are needed", n,
                        n == 1 ? "" : "s", parameters, nameOf(model), parameters + 1),
            true};
  const auto look = [&](int k, const char *name, int leastDifferent, auto member) -> std::string {
    if (!free[k])
      return "";
    std::vector<double> values;
    for (const auto &mean : means)
      values.push_back(member(mean));
    const int different = countDifferent(values);
    if (different >= leastDifferent)
      return "";
    return fmt::format(
        "the conditions have only {} different {} ({:.4g} to {:.4g}), at least {} are "
        "needed",
        different, name, *std::min_element(values.begin(), values.end()),
        *std::max_element(values.begin(), values.end()), leastDifferent);
  };
  // a saturating term has two parameters beside the constant
  auto reason = look(Mu1, "kappa1", 3, [](const ConditionMean &mean) { return mean.kappa1; });
  if (reason.empty())
    reason = look(S1, "kappa1", 3, [](const ConditionMean &mean) { return mean.kappa1; });
  if (reason.empty())
    reason = look(Mu2, "kappa2", 3, [](const ConditionMean &mean) { return mean.kappa2; });
  const ThirdNumber third = thirdNumberOf(model);
  const auto isUnknown = [third](const ConditionMean &mean) {
    return !(valueOf(third, mean) > 0.0);
  };
  if (reason.empty() && std::any_of(means.begin(), means.end(), isUnknown))
    reason = fmt::format("the {} of a condition is not known: its logs do not tell the breaking "
                         "strain",
                         nameOf(third));
  if (reason.empty())
    reason = look(N, nameOf(third), 2,
                  [third](const ConditionMean &mean) { return valueOf(third, mean); });
  if (reason.empty())
    reason = look(S, "p/sigma_0", 3,
                  [](const ConditionMean &mean) { return mean.kappa2 / mean.kappa3; });
  return {reason, false};
}

// Weighted least squares by iterated weights. Each condition scatters by the error of its mean and
// by what the law does not describe, a share `scatter` of mu that is the same for all:
//   sigma_i^2 = se_i^2 + (scatter mu_i)^2.
// The scatter is unknown; it is the one with which chi^2 equals the degrees of freedom, as it must
// on average if sigma is right. A round takes sigma from the last fit, fits the parameters, and
// finds the scatter anew, until both stay.
//
// The terms of Eq. 2 saturate, so that sums of squares have more than one minimum: the first round
// begins at a grid of starts (`LawProblem::starts`), later ones where the last ended.
//
// From the Jacobian at the end come the covariance, the condition number, which says whether the
// conditions determine the parameters at all, and the leverage of each condition. Intervals are not
// taken from the covariance but from the profile of chi^2, because b and c have skew likelihoods:
// an end of an interval is where the best fit with this parameter held is worse by t^2, Student's t
// of the degrees of freedom, since the scatter was estimated from the same conditions. Models are
// compared by AICc, in which the scatter counts as one more parameter.
LawFit fitLaw(LawModel model, const std::vector<ConditionMean> &means, double level,
              double reference)
{
  checkMeans(means);
  if (const auto obstacle = obstacleTo(model, means); !obstacle.reason.empty())
    throw Error(ExitCode::NotConverged, obstacle.reason);
  const int n = static_cast<int>(means.size());
  LawFit fit;
  fit.model = model;
  fit.freedom = n - countParameters(model);
  if (!(reference >= 0.0 && std::isfinite(reference)))
    throw std::invalid_argument("fitLaw: the reference is not finite or negative");
  const ThirdNumber third = thirdNumberOf(model);
  const PowerOf power = {third, reference == 0.0 ? geometricMean(third, means) : reference};

  // Weights depend on the fit and on the scatter, both on the weights: repeat until they agree. The
  // scatter is relative to the fitted mu, not to the measured one, so that a condition does not
  // weigh more because it happened to come out low.
  VectorXd fitted(n);
  for (int i = 0; i < n; ++i)
    fitted[i] = std::max(means[i].mu, 1e-3);
  fit.scatter = 0.1;
  VectorXd sigma;
  LeastSquaresSolution solution;
  constexpr int mostRounds = 50;
  constexpr double tolerance = 1e-7;
  for (int round = 0; round < mostRounds; ++round) {
    sigma = deviations(means, fitted, fit.scatter);
    const LawProblem weighted(model, means, sigma, power);
    const auto problem = weighted.make();
    auto starts = weighted.starts(problem);
    if (round > 0)
      starts = {solution.x}; // the grid has done its work
    solution = solveLeastSquares(problem, starts);
    if (!solution.converged)
      throw Error(ExitCode::NotConverged, fmt::format("the fit of {} does not converge: {}",
                                                      nameOf(model), solution.message));
    const VectorXd before = fitted;
    fitted = fittedMu(solution.x, means, power);
    const double scatter = scatterFor(means, fitted, fit.freedom);
    const bool settled = std::abs(scatter - fit.scatter) <= tolerance * (scatter + leastScatter) &&
                         (fitted - before).norm() <= tolerance * fitted.norm();
    fit.scatter = scatter;
    if (settled)
      break;
  }
  // once more with the weights that belong to the last scatter: parameters, chi^2 and Jacobian
  // agree
  sigma = deviations(means, fitted, fit.scatter);
  const LawProblem weighted(model, means, sigma, power);
  const auto problem = weighted.make();
  solution = solveLeastSquares(problem, {solution.x});
  setParameters(fit.law, solution.x);
  fitted = fittedMu(solution.x, means, power);
  fit.chiSquared = solution.sumOfSquares;

  for (int k = 0; k < fitParameters; ++k) {
    constexpr double near = 1e-9;
    const double range = std::isfinite(problem.upper[k]) ? problem.upper[k] : 1.0;
    fit.atBound[k] = !problem.constant[k] && (solution.x[k] - problem.lower[k] < near * range ||
                                              problem.upper[k] - solution.x[k] < near * range);
  }
  // Whether the conditions determine the parameters at all is asked of all of them. Errors are
  // those along the bound: (J^T J)^-1 is that of a minimum, which a bound across which the sum of
  // squares falls is not.
  const auto analysis = analyseJacobian(solution.jacobian, problem.constant);
  fit.conditionNumber = analysis.conditionNumber;
  fit.notIdentifiable = explainWeakness(fit, solution.x, analysis, problem);
  auto held = problem.constant;
  for (int k = 0; k < fitParameters; ++k)
    held[k] = held[k] || fit.atBound[k];
  fit.parameters = solution.x;
  fit.covariance = analyseJacobian(solution.jacobian, held).covariance;
  fit.law.covariance = fit.covariance.topLeftCorner<lawParameters, lawParameters>();
  if (third != ThirdNumber::None)
    fit.reference = power.reference;
  fit.law.n = n;
  fillResiduals(fit, means, fitted, sigma, solution.jacobian, fit.covariance);
  fit.law.kappa1Range = rangeOf(means, &ConditionMean::kappa1);
  fit.law.kappa2Range = rangeOf(means, &ConditionMean::kappa2);
  fit.law.kappa3Range = rangeOf(means, &ConditionMean::kappa3);
  if (third == ThirdNumber::Kappa3)
    fit.law.kappa3 = power.reference;
  if (third == ThirdNumber::Ductility)
    fit.law.ductility = power.reference;

  const int k = countParameters(model) + 1; // and the scatter
  fit.aicc =
      n > k + 1 ? minusTwoLogLikelihood(means, fitted) + 2.0 * k + 2.0 * k * (k + 1) / (n - k - 1.0)
                : std::numeric_limits<double>::infinity();
  if (level > 0.0 && fit.notIdentifiable.empty()) {
    const double t = studentQuantile(0.5 * (1.0 + level), fit.freedom);
    for (int j = 0; j < fitParameters; ++j) {
      if (problem.constant[j])
        continue;
      double error = std::sqrt(analysis.covariance(j, j));
      // a parameter at its bound has no curvature to measure: start the search at its own scale
      if (error == 0.0)
        error = std::max(0.1 * std::abs(solution.x[j]), 1e-3);
      fit.intervals[j] = profileInterval(problem, solution, j, error, t * t);
    }
  }
  return fit;
}

} // namespace wheelrail
