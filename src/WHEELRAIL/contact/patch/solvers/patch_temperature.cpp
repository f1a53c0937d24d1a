// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/patch_temperature.h"

namespace wheelrail {

using Vector = Eigen::VectorXd;

PatchFlashTemperature::PatchFlashTemperature(const CellGrid &grid, double cellLength, double speed,
                                             const ThermalMaterial &material)
    : grid_(grid), row_(grid.nx, cellLength, speed, material)
{
}

Vector PatchFlashTemperature::rise(const Vector &heat)
{
  Vector theta = Vector::Zero(grid_.cells());
  for (int iy = 0; iy < grid_.ny; ++iy) {
    const Vector row = heat.segment(grid_.index(0, iy), grid_.nx);
    if ((row.array() != 0.0).any())
      theta.segment(grid_.index(0, iy), grid_.nx) = row_.rise(row);
  }
  return theta;
}

PatchTravellingHeat::PatchTravellingHeat(const CellGrid &grid, double cellLength, double speed,
                                         const ThermalMaterial &material)
    : grid_(grid), rows_(grid.ny, TravellingHeat(grid.nx, cellLength, speed, material))
{
}

void PatchTravellingHeat::step(const Vector &heat)
{
  for (int iy = 0; iy < grid_.ny; ++iy)
    rows_[iy].step(heat.segment(grid_.index(0, iy), grid_.nx));
}

Vector PatchTravellingHeat::rise() const
{
  Vector theta(grid_.cells());
  for (int iy = 0; iy < grid_.ny; ++iy)
    for (int ix = 0; ix < grid_.nx; ++ix)
      theta[grid_.index(ix, iy)] = rows_[iy].rise(ix);
  return theta;
}

} // namespace wheelrail
