// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/normal_contact.h"

#include "base/errors.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <memory>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double coarseTolerance = 1e-3; ///< a start for the next grid needs no more
constexpr double rounding = 1e-14;
constexpr int boldSets = 20;            ///< sets that may raise the energy; mostly 8 are enough
constexpr double firstTolerance = 1e-2; ///< the first sets are wrong anyway
constexpr double quickError = 1e-6;     ///< of quick products, relative
constexpr double quickShare = 1e-4;     ///< of a residual that steps with quick products leave
constexpr double doubtShare = 0.1;      ///< of the tolerance that their errors may come to

Vector limitsOf(const NormalContactProblem &problem, int cells)
{
  return problem.cellLimits.size() > 0 ? problem.cellLimits
                                       : Vector::Constant(cells, problem.pressureLimit);
}

/// The products of a half-space as they are.
class ExactProducts final : public QuickProducts {
 public:
  explicit ExactProducts(HalfSpace &space) : space_(space) {}
  void displacement(const Vector &pressure, Vector &result) override
  {
    result = space_.displacement(pressure);
  }
  void tractionEstimate(const Vector &displacement, Vector &result) override
  {
    result = space_.tractionEstimate(displacement);
  }

 private:
  HalfSpace &space_;
};

/// Some cells of a grid, as the stretches in which they follow on each other: a vector over them is
/// short, and quickly taken from one over the grid.
class Stretches {
 public:
  /// \param chosen says it of cell i
  template<class Chosen>
  Stretches(int cells, const Chosen &chosen)
  {
    for (int i = 0; i < cells; ++i) {
      if (!chosen(i))
        continue;
      if (list_.empty() || list_.back().first + list_.back().length != i)
        list_.push_back({i, 0});
      ++list_.back().length;
      ++size_;
    }
  }
  int size() const { return size_; }
  void take(const Vector &whole, Vector &part) const
  {
    int at = 0;
    for (const Stretch &s : list_) {
      part.segment(at, s.length) = whole.segment(s.first, s.length);
      at += s.length;
    }
  }
  void put(const Vector &part, Vector &whole) const
  {
    int at = 0;
    for (const Stretch &s : list_) {
      whole.segment(s.first, s.length) = part.segment(at, s.length);
      at += s.length;
    }
  }

 private:
  struct Stretch {
    int first, length;
  };
  std::vector<Stretch> list_;
  int size_ = 0;
};

/// Calls pass(first, count) for stretches of n values that stay in the nearest cache, so that what
/// is done to them one after the other costs one way through memory.
template<class Pass>
void inStretches(int n, const Pass &pass)
{
  constexpr int most = 1024;
  for (int first = 0; first < n; first += most)
    pass(first, std::min(most, n - first));
}

/// One grid's search, as a loop of two moves: `solveInside` finds the pressures of the cells in
/// between as if the others were fixed, then `jump` or `join` changes who is in between.
///
/// That the mean gap of the cells in between stands for the unknown approach is Polonsky and Keer's
/// (Wear 231 (1999) 206). Unlike theirs, the set stays as it is while conjugate gradients run, so
/// that they remain conjugate and the preconditioner may be cut to the set.
///
/// `jump` moves every cell that breaks its condition at once. That is bold: the energy may rise,
/// but from a coarser grid's start 8 sets are mostly enough, however many cells there are. Now and
/// then the sets cycle. Then `beCareful` makes every move lower the energy: `solveInside` goes only
/// as far as that allows, and `join` takes one step of projected gradient, which cannot cycle,
/// since no set of cells comes back at a lower energy.
///
/// Corrections need few digits: where the half-space offers quicker products they serve as long as
/// their errors are small beside the tolerance of the set. Then the gap is computed anew from all
/// of the pressure, and the correction that is left is smaller by as much.
///
/// The quadratic programme: minimise p.A p/2 + profile.p with 0 <= p <= limit, sum p = load; or,
/// where the approach is given, p.A p/2 + (profile - approach).p with 0 <= p <= limit.
class PressureSearch {
 public:
  PressureSearch(HalfSpace &space, const NormalContactProblem &input)
      : approach(input.approach.value_or(0.0)), halfSpace_(space), problem_(input),
        n_(space.cells()), limit_(limitsOf(input, n_)), quick_(space.quick()), exact_(space),
        field_(Vector::Zero(n_)), image_(Vector::Zero(n_))
  {
  }

  /// From any guess: the nearest admissible pressure with the same shape.
  void startFrom(const Vector &guess)
  {
    pressure = guess.cwiseMax(0.0);
    if (!problem_.approach)
      pressure *= problem_.load / pressure.sum();
    pressure = projected(pressure, Vector::Ones(n_));
    gap = problem_.profile;
    changeGap(pressure);
  }

  /// Conjugate gradients on the cells strictly inside the limits, then as much of the way there
  /// as lowers the energy when what leaves the limits is cut off.
  /// \return steps taken
  int solveInside(double tolerance, int maxSteps);

  /// Lets cells that overlap, or that lie at the limit but apart, join by one step of projected
  /// gradient.
  /// \return how many broke their condition by more than the tolerance
  int join(double tolerance);

  /// Without regard to the energy: what pulls is released, what is above the limit is set to it,
  /// what overlaps joins, all at once.
  /// \return number of cells that changed
  int jump(double tolerance);

  bool wasCut() const { return cut_; }
  /// Did the last `solveInside` meet its tolerance, or come as near as rounding lets it?
  bool isSettled() const { return settled_; }
  /// From now on the energy has to fall in every step: slower, but it cannot cycle.
  void beCareful()
  {
    if (!careful_)
      renewGap();
    quick_ = nullptr;
    careful_ = true;
  }
  CellState state(int i) const
  {
    if (pressure[i] <= 0.0)
      return CellState::Apart;
    return pressure[i] >= limit_[i] ? CellState::Plastic : CellState::Contact;
  }

  /// The load, or what is carried at the given approach.
  double load() const { return problem_.approach ? pressure.sum() : problem_.load; }

  Vector pressure;
  Vector gap; ///< profile + displacement, before the approach is taken off
  double approach;
  double residual = std::numeric_limits<double>::infinity();

 private:
  bool isInside(int i) const { return pressure[i] > 0.0 && pressure[i] < limit_[i]; }
  Vector inside() const
  {
    return (pressure.array() > 0.0 && pressure.array() < limit_.array()).cast<double>();
  }
  /// Gives the cells inside the limits what the others do not carry.
  void balance();
  /// The gap from all of the pressure, exactly.
  void renewGap();
  /// The gap after a change of the pressure that has been made.
  void changeGap(const Vector &change);
  /// Nearest point of {0 <= p <= limit, sum p = load where it is given} that differs only where
  /// free is 1.
  Vector projected(const Vector &wanted, const Vector &free) const;
  /// Moves to the projection of pressure + length * direction, the length halved until the energy
  /// falls by a tenth of what the slope promises.
  /// \return false if rounding leaves nothing to gain
  bool descend(const Vector &direction, const Vector &free, double length);

  HalfSpace &halfSpace_;
  const NormalContactProblem &problem_;
  int n_;
  Vector limit_; ///< of each cell
  bool cut_ = false, careful_ = false, settled_ = false;
  QuickProducts *quick_; ///< null: products are exact
  ExactProducts exact_;
  double doubt_ = 0.0;   ///< error of the gap by quick products, as the residual
  Vector field_, image_; ///< work space, over the grid
};

void PressureSearch::renewGap()
{
  gap = problem_.profile + halfSpace_.displacement(pressure);
  doubt_ = 0.0;
}

void PressureSearch::changeGap(const Vector &change)
{
  if (!quick_) {
    renewGap();
    return;
  }
  quick_->displacement(change, image_);
  gap += image_;
  doubt_ += quickError * change.norm() / pressure.norm();
}

Vector PressureSearch::projected(const Vector &wanted, const Vector &free) const
{
  if (problem_.approach)
    return (free.array() == 0.0).select(pressure, wanted.cwiseMax(0.0).cwiseMin(limit_));
  // clamp(wanted - shift) carries the load at one shift; Newton on a piecewise linear, monotone
  // function, kept between bounds
  const double highest = std::min(limit_.maxCoeff(), problem_.load);
  double low = -highest, high = highest; // too much is carried at `low`, nothing at `high`
  for (int i = 0; i < n_; ++i) {
    if (free[i] == 0.0)
      continue;
    low = std::min(low, wanted[i] - highest);
    high = std::max(high, wanted[i]);
  }
  const auto shifted = [&](double shift) {
    Vector p = wanted;
    for (int i = 0; i < n_; ++i)
      p[i] = free[i] == 0.0 ? pressure[i] : std::clamp(wanted[i] - shift, 0.0, limit_[i]);
    return p;
  };
  double shift = 0.0;
  Vector p = shifted(shift);
  for (int step = 0; step < 200; ++step) {
    const double excess = p.sum() - problem_.load;
    if (std::abs(excess) <= rounding * problem_.load)
      break;
    (excess > 0.0 ? low : high) = shift;
    const double moving = // minus the slope: how many cells follow the shift
        (free.array() * ((p.array() > 0.0 && p.array() < limit_.array())).cast<double>()).sum();
    const double newton = shift + excess / moving;
    shift = newton > low && newton < high ? newton : 0.5 * (low + high);
    p = shifted(shift);
  }
  return p;
}

bool PressureSearch::descend(const Vector &direction, const Vector &free, double length)
{
  constexpr double sufficient = 0.1, shortest = 1e-6;
  for (double part = 1.0; part > shortest; part *= 0.5) {
    const Vector wanted = pressure + part * length * direction;
    const Vector target = projected(wanted, free);
    const Vector step = target - pressure;
    // The energy is quadratic: its change is slope + step.A step/2 exactly. Where the load is kept
    // the steps' sum is 0 and the approach drops out.
    const double slope = step.dot(gap) - approach * step.sum();
    const Vector change = halfSpace_.displacement(step);
    if (!(slope + 0.5 * step.dot(change) < sufficient * slope))
      continue;
    cut_ = part < 1.0 || ((target - wanted).array() != 0.0).any();
    pressure = target;
    gap += change;
    return true;
  }
  return false;
}

int PressureSearch::solveInside(double tolerance, int maxSteps)
{
  const Stretches free(n_, [this](int i) { return isInside(i); });
  const int cells = free.size();
  cut_ = false;
  settled_ = true;
  if (cells < 1)
    return 0;
  if (doubt_ > doubtShare * tolerance)
    renewGap();
  const double contact = static_cast<double>((pressure.array() > 0.0).count());
  QuickProducts &products = quick_ ? *quick_ : exact_;
  // Vectors over the free cells; `field_` is zero elsewhere.
  field_.setZero();
  const auto multiply = [&](const Vector &of, Vector &result,
                            void (QuickProducts::*make)(const Vector &, Vector &)) {
    free.put(of, field_);
    (products.*make)(field_, image_);
    free.take(image_, result);
  };
  // What the preconditioner makes of a change of the approach; taken off, it leaves the load alone
  Vector r = Vector::Ones(cells), unit(cells);
  if (!problem_.approach)
    multiply(r, unit, &QuickProducts::tractionEstimate);
  const double unitSum = unit.sum(), pressureSum = pressure.sum();

  Vector total = Vector::Zero(cells), direction = total, current(cells), z(cells), change(cells);
  free.take(gap, current);
  double product = 0.0, goal = tolerance, first = 0.0; // product: residual . preconditioned
  double mean = current.mean();
  // At the solution the gap of every free cell is the approach, the multiplier of the condition
  // that the load is kept. It is not known before: each step takes the mean gap for it, which makes
  // the residual's sum zero, and takes the multiple of `unit` off that makes the step's sum zero.
  int step = 0;
  for (;; ++step) {
    if (!problem_.approach)
      approach = mean;
    r = approach - current.array();
    multiply(r, z, &QuickProducts::tractionEstimate);
    const double surplus = problem_.approach ? 0.0 : z.sum() / unitSum;
    double squares = 0.0, newProduct = 0.0;
    inStretches(cells, [&](int at, int count) {
      auto part = z.segment(at, count);
      if (!problem_.approach)
        part -= surplus * unit.segment(at, count);
      squares += part.squaredNorm();
      newProduct += part.dot(r.segment(at, count));
    });
    // The preconditioner turns what is left of the gap into the pressure that it is worth.
    const double meanPressure =
        (problem_.approach ? pressureSum + total.sum() : problem_.load) / contact;
    residual = std::sqrt(squares / cells) / std::abs(meanPressure);
    if (step == 0) {
      first = residual;
      if (quick_)
        goal = std::max(tolerance, quickShare * residual);
    }
    settled_ = residual <= tolerance;
    if (residual <= goal || step >= maxSteps)
      break;
    direction = z + (step > 0 ? newProduct / product : 0.0) * direction;
    product = newProduct;
    multiply(direction, change, &QuickProducts::displacement);
    double curvature = 0.0, slope = 0.0;
    inStretches(cells, [&](int at, int count) {
      const auto part = direction.segment(at, count);
      curvature += part.dot(change.segment(at, count));
      slope += part.dot(r.segment(at, count));
    });
    if (!(curvature > 0.0)) {
      settled_ = true; // rounding: nothing is left to gain
      break;
    }
    const double length = slope / curvature;
    mean = 0.0;
    inStretches(cells, [&](int at, int count) {
      total.segment(at, count) += length * direction.segment(at, count);
      current.segment(at, count) += length * change.segment(at, count);
      mean += current.segment(at, count).sum();
    });
    mean /= cells;
    gap += length * image_;
  }
  if (step == 0)
    return 0;
  free.put(total, field_);
  if (careful_) {
    const Vector target = pressure + field_;
    if (!(target.array() >= 0.0 && target.array() <= limit_.array()).all()) {
      renewGap();
      descend(Vector(field_), inside(), 1.0);
      return step;
    }
  }
  pressure += field_;
  doubt_ += quick_ ? quickError * first : 0.0;
  if (doubt_ > doubtShare * tolerance) {
    renewGap();
    settled_ = false;
  }
  return step;
}

int PressureSearch::join(double tolerance)
{
  const Vector free = inside();
  if (free.sum() < 1.0 &&
      !problem_.approach) { // nothing in between: the approach lies between the two kinds' gaps
    double limited = -std::numeric_limits<double>::infinity(), apart = -limited;
    for (int i = 0; i < n_; ++i)
      if (pressure[i] > 0.0)
        limited = std::max(limited, gap[i]);
      else
        apart = std::min(apart, gap[i]);
    approach = std::isfinite(apart) ? 0.5 * (limited + apart) : limited;
  }
  const double threshold = tolerance * halfSpace_.displacementScale(load()); // of the gap
  const Vector slope = approach - gap.array();
  Vector active = slope; // without the cells that their limit keeps from following the slope
  int broken = 0;
  for (int i = 0; i < n_; ++i) {
    const CellState is = state(i);
    if (is == CellState::Contact)
      continue;
    const double violation = is == CellState::Apart ? slope[i] : -slope[i];
    if (violation <= 0.0)
      active[i] = 0.0;
    broken += violation > threshold;
  }
  if (!broken)
    return 0;
  // As far as the minimum along `active` if no limit were met; `descend` shortens it where one is.
  const double curvature = active.dot(halfSpace_.displacement(active));
  const double length = active.squaredNorm() / std::abs(curvature);
  return descend(slope, Vector::Ones(n_), length) ? broken : 0;
}

void PressureSearch::balance()
{
  if (problem_.approach)
    return;
  const Vector free = inside();
  const double cells = free.sum(), carried = pressure.dot(free);
  const double wanted = problem_.load - (pressure.sum() - carried);
  const auto highest = [this](int i) { return (1.0 - rounding) * limit_[i]; };
  const double uniform = wanted / cells;
  double lowest = std::numeric_limits<double>::infinity(); // limit of the cells in between
  for (int i = 0; i < n_; ++i)
    if (free[i] != 0.0)
      lowest = std::min(lowest, highest(i));
  if (cells > 0.0 && uniform > 0.0 && uniform < lowest) {
    // scaled, and as far towards uniform as the limits ask: both carry the load
    const double factor = wanted / carried;
    double part = 1.0;
    for (int i = 0; i < n_; ++i)
      if (const double scaled = factor * pressure[i]; free[i] != 0.0 && scaled >= highest(i))
        part = std::min(part, (highest(i) - uniform) / (scaled - uniform));
    for (int i = 0; i < n_; ++i)
      if (free[i] != 0.0)
        pressure[i] = part * factor * pressure[i] + (1.0 - part) * uniform;
  } else {
    pressure = projected(pressure, Vector::Ones(n_));
  }
}

// A cell that joins gets next to nothing, for the cells in between are told by 0 < p < limit: the
// next `solveInside` gives it what it carries.
int PressureSearch::jump(double tolerance)
{
  const double threshold = tolerance * halfSpace_.displacementScale(load()),
               little = rounding * load() / n_;
  field_ = pressure;
  int changed = 0;
  for (int i = 0; i < n_; ++i) {
    const double p = pressure[i], distance = gap[i] - approach;
    if (p < 0.0)
      pressure[i] = 0.0;
    else if (p > limit_[i])
      pressure[i] = limit_[i];
    else if (p == 0.0 && distance < -threshold)
      pressure[i] = little;
    else if (p == limit_[i] && distance > threshold)
      pressure[i] = std::min(p - little, std::nextafter(p, 0.0)); // little may be lost in p
    changed += pressure[i] != p;
  }
  if (changed) {
    balance();
    field_ = pressure - field_;
    changeGap(field_);
  }
  return changed;
}

} // namespace

int NormalContactResult::contactCells() const
{
  return static_cast<int>((pressure.array() > 0.0).count());
}

namespace {

/// The problem on a coarser grid of the same half-space.
NormalContactProblem coarsened(const NormalContactProblem &fine, const CellGrid &grid,
                               const CellGrid &coarseGrid)
{
  NormalContactProblem coarse = fine;
  coarse.profile = coarseMean(grid, coarseGrid, fine.profile);
  if (fine.cellLimits.size() > 0)
    coarse.cellLimits = coarseMean(grid, coarseGrid, fine.cellLimits);
  coarse.load = fine.load * coarseGrid.cells() / grid.cells(); // a sum of pressures, not a force
  return coarse;
}

NormalContactResult solveOnGrids(HalfSpace &halfSpace, const NormalContactProblem &problem,
                                 const NormalContactOptions &options)
{
  const int n = halfSpace.cells();
  PressureSearch search(halfSpace, problem);
  int iterations = 0;
  if (options.start.size() == n && options.start.maxCoeff() > 0.0) {
    search.startFrom(options.start);
  } else if (HalfSpace *coarseSpace = halfSpace.coarser()) {
    NormalContactOptions coarseOptions = options;
    coarseOptions.start.resize(0);
    coarseOptions.tolerance = coarseTolerance;
    const CellGrid &grid = halfSpace.grid(), &coarseGrid = coarseSpace->grid();
    const NormalContactResult coarse =
        solveOnGrids(*coarseSpace, coarsened(problem, grid, coarseGrid), coarseOptions);
    iterations = coarse.iterations;
    search.startFrom(refinedField(grid, coarseGrid, coarse.pressure));
  } else if (problem.approach) {
    search.startFrom(
        halfSpace.tractionEstimate((*problem.approach - problem.profile.array()).max(0.0)));
  } else {
    search.startFrom(Vector::Constant(n, problem.load / n));
  }

  NormalContactResult result;
  double tolerance = std::max(options.tolerance, firstTolerance);
  for (int set = 1;; ++set) {
    if (set > boldSets)
      search.beCareful();
    iterations += search.solveInside(tolerance, options.maxIterations - iterations);
    const int changed =
        set <= boldSets ? search.jump(options.tolerance) : search.join(options.tolerance);
    result.activeSets = set;
    if (!changed && !search.wasCut() && search.isSettled() && tolerance <= options.tolerance)
      break;
    if (set >= options.maxActiveSets || iterations >= options.maxIterations)
      throw Error(ExitCode::NotConverged,
                  fmt::format("normal contact: no convergence after {} active sets, {} iterations, "
                              "residual {:.2e} (wanted {:.2e})",
                              set, iterations, search.residual, options.tolerance));
    // Ten times tighter with each set, in full as soon as the set stands: only a set that stays
    // when its pressures are exact is the solution.
    tolerance = std::max(options.tolerance, changed ? 0.1 * tolerance : 0.0);
  }

  result.iterations = iterations;
  result.residual = search.residual;
  result.approach = search.approach;
  result.pressure = search.pressure;
  result.gap = Vector::Zero(n);
  result.plasticDepth = Vector::Zero(n);
  result.state.resize(n);
  for (int i = 0; i < n; ++i) {
    const double distance = search.gap[i] - search.approach;
    result.state[i] = search.state(i);
    if (result.state[i] == CellState::Apart)
      result.gap[i] = std::max(0.0, distance);
    if (result.state[i] == CellState::Plastic)
      result.plasticDepth[i] = std::max(0.0, -distance);
  }
  return result;
}

} // namespace

NormalContactResult solveNormalContact(HalfSpace &halfSpace, const NormalContactProblem &problem,
                                       const NormalContactOptions &options)
{
  const auto begin = std::chrono::steady_clock::now();
  const int n = halfSpace.cells();
  if (problem.profile.size() != n || !problem.profile.allFinite() ||
      (problem.cellLimits.size() != 0 && problem.cellLimits.size() != n))
    throw Error(ExitCode::Internal, "normal contact: profile or limits do not fit the grid");
  const double capacity = limitsOf(problem, n).sum();
  if (!problem.approach && (!(problem.load > 0.0) || problem.load >= capacity))
    throw Error(
        ExitCode::BadInput,
        fmt::format("contact.hardness_limit: the load needs a mean pressure of {:.5g} MPa over all "
                    "that is computed; it must be positive and below the hardness, {:.5g} MPa (3 "
                    "friction.strength)",
                    problem.load / n * problem.pascals * 1e-6,
                    capacity / n * problem.pascals * 1e-6));
  NormalContactResult result;
  if (problem.approach && problem.profile.minCoeff() >= *problem.approach) {
    result.pressure = result.plasticDepth = Vector::Zero(n);
    result.gap = problem.profile.array() - *problem.approach;
    result.state.assign(n, CellState::Apart);
    result.approach = *problem.approach;
  } else {
    result = solveOnGrids(halfSpace, problem, options);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

} // namespace wheelrail
