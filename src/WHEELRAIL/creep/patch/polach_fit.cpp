// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/polach_forces.h"

#include "base/errors.h"
#include "base/least_squares.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace wheelrail {

namespace {

using Vector = Eigen::VectorXd;

enum Place { Mu0, A, B, KA, KS };
constexpr double leastFactor = 1e-3, largestFactor = 1e2; // of kA, kS: far beyond any contact
constexpr double leastFriction = 1e-6;

PolachParameters parametersOf(const Vector &x)
{
  return {x[Mu0], x[A], x[B], x[KA], x[KS]};
}

bool hasX(const PolachPoint &p)
{
  return p.state.creep != 0.0;
}
bool hasY(const PolachPoint &p)
{
  return p.state.lateral != 0.0 || p.state.spin != 0.0;
}

double slipSpeed(const PolachPoint &p)
{
  return std::hypot(p.state.creep, p.state.lateral) * p.state.speed;
}

void checkPoints(const std::vector<PolachPoint> &points)
{
  for (const PolachPoint &p : points) {
    const PolachState &s = p.state;
    for (const double v : {s.creep, s.lateral, s.spin, s.speed, s.load, p.forceX, p.forceY})
      if (!std::isfinite(v))
        throw std::invalid_argument("Polach's law: a point that is not finite");
    if (!(s.load > 0.0) || s.speed < 0.0)
      throw std::invalid_argument("Polach's law: loads must be positive, speeds not negative");
  }
}

/// Residuals of all points with the law's parameters as unknowns.
class Problem {
 public:
  Problem(const std::vector<PolachPoint> &points, const PolachContact &contact,
          PolachFriction friction, double largestMu)
      : points_(points), contact_(contact), falling_(friction == PolachFriction::Falling),
        largestMu_(largestMu)
  {
    for (const PolachPoint &p : points) {
      residuals_ += static_cast<int>(hasX(p)) + static_cast<int>(hasY(p));
      peak_ = std::max(peak_, std::hypot(p.forceX, p.forceY) / p.state.load);
      fastest_ = std::max(fastest_, slipSpeed(p));
    }
  }

  int residuals() const { return residuals_; }
  int freeParameters() const { return falling_ ? polachParameters : 3; }
  bool isFree(int k) const { return falling_ || (k != A && k != B); }
  /// Slip speed times B beyond which mu cannot be told from its limit, or not from mu0.
  double largestB() const { return fastest_ > 0.0 ? 1e4 / fastest_ : 1.0; }

  /// For solveLeastSquares; refers to *this.
  LeastSquaresProblem make() const
  {
    LeastSquaresProblem problem;
    problem.parameters = polachParameters;
    problem.residuals = residuals_;
    problem.hasJacobian = false;
    problem.lower = Vector(polachParameters);
    problem.upper = Vector(polachParameters);
    problem.lower << leastFriction, 0.0, 0.0, leastFactor, leastFactor;
    problem.upper << largestMu_, 1.0, largestB(), largestFactor, largestFactor;
    for (int k = 0; k < polachParameters; ++k)
      problem.constant.push_back(!isFree(k));
    problem.evaluate = [this](const Vector &x, Vector &r, Eigen::MatrixXd *) {
      return evaluate(x, r);
    };
    return problem;
  }

  /// The friction at the largest force, and factors and falls over their usual range.
  std::vector<Vector> starts() const
  {
    std::vector<Vector> result;
    const auto add = [&](double limit, double fall, double kA, double kS) {
      Vector x(polachParameters);
      x << std::min(std::max(1.1 * peak_, 2.0 * leastFriction), largestMu_), limit, fall, kA, kS;
      result.push_back(x);
    };
    for (const double kA : {1.0, 0.3})
      for (const double kS : {0.8 * kA, 0.2 * kA}) {
        if (!falling_)
          add(1.0, 0.0, kA, kS);
        for (const double fall : {0.3, 3.0, 30.0})
          if (falling_ && fastest_ > 0.0)
            add(0.5, fall / fastest_, kA, kS);
      }
    return result;
  }

  double fastest() const { return fastest_; }

 private:
  bool evaluate(const Vector &x, Vector &r) const
  {
    if (!(x[Mu0] > 0.0))
      return false;
    const PolachParameters parameters = parametersOf(x);
    int k = 0;
    for (const PolachPoint &p : points_) {
      const PolachForce force = polachForce(parameters, contact_, p.state);
      if (hasX(p))
        r[k++] = (force.x - p.forceX) / p.state.load;
      if (hasY(p))
        r[k++] = (force.y - p.forceY) / p.state.load;
    }
    return r.allFinite();
  }

  const std::vector<PolachPoint> &points_;
  const PolachContact &contact_;
  bool falling_;
  double largestMu_;
  int residuals_ = 0;
  double peak_ = 0.0, fastest_ = 0.0; // largest force/load; largest slip speed, m/s
};

/// Names the first parameter whose standard error is as large as itself (A: as its range).
std::string undetermined(const PolachFit &fit)
{
  const PolachParameters &p = fit.parameters;
  const std::array<double, polachParameters> scale = {p.mu0, 1.0, p.B, p.kA, p.kS};
  for (int k = 0; k < polachParameters; ++k)
    if (fit.standardError[k] > 0.0 && fit.standardError[k] >= scale[k])
      return fmt::format("{} is not determined: its standard error is {:.3g}",
                         polachParameterNames[k], fit.standardError[k]);
  return "";
}

/// A parameter that runs to its bound is named first, for there standard errors mean nothing; then
/// those that the points do not tell apart, or one whose error is as large as itself.
std::string whyNot(const PolachFit &fit, const Identifiability &analysis)
{
  if (fit.friction == PolachFriction::Falling && (fit.atBound[A] && fit.parameters.A == 1.0))
    return "A runs to 1: mu does not fall with the slip speed, so that B is not determined";
  if (fit.friction == PolachFriction::Falling && fit.atBound[B])
    return fmt::format("B runs to {:g} s/m: the points do not show how mu falls, A and B are not "
                       "determined",
                       fit.parameters.B);
  for (const int k : {KA, KS})
    if (fit.atBound[k])
      return fmt::format("{} runs to the end of its range; points between the linear part and full "
                         "sliding are missing, or the contact is not that of the points",
                         polachParameterNames[k]);
  if (analysis.conditionNumber <= worstCondition)
    return undetermined(fit);
  std::string names;
  for (int k = 0; k < polachParameters; ++k)
    if (std::abs(analysis.weakDirection[k]) > 0.3)
      names += (names.empty() ? "" : ", ") + std::string(polachParameterNames[k]);
  return fmt::format("{} cannot be told apart (condition number {:.3g}, at most {:.0e} is "
                     "accepted)",
                     names, analysis.conditionNumber, worstCondition);
}

double aiccOf(double sumOfSquares, int residuals, int parameters)
{
  const double n = residuals, k = parameters + 1; // the scatter counts too
  if (n - k - 1.0 <= 0.0)
    return std::numeric_limits<double>::infinity();
  const double variance = std::max(sumOfSquares / n, std::numeric_limits<double>::min());
  return n * std::log(variance) + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0);
}

} // namespace

bool isInPolachsSpin(const PolachState &state, const PolachContact &contact)
{
  const double longer = std::max(contact.a, contact.b) * std::cbrt(state.load / contact.load);
  return std::abs(state.spin) * longer <= std::hypot(state.creep, state.lateral);
}

PolachFit fitPolach(const std::vector<PolachPoint> &points, const PolachContact &contact,
                    PolachFriction friction, double largestMu)
{
  checkPoints(points);
  const Problem problem(points, contact, friction, largestMu);
  const int freedom = problem.residuals() - problem.freeParameters();
  PolachFit fit;
  fit.friction = friction;
  fit.residuals = problem.residuals();
  if (freedom < 1)
    throw Error(ExitCode::NotConverged,
                fmt::format("Polach's law: {} forces; its {} parameters need at least {}",
                            problem.residuals(), problem.freeParameters(),
                            problem.freeParameters() + 1));
  if (friction == PolachFriction::Falling && problem.fastest() == 0.0) {
    fit.notIdentifiable = "no point slips at a speed: A and B are not determined";
    fit.aicc = std::numeric_limits<double>::infinity();
    return fit;
  }
  const LeastSquaresProblem squares = problem.make();
  const LeastSquaresSolution solution = solveLeastSquares(squares, problem.starts());
  if (!solution.converged)
    throw Error(ExitCode::NotConverged, "Polach's law: " + solution.message);
  fit.parameters = parametersOf(solution.x);
  const Identifiability analysis = analyseJacobian(solution.jacobian, squares.constant);
  fit.conditionNumber = analysis.conditionNumber;
  fit.rms = std::sqrt(solution.sumOfSquares / freedom);
  fit.aicc = aiccOf(solution.sumOfSquares, problem.residuals(), problem.freeParameters());
  Vector r(problem.residuals());
  squares.evaluate(solution.x, r, nullptr);
  fit.worst = r.cwiseAbs().maxCoeff();
  for (int k = 0; k < polachParameters; ++k) {
    fit.standardError[k] = fit.rms * std::sqrt(analysis.covariance(k, k));
    const double x = solution.x[k], span = 1e-6 * std::max(std::abs(x), 1.0);
    fit.atBound[k] = problem.isFree(k) &&
                     (x - squares.lower[k] <= (k == Mu0 ? leastFriction : span * leastFactor) ||
                      squares.upper[k] - x <= span);
  }
  fit.notIdentifiable = whyNot(fit, analysis);
  return fit;
}

namespace {

/// Both forms of friction to these points.
PolachChoice chosenFrom(const std::vector<PolachPoint> &points, const PolachContact &contact,
                        double largestMu = std::numeric_limits<double>::infinity())
{
  const PolachFit constant = fitPolach(points, contact, PolachFriction::Constant, largestMu);
  const bool enough = constant.residuals > polachParameters;
  const PolachFit falling =
      enough ? fitPolach(points, contact, PolachFriction::Falling, largestMu) : PolachFit{};
  if (enough && falling.notIdentifiable.empty() && falling.aicc < constant.aicc)
    return {falling, "friction that falls with the slip speed describes the points better", 0, 0.0,
            ""};
  if (!constant.notIdentifiable.empty())
    throw Error(ExitCode::NotConverged,
                "Polach's law is not identifiable: " + constant.notIdentifiable);
  if (!enough)
    return {constant, "too few points for friction that falls with the slip speed", 0, 0.0, ""};
  if (!falling.notIdentifiable.empty())
    return {constant, falling.notIdentifiable, 0, 0.0, ""};
  return {constant, "friction that falls with the slip speed describes the points no better", 0,
          0.0, ""};
}

/// Worst residual of a law, of the load.
double worstOf(const PolachParameters &parameters, const std::vector<PolachPoint> &points,
               const PolachContact &contact)
{
  double worst = 0.0;
  for (const PolachPoint &p : points) {
    const PolachForce force = polachForce(parameters, contact, p.state);
    worst = std::max(worst, std::hypot(force.x - p.forceX, force.y - p.forceY) / p.state.load);
  }
  return worst;
}

constexpr const char *whereItHolds = "Polach's form takes a spin whose slip |phi| times the longer "
                                     "semi-axis is at most the creepage";

} // namespace

PolachChoice choosePolach(const std::vector<PolachPoint> &points, const PolachContact &contact)
{
  checkPoints(points);
  std::vector<PolachPoint> inside, outside;
  double largest = 0.0;
  bool spins = false;
  for (const PolachPoint &p : points) {
    (isInPolachsSpin(p.state, contact) ? inside : outside).push_back(p);
    largest = std::max(largest, std::hypot(p.forceX, p.forceY) / p.state.load);
    spins = spins || p.state.spin != 0.0;
  }
  // The form's force of spin comes on top of mu N, and its misfit would be laid on mu0 and kS.
  if (!spins)
    return chosenFrom(points, contact);
  if (outside.empty())
    return chosenFrom(points, contact, largest);
  try {
    PolachChoice choice = chosenFrom(inside, contact, largest);
    choice.leftOut = static_cast<int>(outside.size());
    choice.worstLeftOut = worstOf(choice.best.parameters, outside, contact);
    choice.warning =
        fmt::format("--polach: {} of {} operating points have more spin and are left out; the "
                    "law misses them by up to {:.2g} of the load. {}",
                    outside.size(), points.size(), choice.worstLeftOut, whereItHolds);
    return choice;
  } catch (const Error &error) {
    if (error.code() != ExitCode::NotConverged)
      throw;
  }
  PolachChoice choice = chosenFrom(points, contact, largest);
  choice.warning = fmt::format(
      "--polach: {} of {} operating points have more spin; without them the parameters are not "
      "determined, so all are fitted. The law misses them by up to {:.2g} of the load. "
      "{}",
      outside.size(), points.size(), worstOf(choice.best.parameters, points, contact),
      whereItHolds);
  return choice;
}

} // namespace wheelrail
