// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/normal_contact.h"

#include "base/errors.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

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

/// The products of a half-space as they are, where the result lies.
class ExactProducts final : public ProductsOf<double> {
 public:
  explicit ExactProducts(HalfSpace &space) : space_(space) {}
  void displacement(const Field &pressure, Field &result) override
  {
    result.array() = space_.displacement(pressure).array();
  }
  void tractionEstimate(const Field &displacement, Field &result) override
  {
    result.array() = space_.tractionEstimate(displacement).array();
  }

 private:
  HalfSpace &space_;
};

/// Some cells of a grid, as the stretches in which they follow on each other. What is done to one
/// stretch after the other costs one way through memory, since a stretch stays in the nearest
/// cache.
class Stretches {
 public:
  /// \param chosen says it of cell i
  template<class Chosen>
  Stretches(int cells, const Chosen &chosen)
  {
    constexpr int longest = 1024;
    for (int i = 0; i < cells; ++i) {
      if (!chosen(i))
        continue;
      if (list_.empty() || list_.back().first + list_.back().length != i ||
          list_.back().length == longest)
        list_.push_back({i, size_, 0});
      ++list_.back().length;
      ++size_;
    }
  }
  int size() const { return size_; }
  /// Calls visit(its first cell, its place in a vector over the chosen cells, its length).
  template<class Visit>
  void each(const Visit &visit) const
  {
    for (const Stretch &s : list_)
      visit(s.first, s.at, s.length);
  }

 private:
  struct Stretch {
    int first, at, length;
  };
  std::vector<Stretch> list_;
  int size_ = 0;
};

/// term(0) + .. + term(n - 1), in as many partial sums as a processor adds at a time.
template<class Term>
double sumOf(int n, const Term &term)
{
  constexpr int parts = 8;
  double sums[parts] = {};
  int i = 0;
  for (; i + parts <= n; i += parts)
    for (int k = 0; k < parts; ++k)
      sums[k] += term(i + k);
  for (; i < n; ++i)
    sums[0] += term(i);
  return std::accumulate(sums, sums + parts, 0.0);
}

/// What corrections of one precision are computed in.
template<class Real>
struct Workspace {
  using Field = typename ProductsOf<Real>::Field;
  explicit Workspace(int cells)
      : field(cells), image(cells), unit(Field::Zero(cells)), residual(cells), direction(cells),
        total(cells)
  {
  }
  Field field, image;               ///< over the grid: what a product takes and gives
  Field unit;                       ///< over the grid: `PressureSearch::renewUnit`
  Field residual, direction, total; ///< over the free cells, in the first places
  int unitCells = 0;                ///< free cells that `unit` was made for
};

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
        n_(space.cells()), limit_(limitsOf(input, n_)), quick_(space.quick()), exact_(space)
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
    changeGap(Vector::Zero(n_));
  }

  /// Conjugate gradients on the cells strictly inside the limits, then as much of the way there
  /// as lowers the energy when what leaves the limits is cut off.
  /// \return steps taken
  int solveInside(double tolerance, int maxSteps)
  {
    return quick_ ? solveInside(*quick_, workspace(quickWork_), tolerance, maxSteps)
                  : solveInside(exact_, workspace(exactWork_), tolerance, maxSteps);
  }

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
  template<class Real>
  Workspace<Real> &workspace(std::optional<Workspace<Real>> &work) const
  {
    if (!work)
      work.emplace(n_);
    return *work;
  }
  template<class Real>
  int solveInside(ProductsOf<Real> &products, Workspace<Real> &work, double tolerance,
                  int maxSteps);
  /// What the estimate makes of a uniform change of the gap of the free cells.
  template<class Real>
  static void renewUnit(ProductsOf<Real> &products, const Stretches &free, Workspace<Real> &work);
  Vector inside() const
  {
    return (pressure.array() > 0.0 && pressure.array() < limit_.array()).cast<double>();
  }
  /// Gives the cells inside the limits what the others do not carry.
  void balance();
  /// The gap from all of the pressure, exactly.
  void renewGap();
  /// The gap after the pressure has changed.
  void changeGap(const Vector &before);
  template<class Field>
  void addToGap(double factor, const Field &image)
  {
    for (int i = 0; i < n_; ++i)
      gap[i] += factor * image[i];
  }
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
  double doubt_ = 0.0; ///< error of the gap by quick products, as the residual
  std::optional<Workspace<float>> quickWork_;
  std::optional<Workspace<double>> exactWork_;
};

void PressureSearch::renewGap()
{
  gap = problem_.profile + halfSpace_.displacement(pressure);
  doubt_ = 0.0;
}

void PressureSearch::changeGap(const Vector &before)
{
  if (!quick_) {
    renewGap();
    return;
  }
  Workspace<float> &work = workspace(quickWork_);
  float *const field = work.field.data();
  for (int i = 0; i < n_; ++i)
    field[i] = static_cast<float>(pressure[i] - before[i]);
  quick_->displacement(work.field, work.image);
  addToGap(1.0, work.image);
  const double change = sumOf(n_, [&](int i) { return double(field[i]) * field[i]; });
  doubt_ += quickError * std::sqrt(change) / pressure.norm();
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

template<class Real>
void PressureSearch::renewUnit(ProductsOf<Real> &products, const Stretches &free,
                               Workspace<Real> &work)
{
  work.field.setZero();
  free.each([&](int first, int, int n) { work.field.segment(first, n).setOnes(); });
  products.tractionEstimate(work.field, work.image);
  work.unit.setZero();
  free.each(
      [&](int first, int, int n) { work.unit.segment(first, n) = work.image.segment(first, n); });
  work.unitCells = free.size();
}

// At the solution the gap of every free cell is the approach, the multiplier of the condition that
// the load is kept. It is not known before. With A the displacements, M their estimated inverse and
// a field u, each step takes the mean gap with weights u for the approach, which makes u.residual
// zero, and takes the multiple of u off M residual that makes the step's sum zero: this is M
// between two projections, symmetric for any u. The best u is M 1, and it may be that of a similar
// set.
template<class Real>
int PressureSearch::solveInside(ProductsOf<Real> &products, Workspace<Real> &work, double tolerance,
                                int maxSteps)
{
  const Stretches free(n_, [this](int i) { return isInside(i); });
  const int cells = free.size();
  cut_ = false;
  settled_ = true;
  if (cells < 1)
    return 0;
  if (doubt_ > doubtShare * tolerance)
    renewGap();
  const bool isLoadKept = !problem_.approach;
  // places in vectors over the grid and over the free cells
  Real *const field = work.field.data(), *const image = work.image.data();
  Real *const unit = work.unit.data(), *const residuals = work.residual.data();
  Real *const directions = work.direction.data(), *const totals = work.total.data();
  /// The sum over the free cells of term(place over the grid, place over the free cells).
  const auto sumOfFree = [&](const auto &term) {
    double sum = 0.0;
    free.each([&](int first, int at, int n) {
      sum += sumOf(n, [&](int i) { return term(first + i, at + i); });
    });
    return sum;
  };
  constexpr double similar = 0.9; // share of the cells that two sets have in common
  if (isLoadKept && sumOfFree([&](int i, int) { return double(unit[i] > Real(0)); }) <
                        similar * std::max(cells, std::max(work.unitCells, 1)))
    renewUnit(products, free, work);
  const double contact = static_cast<double>((pressure.array() > 0.0).count());
  double unitSum = 1.0, carried = problem_.load;
  if (isLoadKept) {
    unitSum = sumOfFree([&](int i, int) { return double(unit[i]); });
    approach = sumOfFree([&](int i, int) { return unit[i] * gap[i]; }) / unitSum;
  } else {
    carried = pressure.sum();
  }
  work.field.setZero();
  free.each([&](int first, int at, int n) {
    for (int i = 0; i < n; ++i) {
      field[first + i] = residuals[at + i] = static_cast<Real>(approach - gap[first + i]);
      totals[at + i] = directions[at + i] = Real(0);
    }
  });

  double product = 1.0, goal = tolerance, first = 0.0; // product: residual . preconditioned
  int step = 0;
  for (;; ++step) {
    products.tractionEstimate(work.field, work.image);
    double sum = 0.0, newProduct = 0.0;
    free.each([&](int begin, int at, int n) {
      sum += sumOf(n, [&](int i) { return double(image[begin + i]); });
      newProduct += sumOf(n, [&](int i) { return double(image[begin + i]) * residuals[at + i]; });
    });
    const auto surplus = static_cast<Real>(isLoadKept ? sum / unitSum : 0.0);
    const auto kept = static_cast<Real>(step > 0 ? newProduct / product : 0.0);
    product = newProduct;
    double squares = 0.0, directionSum = 0.0;
    free.each([&](int begin, int at, int n) {
      Real *const direction = directions + at;
      for (int i = 0; i < n; ++i)
        image[begin + i] -= surplus * unit[begin + i];
      squares += sumOf(n, [&](int i) { return double(image[begin + i]) * image[begin + i]; });
      for (int i = 0; i < n; ++i)
        field[begin + i] = direction[i] = image[begin + i] + kept * direction[i];
      if (!isLoadKept)
        directionSum += sumOf(n, [&](int i) { return double(direction[i]); });
    });
    // The preconditioner turns what is left of the gap into the pressure that it is worth.
    residual = std::sqrt(squares / cells) / std::abs(carried / contact);
    if (step == 0) {
      first = residual;
      if (quick_)
        goal = std::max(tolerance, quickShare * residual);
    }
    settled_ = residual <= tolerance;
    if (residual <= goal || step >= maxSteps)
      break;
    products.displacement(work.field, work.image);
    double curvature = 0.0, shift = 0.0; // shift: of the mean gap
    free.each([&](int begin, int at, int n) {
      curvature += sumOf(n, [&](int i) { return double(directions[at + i]) * image[begin + i]; });
      if (isLoadKept)
        shift += sumOf(n, [&](int i) { return double(unit[begin + i]) * image[begin + i]; });
    });
    shift /= unitSum;
    if (!(curvature > 0.0)) {
      settled_ = true; // rounding: nothing is left to gain
      break;
    }
    const double length = product / curvature;
    const auto way = static_cast<Real>(length), mean = static_cast<Real>(shift);
    free.each([&](int begin, int at, int n) {
      for (int i = 0; i < n; ++i) {
        totals[at + i] += way * directions[at + i];
        residuals[at + i] -= way * (image[begin + i] - mean);
        field[begin + i] = residuals[at + i];
      }
    });
    addToGap(length, work.image);
    approach += length * shift;
    carried += length * directionSum;
  }
  if (step == 0)
    return 0;
  if (careful_) {
    Vector change = Vector::Zero(n_);
    free.each([&](int begin, int at, int n) {
      change.segment(begin, n) = work.total.segment(at, n).template cast<double>();
    });
    const Vector target = pressure + change;
    if (!(target.array() >= 0.0 && target.array() <= limit_.array()).all()) {
      renewGap();
      descend(change, inside(), 1.0);
      return step;
    }
  }
  // what rounding has changed of the load
  const double excess =
      isLoadKept ? sumOfFree([&](int, int at) { return double(totals[at]); }) / unitSum : 0.0;
  free.each([&](int begin, int at, int n) {
    for (int i = 0; i < n; ++i)
      pressure[begin + i] += totals[at + i] - excess * unit[begin + i];
  });
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
  const Stretches free(n_, [this](int i) { return isInside(i); });
  const auto highest = [this](int i) { return (1.0 - rounding) * limit_[i]; };
  double carried = 0.0;
  double lowest = std::numeric_limits<double>::infinity(); // limit of the cells in between
  free.each([&](int first, int, int n) {
    carried += sumOf(n, [&](int i) { return pressure[first + i]; });
    for (int i = first; i < first + n; ++i)
      lowest = std::min(lowest, highest(i));
  });
  const double wanted = problem_.load - (pressure.sum() - carried);
  const double uniform = wanted / free.size();
  if (free.size() > 0 && uniform > 0.0 && uniform < lowest) {
    // scaled, and as far towards uniform as the limits ask: both carry the load
    const double factor = wanted / carried;
    double part = 1.0;
    free.each([&](int first, int, int n) {
      for (int i = first; i < first + n; ++i)
        if (const double scaled = factor * pressure[i]; scaled >= highest(i))
          part = std::min(part, (highest(i) - uniform) / (scaled - uniform));
    });
    free.each([&](int first, int, int n) {
      for (int i = first; i < first + n; ++i)
        pressure[i] = part * factor * pressure[i] + (1.0 - part) * uniform;
    });
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
  const Vector before = pressure;
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
    changeGap(before);
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
  result.pressure = std::move(search.pressure);
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
