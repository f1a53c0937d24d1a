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
/// \return false where the residuals cannot be computed (the solver then takes a shorter step)
using Residuals =
    std::function<bool(const Eigen::VectorXd &x, Eigen::VectorXd &r, Eigen::MatrixXd *jacobian)>;

/// Minimise sum r_i(x)^2 within lower <= x <= upper.
struct LeastSquaresProblem {
  int parameters = 0; ///< length of x, >= 1
  int residuals = 0;  ///< length of r, >= 1
  Residuals evaluate; ///< called from one thread
  /// false: `evaluate` is never given a Jacobian to fill; it is taken from extrapolated
  /// central differences.
  bool hasJacobian = true;
  Eigen::VectorXd lower;      ///< empty: no bounds; else one per parameter, -infinity allowed
  Eigen::VectorXd upper;      ///< likewise, +infinity allowed
  std::vector<bool> constant; ///< parameters held at their start; empty: none
};

/// Where the solver came to; in the units of the problem.
struct LeastSquaresSolution {
  Eigen::VectorXd x;         ///< best parameters found, within the bounds
  double sumOfSquares = 0.0; ///< sum r_i(x)^2
  bool converged = false;    ///< to the rounding of double precision
  std::string message;       ///< why it did not, without a full stop; empty: it did
  Eigen::MatrixXd jacobian;  ///< dr_i/dx_j at x; nan where it cannot be computed there
};

/// Solves from each start (Ceres, Levenberg-Marquardt, dense QR; an active set for parameters at
/// bounds) and keeps the best solution; one that converged is better than one that did not.
/// \param starts at least one, within the bounds
/// \return the best, converged or not: `converged` is for the caller to look at
/// \throws std::invalid_argument if sizes disagree
LeastSquaresSolution solveLeastSquares(const LeastSquaresProblem &problem,
                                       const std::vector<Eigen::VectorXd> &starts);

/// A condition number beyond it: data of a few per cent scatter determine the parameters to no
/// digit.
constexpr double worstCondition = 1e6;

/// What a solution says about its parameters.
struct Identifiability {
  Eigen::MatrixXd covariance;    ///< (J^T J)^-1; rows and columns of fixed parameters are zero
  double conditionNumber = 0.0;  ///< of J with columns scaled to length 1; infinite if singular
  Eigen::VectorXd weakDirection; ///< combination of parameters (unit vector in units of 1/|column|)
                                 ///< that the data determine worst
};

/// From the Jacobian at a solution, by singular values; independent of the parameters' units.
/// \param jacobian residuals x parameters; residuals of unit variance make the covariance a true
/// one
/// \param isFixed one per parameter: held, or at a bound; those are left out
/// \return a covariance of zeros where the condition number is infinite
Identifiability analyseJacobian(const Eigen::MatrixXd &jacobian, const std::vector<bool> &isFixed);

/// Profile-likelihood interval of parameter k: the values at which the sum of squares, minimised
/// over the other parameters, exceeds its minimum by `rise`. An end that lies beyond a bound, or
/// that is not met within `reach` standard errors, is open. Ends are found to a millionth of the
/// standard error.
struct Interval {
  double lower = 0.0;     ///< in the unit of the parameter, as is `upper`
  double upper = 0.0;     ///< >= lower
  bool lowerOpen = false; ///< `lower` is then the bound, or -infinity
  bool upperOpen = false; ///< `upper` likewise, or +infinity
};
/// \param solution of solveLeastSquares; k: number of the parameter, not a constant one
/// \param standardError > 0, of the parameter: the first stride outwards
/// \param rise > 0, of the sum of squares; Student's t squared where residuals have unit variance
/// \param reach in standard errors: how far an end is looked for
Interval profileInterval(const LeastSquaresProblem &problem, const LeastSquaresSolution &solution,
                         int k, double standardError, double rise, double reach = 50.0);

} // namespace wheelrail

#endif
