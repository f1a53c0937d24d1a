// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/kalker.h"

#include "contact/patch/solvers/patch_sums.h"
#include "shared/pi.h"

#include <cmath>
#include <limits>

namespace wheelrail {
namespace {

using mcawr::pi;

KalkerCoefficients onGrid(double axesRatio, double nu, int cells)
{
  const ElasticPair pair{1.0, nu};
  const double a = std::sqrt(axesRatio), b = 1.0 / a; // ab = 1
  // one empty column at the leading edge, where material comes in from
  const double dx = 2.0 * a / cells;
  const PatchGrid grid{{cells + 1, cells, dx, 2.0 * b / cells}, -a, -b};
  const Eigen::VectorXd inside = sampled(grid, [&](double x, double y) {
    return x * x / (a * a) + y * y / (b * b) < 1.0 ? 1.0 : 0.0;
  });
  TangentialSolver solver(grid, pair);
  return kalkerCoefficients(creepSensitivity(solver, inside), pair.G,
                            inside.sum() * grid.cellArea());
}

} // namespace

CreepSensitivity creepSensitivity(TangentialSolver &solver, const Eigen::VectorXd &contact)
{
  TangentialProblem problem;
  // An infinite bound: no cell slips and the forces are linear in the creepages, so that any size
  // of theirs gives the derivative.
  problem.bound = (contact.array() > 0.0)
                      .select(Eigen::VectorXd::Constant(contact.size(),
                                                        std::numeric_limits<double>::infinity()),
                              0.0);
  const auto sums = [&](const Creepage &creepage) {
    problem.creepage = creepage;
    return patchSums(solver.grid(), solver.solve(problem));
  };
  const PatchGrid &grid = solver.grid();
  const double length = std::max(grid.nx * grid.dx, grid.ny * grid.dy); // any scale will do
  const PatchSums x = sums({1.0, 0.0, 0.0}), y = sums({0.0, 1.0, 0.0});
  const PatchSums spin = sums({0.0, 0.0, 1.0 / length});
  return {-x.forceX, -y.forceY, -spin.forceY * length, -y.momentZ, -spin.momentZ * length};
}

KalkerCoefficients kalkerCoefficients(const CreepSensitivity &s, double G, double area)
{
  const double ab = area / pi, root = std::sqrt(ab);
  return {s.xx / (G * ab), s.yy / (G * ab), 0.5 * (s.yz - s.zy) / (G * ab * root),
          s.zz / (G * ab * ab)};
}

KalkerCoefficients ellipseKalkerCoefficients(double axesRatio, double nu, int cells)
{
  // The error is of first order in the cells' length: half the length, half the error.
  const KalkerCoefficients coarse = onGrid(axesRatio, nu, cells / 2);
  const KalkerCoefficients fine = onGrid(axesRatio, nu, cells);
  return {2.0 * fine.c11 - coarse.c11, 2.0 * fine.c22 - coarse.c22, 2.0 * fine.c23 - coarse.c23,
          2.0 * fine.c33 - coarse.c33};
}

} // namespace wheelrail
