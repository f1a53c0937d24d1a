// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/patch_sums.h"

namespace wheelrail {

double PatchSums::powerClosure() const
{
  return drivingPower == 0.0 ? 1.0 : frictionalPower / drivingPower;
}

PatchSums patchSums(const PatchGrid &grid, const TangentialResult &result)
{
  PatchSums sums;
  const TangentialField &q = result.traction, &s = result.slip;
  const double area = grid.cellArea();
  sums.forceX = area * q.x.sum();
  sums.forceY = area * q.y.sum();
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const int i = grid.index(ix, iy);
      sums.momentZ += area * (grid.x(ix) * q.y[i] - grid.y(iy) * q.x[i]);
    }
  sums.stickArea = area * result.stickCells();
  sums.slipArea = area * result.slipCells();
  sums.contactArea = sums.stickArea + sums.slipArea;
  sums.frictionalPower = 0.0 - area * (q.x.dot(s.x) + q.y.dot(s.y)); // no -0
  const Creepage &creep = result.creepage;
  sums.drivingPower =
      0.0 - (creep.xi * sums.forceX + creep.eta * sums.forceY + creep.phi * sums.momentZ);
  return sums;
}

double couplingPower(const PatchGrid &grid, const TangentialField &traction,
                     const TangentialField &imposed, const TangentialField &before)
{
  if (imposed.x.size() == 0)
    return 0.0;
  return -grid.cellArea() / grid.dx *
         (traction.x.dot(imposed.x - shifted(grid, before.x, 1)) +
          traction.y.dot(imposed.y - shifted(grid, before.y, 1)));
}

} // namespace wheelrail
