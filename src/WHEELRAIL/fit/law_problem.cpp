// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/law_problem.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wheelrail {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
// a term is as good as constant when b kappa (c kappa) exceeds this at its smallest kappa
constexpr double saturation = 100.0;
// largest bend of the bound: where both of its sides are equal, mu is 0.986 of them
constexpr double sharpest = 50.0;

} // namespace

void setParameters(KappaLaw &law, const VectorXd &x)
{
  law.mu0 = x[Mu0];
  law.mu1 = x[Mu1];
  law.mu2 = x[Mu2];
  law.b = x[B];
  law.c = x[C];
}

double modelMu(const VectorXd &x, const ConditionMean &mean, const PowerOf &power)
{
  return boundedMu(x, {mean.kappa1, mean.kappa2, mean.kappa3}, power.over(mean));
}

LawProblem::LawProblem(LawModel model, const std::vector<ConditionMean> &data, VectorXd deviations,
                       const PowerOf &power)
    : means_(data), sigma_(std::move(deviations)), power_(power), free_(parametersOf(model))
{
}

LeastSquaresProblem LawProblem::make() const
{
  LeastSquaresProblem problem;
  problem.parameters = fitParameters;
  problem.residuals = static_cast<int>(means_.size());
  problem.lower = VectorXd::Constant(fitParameters, -infinity);
  problem.upper = VectorXd::Constant(fitParameters, infinity);
  for (int k : {Mu0, B, C, S1, D})
    problem.lower[k] = 0.0;
  problem.upper[B] = problem.upper[D] = saturation / smallest(&ConditionMean::kappa1);
  problem.upper[C] = saturation / smallest(&ConditionMean::kappa2);
  if (free_[S]) {
    problem.lower[S] = largestStress() / saturation;
    problem.upper[S] = largestStress() * saturation;
    problem.lower[Q] = roundestBend;
    problem.upper[Q] = sharpest;
  }
  for (bool isFree : free_)
    problem.constant.push_back(!isFree);
  problem.evaluate = [this](const VectorXd &x, VectorXd &r, MatrixXd *jacobian) {
    evaluate(x, r, jacobian);
    return true;
  };
  return problem;
}

// Eq. 2 is linear in mu0, mu1 and mu2 once b and c are given, which leaves a plane to be searched:
// a grid of it, two values a decade, finds the valley that a single start would have to hit. So it
// is with a bound, once its parameters are given.
std::vector<VectorXd> LawProblem::starts(const LeastSquaresProblem &problem) const
{
  std::vector<std::pair<double, VectorXd>> candidates;
  for (double b : grid(B, problem.upper[B]))
    for (double c : grid(C, problem.upper[C]))
      for (VectorXd x : limits(problem.upper[D])) {
        x[B] = b;
        x[C] = c;
        candidates.push_back(linearFit(std::move(x)));
      }
  const size_t kept = std::min<size_t>(3, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + kept, candidates.end(),
                    [](const auto &p, const auto &q) { return p.first < q.first; });
  std::vector<VectorXd> result;
  for (size_t i = 0; i < kept; ++i)
    result.push_back(candidates[i].second);
  return result;
}

double LawProblem::smallest(double ConditionMean::*kappa) const
{
  double least = infinity;
  for (const auto &mean : means_)
    if (mean.*kappa > 0.0)
      least = std::min(least, mean.*kappa);
  return std::isfinite(least) ? least : 1.0;
}

double LawProblem::largestStress() const
{
  double largest = 0.0;
  for (const auto &mean : means_)
    largest = std::max(largest, mean.mu * mean.kappa2 / mean.kappa3);
  return largest > 0.0 ? largest : 1.0;
}

std::vector<VectorXd> LawProblem::limits(double largestD) const
{
  if (!free_[S])
    return {VectorXd::Zero(fitParameters)};
  const std::vector<double> rises = free_[S1] ? std::vector{1.0, 4.0} : std::vector{0.0};
  std::vector<VectorXd> values;
  for (const double most : {1.02, 1.3, 2.0}) // of the largest stress that is there
    for (const double q : {1.5, 4.0, 12.0})
      for (const double d : grid(D, largestD))
        for (const double rise : rises) { // from rest to the largest speed
          VectorXd x = VectorXd::Zero(fitParameters);
          x[S] = most * largestStress() / (1.0 + rise);
          x[Q] = q;
          x[D] = d;
          x[S1] = rise * x[S] * d;
          values.push_back(std::move(x));
        }
  return values;
}

std::vector<double> LawProblem::grid(int k, double upper) const
{
  if (!free_[k])
    return {0.0};
  std::vector<double> values;
  constexpr int perDecade = 2;
  constexpr int count = 13; // six decades below the bound
  for (int i = 1; i < count; ++i)
    values.push_back(upper * std::pow(10.0, -static_cast<double>(i) / perDecade));
  return values;
}

// A bound is taken off first: what mu would be without it follows from mu, s and q. A condition at
// its limit says nothing of it and is left out.
std::pair<double, VectorXd> LawProblem::linearFit(VectorXd x) const
{
  const double s = std::exchange(x[S], 0.0), q = x[Q];
  std::vector<int> linear;
  for (int k : {Mu0, Mu1, Mu2})
    if (free_[k])
      linear.push_back(k);
  // at mu0 = mu1 = mu2 = 0 the residuals are minus the data and the derivatives the design matrix
  VectorXd r(means_.size());
  MatrixXd jacobian(means_.size(), fitParameters);
  evaluate(x, r, &jacobian);
  MatrixXd design(means_.size(), linear.size());
  for (size_t j = 0; j < linear.size(); ++j)
    design.col(j) = jacobian.col(linear[j]);
  VectorXd target = -r;
  for (size_t i = 0; s > 0.0 && i < means_.size(); ++i) {
    const ConditionMean &mean = means_[i];
    const double limit = s + x[S1] * mean.kappa1 / (1.0 + x[D] * mean.kappa1);
    const double limited = std::pow(mean.mu * mean.kappa2 / (mean.kappa3 * limit), q);
    constexpr double far = 0.9; // beyond, the rest is small beside the scatter
    target[i] = limited < far ? target[i] * std::pow(1.0 - limited, -1.0 / q) : 0.0;
    if (limited >= far)
      design.row(i).setZero();
  }
  const VectorXd solution = design.colPivHouseholderQr().solve(target);
  for (size_t j = 0; j < linear.size(); ++j)
    x[linear[j]] = solution[j];
  x[Mu0] = std::max(0.0, x[Mu0]);
  x[S] = s;
  evaluate(x, r, nullptr);
  return {r.squaredNorm(), x};
}

void LawProblem::evaluate(const VectorXd &x, VectorXd &r, MatrixXd *jacobian) const
{
  for (size_t i = 0; i < means_.size(); ++i) {
    const auto &mean = means_[i];
    const double weight = 1.0 / sigma_[i];
    LawParameters gradient;
    const double mu = boundedMu(x, {mean.kappa1, mean.kappa2, mean.kappa3}, power_.over(mean),
                                jacobian ? &gradient : nullptr);
    r[i] = weight * (mu - mean.mu);
    if (jacobian)
      jacobian->row(i) = weight * gradient.transpose();
  }
}

} // namespace wheelrail
