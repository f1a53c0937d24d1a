// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/transient.h"

#include "base/errors.h"

#include <fmt/format.h>

namespace wheelrail {

using Vector = Eigen::VectorXd;

TransientPatch::TransientPatch(const PatchGrid &grid, const ElasticPair &pair)
    : solver_(grid, pair), space_(grid, pair)
{
  traction_.x = traction_.y = displacement_.x = displacement_.y = Vector::Zero(grid.cells());
}

void TransientPatch::startFrom(const TangentialField &traction)
{
  traction_ = traction;
  displacement_ = space_.displacement(traction);
}

TangentialOptions TransientPatch::defaultOptions()
{
  TangentialOptions options;
  options.tolerance = 1e-4;
  return options;
}

TangentialResult TransientPatch::step(const Step &step, const TangentialOptions &options)
{
  const PatchGrid &g = grid();
  if (step.bound.size() != g.cells() || step.cells < 0)
    throw Error(ExitCode::Internal, "transient contact: bound or step do not fit the grid");
  for (int iy = 0; iy < g.ny; ++iy)
    for (int ix = std::max(0, g.nx - step.cells); ix < g.nx; ++ix)
      if (step.bound[g.index(ix, iy)] > 0.0)
        throw Error(ExitCode::BadInput,
                    fmt::format("transient contact: contact at x = {}, within a step's length of "
                                "the leading border {}: a longer box is needed",
                                g.x(ix), g.left + g.nx * g.dx));
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
  TangentialOptions warm = options;
  if (warm.start.x.size() == 0) {
    warm.start.x = shifted(g, traction_.x, step.cells);
    warm.start.y = shifted(g, traction_.y, step.cells);
  }
  TangentialResult result = solver_.solve(problem, warm);
  traction_ = result.traction;
  displacement_ = space_.displacement(traction_);
  return result;
}

} // namespace wheelrail
