// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_LEAST_SQUARES_H
#define WHEELRAIL_BASE_LEAST_SQUARES_H

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace wheelrail {

/// Residuals r(x) of a least-squares problem; fills `jacobian` (residuals x parameters, dr_i/dx_j)
/// too unless it is null. Weights belong into the residuals.
/// @return false where the residuals cannot be computed (the solver then takes a shorter step)
using Residuals =
    std::function<bool(const Eigen::VectorXd &x, Eigen::VectorXd &r, Eigen::MatrixXd *jacobian)>;

/// Minimise sum r_i(x)^2 within lower <= x <= upper.
struct LeastSquaresProblem {
  int parameters = 0;
  int residuals = 0;
  Residuals evaluate;
  /// false: `evaluate` is never given a Jacobian to fill; it is taken from extrapolated
  /// central differences.
  bool hasJacobian = true;
  Eigen::VectorXd lower; ///< empty: no bounds; else one per parameter, -infinity allowed
  Eigen::VectorXd upper;
  std::vector<bool> constant; ///< parameters held at their start; empty: none
};

/// Where the solver came to; in the units of the problem.
struct LeastSquaresSolution {
  Eigen::VectorXd x;
  double sumOfSquares = 0.0;
  bool converged = false;
  std::string message;      ///< the solver's own words, without a full stop
  Eigen::MatrixXd jacobian; ///< at x; empty unless asked for
};

/// Solves from each start (Ceres, Levenberg-Marquardt, dense QR) and keeps the best solution.
/// @param starts at least one, within the bounds
/// @throws std::invalid_argument if sizes disagree
LeastSquaresSolution solveLeastSquares(const LeastSquaresProblem &problem,
                                       const std::vector<Eigen::VectorXd> &starts);

/// What a solution says about its parameters.
struct Identifiability {
  Eigen::MatrixXd covariance;    ///< (J^T J)^-1; rows and columns of fixed parameters are zero
  double conditionNumber = 0.0;  ///< of J with columns scaled to length 1; infinite if singular
  Eigen::VectorXd weakDirection; ///< combination of parameters (unit vector in units of 1/|column|)
                                 ///< that the data determine worst
};

/// From the Jacobian at a solution; parameters with isFixed (held, or at a bound) are left out.
Identifiability analyseJacobian(const Eigen::MatrixXd &jacobian, const std::vector<bool> &isFixed);

/// Profile-likelihood interval of parameter k: the values at which the sum of squares, minimised
/// over the other parameters, exceeds its minimum by `rise`. An end that lies beyond a bound, or
/// that is not met within `reach` standard errors, is open. Ends are found to a millionth of the
/// standard error.
struct Interval {
  double lower = 0.0;
  double upper = 0.0;
  bool lowerOpen = false; ///< `lower` is then the bound, or -infinity
  bool upperOpen = false;
};
/// @param solution of solveLeastSquares; k: number of the parameter, not a constant one
/// @param standardError > 0, of the parameter: the first stride outwards
/// @param rise > 0, of the sum of squares; Student's t squared where residuals have unit variance
Interval profileInterval(const LeastSquaresProblem &problem, const LeastSquaresSolution &solution,
                         int k, double standardError, double rise, double reach = 50.0);

} // namespace wheelrail

#endif
