// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/transient.h"

#include "base/errors.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace wheelrail {

using Vector = Eigen::VectorXd;

namespace {

constexpr double forcedTolerance = 3e-6; ///< creepages then scatter by 1e-5 from step to step

} // namespace

TransientPatch::TransientPatch(const PatchGrid &grid, const ElasticPair &pair)
    : solver_(grid, pair), space_(grid, pair)
{
  traction_.x = traction_.y = displacement_.x = displacement_.y = Vector::Zero(grid.cells());
}

void TransientPatch::startFrom(const TangentialField &traction, const TangentialField &imposed)
{
  traction_ = traction;
  before_ = {};
  bound_.resize(0);
  displacement_ = space_.displacement(traction);
  if (imposed.x.size() == displacement_.x.size()) {
    displacement_.x += imposed.x;
    displacement_.y += imposed.y;
  }
}

TangentialOptions TransientPatch::defaultOptions()
{
  TangentialOptions options;
  options.tolerance = 1e-4;
  return options;
}

TangentialResult TransientPatch::step(const Step &step, const TangentialOptions &options)
{
  TangentialResult result = attempt(step, options);
  accept(step, result);
  return result;
}

void TransientPatch::accept(const Step &step, const TangentialResult &result)
{
  TangentialField last = std::move(traction_);
  startFrom(result.traction, step.imposed);
  if (step.cells > 0) // a shift is no trend
    before_ = std::move(last);
  bound_ = step.bound;
}

// Where Newton's method begins. There are two pictures of how tractions change in a step, and the
// bound tells which of them holds: is it nearer to the former bound, or to that one moved by the
// way of the material? Bounds that stay are those of smooth bodies: the tractions change in place,
// and are continued linearly from the last two. Bounds that travel are those of asperities, which
// take their tractions with them. (Of the last one only, where there is no other: after a start or
// a shift.)
TangentialField TransientPatch::expected(const Step &step) const
{
  const PatchGrid &g = grid();
  const auto movedOn = [&](const Vector &v) { return shifted(g, v, step.cells); };
  const bool travels = bound_.size() == 0 || (step.bound - movedOn(bound_)).squaredNorm() <=
                                                 (step.bound - bound_).squaredNorm();
  if (travels)
    return {movedOn(traction_.x), movedOn(traction_.y)};
  if (before_.x.size() == 0)
    return traction_;
  return {2.0 * traction_.x - before_.x, 2.0 * traction_.y - before_.y};
}

TangentialResult TransientPatch::attempt(const Step &step, const TangentialOptions &options)
{
  const PatchGrid &g = grid();
  if (step.bound.size() != g.cells() || step.cells < 0)
    throw Error(ExitCode::Internal, "transient contact: bound or step do not fit the grid");
  for (int iy = 0; iy < g.ny; ++iy)
    for (int ix = std::max(0, g.nx - step.cells); ix < g.nx; ++ix)
      if (step.bound[g.index(ix, iy)] > 0.0)
        throw Error(ExitCode::BadInput,
                    "contact.domain: the contact comes within a step's length of the leading "
                    "border of the box of cells; increase it");
  // The material brings its displacement along, so u'(x + d) is the former field read d further
  // ahead. A shift at rest (no cells) moves nothing, and its creepage is the shift itself: d = 1,
  // without a lever of its own for the spin.
  TangentialProblem problem;
  problem.kind = TangentialProblem::Kind::Step;
  problem.bound = step.bound;
  problem.creepage = step.creepage;
  problem.forceX = step.forceX;
  problem.forceY = step.forceY;
  problem.distance = step.cells ? step.cells * g.dx : 1.0;
  problem.spinPoint = step.cells ? step.spinPoint : 0.0;
  problem.previous.x = shifted(g, displacement_.x, step.cells);
  problem.previous.y = shifted(g, displacement_.y, step.cells);
  problem.imposed = step.imposed;
  if (step.cells == 1)
    problem.edge = step.edge;
  TangentialOptions warm = options;
  if (warm.start.x.size() == 0)
    warm.start = expected(step);
  if (step.forceX || step.forceY)
    warm.tolerance = std::min(warm.tolerance, forcedTolerance);
  return solver_.solve(problem, warm);
}

} // namespace wheelrail
