// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/line/rolling_contact.h"

#include "base/errors.h"
#include "contact/gmres.h"
#include "shared/pi.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double firstTolerance = 1e-2; ///< the first sets are wrong anyway
constexpr int coarsestGrid = 1024;
constexpr double coarseTolerance = 1e-4;    ///< a start for the next grid needs no more
constexpr double limitMargin = 1e-9;        ///< rounding of |q| against the bound
constexpr double transientTolerance = 1e-5; ///< of the slip in the stick zone / creep

/// Inverse of the finite Hilbert transform on the stick intervals, bounded at their leading edges:
/// q = w H' (v/w)/4, w = prod sqrt((leading_j - x)/(x - trailing_j)) (Soehngen's inversion;
/// Johnson, Contact Mechanics, sec. 2.7). The weight vanishes at a leading edge, where the traction
/// of rolling begins at zero, and is infinite where a stick zone ends, as the traction is there
/// until the zone has its right length. On the staggered grid H H' = 4 holds to the last bit on an
/// unbounded line; cut to the intervals it is an inverse but for the error of the cells, which
/// GMRES removes. A layer of the compliance l multiplies H by 1 + l/A on an unbounded line, A of
/// `HalfPlane::displacement`: its inverse 1 - l/(A + l) is applied to the result.
class FiniteHilbertInverse {
 public:
  FiniteHilbertInverse(HalfPlane &plane, const Vector &stickCells, double layer)
      : halfPlane_(plane), stick_(stickCells), layer_(layer)
  {
    const int n = plane.cells();
    Vector charge = Vector::Zero(n);
    for (int i = 1; i < n; ++i)
      charge[i] = 0.5 * (stick_[i - 1] - stick_[i]);
    weight_ = plane.edgeLogarithm(charge).array().exp() * stick_.array();
    inverseWeight_ = Vector::Zero(n);
    for (int i = 0; i < n; ++i)
      if (stick_[i] != 0.0)
        inverseWeight_[i] = 1.0 / weight_[i];
  }

  Vector operator()(const Vector &v) const
  {
    Vector q =
        0.25 * weight_.cwiseProduct(halfPlane_.stretchTransposed(v.cwiseProduct(inverseWeight_)));
    if (layer_ > 0.0)
      q -= layer_ * halfPlane_.layeredEstimate(q, layer_).cwiseProduct(stick_);
    return q;
  }

 private:
  HalfPlane &halfPlane_;
  const Vector &stick_;
  double layer_;
  Vector weight_, inverseWeight_;
};

/// Compliance in addition to the half-plane's of the cells at the edges of the contact.
///
/// A cell's load acts at its centre and its equation holds half a cell further on: as a load at
/// 1/4 and an equation at 3/4 of a panel that reaches from 1/4 cell behind the centre to 3/4 before
/// it. The contact's edges are seen from these panels, a quarter of a cell further back; taken at
/// the cells' faces, the leading edge would lie 1/4 cell too far ahead and T be too large in the
/// first order of the cell size. A panel of which only the share w is in contact gets the
/// compliance 2 (1 - w)/w, which is negative for the trailing one that is longer than a cell.
Vector edgeCompliance(const std::vector<ContactInterval> &contact, int cells, double layer)
{
  using mcawr::pi;
  constexpr double panelShift = 0.25;
  constexpr double leastShare = 0.01; ///< of a panel: what has less carries nothing
  Vector compliance = Vector::Zero(cells);
  const auto ofShare = [](double share) { return (1.0 - share) / share; };
  // a layer that comes in is sheared on the way from the edge to the cell's centre only
  for (const ContactInterval &interval : contact) {
    const double way = interval.right - interval.last;
    compliance[interval.last] += layer * ofShare(std::max(way, leastShare));
    if (way < 0.0 && interval.last > interval.first)
      compliance[interval.last - 1] += layer * ofShare(1.0 + way);
  }
  for (const ContactInterval &interval : contact) {
    if (interval.first == interval.last) {
      compliance[interval.first] += 4.0 / pi * ofShare(interval.length());
      continue;
    }
    const double ahead = interval.right - interval.last + 0.5 - panelShift;
    const double behind = interval.first + 0.5 - interval.left + panelShift;
    compliance[interval.first] += 2.0 * ofShare(behind);
    compliance[interval.last] += 2.0 * ofShare(std::max(ahead, leastShare));
    if (ahead < 0.0 && interval.last - interval.first > 1)
      compliance[interval.last - 1] += 2.0 * ofShare(1.0 + ahead);
  }
  return compliance;
}

/// What a particle gives way while it moves on by a cell: half-planes, edge cells and layer.
class Stretch {
 public:
  Stretch(HalfPlane &plane, const RollingOptions &options)
      : halfPlane_(plane), layer_(options.layer),
        edge_(edgeCompliance(options.contact, plane.cells(), options.layer))
  {
  }

  Vector operator()(const Vector &q) const
  {
    Vector stretched = halfPlane_.stretch(q) + edge_.cwiseProduct(q);
    if (layer_ > 0.0) {
      stretched += layer_ * q;
      stretched.head(q.size() - 1) -= layer_ * q.tail(q.size() - 1);
    }
    return stretched;
  }

 private:
  HalfPlane &halfPlane_;
  double layer_;
  Vector edge_;
};

double sign(Adhesion state)
{
  return state == Adhesion::BackwardSlip ? -1.0 : 1.0;
}

bool slips(Adhesion state)
{
  return state == Adhesion::Slip || state == Adhesion::BackwardSlip;
}

/// Moves cells between stick and slip: a cell that sticks beyond its bound slips from now on, with
/// the traction's sign; a cell that slips against its traction sticks. All at once, as in a
/// primal-dual active set; `threshold` keeps the rounding of slips near zero from moving a cell to
/// and fro.
/// \return number of cells that changed
int updateStates(const Vector &bound, const Vector &traction, const Vector &slip, double threshold,
                 std::vector<Adhesion> &state)
{
  int changed = 0;
  for (int i = 0; i < bound.size(); ++i) {
    const Adhesion old = state[i];
    if (old == Adhesion::Stick && std::abs(traction[i]) > bound[i] * (1.0 + limitMargin))
      state[i] = traction[i] > 0.0 ? Adhesion::Slip : Adhesion::BackwardSlip;
    else if (slips(old) && sign(old) * slip[i] < -threshold)
      state[i] = Adhesion::Stick;
    changed += state[i] != old;
  }
  return changed;
}

/// Stick for cells in contact, their states from the start where it is given.
std::vector<Adhesion> startStates(const Vector &bound, const std::vector<Adhesion> &given)
{
  std::vector<Adhesion> state(bound.size(), Adhesion::Apart);
  for (int i = 0; i < bound.size(); ++i) {
    if (!(bound[i] > 0.0))
      continue;
    const bool useful = given.size() == state.size() && given[i] != Adhesion::Apart;
    state[i] = useful ? given[i] : Adhesion::Stick;
  }
  return state;
}

/// States from the solution on cells twice as long: on long grids most sets are tried there.
std::vector<Adhesion> statesFromCoarseGrid(const Vector &bound, double creep,
                                           const RollingOptions &fine)
{
  const auto cells = bound.size() / 2;
  const auto coarsened = [](const Vector &values) {
    const Eigen::Map<const Eigen::Matrix2Xd> pairs(values.data(), 2, values.size() / 2);
    return Vector(pairs.colwise().mean());
  };
  HalfPlane plane(static_cast<int>(cells), Boundary::Free);
  RollingOptions options;
  options.tolerance = coarseTolerance;
  options.imposed = coarsened(fine.imposed);
  options.layer = 0.5 * fine.layer;
  const auto coarse = solveFrozenRolling(plane, coarsened(bound), creep, options).state;
  std::vector<Adhesion> states(bound.size());
  for (Eigen::Index i = 0; i < bound.size(); ++i)
    states[i] = coarse[i / 2];
  return states;
}

Vector stickCells(const std::vector<Adhesion> &state)
{
  Vector stick(state.size());
  for (std::size_t i = 0; i < state.size(); ++i)
    stick[i] = state[i] == Adhesion::Stick ? 1.0 : 0.0;
  return stick;
}

} // namespace

RollingResult solveFrozenRolling(HalfPlane &halfPlane, const Vector &bound, double creep,
                                 const RollingOptions &options)
{
  const int n = halfPlane.cells();
  const bool couples = options.imposed.size() > 0;
  if (bound.size() != n || !(creep >= 0.0) || halfPlane.boundary() != Boundary::Free ||
      (couples && options.imposed.size() != n))
    throw Error(ExitCode::Internal, "rolling contact: bound, creep or boundary do not fit");
  Vector drive = Vector::Constant(n, creep);
  if (couples)
    drive += options.imposed;
  const double scale = drive.cwiseAbs().maxCoeff();
  RollingResult result;
  result.traction = options.startTraction.size() == n ? options.startTraction : Vector::Zero(n);
  const bool cold = std::all_of(options.start.begin(), options.start.end(),
                                [](Adhesion state) { return state == Adhesion::Apart; });
  result.state = startStates(bound, cold && scale > 0.0 && n >= 2 * coarsestGrid && n % 2 == 0
                                        ? statesFromCoarseGrid(bound, creep, options)
                                        : options.start);
  if (scale == 0.0) {
    result.state = startStates(bound, {}); // nothing slips, whatever the start did
    result.traction.setZero();
    result.slip = Vector::Zero(n);
    return result;
  }

  // On given states the problem is linear: where a cell slips its traction is the bound, where it
  // sticks the stretch of both is what drives it. So each turn solves for the sticking cells'
  // traction and asks every cell whether its state still holds. Warm from the last turn's traction.
  const Stretch stretch(halfPlane, options);
  double tolerance = std::max(options.tolerance, firstTolerance);
  for (int set = 1;; ++set) {
    const Vector stick = stickCells(result.state);
    Vector fixed = Vector::Zero(n);
    for (int i = 0; i < n; ++i)
      if (slips(result.state[i]))
        fixed[i] = sign(result.state[i]) * bound[i];
    const Vector driven = drive - stretch(fixed);
    Vector q = result.traction.cwiseProduct(stick);
    const double cells = stick.sum();
    if (cells > 0.0) {
      const FiniteHilbertInverse inverse(halfPlane, stick, options.layer);
      const auto apply = [&](const Vector &v) { return Vector(stretch(v).cwiseProduct(stick)); };
      const Vector wanted = driven.cwiseProduct(stick);
      const GmresReport report =
          gmres(apply, inverse, wanted, q, scale * std::sqrt(cells), tolerance);
      result.products += report.products;
      result.residual = report.residual;
      if (!report.converged)
        throw Error(ExitCode::NotConverged,
                    fmt::format("rolling contact: GMRES stopped at a residual of {:.1e} (wanted "
                                "{:.1e}) after {} products on {} cells",
                                report.residual, tolerance, report.products, cells));
    }
    result.traction = q + fixed;
    result.slip = drive - stretch(result.traction);
    result.activeSets = set;
    const int changed =
        updateStates(bound, result.traction, result.slip, options.tolerance * scale, result.state);
    if (!changed && (tolerance <= options.tolerance || cells == 0.0))
      break;
    if (set >= options.maxActiveSets)
      throw Error(
          ExitCode::NotConverged,
          fmt::format("rolling contact: {} cells still change after {} active sets", changed, set));
    // Loose while the set is far off, full accuracy before it is believed.
    tolerance = std::max(options.tolerance, tolerance * (changed ? 0.1 : 1e-8));
  }
  for (int i = 0; i < n; ++i)
    if (result.state[i] == Adhesion::Apart)
      result.slip[i] = 0.0;
  return result;
}

TransientRolling::TransientRolling(HalfPlane &plane, double referenceLength, double layer)
    : halfPlane_(&plane), constant_(2.0 / mcawr::pi * std::log(referenceLength)), layer_(layer),
      traction_(Vector::Zero(plane.cells()))
{
}

void TransientRolling::moveTo(HalfPlane &plane, int shift)
{
  const auto moved = [&](const Vector &old) {
    Vector result = Vector::Zero(plane.cells());
    for (int i = 0; i < plane.cells(); ++i)
      if (i + shift >= 0 && i + shift < old.size())
        result[i] = old[i + shift];
    return result;
  };
  halfPlane_ = &plane;
  traction_ = moved(traction_);
}

// The constant makes displacements those against a point `referenceLength` cells away: without it
// a tangential force that changes would move the far ends of a half-plane by an unknown amount.
Vector TransientRolling::displacement(const Vector &q)
{
  return halfPlane_->displacement(q).array() + constant_ * q.sum() + layer_ * q.array();
}

int TransientRolling::solveStick(const Vector &stick, Vector &residual, Vector &q, double scale)
{
  Vector r = residual.cwiseProduct(stick), direction;
  double product = 0.0;
  constexpr int maxSteps = 400;
  for (int step = 0; step < maxSteps; ++step) {
    if (r.norm() <= scale)
      return step;
    const Vector z = halfPlane_->layeredEstimate(r, layer_).cwiseProduct(stick);
    const double newProduct = r.dot(z);
    direction = step ? Vector(z + newProduct / product * direction) : z;
    product = newProduct;
    const Vector moved = displacement(direction);
    const double length = product / direction.dot(moved);
    q += length * direction;
    residual -= length * moved;
    r = residual.cwiseProduct(stick);
  }
  throw Error(
      ExitCode::NotConverged,
      fmt::format("transient rolling: conjugate gradients stopped after {} steps", maxSteps));
}

// The displacement that the material brings along is that of the former traction moved by a cell,
// for the half-plane is the same everywhere: nothing but the traction needs to be remembered.
// On given states the slip is linear in the traction of the cells that stick, with an operator
// that is symmetric: conjugate gradients instead of the GMRES of steady rolling.
RollingResult TransientRolling::step(const Vector &bound, double creep, const Vector &imposed)
{
  const int n = halfPlane_->cells();
  Vector drive = Vector::Constant(n, creep);
  if (imposed.size() > 0)
    drive += imposed;
  const double scale = drive.cwiseAbs().maxCoeff();
  Vector carried = Vector::Zero(n);
  carried.head(n - 1) = traction_.tail(n - 1);
  Vector q = carried;
  RollingResult result;
  result.state = startStates(bound, {});
  for (int i = 0; i < n; ++i)
    if (std::abs(q[i]) >= bound[i] && bound[i] > 0.0)
      result.state[i] = q[i] > 0.0 ? Adhesion::Slip : Adhesion::BackwardSlip;
  constexpr int maxActiveSets = 60;
  for (int set = 1;; ++set) {
    const Vector stick = stickCells(result.state);
    for (int i = 0; i < n; ++i) {
      if (result.state[i] == Adhesion::Apart)
        q[i] = 0.0;
      if (slips(result.state[i]))
        q[i] = sign(result.state[i]) * bound[i];
    }
    result.slip = drive - displacement(q - carried);
    const double cells = stick.sum();
    if (cells > 0.0)
      result.products +=
          solveStick(stick, result.slip, q, transientTolerance * scale * std::sqrt(cells));
    result.activeSets = set;
    if (!updateStates(bound, q, result.slip, 10.0 * transientTolerance * scale, result.state))
      break;
    if (set >= maxActiveSets)
      throw Error(ExitCode::NotConverged,
                  fmt::format("transient rolling: no convergence after {} active sets", set));
  }
  traction_ = q;
  result.traction = q;
  for (int i = 0; i < n; ++i)
    if (result.state[i] == Adhesion::Apart)
      result.slip[i] = 0.0;
  return result;
}

} // namespace wheelrail
