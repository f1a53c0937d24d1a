// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/least_squares.h"
#include "nist.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

using namespace wheelrail;
using Eigen::VectorXd;

namespace {

using Model = std::function<double(const VectorXd &b, double x)>;

struct NistCase {
  const char *name;
  Model model;
  int parameterDigits; ///< significant digits of parameters and their deviations that are asked for
  bool alone = true; ///< from each start by itself; false: from both, as our own fits have several
};

std::ostream &operator<<(std::ostream &out, const NistCase &c)
{
  return out << c.name;
}

double cubicOverCubic(const VectorXd &b, double x)
{
  return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1 + x * (b[4] + x * (b[5] + x * b[6])));
}

LeastSquaresProblem asProblem(const NistProblem &data, const Model &model)
{
  LeastSquaresProblem problem;
  problem.parameters = static_cast<int>(data.certified.size());
  problem.residuals = static_cast<int>(data.x.size());
  problem.hasJacobian = false;
  problem.evaluate = [&data, model](const VectorXd &b, VectorXd &r, Eigen::MatrixXd *) {
    for (size_t i = 0; i < data.x.size(); ++i)
      r[i] = data.y[i] - model(b, data.x[i]);
    return r.allFinite();
  };
  return problem;
}

/// NIST's log relative error: how many leading digits agree.
double digits(double value, double certified)
{
  return -std::log10(std::abs(value - certified) / std::abs(certified) + 1e-16);
}

class Nist : public testing::TestWithParam<NistCase> {};

} // namespace

// The certified values are given to 11 digits. BoxBOD's start 1 lies on a plateau that no descent
// leaves: there the two starts are tried together.
TEST_P(Nist, certifiedValuesFromBothStarts)
{
  const auto &c = GetParam();
  const auto data = readNist(std::string(TEST_DATA) + "/nist/" + c.name + ".dat");
  const auto problem = asProblem(data, c.model);
  for (const auto &start : data.starts) {
    const auto solution =
        c.alone ? solveLeastSquares(problem, {start}) : solveLeastSquares(problem, data.starts);
    EXPECT_GE(digits(solution.sumOfSquares, data.sumOfSquares), c.parameterDigits);
    const int freedom = problem.residuals - problem.parameters;
    const auto analysis =
        analyseJacobian(solution.jacobian, std::vector<bool>(problem.parameters, false));
    for (int k = 0; k < problem.parameters; ++k) {
      EXPECT_GE(digits(solution.x[k], data.certified[k]), c.parameterDigits) << "b" << k + 1;
      const double deviation =
          std::sqrt(analysis.covariance(k, k) * solution.sumOfSquares / freedom);
      EXPECT_GE(digits(deviation, data.deviation[k]), c.parameterDigits - 1) << "b" << k + 1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    StRD, Nist,
    testing::Values(
        NistCase{"Misra1a",
                 [](const VectorXd &b, double x) { return b[0] * -std::expm1(-b[1] * x); }, 8},
        NistCase{
            "Misra1b",
            [](const VectorXd &b, double x) { return b[0] * (1 - std::pow(1 + b[1] * x / 2, -2)); },
            8},
        NistCase{"Misra1c",
                 [](const VectorXd &b, double x) {
                   return b[0] * (1 - std::pow(1 + 2 * b[1] * x, -0.5));
                 },
                 8},
        NistCase{"Misra1d",
                 [](const VectorXd &b, double x) { return b[0] * b[1] * x / (1 + b[1] * x); }, 8},
        NistCase{"DanWood", [](const VectorXd &b, double x) { return b[0] * std::pow(x, b[1]); },
                 8},
        NistCase{
            "Chwirut2",
            [](const VectorXd &b, double x) { return std::exp(-b[0] * x) / (b[1] + b[2] * x); }, 8},
        NistCase{"Lanczos3",
                 [](const VectorXd &b, double x) {
                   return b[0] * std::exp(-b[1] * x) + b[2] * std::exp(-b[3] * x) +
                          b[4] * std::exp(-b[5] * x);
                 },
                 6},
        NistCase{"Kirby2",
                 [](const VectorXd &b, double x) {
                   return (b[0] + x * (b[1] + x * b[2])) / (1 + x * (b[3] + x * b[4]));
                 },
                 8},
        NistCase{"Hahn1", cubicOverCubic, 8}, NistCase{"Thurber", cubicOverCubic, 8},
        NistCase{"MGH17",
                 [](const VectorXd &b, double x) {
                   return b[0] + b[1] * std::exp(-x * b[3]) + b[2] * std::exp(-x * b[4]);
                 },
                 7},
        NistCase{"MGH09",
                 [](const VectorXd &b, double x) {
                   return b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]);
                 },
                 7},
        NistCase{"MGH10",
                 [](const VectorXd &b, double x) { return b[0] * std::exp(b[1] / (x + b[2])); }, 8},
        NistCase{"BoxBOD",
                 [](const VectorXd &b, double x) { return b[0] * -std::expm1(-b[1] * x); }, 8,
                 false},
        NistCase{"Rat42",
                 [](const VectorXd &b, double x) { return b[0] / (1 + std::exp(b[1] - b[2] * x)); },
                 8},
        NistCase{"Rat43",
                 [](const VectorXd &b, double x) {
                   return b[0] / std::pow(1 + std::exp(b[1] - b[2] * x), 1 / b[3]);
                 },
                 8},
        NistCase{"Eckerle4",
                 [](const VectorXd &b, double x) {
                   return b[0] / b[1] * std::exp(-0.5 * std::pow((x - b[2]) / b[1], 2));
                 },
                 8},
        NistCase{"Bennett5",
                 [](const VectorXd &b, double x) { return b[0] * std::pow(b[1] + x, -1 / b[2]); },
                 6}),
    [](const auto &given) { return std::string(given.param.name); });

namespace {

/// y = x0 exp(-x1 t) with an analytic Jacobian, t = 0 .. 9, and noise of the given size.
LeastSquaresProblem decay(const std::vector<double> &y)
{
  LeastSquaresProblem problem;
  problem.parameters = 2;
  problem.residuals = static_cast<int>(y.size());
  problem.evaluate = [y](const VectorXd &x, VectorXd &r, Eigen::MatrixXd *jacobian) {
    for (size_t t = 0; t < y.size(); ++t) {
      const double e = std::exp(-x[1] * static_cast<double>(t));
      r[t] = x[0] * e - y[t];
      if (jacobian)
        jacobian->row(t) << e, -x[0] * static_cast<double>(t) * e;
    }
    return true;
  };
  return problem;
}

std::vector<double> decayData(double noise)
{
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  std::vector<double> y;
  for (int t = 0; t < 10; ++t)
    y.push_back(2.0 * std::exp(-0.3 * t) + noise * normal(generator));
  return y;
}

VectorXd vector2(double a, double b)
{
  return Eigen::Vector2d(a, b);
}

} // namespace

TEST(LeastSquares, numericalJacobianAgreesWithAnalytic)
{
  auto problem = decay(decayData(0.1));
  const auto analytic = solveLeastSquares(problem, {vector2(1, 1)});
  problem.hasJacobian = false;
  const auto numerical = solveLeastSquares(problem, {vector2(1, 1)});
  // extrapolated differences: eps/step and step^6, both about 1e-12
  EXPECT_LT((analytic.jacobian - numerical.jacobian).norm(), 1e-10 * analytic.jacobian.norm());
  EXPECT_LT((analytic.x - numerical.x).norm(), 1e-8);
}

TEST(LeastSquares, boundsAndConstantsHold)
{
  auto problem = decay(decayData(0.0));
  problem.lower = vector2(-1e300, 0.5);
  problem.upper = vector2(1e300, 10.0);
  EXPECT_DOUBLE_EQ(solveLeastSquares(problem, {vector2(1, 1)}).x[1], 0.5);
  problem.constant = {true, false};
  problem.lower[1] = 0.0;
  const auto held = solveLeastSquares(problem, {vector2(1.9, 1)});
  EXPECT_DOUBLE_EQ(held.x[0], 1.9);
  EXPECT_GT(held.sumOfSquares, 1e-4);
}

/// With a parameter at its bound the others are at the least sum along the bound, whatever the
/// start: Ceres' own steps, which are cut off there, end short of it.
TEST(LeastSquares, leastAlongABound)
{
  LeastSquaresProblem problem; // y = x0 exp(-x1 t) + x2, where x1 and x2 depend on each other
  problem.parameters = 3;
  problem.residuals = 10;
  const auto y = decayData(0.1);
  problem.evaluate = [y](const VectorXd &x, VectorXd &r, Eigen::MatrixXd *jacobian) {
    for (int t = 0; t < 10; ++t) {
      const double e = std::exp(-x[1] * t);
      r[t] = x[0] * e + x[2] - y[t];
      if (jacobian)
        jacobian->row(t) << e, -x[0] * t * e, 1.0;
    }
    return true;
  };
  VectorXd start(3), other(3);
  start << 1.0, 1.0, 1.0;
  other << 5.0, 3.0, 0.3;
  problem.lower = VectorXd::Constant(3, -1e300);
  problem.lower[2] = solveLeastSquares(problem, {start}).x[2] + 0.1;
  problem.upper = VectorXd::Constant(3, 1e300);
  auto held = problem;
  held.constant = {false, false, true};
  start[2] = problem.lower[2];
  const auto along = solveLeastSquares(held, {start});
  for (VectorXd from : {start, other}) {
    from[2] = std::max(from[2], problem.lower[2]);
    const auto found = solveLeastSquares(problem, {from});
    EXPECT_DOUBLE_EQ(found.x[2], problem.lower[2]);
    EXPECT_LT((found.x - along.x).norm(), 1e-7 * along.x.norm());
  }
  // and a start at a bound that is none of the solution's is left
  problem.lower[2] -= 0.2;
  start[2] = problem.lower[2];
  EXPECT_GT(solveLeastSquares(problem, {start}).x[2], problem.lower[2] + 0.05);
}

TEST(LeastSquares, wrongSizesAreRefused)
{
  const auto problem = decay(decayData(0.0));
  EXPECT_THROW(solveLeastSquares(problem, {}), std::invalid_argument);
  EXPECT_THROW(solveLeastSquares(problem, {VectorXd::Zero(3)}), std::invalid_argument);
}

TEST(LeastSquares, profileOfLinearParameterIsItsWaldInterval)
{
  // y = x0 + x1 t: the sum of squares is a parabola, so that both intervals agree exactly
  LeastSquaresProblem line;
  line.parameters = 2;
  line.residuals = 10;
  const auto y = decayData(0.1);
  line.evaluate = [y](const VectorXd &x, VectorXd &r, Eigen::MatrixXd *jacobian) {
    for (int t = 0; t < 10; ++t) {
      r[t] = x[0] + x[1] * t - y[t];
      if (jacobian)
        jacobian->row(t) << 1.0, t;
    }
    return true;
  };
  const auto solution = solveLeastSquares(line, {vector2(0, 0)});
  const auto covariance = analyseJacobian(solution.jacobian, {false, false}).covariance;
  const double rise = 4.0;
  for (int k = 0; k < 2; ++k) {
    const double error = std::sqrt(covariance(k, k));
    const auto interval = profileInterval(line, solution, k, error, rise);
    EXPECT_NEAR(interval.upper, solution.x[k] + 2.0 * error, 1e-3 * error);
    EXPECT_NEAR(interval.lower, solution.x[k] - 2.0 * error, 1e-3 * error);
    EXPECT_FALSE(interval.lowerOpen || interval.upperOpen);
  }
  line.lower = vector2(solution.x[0] - 0.01, -1.0);
  line.upper = vector2(10.0, 10.0);
  const auto cut = profileInterval(line, solution, 0, std::sqrt(covariance(0, 0)), rise);
  EXPECT_TRUE(cut.lowerOpen);
  EXPECT_DOUBLE_EQ(cut.lower, line.lower[0]);
}

TEST(LeastSquares, collinearColumnsAreSeen)
{
  Eigen::MatrixXd jacobian(4, 3);
  jacobian << 1, 2e5, 1, 2, 4e5, 0, 3, 6e5, 2, 4, 8e5, -1;
  const auto analysis = analyseJacobian(jacobian, {false, false, false});
  EXPECT_GT(analysis.conditionNumber, 1e12);
  EXPECT_NEAR(analysis.weakDirection[2], 0.0, 1e-9);
  EXPECT_LT(analyseJacobian(jacobian, {false, true, false}).conditionNumber, 10.0);
}

TEST(LeastSquares, residualsThatAreNotFiniteArePassedOverInSilence)
{
  auto problem = decay(std::vector<double>(10, 1.0));
  const auto finite = problem.evaluate;
  problem.evaluate = [&](const VectorXd &x, VectorXd &r, Eigen::MatrixXd *jacobian) {
    finite(x, r, jacobian);
    r[3] = NAN;
    return true;
  };
  testing::internal::CaptureStderr();
  const auto solution = solveLeastSquares(problem, {VectorXd::Ones(2)});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_FALSE(solution.converged);
  EXPECT_EQ(solution.message.find("nan"), std::string::npos) << solution.message;
  EXPECT_EQ(analyseJacobian(solution.jacobian, {false, false}).conditionNumber, INFINITY);
}

TEST(LeastSquares, messageIsPartOfASentence)
{
  auto problem = decay(std::vector<double>(10, 1.0));
  problem.evaluate = [](const VectorXd &, VectorXd &, Eigen::MatrixXd *) { return false; };
  const auto solution = solveLeastSquares(problem, {VectorXd::Ones(2)});
  EXPECT_FALSE(solution.converged);
  ASSERT_FALSE(solution.message.empty());
  EXPECT_NE(solution.message.back(), '.');
}
