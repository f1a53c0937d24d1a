// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/least_squares.h"

#include <Eigen/SVD>
#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <glog/logging.h>
#include <limits>
#include <stdexcept>

namespace wheelrail {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Central differences at three steps, extrapolated twice (error of the sixth order in the step).
/// Steps are relative to the parameter: Ceres' own differences have a least absolute step, which
/// spoils parameters as small as those of the NIST problems.
bool numericalJacobian(const LeastSquaresProblem &problem, const Eigen::VectorXd &x,
                       Eigen::MatrixXd &jacobian)
{
  constexpr double relativeStep = 2e-3;
  Eigen::VectorXd plus(problem.residuals);
  Eigen::VectorXd minus(problem.residuals);
  Eigen::VectorXd moved = x;
  for (int j = 0; j < problem.parameters; ++j) {
    std::array<Eigen::VectorXd, 3> difference;
    double step = relativeStep * (x[j] != 0.0 ? std::abs(x[j]) : 1.0);
    for (auto &d : difference) {
      moved[j] = x[j] + step;
      const double up = moved[j];
      if (!problem.evaluate(moved, plus, nullptr))
        return false;
      moved[j] = x[j] - step;
      if (!problem.evaluate(moved, minus, nullptr))
        return false;
      d = (plus - minus) / (up - moved[j]);
      step *= 0.5;
    }
    moved[j] = x[j];
    const Eigen::VectorXd coarse = (4.0 * difference[1] - difference[0]) / 3.0;
    const Eigen::VectorXd fine = (4.0 * difference[2] - difference[1]) / 3.0;
    jacobian.col(j) = (16.0 * fine - coarse) / 15.0;
  }
  return true;
}

/// The problem as Ceres asks for it.
class Cost : public ceres::CostFunction {
 public:
  explicit Cost(const LeastSquaresProblem &given) : problem_(given)
  {
    set_num_residuals(problem_.residuals);
    mutable_parameter_block_sizes()->push_back(problem_.parameters);
  }

  bool Evaluate(double const *const *parameters, double *residuals,
                double **jacobians) const override
  {
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], problem_.parameters);
    Eigen::VectorXd r(problem_.residuals);
    Eigen::MatrixXd jacobian;
    const bool wanted = jacobians != nullptr && jacobians[0] != nullptr;
    if (wanted)
      jacobian.setZero(problem_.residuals, problem_.parameters);
    if (!problem_.evaluate(x, r, wanted && problem_.hasJacobian ? &jacobian : nullptr))
      return false;
    if (wanted && !problem_.hasJacobian && !numericalJacobian(problem_, x, jacobian))
      return false;
    // Ceres would print all of them
    if (!r.allFinite() || !jacobian.allFinite())
      return false;
    Eigen::Map<Eigen::VectorXd>(residuals, problem_.residuals) = r;
    if (wanted)
      Eigen::Map<RowMajor>(jacobians[0], problem_.residuals, problem_.parameters) = jacobian;
    return true;
  }

 private:
  const LeastSquaresProblem &problem_;
};

void checkSizes(const LeastSquaresProblem &problem, const std::vector<Eigen::VectorXd> &starts)
{
  const auto fits = [&](Eigen::Index size) { return size == 0 || size == problem.parameters; };
  if (starts.empty())
    throw std::invalid_argument("least squares: no start");
  for (const auto &start : starts)
    if (start.size() != problem.parameters)
      throw std::invalid_argument("least squares: a start of another size than the parameters");
  if (!fits(problem.lower.size()) || !fits(problem.upper.size()) ||
      !fits(static_cast<Eigen::Index>(problem.constant.size())))
    throw std::invalid_argument("least squares: bounds of another size than the parameters");
}

/// Residuals and their Jacobian; false where they are not finite.
bool linearise(const LeastSquaresProblem &problem, const Eigen::VectorXd &x, Eigen::VectorXd &r,
               RowMajor &jacobian)
{
  r.resize(problem.residuals);
  jacobian.resize(problem.residuals, problem.parameters);
  const double *parameters = x.data();
  double *rows = jacobian.data();
  return Cost(problem).Evaluate(&parameters, r.data(), &rows);
}

using Held = std::vector<bool>; // one per parameter

/// The problem's constants, and the parameters at a bound across which the sum would fall.
Held heldAt(const LeastSquaresProblem &problem, const Eigen::VectorXd &x)
{
  Held held = problem.constant;
  held.resize(problem.parameters, false);
  Eigen::VectorXd r;
  RowMajor jacobian;
  if (!linearise(problem, x, r, jacobian))
    return held;
  const Eigen::VectorXd rise = jacobian.transpose() * r;
  for (int i = 0; i < problem.parameters; ++i)
    if ((problem.lower.size() > 0 && x[i] <= problem.lower[i] && rise[i] >= 0.0) ||
        (problem.upper.size() > 0 && x[i] >= problem.upper[i] && rise[i] <= 0.0))
      held[i] = true;
  return held;
}

LeastSquaresSolution solveFrom(const LeastSquaresProblem &problem, const Eigen::VectorXd &start,
                               const Held &held)
{
  LeastSquaresSolution solution;
  solution.x = start;
  ceres::Problem ceresProblem;
  double *x = solution.x.data();
  ceresProblem.AddResidualBlock(new Cost(problem), nullptr, x);
  for (int i = 0; i < problem.parameters; ++i) {
    if (problem.lower.size() > 0)
      ceresProblem.SetParameterLowerBound(x, i, problem.lower[i]);
    if (problem.upper.size() > 0)
      ceresProblem.SetParameterUpperBound(x, i, problem.upper[i]);
  }
  std::vector<int> constant;
  for (size_t i = 0; i < held.size(); ++i)
    if (held[i])
      constant.push_back(static_cast<int>(i));
  if (static_cast<int>(constant.size()) == problem.parameters)
    ceresProblem.SetParameterBlockConstant(x);
  else if (!constant.empty())
    ceresProblem.SetManifold(x, new ceres::SubsetManifold(problem.parameters, constant));

  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 2000;
  options.function_tolerance = 1e-16; // as far as double precision goes: the problems are small
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  options.max_num_consecutive_invalid_steps = 50;
  FLAGS_minloglevel = google::GLOG_FATAL; // errors are said by us, in our words
  ceres::Solver::Summary summary;
  ceres::Solve(options, &ceresProblem, &summary);
  solution.sumOfSquares = 2.0 * summary.final_cost;
  solution.converged = summary.termination_type == ceres::CONVERGENCE;
  if (!solution.converged)
    solution.message = summary.termination_type == ceres::NO_CONVERGENCE
                           ? fmt::format("{} steps are not enough", options.max_num_iterations)
                           : "there are no finite residuals near the best parameters found";
  return solution;
}

/// Ceres cuts its steps off at bounds, and where one is met it ends short of the least sum along
/// the bound. So what lies at a bound is held there, the others are solved for again, and what
/// would then go inwards is let go: an active set.
LeastSquaresSolution solveWithinBounds(const LeastSquaresProblem &problem,
                                       const Eigen::VectorXd &start)
{
  Held held = problem.constant;
  held.resize(problem.parameters, false);
  LeastSquaresSolution solution = solveFrom(problem, start, held);
  for (int round = 0; round < 2 * problem.parameters && solution.converged; ++round) {
    Held next = heldAt(problem, solution.x);
    if (next == held)
      break;
    held = std::move(next);
    LeastSquaresSolution along = solveFrom(problem, solution.x, held);
    if (!along.converged || along.sumOfSquares > solution.sumOfSquares)
      break;
    solution = std::move(along);
  }
  return solution;
}

Eigen::MatrixXd jacobianAt(const LeastSquaresProblem &problem, const Eigen::VectorXd &x)
{
  Eigen::VectorXd r;
  RowMajor jacobian;
  if (!linearise(problem, x, r, jacobian))
    jacobian.setConstant(std::numeric_limits<double>::quiet_NaN());
  return jacobian;
}

} // namespace

LeastSquaresSolution solveLeastSquares(const LeastSquaresProblem &problem,
                                       const std::vector<Eigen::VectorXd> &starts)
{
  checkSizes(problem, starts);
  LeastSquaresSolution best;
  best.sumOfSquares = infinity;
  for (const auto &start : starts) {
    auto solution = solveWithinBounds(problem, start);
    const bool better = solution.sumOfSquares < best.sumOfSquares;
    // whatever comes first, then what converged, then what is lower
    if (best.x.size() == 0 || (solution.converged && !best.converged) ||
        (better && solution.converged == best.converged))
      best = std::move(solution);
  }
  best.jacobian = jacobianAt(problem, best.x);
  return best;
}

Identifiability analyseJacobian(const Eigen::MatrixXd &jacobian, const std::vector<bool> &isFixed)
{
  std::vector<Eigen::Index> free;
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j)
    if (!isFixed[j])
      free.push_back(j);
  Identifiability result;
  result.covariance.setZero(jacobian.cols(), jacobian.cols());
  result.weakDirection.setZero(jacobian.cols());
  result.conditionNumber = 1.0;
  if (free.empty())
    return result;

  // Columns of length 1: a condition number that no unit of a parameter changes. (J'J)^-1 = V S^-2
  // V' from the singular values; forming J'J would square the condition number.
  const auto k = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd scaled(jacobian.rows(), k);
  Eigen::VectorXd length(k);
  for (Eigen::Index j = 0; j < k; ++j) {
    length[j] = jacobian.col(free[j]).norm();
    scaled.col(j) = length[j] > 0.0 ? Eigen::VectorXd(jacobian.col(free[j]) / length[j])
                                    : Eigen::VectorXd::Zero(jacobian.rows());
  }
  if (!scaled.allFinite()) {
    result.conditionNumber = infinity;
    return result;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const auto &values = svd.singularValues();
  const bool wide = jacobian.rows() < k; // fewer data than parameters
  const double least = wide ? 0.0 : values[k - 1];
  result.conditionNumber = least > 0.0 ? values[0] / least : infinity;
  const Eigen::VectorXd weak = svd.matrixV().col(svd.matrixV().cols() - 1);
  for (Eigen::Index j = 0; j < k; ++j)
    result.weakDirection[free[j]] = weak[j];
  if (!std::isfinite(result.conditionNumber))
    return result;

  const Eigen::MatrixXd half = svd.matrixV() * values.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd inverse = half * half.transpose();
  for (Eigen::Index i = 0; i < k; ++i)
    for (Eigen::Index j = 0; j < k; ++j)
      result.covariance(free[i], free[j]) = inverse(i, j) / (length[i] * length[j]);
  return result;
}

namespace {

/// One end of a profile interval; direction is -1 or +1.
class ProfileEnd {
 public:
  ProfileEnd(const LeastSquaresProblem &given, const LeastSquaresSolution &solution, int parameter,
             double allowedRise)
      : problem_(given), k_(parameter), minimum_(solution.sumOfSquares), rise_(allowedRise),
        nearest_(solution.x)
  {
    if (problem_.constant.empty())
      problem_.constant.assign(problem_.parameters, false);
    problem_.constant[k_] = true;
  }

  /// sqrt((S(value) - S_min)/rise): 1 at the end looked for, nearly linear in between.
  double operator()(double value)
  {
    Eigen::VectorXd start = nearest_;
    start[k_] = value;
    const auto solution = solveLeastSquares(problem_, {start});
    nearest_ = solution.x;
    return std::sqrt(std::max(0.0, solution.sumOfSquares - minimum_) / rise_);
  }

 private:
  LeastSquaresProblem problem_;
  int k_;
  double minimum_, rise_;
  Eigen::VectorXd nearest_; // warm start
};

} // namespace

// The curve S(x_k), minimised over the other parameters, is a parabola where the problem is linear;
// its root, which `ProfileEnd` gives, is then a straight line through the best value (the profile t
// of Bates and Watts, Nonlinear Regression Analysis, 1988, ch. 6) and nearly one elsewhere. Strides
// of growing length lead out of the interval, then a bracketing search closes in between values
// that were computed; each minimum is the start of the next.
Interval profileInterval(const LeastSquaresProblem &problem, const LeastSquaresSolution &solution,
                         int k, double standardError, double rise, double reach)
{
  const double best = solution.x[k];
  const auto findEnd = [&](double direction, double bound, double &end, bool &open) {
    ProfileEnd profile(problem, solution, k, rise);
    double inside = best;
    double atInside = 0.0;
    double stride = standardError;
    double outside = best;
    double atOutside = 0.0;
    // outwards until the end is behind us
    while (true) {
      outside = best + direction * stride;
      const bool beyond = direction * (outside - bound) >= 0.0;
      if (beyond)
        outside = bound;
      atOutside = profile(outside);
      if (atOutside >= 1.0)
        break;
      if (beyond || stride > reach * standardError) {
        open = true;
        end = beyond ? bound : direction * infinity;
        return;
      }
      inside = outside;
      atInside = atOutside;
      stride *= 1.7;
    }
    constexpr double tolerance = 1e-6;
    const auto near = [&](double a, double b) { return b - a <= tolerance * standardError; };
    const auto excess = [&](double value) { return profile(value) - 1.0; };
    const bool upwards = outside > inside;
    std::uintmax_t steps = 60;
    const auto bracket = boost::math::tools::toms748_solve(
        excess, upwards ? inside : outside, upwards ? outside : inside,
        (upwards ? atInside : atOutside) - 1.0, (upwards ? atOutside : atInside) - 1.0, near,
        steps);
    end = 0.5 * (bracket.first + bracket.second);
  };
  Interval interval;
  double lowest = -infinity, highest = infinity;
  if (problem.lower.size() > 0)
    lowest = problem.lower[k];
  if (problem.upper.size() > 0)
    highest = problem.upper[k];
  findEnd(-1.0, lowest, interval.lower, interval.lowerOpen);
  findEnd(1.0, highest, interval.upper, interval.upperOpen);
  return interval;
}

} // namespace wheelrail
