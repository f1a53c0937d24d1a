// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/friction_newton.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

/// Tolerances of a Newton step's linear system: nothing is gained by a better solution before every
/// cell's state is right, but much by one Krylov space for the rest of the way afterwards.
constexpr double innerTolerance = 0.1, tightTolerance = 1e-3, innerShare = 0.3;
/// r of q = P(q - r S), in units of a cell's stiffness: how far a cell's slip counts when its state
/// is predicted. The smaller, the slower and the safer. Of a step, whose S is that of all
/// wavelengths together, a larger one lets the states of a fine grid go to and fro.
struct Attempt {
  double rolling, step; ///< the prediction
  int steps;            ///< mostly 5 to 10 are enough where it converges at all
};
constexpr Attempt attempts[] = {{0.5, 0.1, 20}, {0.1, 0.02, 40}, {0.02, 0.005, 100}};
/// Softer slip (see `Linearisation::softness`) hardly feels the half-space: 2 to 5 serve as well.
constexpr double softest = 3.0;
constexpr double leastSoftness = 1e-3; ///< in the mean of the logarithms
constexpr int restart = 30, maxInner = 120;
/// What sums of images can tell of a residual, as a share of that before them.
constexpr double rounding = 1e-8;
constexpr double quickError = 1e-6; ///< of products in single precision, of a direction's image
constexpr double doubtShare = 0.1;  ///< of the tolerance that these errors may come to

} // namespace

FrictionNewton::FrictionNewton(PatchHalfSpace &halfSpace, Equations equations)
    : space_(halfSpace), eq_(std::move(equations)), n_(static_cast<int>(eq_.cells.size())),
      compliance_(halfSpace.tangentialCompliance()),
      upstream_(n_, -1), field_{Vector::Zero(halfSpace.cells()), Vector::Zero(halfSpace.cells())}
{
  stiffness_ = Vector::Ones(n_);
  for (int i = 0; 3 * i < eq_.edge.size(); ++i)
    stiffness_[i] = 1.0 / (1.0 + std::max({0.0, eq_.edge[3 * i], eq_.edge[3 * i + 1]}));
  // cells are numbered with x running fastest: the one upstream is the next in the list, if any
  const int nx = space_.grid().nx;
  for (int i = 0; i + 1 < n_; ++i)
    if (eq_.cells[i + 1] == eq_.cells[i] + 1 && eq_.cells[i + 1] % nx != 0)
      upstream_[i] = i + 1;
}

Vector FrictionNewton::operatorB(const Vector &x, Precision precision)
{
  ++operatorProducts_;
  field_.x.setZero();
  field_.y.setZero();
  for (int i = 0; i < n_; ++i) {
    field_.x[eq_.cells[i]] = x[2 * i];
    field_.y[eq_.cells[i]] = x[2 * i + 1];
  }
  const TangentialField u = precision == Precision::Single
                                ? space_.quickTractions().displacement(field_)
                                : space_.displacement(field_);
  Vector result(2 * n_);
  // Steady rolling: u(x) - u(x + d), the displacement a cell upstream, where the material was.
  const int ahead = eq_.steady ? 1 : 0;
  const double unit = 1.0 / compliance_;
  for (int i = 0; i < n_; ++i) {
    const int cell = eq_.cells[i];
    double ux = u.x[cell], uy = u.y[cell];
    if (ahead) {
      ux -= u.x[cell + 1];
      uy -= u.y[cell + 1];
    }
    result[2 * i] = unit * ux;
    result[2 * i + 1] = unit * uy;
  }
  if (eq_.edge.size() > 0)
    for (int i = 0; i < n_; ++i) {
      result[2 * i] += eq_.edge[3 * i] * x[2 * i] + eq_.edge[3 * i + 2] * x[2 * i + 1];
      result[2 * i + 1] += eq_.edge[3 * i + 2] * x[2 * i] + eq_.edge[3 * i + 1] * x[2 * i + 1];
    }
  for (std::size_t j = 0; j < eq_.unknown.size(); ++j)
    for (int i = 0; i < n_; ++i)
      result[2 * i + eq_.unknown[j]] += x[2 * n_ + j];
  return result;
}

// A cell sticks where q - r S lies within the disc of its bound. There q - P(q - r S) is r S; the
// factor is left out. The equations of given forces are divided by sqrt(n), so that they do not
// outweigh those of the cells.
Vector FrictionNewton::evaluate(const Vector &x, Linearisation &linear)
{
  scaledSlip_ = eq_.drive + image_;
  linear.slips.assign(n_, 0);
  linear.tangent = Vector::Zero(2 * n_);
  linear.lambda = linear.softness = Vector::Zero(n_);
  Vector f(x.size());
  for (int i = 0; i < n_; ++i) {
    const double r = predictionOf(i);
    const double zx = x[2 * i] - r * scaledSlip_[2 * i],
                 zy = x[2 * i + 1] - r * scaledSlip_[2 * i + 1];
    const double length = std::hypot(zx, zy);
    if (length <= eq_.bound[i]) {
      f[2 * i] = scaledSlip_[2 * i];
      f[2 * i + 1] = scaledSlip_[2 * i + 1];
      continue;
    }
    linear.slips[i] = 1;
    linear.lambda[i] = eq_.bound[i] / length;
    linear.softness[i] = (1.0 - linear.lambda[i]) / (linear.lambda[i] * r);
    linear.tangent[2 * i] = -zy / length;
    linear.tangent[2 * i + 1] = zx / length;
    f[2 * i] = x[2 * i] - linear.lambda[i] * zx;
    f[2 * i + 1] = x[2 * i + 1] - linear.lambda[i] * zy;
  }
  for (std::size_t j = 0; j < eq_.unknown.size(); ++j) {
    double sum = -eq_.force[j];
    for (int i = 0; i < n_; ++i)
      sum += x[2 * i + eq_.unknown[j]];
    f[2 * n_ + j] = sum / std::sqrt(double(n_));
  }
  return f;
}

Vector FrictionNewton::jacobian(const Linearisation &linear, const Vector &x, const Vector &s) const
{
  Vector f(x.size());
  for (int i = 0; i < n_; ++i) {
    if (!linear.slips[i]) {
      f[2 * i] = s[2 * i];
      f[2 * i + 1] = s[2 * i + 1];
      continue;
    }
    // q - lambda (q - r S) along the circle, q itself across it
    const double tx = linear.tangent[2 * i], ty = linear.tangent[2 * i + 1];
    const double lambda = linear.lambda[i];
    const double along = tx * x[2 * i] + ty * x[2 * i + 1];
    const double alongS = tx * s[2 * i] + ty * s[2 * i + 1];
    const double change = -lambda * (along - predictionOf(i) * alongS);
    f[2 * i] = x[2 * i] + change * tx;
    f[2 * i + 1] = x[2 * i + 1] + change * ty;
  }
  for (std::size_t j = 0; j < eq_.unknown.size(); ++j) {
    double sum = 0.0;
    for (int i = 0; i < n_; ++i)
      sum += x[2 * i + eq_.unknown[j]];
    f[2 * n_ + j] = sum / std::sqrt(double(n_));
  }
  return f;
}

Vector FrictionNewton::fromLeft(const Linearisation &linear, const Vector &residual) const
{
  Vector sum = residual;
  if (!eq_.steady)
    return sum;
  for (int i = n_ - 2; i >= 0; --i)
    if (!linear.slips[i] && upstream_[i] >= 0 && !linear.slips[i + 1]) {
      sum[2 * i] += sum[2 * i + 2];
      sum[2 * i + 1] += sum[2 * i + 3];
    }
  return sum;
}

Vector FrictionNewton::fromRight(const Linearisation &linear, const Vector &x)
{
  Vector result = x;
  if (eq_.steady) {
    fillStick(linear, x, result);
    fillSlip(linear, x, result);
  } else {
    fillStep(linear, x, result);
  }
  return result;
}

// Once q across the circle is known where a cell slips, what is left of a step's equations is
// symmetric: A on the directions that are free, and the softness on the diagonal. The half-space's
// inverse, scaled from both sides, is that of either where it is alone.
void FrictionNewton::fillStep(const Linearisation &linear, const Vector &x, Vector &result)
{
  field_.x.setZero();
  field_.y.setZero();
  const auto scaleOf = [&](int i) { return 1.0 / std::sqrt(1.0 + linear.softness[i]); };
  for (int i = 0; i < n_; ++i) {
    const int cell = eq_.cells[i];
    if (!linear.slips[i]) {
      field_.x[cell] = compliance_ * x[2 * i];
      field_.y[cell] = compliance_ * x[2 * i + 1];
      continue;
    }
    const double wanted = compliance_ * scaleOf(i) * linear.along(i, x[2 * i], x[2 * i + 1]) /
                          (linear.lambda[i] * predictionOf(i));
    field_.x[cell] = wanted * linear.tangent[2 * i];
    field_.y[cell] = wanted * linear.tangent[2 * i + 1];
  }
  const TangentialField q = space_.quickTractions().tractionEstimate(field_);
  for (int i = 0; i < n_; ++i) {
    const int cell = eq_.cells[i];
    if (linear.slips[i]) {
      linear.setAlong(i, scaleOf(i) * linear.along(i, q.x[cell], q.y[cell]), result);
    } else {
      result[2 * i] = q.x[cell];
      result[2 * i + 1] = q.y[cell];
    }
  }
}

void FrictionNewton::fillStick(const Linearisation &linear, const Vector &x, Vector &result)
{
  field_.x.setZero();
  field_.y.setZero();
  for (int i = 0; i < n_; ++i)
    if (!linear.slips[i]) {
      field_.x[eq_.cells[i]] = compliance_ * x[2 * i];
      field_.y[eq_.cells[i]] = compliance_ * x[2 * i + 1];
    }
  const TangentialField q = space_.tractionEstimate(field_);
  for (int i = 0; i < n_; ++i)
    if (!linear.slips[i]) {
      result[2 * i] = q.x[eq_.cells[i]];
      result[2 * i + 1] = q.y[eq_.cells[i]];
    }
}

// Where a cell slips, about the diagonal of its equation along the circle, with S taken for as much
// as q: in units of the cell's own compliance it nearly is.
void FrictionNewton::fillSlip(const Linearisation &linear, const Vector &x, Vector &result)
{
  field_.x.setZero();
  field_.y.setZero();
  double logarithms = 0.0;
  int count = 0;
  for (int i = 0; i < n_; ++i) {
    if (!linear.slips[i])
      continue;
    // the row, over lambda r: softness q + S along the tangent
    const double softness = linear.softness[i];
    const double wanted =
        linear.along(i, x[2 * i], x[2 * i + 1]) / (linear.lambda[i] * predictionOf(i));
    if (softness >= softest) {
      linear.setAlong(i, wanted / (softness + 1.0), result);
      continue;
    }
    const int cell = eq_.cells[i];
    field_.x[cell] = compliance_ * wanted * linear.tangent[2 * i];
    field_.y[cell] = compliance_ * wanted * linear.tangent[2 * i + 1];
    logarithms += std::log(std::max(softness, leastSoftness));
    ++count;
  }
  if (count == 0)
    return;
  const double mean = std::exp(logarithms / count);
  const TangentialField q = space_.softenedEstimate(field_, mean * compliance_);
  for (int i = 0; i < n_; ++i)
    if (linear.slips[i] && linear.softness[i] < softest)
      linear.setAlong(i, linear.along(i, q.x[eq_.cells[i]], q.y[eq_.cells[i]]), result);
}

// Two preconditioners, for the operator is a product of two: B = A - A moved by a cell is the
// influence A after the difference along the stream. The sum along each stick segment undoes the
// difference (left), the half-space's symbol undoes the influence (right).
//
// Most of the work is products with B. What B makes of a direction is kept with it: so the slip of
// the solution follows from those of its directions, and steps that are known from solutions before
// cost no product.
void FrictionNewton::newtonStep(const Linearisation &linear, const Vector &f, double tolerance,
                                const std::vector<KnownStep> &known, Vector &x)
{
  StepSpace space(fromLeft(linear, -f), static_cast<int>(known.size()) + restart);
  const double goal = tolerance * space.residual().norm();
  const auto imageOf = [&](const Vector &direction, const Vector &slip) -> Eigen::VectorXd {
    return fromLeft(linear, jacobian(linear, direction, slip));
  };
  std::vector<KnownStep> taken;
  for (const KnownStep &step : known)
    if (space.add(imageOf(step.x, step.image)))
      taken.push_back(step);
  const auto takeStep = [&] {
    const Vector weights = space.weights();
    for (std::size_t j = 0; j < taken.size(); ++j) {
      x += weights[j] * taken[j].x;
      image_ += weights[j] * taken[j].image;
      if (!eq_.steady)
        doubt_ += quickError * std::abs(weights[j]) * taken[j].image.norm();
    }
  };
  // Steady rolling needs the difference of displacements of neighbours, of which single precision
  // leaves too little.
  const Precision precision = eq_.steady ? Precision::Double : Precision::Single;
  for (int products = 0; space.residual().norm() > goal && products < maxInner; ++products) {
    KnownStep step;
    step.x = fromRight(linear, space.next());
    const Vector direction = step.x, slip = operatorB(direction, precision);
    const Eigen::VectorXd image = imageOf(direction, slip);
    bool added = !space.isFull() && space.add(image);
    if (!added) { // no room, or nothing new
      takeStep();
      taken.clear();
      space = StepSpace(space.residual(), restart);
      added = space.add(image);
    }
    if (!added)
      break;
    step.image = slip;
    taken.push_back(std::move(step));
  }
  takeStep();
}

bool FrictionNewton::solve(Vector &x, double tolerance, int maxSteps,
                           const std::vector<KnownStep> &known)
{
  known_ = known;
  const Vector start = x;
  if (tryAttempts(start, x, tolerance, maxSteps))
    return true;
  if (eq_.unknown.empty())
    return false;
  // A force far from that of the start: go there by parts
  constexpr double smallestPart = 1.0 / 64.0;
  const std::vector<double> goal = eq_.force;
  std::vector<double> base(goal.size(), 0.0);
  for (std::size_t j = 0; j < goal.size(); ++j) // what the start carries within its bounds
    for (int i = 0; i < n_; ++i)
      base[j] += std::clamp(start[2 * i + eq_.unknown[j]], -eq_.bound[i], eq_.bound[i]);
  Vector reachedAt = start;
  double reached = 0.0, part = 0.5;
  while (reached < 1.0 && part >= smallestPart) {
    const double next = std::min(1.0, reached + part);
    for (std::size_t j = 0; j < goal.size(); ++j)
      eq_.force[j] = next == 1.0 ? goal[j] : base[j] + next * (goal[j] - base[j]);
    if (tryAttempts(reachedAt, x, tolerance, maxSteps)) {
      reachedAt = x;
      reached = next;
    } else {
      part *= 0.5;
    }
  }
  eq_.force = goal;
  return reached == 1.0;
}

bool FrictionNewton::tryAttempts(const Vector &start, Vector &x, double tolerance, int maxSteps)
{
  for (const auto &attempt : attempts) {
    prediction_ = eq_.steady ? attempt.rolling : attempt.step;
    x = start;
    if (iterate(x, tolerance, std::min(attempt.steps, maxSteps)))
      return true;
  }
  return false;
}

// Semismooth Newton's method. Each cell's equation is that of stick, S = 0, or that of slip, |q| =
// bound with q against S; q - r S tells which, at the last iterate. With all states chosen the
// equations are linear but for the direction of slip, and one linear system (`newtonStep`) gives
// the next iterate, from which the states are chosen anew. Once they stand the steps converge
// quadratically. Until then a linear system is not worth solving well: a tenth is enough.
//
// Full steps without a line search: the norm of a residual with kinks may have to rise on the way.
// What does not converge is tried again with a smaller r.
bool FrictionNewton::iterate(Vector &x, double tolerance, int maxSteps)
{
  Linearisation &linear = linear_;
  std::vector<char> former;
  image_ = operatorB(x, Precision::Double);
  doubt_ = 0.0;
  const Vector start = x, imageOfStart = image_;
  double exact = 0.0, last = 0.0; // residuals at the last product and of the last iterate
  for (int step = 0;; ++step, ++newtonSteps_) {
    Vector f = evaluate(x, linear);
    // where it stays although the states do, rounding may be all that is left
    const bool stays = linear.slips == former && f.norm() > innerTolerance * last;
    const bool doubtful = doubt_ > doubtShare * tolerance * eq_.scale;
    if (f.norm() < rounding * exact || stays || (doubtful && f.norm() <= tolerance * eq_.scale)) {
      image_ = operatorB(x, Precision::Double);
      doubt_ = 0.0;
      f = evaluate(x, linear);
      exact = f.norm();
    } else if (step == 0) {
      exact = f.norm();
    }
    last = f.norm();
    relativeResidual_ = last / eq_.scale;
    if (relativeResidual_ <= tolerance) {
      wholeStep_ = {(x - start), (image_ - imageOfStart)};
      return true;
    }
    if (step >= maxSteps || !std::isfinite(relativeResidual_))
      return false;
    const double goal = innerShare * tolerance / relativeResidual_;
    newtonStep(linear, f,
               linear.slips == former ? std::clamp(goal, tightTolerance, innerTolerance)
                                      : innerTolerance,
               step == 0 ? known_ : std::vector<KnownStep>{}, x);
    former = linear.slips;
  }
}

} // namespace wheelrail
