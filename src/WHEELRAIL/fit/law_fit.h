// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_LAW_FIT_H
#define WHEELRAIL_FIT_LAW_FIT_H

#include "base/least_squares.h"
#include "fit/law_model.h"
#include "law/kappa_law.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

/// A fitted law and how much it is worth.
///
/// The residuals are weighted with 1/sigma_i, sigma_i^2 = mu_se_i^2 + (scatter mu_fit_i)^2. The
/// scatter is what runs differ by beyond their own standard errors, relative to mu; it is the
/// value that makes chi^2 equal to the degrees of freedom (Paule and Mandel, J. Res. NBS 87
/// (1982) 377), zero if the standard errors alone explain the residuals. The covariance is (J^T
/// J)^-1 with these weights; a parameter at its bound counts as held in it, with an error of 0, and
/// in the leverage, which says how far the fit follows each condition. The condition number counts
/// it as free.
struct LawFit {
  LawModel model = LawModel::Full;
  KappaLaw law; ///< Eq. 2's parameters and what it was fitted on; with a power of a third number:
                ///< at the reference; without a bound
  LawParameters parameters = LawParameters::Zero();               ///< all of them
  Eigen::Matrix<double, allParameters, allParameters> covariance; ///< of all of them
  double reference = 0.0;       ///< third number at which the law holds; 0: it has none
  double scatter = 0.0;         ///< relative
  double chiSquared = 0.0;      ///< sum of the weighted squares
  int freedom = 0;              ///< conditions minus parameters
  double conditionNumber = 0.0; ///< of the Jacobian with columns of length 1
  double aicc = 0.0;            ///< Akaike's criterion for small samples; the scatter counts too
  std::array<bool, fitParameters> atBound = {}; ///< the best value lies on a bound
  std::array<Interval, fitParameters>
      intervals;                   ///< profile likelihood; empty for what is not fitted
  std::vector<double> residuals;   ///< (mu - fit)/fit of every condition
  std::vector<double> studentised; ///< residual in units of its own standard deviation
  std::vector<double> leverage;    ///< 0 .. 1; parameters/conditions on average
  /// Why the parameters cannot be told apart; empty if they can.
  std::string notIdentifiable;
};

/// Absolute studentised residual beyond which a condition is reported as an outlier.
constexpr double outlierLimit = 3.0;

/// What keeps these conditions from being fitted with this model at all: too few of them, too few
/// different kappa1, kappa2 or third numbers. Empty: nothing.
struct Obstacle {
  std::string reason;
  bool tooFew = false; ///< more conditions would help whatever they are
};
/// Asks for more conditions than parameters and for as many different kappas as the terms need.
Obstacle obstacleTo(LawModel model, const std::vector<ConditionMean> &means);

/// Weighted least squares with mu0, b, c >= 0, started from the best places of a grid over b and c
/// with the linear parameters solved for.
/// \param level of the confidence intervals, 0 < level < 1; 0: none are computed
/// \param reference third number > 0 at which the law is to hold, where the model has a power of
///        one; 0: the geometric mean of the conditions
/// \throws Error (NotConverged) if obstacleTo names an obstacle or the solver does not converge
/// \throws std::invalid_argument for values that are not finite, negative kappas, negative errors
LawFit fitLaw(LawModel model, const std::vector<ConditionMean> &means, double level = 0.95,
              double reference = 0.0);

} // namespace wheelrail

#endif
