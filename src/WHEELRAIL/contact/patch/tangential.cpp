// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/tangential.h"

#include "base/errors.h"
#include "contact/patch/friction_newton.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr int coarsest = 24;             ///< cells of the box's shorter side, at least
constexpr double coarseTolerance = 1e-2; ///< a start for the next grid needs no more

} // namespace

int TangentialResult::stickCells() const
{
  return static_cast<int>(std::count(state.begin(), state.end(), PatchState::Stick));
}
int TangentialResult::slipCells() const
{
  return static_cast<int>(std::count(state.begin(), state.end(), PatchState::Slip));
}

struct TangentialSolver::Work {
  PatchGrid grid;
  ElasticPair pair;
  std::unique_ptr<PatchHalfSpace> space; ///< of the last box

  PatchHalfSpace &spaceOn(const PatchGrid &box)
  {
    if (!space || space->grid().nx != box.nx || space->grid().ny != box.ny)
      space = std::make_unique<PatchHalfSpace>(box, pair);
    return *space;
  }
};

TangentialSolver::TangentialSolver(const PatchGrid &grid, const ElasticPair &pair)
    : work(std::make_unique<Work>(Work{grid, pair, nullptr}))
{
}
TangentialSolver::~TangentialSolver() = default;
TangentialSolver::TangentialSolver(TangentialSolver &&) noexcept = default;
TangentialSolver &TangentialSolver::operator=(TangentialSolver &&) noexcept = default;

const PatchGrid &TangentialSolver::grid() const
{
  return work->grid;
}

TangentialResult TangentialSolver::solve(const TangentialProblem &problem,
                                         const TangentialOptions &options)
{
  const PatchGrid &grid = work->grid;
  const bool steady = problem.kind == TangentialProblem::Kind::Steady;
  const double distance = steady ? grid.dx : problem.distance;
  if (problem.bound.size() != grid.cells() || !(distance > 0.0))
    throw Error(ExitCode::Internal, "tangential contact: bound or distance do not fit the grid");
  if (steady)
    for (int iy = 0; iy < grid.ny; ++iy)
      if (problem.bound[grid.index(grid.nx - 1, iy)] > 0.0)
        throw Error(ExitCode::BadInput, fmt::format("tangential contact: contact in the leading "
                                                    "column (x = {}): a longer box is needed",
                                                    grid.x(grid.nx - 1)));
  TangentialResult result;
  result.traction.x = result.traction.y = result.slip.x = result.slip.y =
      Vector::Zero(grid.cells());
  result.state.assign(grid.cells(), PatchState::Apart);
  result.creepage = problem.creepage;

  const SubGrid box = boundingBox(grid, problem.bound, steady ? 1 : 0);
  PatchHalfSpace &space = work->spaceOn(box.grid);
  const double compliance = space.tangentialCompliance();
  const auto wholeIndex = [&](int cell) {
    return grid.index(box.firstX + cell % box.grid.nx, box.firstY + cell / box.grid.nx);
  };

  FrictionNewton::Equations eq;
  eq.steady = steady;
  for (int cell = 0; cell < box.grid.cells(); ++cell)
    if (problem.bound[wholeIndex(cell)] > 0.0)
      eq.cells.push_back(cell);
  const int n = static_cast<int>(eq.cells.size());
  if (n == 0)
    return result;
  double unit = 0.0;
  for (int cell : eq.cells)
    unit = std::max(unit, problem.bound[wholeIndex(cell)]);
  if (!std::isfinite(unit))
    unit = work->pair.G; // no slip: everything is linear
  const double slipUnit = unit * compliance;

  eq.bound.resize(n);
  eq.drive.resize(2 * n);
  Vector rigid(2 * n);
  const bool moved = problem.previous.x.size() == grid.cells() && !steady;
  const Creepage &creep = problem.creepage;
  for (int i = 0; i < n; ++i) {
    const int cell = wholeIndex(eq.cells[i]);
    const double x = grid.x(cell % grid.nx), y = grid.y(cell / grid.nx);
    eq.bound[i] = problem.bound[cell] / unit;
    const double lever = x + problem.spinPoint * distance;
    rigid[2 * i] = distance * ((problem.forceX ? 0.0 : creep.xi) - creep.phi * y) / slipUnit;
    rigid[2 * i + 1] =
        distance * ((problem.forceY ? 0.0 : creep.eta) + creep.phi * lever) / slipUnit;
    eq.drive[2 * i] = rigid[2 * i] - (moved ? problem.previous.x[cell] / slipUnit : 0.0);
    eq.drive[2 * i + 1] = rigid[2 * i + 1] - (moved ? problem.previous.y[cell] / slipUnit : 0.0);
  }
  const double cellForce = unit * grid.cellArea();
  Vector x = Vector::Zero(2 * n);
  double given = 0.0;
  for (int component : {0, 1}) {
    const auto &force = component ? problem.forceY : problem.forceX;
    if (!force)
      continue;
    eq.unknown.push_back(component);
    eq.force.push_back(*force / cellForce);
    given = std::hypot(given, *force / cellForce);
    x.conservativeResize(x.size() + 1);
    x[x.size() - 1] = distance * (component ? creep.eta : creep.xi) / slipUnit;
  }
  const double most = eq.bound.sum();
  if (given >= most)
    throw Error(ExitCode::BadInput,
                fmt::format("tangential contact: a force of {} cannot be carried: friction allows "
                            "less than {}",
                            given * cellForce, most * cellForce));
  const double capacity = std::isfinite(most) ? eq.bound.norm() : 1e300;
  double driving = rigid.norm() > 0.0 ? rigid.norm() : eq.drive.norm();
  if (!eq.unknown.empty())
    driving = std::max(driving, std::isfinite(most) ? capacity * given / most : given);
  eq.scale = std::min(capacity, driving);
  if (!(eq.scale > 0.0)) {
    for (int cell : eq.cells)
      result.state[wholeIndex(cell)] = PatchState::Stick;
    return result;
  }

  if (options.start.x.size() == grid.cells())
    for (int i = 0; i < n; ++i) {
      const int cell = wholeIndex(eq.cells[i]);
      x[2 * i] = options.start.x[cell] / unit;
      x[2 * i + 1] = options.start.y[cell] / unit;
    }
  const std::vector<int> cells = eq.cells;
  const Vector bound = eq.bound;
  const std::vector<int> unknown = eq.unknown;
  FrictionNewton newton(space, std::move(eq));
  const bool converged = newton.solve(x, options.tolerance, options.maxSteps);
  result.newtonSteps = newton.steps();
  result.products = newton.products();
  result.residual = newton.residual();
  if (!converged)
    throw Error(ExitCode::NotConverged,
                fmt::format("tangential contact: residual {:.1e} (wanted {:.1e}) after {} steps",
                            newton.residual(), options.tolerance, newton.steps()));
  for (int i = 0; i < n; ++i) {
    const int cell = wholeIndex(cells[i]);
    const Vector &s = newton.slip();
    result.traction.x[cell] = unit * x[2 * i];
    result.traction.y[cell] = unit * x[2 * i + 1];
    result.slip.x[cell] = slipUnit * s[2 * i] / distance;
    result.slip.y[cell] = slipUnit * s[2 * i + 1] / distance;
    const bool slips = std::hypot(x[2 * i] - s[2 * i], x[2 * i + 1] - s[2 * i + 1]) > bound[i];
    result.state[cell] = slips ? PatchState::Slip : PatchState::Stick;
  }
  for (std::size_t j = 0; j < unknown.size(); ++j)
    (unknown[j] ? result.creepage.eta : result.creepage.xi) = x[2 * n + j] * slipUnit / distance;
  return result;
}

} // namespace wheelrail
