// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/tangential.h"

#include "contact/patch/solvers/friction_newton.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr int coarsest = 24;       ///< cells of the grid's longer side, at least
constexpr double forceShare = 0.1; ///< of the tolerance, where forces are prescribed and to be met
constexpr std::size_t pastSteps = 2;     ///< 3 or more save no product
constexpr double coarseTolerance = 1e-2; ///< a start for the next grid needs no more

} // namespace

ForceTooLarge::ForceTooLarge(double given, double most)
    : Error(ExitCode::BadInput,
            fmt::format("a force of {:.5g} N cannot be carried: friction allows "
                        "less than {:.5g} N",
                        given, most)),
      force(given), capacity(most)
{
}

int TangentialResult::stickCells() const
{
  return static_cast<int>(std::count(state.begin(), state.end(), PatchState::Stick));
}
int TangentialResult::slipCells() const
{
  return static_cast<int>(std::count(state.begin(), state.end(), PatchState::Slip));
}

/// Steps from one solution of steady rolling to the next, the latest last. They serve where the
/// operator is the same.
struct PastSteps {
  std::vector<int> cells; ///< in contact
  std::vector<int> unknown;
  Vector edge;
  std::vector<KnownStep> steps;
};

struct TangentialSolver::Work {
  PatchGrid grid;
  ElasticPair pair;
  std::unique_ptr<PatchHalfSpace> space; ///< of the last box
  PastSteps past;

  PatchHalfSpace &spaceOn(const PatchGrid &box)
  {
    if (!space || space->grid().nx != box.nx || space->grid().ny != box.ny)
      space = std::make_unique<PatchHalfSpace>(box, pair);
    return *space;
  }
};

TangentialSolver::TangentialSolver(const PatchGrid &grid, const ElasticPair &pair)
    : work_(std::make_unique<Work>(Work{grid, pair, nullptr, {}}))
{
}
TangentialSolver::~TangentialSolver() = default;
TangentialSolver::TangentialSolver(TangentialSolver &&) noexcept = default;
TangentialSolver &TangentialSolver::operator=(TangentialSolver &&) noexcept = default;

const PatchGrid &TangentialSolver::grid() const
{
  return work_->grid;
}

namespace {

bool worthCoarser(const PatchGrid &grid)
{
  return std::max(grid.nx, grid.ny) >= 2 * coarsest;
}

/// Cells twice as long, from the same corner; one column more at the leading edge, for it has to
/// stay free of contact however the columns fall together.
PatchGrid coarseGridOf(const PatchGrid &grid)
{
  const bool alongY = grid.ny > 1;
  return {{grid.nx / 2 + 1, alongY ? (grid.ny + 1) / 2 : 1, 2.0 * grid.dx,
           alongY ? 2.0 * grid.dy : grid.dy},
          grid.left,
          grid.bottom};
}

/// Calls visit(fine cell, coarse cell).
template<class Visit>
void eachPair(const PatchGrid &grid, const PatchGrid &coarse, const Visit &visit)
{
  const int rows = grid.ny > 1 ? 2 : 1;
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix)
      visit(grid.index(ix, iy), coarse.index(ix / 2, iy / rows));
}

/// Means of tractions, whose sum is the force: what is outside of the fine grid counts as zero, so
/// that the force stays.
Vector coarseMeans(const PatchGrid &grid, const PatchGrid &coarse, const Vector &fine)
{
  Vector sum = Vector::Zero(coarse.cells());
  eachPair(grid, coarse, [&](int i, int k) { sum[k] += fine[i]; });
  return sum / (grid.ny > 1 ? 4.0 : 2.0);
}

/// Means of displacements, over the fine cells that there are; empty stays empty.
TangentialField coarseDisplacement(const PatchGrid &grid, const PatchGrid &coarse,
                                   const TangentialField &fine)
{
  if (fine.x.size() != grid.cells())
    return {};
  Vector count = Vector::Zero(coarse.cells());
  TangentialField sum{count, count};
  eachPair(grid, coarse, [&](int i, int k) {
    sum.x[k] += fine.x[i];
    sum.y[k] += fine.y[i];
    count[k] += 1.0;
  });
  count = count.cwiseMax(1.0);
  return {sum.x.cwiseQuotient(count), sum.y.cwiseQuotient(count)};
}

TangentialProblem coarsened(const PatchGrid &grid, const PatchGrid &coarse,
                            const TangentialProblem &fine)
{
  TangentialProblem problem = fine;
  problem.bound = coarseMeans(grid, coarse, fine.bound);
  problem.previous = coarseDisplacement(grid, coarse, fine.previous);
  problem.imposed = coarseDisplacement(grid, coarse, fine.imposed);
  problem.edge = {};
  return problem;
}

/// The coarse tractions over their bound, linear between the middles of the coarse cells in
/// contact, times the fine bound: steps would slip by the size of the creep.
TangentialField refined(const PatchGrid &grid, const PatchGrid &coarse, const Vector &fineBound,
                        const Vector &coarseBound, const TangentialField &traction)
{
  TangentialField fine{Vector::Zero(grid.cells()), Vector::Zero(grid.cells())};
  const int rows = grid.ny > 1 ? 2 : 1;
  const auto inContact = [&](int ix, int iy) {
    return ix >= 0 && ix < coarse.nx && iy >= 0 && iy < coarse.ny &&
           coarseBound[coarse.index(ix, iy)] > 0.0;
  };
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const int i = grid.index(ix, iy);
      if (!(fineBound[i] > 0.0))
        continue;
      const int nearX = ix / 2, nearY = iy / rows;
      const int farX = nearX + (ix % 2 ? 1 : -1), farY = nearY + (rows == 1 ? 0 : iy % 2 ? 1 : -1);
      const struct {
        int ix, iy;
        double weight;
      } corners[] = {
          {nearX, nearY, 9.0}, {farX, nearY, 3.0}, {nearX, farY, 3.0}, {farX, farY, 1.0}};
      double weights = 0.0, x = 0.0, y = 0.0;
      for (const auto &corner : corners) {
        if (!inContact(corner.ix, corner.iy))
          continue;
        const int k = coarse.index(corner.ix, corner.iy);
        const double share = std::isfinite(coarseBound[k]) ? 1.0 / coarseBound[k] : 1.0;
        weights += corner.weight;
        x += corner.weight * share * traction.x[k];
        y += corner.weight * share * traction.y[k];
      }
      const double scale = (std::isfinite(fineBound[i]) ? fineBound[i] : 1.0) / weights;
      fine.x[i] = scale * x;
      fine.y[i] = scale * y;
    }
  return fine;
}

/// The cells in contact and their box; the equations there, scaled. `tractionUnit` is the largest
/// bound, `slipUnit` what a cell of that traction moves under itself, `distance` the d over which S
/// is counted: a creepage 1 is distance/slipUnit in the scaled equations.
struct ScaledProblem {
  SubGrid box;
  std::vector<int> wholeIndex; ///< in the whole grid, of each cell in contact
  double distance, tractionUnit, slipUnit;
  double capacity = 0.0; ///< sum of the scaled bounds
  FrictionNewton::Equations equations;
};

void checkLeadingColumn(const PatchGrid &grid, const Vector &bound)
{
  for (int iy = 0; iy < grid.ny; ++iy)
    if (bound[grid.index(grid.nx - 1, iy)] > 0.0)
      throw Error(ExitCode::BadInput,
                  "contact.domain: the contact reaches the leading column of the box of cells; "
                  "increase it, or contact.box, or cells beside contact.cell");
}

/// Rigid slip over the distance d, less the displacement u' of a step: all of S that the traction
/// sought does not change. Creepages that are unknown are left out; `FrictionNewton` adds them.
/// The residual is measured against the rigid slip, or against u' where that is all there is.
void setDrive(const PatchGrid &grid, const TangentialProblem &problem, ScaledProblem &scaled)
{
  const int n = static_cast<int>(scaled.wholeIndex.size());
  const Creepage &creep = problem.creepage;
  const double xi = problem.forceX ? 0.0 : creep.xi, eta = problem.forceY ? 0.0 : creep.eta;
  const double unit = scaled.distance / scaled.slipUnit;
  Vector &drive = scaled.equations.drive;
  drive.resize(2 * n);
  for (int i = 0; i < n; ++i) {
    const int cell = scaled.wholeIndex[i];
    const double x = grid.x(cell % grid.nx) + problem.spinPoint * scaled.distance;
    const double y = grid.y(cell / grid.nx);
    drive[2 * i] = unit * (xi - creep.phi * y);
    drive[2 * i + 1] = unit * (eta + creep.phi * x);
  }
  double given = drive.norm();
  const bool steady = scaled.equations.steady;
  const auto add = [&](const TangentialField &field, int ahead, double sign) {
    if (field.x.size() != grid.cells())
      return;
    const double part = sign / scaled.slipUnit;
    for (int i = 0; i < n; ++i) {
      drive[2 * i] += part * field.x[scaled.wholeIndex[i] + ahead];
      drive[2 * i + 1] += part * field.y[scaled.wholeIndex[i] + ahead];
    }
  };
  add(problem.imposed, 0, 1.0);
  if (steady) {
    add(problem.imposed, 1, -1.0);
    given = std::max(given, drive.norm());
  } else {
    add(problem.previous, 0, -1.0);
  }
  scaled.equations.scale = given > 0.0 ? given : drive.norm();
}

/// Edge cells give way by more than the half-spaces: in units of a cell's own compliance.
void setEdge(const TangentialProblem &problem, double compliance, ScaledProblem &scaled)
{
  if (problem.edge.xx.size() != problem.bound.size())
    return;
  const int n = static_cast<int>(scaled.wholeIndex.size());
  scaled.equations.edge.resize(3 * n);
  for (int i = 0; i < n; ++i) {
    const int cell = scaled.wholeIndex[i];
    scaled.equations.edge[3 * i] = problem.edge.xx[cell] / compliance;
    scaled.equations.edge[3 * i + 1] = problem.edge.yy[cell] / compliance;
    scaled.equations.edge[3 * i + 2] = problem.edge.xy[cell] / compliance;
  }
}

/// Forces in units of a cell's. Where they are more than the rigid slip, the residual is measured
/// against the tractions that carry them, spread as the bound is; never against more than the
/// bound.
void setForces(const PatchGrid &grid, const TangentialProblem &problem, ScaledProblem &scaled)
{
  FrictionNewton::Equations &eq = scaled.equations;
  const double cellForce = scaled.tractionUnit * grid.cellArea();
  double given = 0.0;
  for (int component : {0, 1}) {
    const auto &force = component ? problem.forceY : problem.forceX;
    if (!force)
      continue;
    eq.unknown.push_back(component);
    eq.force.push_back(*force / cellForce);
    given = std::hypot(given, *force / cellForce);
  }
  if (given >= scaled.capacity)
    throw ForceTooLarge(given * cellForce, scaled.capacity * cellForce);
  const bool limited = std::isfinite(scaled.capacity);
  const double most = limited ? eq.bound.norm() : std::numeric_limits<double>::max();
  if (given > 0.0)
    eq.scale = std::max(eq.scale, limited ? most * given / scaled.capacity : given);
  eq.scale = std::min(eq.scale, most);
}

/// Tractions in units of the largest bound, on the smallest box around the contact: outside of it
/// there is no traction, and transforms cost by the box. Steady rolling needs the displacement one
/// column ahead of the contact too.
ScaledProblem scaledProblem(const PatchGrid &grid, const TangentialProblem &problem, double G)
{
  ScaledProblem scaled;
  FrictionNewton::Equations &eq = scaled.equations;
  eq.steady = problem.kind == TangentialProblem::Kind::Steady;
  scaled.distance = eq.steady ? grid.dx : problem.distance;
  scaled.box = boundingBox(grid, problem.bound, eq.steady ? 1 : 0);
  const PatchGrid &box = scaled.box.grid;
  scaled.tractionUnit = 0.0;
  for (int cell = 0; cell < box.cells(); ++cell) {
    const int whole =
        grid.index(scaled.box.firstX + cell % box.nx, scaled.box.firstY + cell / box.nx);
    if (!(problem.bound[whole] > 0.0))
      continue;
    eq.cells.push_back(cell);
    scaled.wholeIndex.push_back(whole);
    scaled.tractionUnit = std::max(scaled.tractionUnit, problem.bound[whole]);
  }
  if (!std::isfinite(scaled.tractionUnit)) // without slip everything is linear
    scaled.tractionUnit = G;
  eq.bound.resize(static_cast<int>(eq.cells.size()));
  for (int i = 0; i < eq.bound.size(); ++i)
    eq.bound[i] = problem.bound[scaled.wholeIndex[i]] / scaled.tractionUnit;
  scaled.capacity = eq.bound.sum();
  return scaled;
}

} // namespace

// What is done on one grid; the nonlinear equations themselves are `FrictionNewton`'s.
//
//   1. The cells in contact are listed, and the smallest box around them is cut out of the grid.
//      Tractions are counted in units of the largest bound, slips in what a cell of that traction
//      moves under itself: then all of the equations are of order 1, whatever the units.
//   2. What moves the contact is gathered into the drive: rigid slip, and the displacements known
//      beforehand. Where a force is given, its creepage is one more unknown and the sum of the
//      tractions one more equation.
//   3. Without a start the same problem is solved on cells of twice the size, down to some 24 along
//      a side. States of stick and slip are found where cells are few. On the fine grid a handful
//      of Newton steps is left, so that the work grows little faster than the number of cells.
//   4. Newton's method, and back to the units of the problem.
TangentialResult TangentialSolver::solve(const TangentialProblem &problem,
                                         const TangentialOptions &options)
{
  const PatchGrid &grid = work_->grid;
  const bool steady = problem.kind == TangentialProblem::Kind::Steady;
  if (problem.bound.size() != grid.cells() || !(steady || problem.distance > 0.0))
    throw Error(ExitCode::Internal, "tangential contact: bound or distance do not fit the grid");
  if (steady)
    checkLeadingColumn(grid, problem.bound);
  TangentialResult result;
  result.creepage = problem.creepage;
  const auto fill = [&](PatchState inContact, const std::vector<int> &cells) {
    result.traction.x = result.traction.y = Vector::Zero(grid.cells());
    result.slip = result.traction;
    result.state.assign(grid.cells(), PatchState::Apart);
    for (int cell : cells)
      result.state[cell] = inContact;
  };

  ScaledProblem scaled = scaledProblem(grid, problem, work_->pair.G);
  const int n = static_cast<int>(scaled.wholeIndex.size());
  if (n == 0) {
    fill(PatchState::Apart, {});
    return result;
  }
  PatchHalfSpace &space = work_->spaceOn(scaled.box.grid);
  scaled.slipUnit = scaled.tractionUnit * space.tangentialCompliance();
  setDrive(grid, problem, scaled);
  setEdge(problem, space.tangentialCompliance(), scaled);
  setForces(grid, problem, scaled);
  // neither creepage nor force nor a displacement that is left: nothing moves
  if (!(scaled.equations.scale > 0.0)) {
    if (problem.forceX) // what was given beside a force is a guess
      result.creepage.xi = 0.0;
    if (problem.forceY)
      result.creepage.eta = 0.0;
    fill(PatchState::Stick, scaled.wholeIndex);
    return result;
  }

  TangentialField start = options.start;
  Creepage creepage = problem.creepage;
  if (start.x.size() != grid.cells() && worthCoarser(grid)) {
    const PatchGrid coarse = coarseGridOf(grid);
    TangentialOptions coarseOptions = options;
    coarseOptions.tolerance = std::max(options.tolerance, coarseTolerance);
    const TangentialProblem coarseProblem = coarsened(grid, coarse, problem);
    TangentialSolver solver(coarse, work_->pair);
    const TangentialResult found = solver.solve(coarseProblem, coarseOptions);
    result.coarseProducts = found.products + found.coarseProducts;
    start = refined(grid, coarse, problem.bound, coarseProblem.bound, found.traction);
    creepage = found.creepage;
  }
  const std::vector<int> unknown = scaled.equations.unknown;
  Vector x = Vector::Zero(2 * n + static_cast<int>(unknown.size()));
  if (start.x.size() == grid.cells())
    for (int i = 0; i < n; ++i) {
      x[2 * i] = start.x[scaled.wholeIndex[i]] / scaled.tractionUnit;
      x[2 * i + 1] = start.y[scaled.wholeIndex[i]] / scaled.tractionUnit;
    }
  start = {}; // on a fine grid each field counts
  const double creepUnit = scaled.slipUnit / scaled.distance;
  for (std::size_t j = 0; j < unknown.size(); ++j)
    x[2 * n + j] = (unknown[j] ? creepage.eta : creepage.xi) / creepUnit;

  PastSteps &past = work_->past;
  const Vector &edge = scaled.equations.edge;
  if (!(options.followsSteps && steady && past.cells == scaled.wholeIndex &&
        past.unknown == unknown && past.edge.size() == edge.size() && past.edge == edge))
    past = {scaled.wholeIndex, unknown, edge, {}};
  FrictionNewton newton(space, std::move(scaled.equations));
  // a given force is to be met itself, more closely than tractions are
  const double tolerance = (unknown.empty() ? 1.0 : forceShare) * options.tolerance;
  const bool converged = newton.solve(x, tolerance, options.maxSteps, past.steps);
  result.newtonSteps = newton.steps();
  result.products = newton.products();
  result.residual = newton.residual();
  if (!converged)
    throw Error(ExitCode::NotConverged,
                fmt::format("tangential contact: residual {:.1e} (wanted {:.1e}) after {} steps",
                            newton.residual(), tolerance, newton.steps()));
  if (options.followsSteps && steady && newton.steps() > 0) {
    if (past.steps.size() == pastSteps)
      past.steps.erase(past.steps.begin());
    past.steps.push_back(newton.wholeStep());
  }
  fill(PatchState::Stick, scaled.wholeIndex);
  const Vector &s = newton.slip();
  for (int i = 0; i < n; ++i) {
    const int cell = scaled.wholeIndex[i];
    result.traction.x[cell] = scaled.tractionUnit * x[2 * i];
    result.traction.y[cell] = scaled.tractionUnit * x[2 * i + 1];
    result.slip.x[cell] = creepUnit * s[2 * i];
    result.slip.y[cell] = creepUnit * s[2 * i + 1];
    if (newton.slips(i))
      result.state[cell] = PatchState::Slip;
  }
  for (std::size_t j = 0; j < unknown.size(); ++j)
    (unknown[j] ? result.creepage.eta : result.creepage.xi) = x[2 * n + j] * creepUnit;
  return result;
}

} // namespace wheelrail
