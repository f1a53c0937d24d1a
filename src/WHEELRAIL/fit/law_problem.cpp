// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/law_problem.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
// a term is as good as constant when b kappa (c kappa) exceeds this at its smallest kappa
constexpr double saturation = 100.0;

} // namespace

void setParameters(KappaLaw &law, const VectorXd &x)
{
  law.mu0 = x[Mu0];
  law.mu1 = x[Mu1];
  law.mu2 = x[Mu2];
  law.b = x[B];
  law.c = x[C];
}

double modelMu(const VectorXd &x, const ConditionMean &mean, double reference)
{
  KappaLaw law;
  setParameters(law, x);
  return law(mean.kappa1, mean.kappa2) * std::pow(mean.kappa3 / reference, x[N]);
}

LawProblem::LawProblem(LawModel model, const std::vector<ConditionMean> &data, VectorXd deviations,
                       double kappa3)
    : means_(data), sigma_(std::move(deviations)), reference_(kappa3), free_(parametersOf(model))
{
}

LeastSquaresProblem LawProblem::make() const
{
  LeastSquaresProblem problem;
  problem.parameters = fitParameters;
  problem.residuals = static_cast<int>(means_.size());
  problem.lower = VectorXd::Constant(fitParameters, -infinity);
  problem.upper = VectorXd::Constant(fitParameters, infinity);
  for (int k : {Mu0, B, C})
    problem.lower[k] = 0.0;
  problem.upper[B] = saturation / smallest(&ConditionMean::kappa1);
  problem.upper[C] = saturation / smallest(&ConditionMean::kappa2);
  for (bool isFree : free_)
    problem.constant.push_back(!isFree);
  problem.evaluate = [this](const VectorXd &x, VectorXd &r, MatrixXd *jacobian) {
    evaluate(x, r, jacobian);
    return true;
  };
  return problem;
}

// Eq. 2 is linear in mu0, mu1 and mu2 once b and c are given, which leaves a plane to be searched:
// a grid of it, two values a decade, finds the valley that a single start would have to hit.
std::vector<VectorXd> LawProblem::starts(const LeastSquaresProblem &problem) const
{
  std::vector<std::pair<double, VectorXd>> candidates;
  for (double b : grid(B, problem.upper[B]))
    for (double c : grid(C, problem.upper[C]))
      candidates.push_back(linearFit(b, c));
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

std::pair<double, VectorXd> LawProblem::linearFit(double b, double c) const
{
  VectorXd x = VectorXd::Zero(fitParameters);
  x[B] = b;
  x[C] = c;
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
  const VectorXd solution = design.colPivHouseholderQr().solve(-r);
  for (size_t j = 0; j < linear.size(); ++j)
    x[linear[j]] = solution[j];
  x[Mu0] = std::max(0.0, x[Mu0]);
  evaluate(x, r, nullptr);
  return {r.squaredNorm(), x};
}

void LawProblem::evaluate(const VectorXd &x, VectorXd &r, MatrixXd *jacobian) const
{
  KappaLaw law;
  setParameters(law, x);
  for (size_t i = 0; i < means_.size(); ++i) {
    const auto &mean = means_[i];
    const double weight = 1.0 / sigma_[i];
    const double mu = modelMu(x, mean, reference_);
    r[i] = weight * (mu - mean.mu);
    if (!jacobian)
      continue;
    const double logarithm = std::log(mean.kappa3 / reference_);
    const double w = weight * std::exp(x[N] * logarithm);
    const double g1 = 1.0 / (1.0 + law.b * mean.kappa1);
    const double g2 = 1.0 / (1.0 + law.c * mean.kappa2);
    (*jacobian)(i, Mu0) = w;
    (*jacobian)(i, Mu1) = w * mean.kappa1 * g1;
    (*jacobian)(i, Mu2) = w * g2;
    (*jacobian)(i, B) = -w * law.mu1 * std::pow(mean.kappa1 * g1, 2);
    (*jacobian)(i, C) = -w * law.mu2 * mean.kappa2 * g2 * g2;
    (*jacobian)(i, N) = weight * mu * logarithm;
  }
}

} // namespace wheelrail
