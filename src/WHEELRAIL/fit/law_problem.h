// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_LAW_PROBLEM_H
#define WHEELRAIL_FIT_LAW_PROBLEM_H

#include "base/least_squares.h"
#include "fit/law_model.h"

#include <utility>
#include <vector>

namespace wheelrail {

/// Puts Eq. 2's parameters of a vector into a law; n, s and q are not part of it.
void setParameters(KappaLaw &law, const Eigen::VectorXd &x);

/// What a model has a power of, and at which value, > 0, the power is 1.
struct PowerOf {
  ThirdNumber number = ThirdNumber::None;
  double reference = 1.0;

  double over(const ConditionMean &mean) const { return valueOf(number, mean) / reference; }
};

/// `boundedMu` of a condition, with the parameters x.
/// \return mu, a pure number
double modelMu(const Eigen::VectorXd &x, const ConditionMean &mean, const PowerOf &power);

/// What a model fits, as a weighted least-squares problem in the `parameterNames`, with analytic
/// derivatives. Bounds: mu0, b, c, s1, d >= 0; b, c, d at most a hundred times the inverse of the
/// smallest positive kappa, where their terms are constant; s > 0 up to a hundred times the largest
/// friction stress over sigma_0, which no condition feels; q from 1 to 50, a bend that is as good
/// as sharp. All parameters and residuals are dimensionless.
class LawProblem {
 public:
  /// \param deviations standard deviation of each condition, > 0
  /// The conditions must outlive the problem.
  LawProblem(LawModel model, const std::vector<ConditionMean> &data, Eigen::VectorXd deviations,
             const PowerOf &power);

  /// For solveLeastSquares; refers to *this.
  /// The object must outlive what it returns.
  LeastSquaresProblem make() const;

  /// Starts: n = 0 and a grid over b, c and the limit with the linear parameters by linear least
  /// squares, the best three.
  /// \param problem  of `make`, which judges the candidates
  std::vector<Eigen::VectorXd> starts(const LeastSquaresProblem &problem) const;

 private:
  /// Smallest positive value of kappa1 or kappa2 over the conditions, 1 without one.
  double smallest(double ConditionMean::*kappa) const;
  /// Largest mu p/sigma_0 over the conditions.
  double largestStress() const;
  /// Values of b, c or d to start from; just 0 where it is not fitted.
  std::vector<double> grid(int k, double upper) const;
  /// Values of s, q, s1 and d to start from, the others 0; all 0 where they are not fitted.
  std::vector<Eigen::VectorXd> limits(double largestD) const;
  /// Sum of squares and parameters of the best mu0, mu1, mu2 where the others are given.
  std::pair<double, Eigen::VectorXd> linearFit(Eigen::VectorXd x) const;
  /// Residuals in units of the deviations, and their derivatives unless null.
  void evaluate(const Eigen::VectorXd &x, Eigen::VectorXd &r, Eigen::MatrixXd *jacobian) const;

  const std::vector<ConditionMean> &means_;
  Eigen::VectorXd sigma_;
  PowerOf power_;
  std::array<bool, fitParameters> free_;
};

} // namespace wheelrail

#endif
