// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/grid.h"

#include <algorithm>

namespace wheelrail {

using Vector = Eigen::VectorXd;

PatchGrid centredGrid(int nx, int ny, double width, double height)
{
  return {{nx, ny, width / nx, height / ny}, -0.5 * width, -0.5 * height};
}

Vector shifted(const PatchGrid &grid, const Vector &field, int stepX, int stepY, double outside)
{
  Vector moved = Vector::Constant(grid.cells(), outside);
  const int firstX = std::max(0, -stepX), lastX = std::min(grid.nx, grid.nx - stepX);
  const int firstY = std::max(0, -stepY), lastY = std::min(grid.ny, grid.ny - stepY);
  if (firstX >= lastX)
    return moved;
  for (int iy = firstY; iy < lastY; ++iy)
    moved.segment(grid.index(firstX, iy), lastX - firstX) =
        field.segment(grid.index(firstX + stepX, iy + stepY), lastX - firstX);
  return moved;
}

Vector SubGrid::part(const PatchGrid &whole, const Vector &field) const
{
  Vector values(grid.cells());
  for (int iy = 0; iy < grid.ny; ++iy)
    values.segment(grid.index(0, iy), grid.nx) =
        field.segment(whole.index(firstX, firstY + iy), grid.nx);
  return values;
}

void SubGrid::put(const PatchGrid &whole, const Vector &values, Vector &field) const
{
  for (int iy = 0; iy < grid.ny; ++iy)
    field.segment(whole.index(firstX, firstY + iy), grid.nx) =
        values.segment(grid.index(0, iy), grid.nx);
}

SubGrid boundingBox(const PatchGrid &whole, const Vector &mask, int leading)
{
  int firstX = whole.nx, lastX = -1, firstY = whole.ny, lastY = -1;
  for (int iy = 0; iy < whole.ny; ++iy)
    for (int ix = 0; ix < whole.nx; ++ix)
      if (mask[whole.index(ix, iy)] > 0.0) {
        firstX = std::min(firstX, ix);
        lastX = std::max(lastX, ix);
        firstY = std::min(firstY, iy);
        lastY = iy;
      }
  if (lastX < 0)
    firstX = lastX = firstY = lastY = 0;
  lastX = std::min(whole.nx - 1, lastX + leading);
  SubGrid box;
  box.firstX = firstX;
  box.firstY = firstY;
  box.grid = {{lastX - firstX + 1, lastY - firstY + 1, whole.dx, whole.dy},
              whole.left + firstX * whole.dx,
              whole.bottom + firstY * whole.dy};
  return box;
}

} // namespace wheelrail
