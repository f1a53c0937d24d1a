// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_GRID_H
#define WHEELRAIL_PATCH_GRID_H

#include "contact/half_space.h"

namespace wheelrail {

/// A box of cells in the plane of contact and where it lies. Lengths in any unit, the same
/// everywhere (with tractions in force per length squared of that unit: mm, N and MPa, for
/// example); nothing in the solvers depends on the choice.
struct PatchGrid : CellGrid {
  double left = 0.0;   ///< x of the box's border at ix = 0 (the trailing side)
  double bottom = 0.0; ///< y of the box's border at iy = 0

  double x(int ix) const { return left + (ix + 0.5) * dx; } ///< centre of a cell
  double y(int iy) const { return bottom + (iy + 0.5) * dy; }
  double cellArea() const { return dx * dy; }
};

/// Box of the given width and height around the origin.
PatchGrid centredGrid(int nx, int ny, double width, double height);

/// Values at the centres of the cells. @param function of (x, y)
template<class Function>
Eigen::VectorXd sampled(const PatchGrid &grid, const Function &function)
{
  Eigen::VectorXd values(grid.cells());
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix)
      values[grid.index(ix, iy)] = function(grid.x(ix), grid.y(iy));
  return values;
}

/// The field moved by whole cells: the value at (ix, iy) is that of (ix + stepX, iy + stepY), or
/// `outside` where that lies beyond the box.
Eigen::VectorXd shifted(const PatchGrid &grid, const Eigen::VectorXd &field, int stepX,
                        int stepY = 0, double outside = 0.0);

/// A part of a grid's cells: those of `grid` begin at (firstX, firstY) of the larger one.
struct SubGrid {
  PatchGrid grid;
  int firstX = 0, firstY = 0;

  Eigen::VectorXd part(const PatchGrid &whole, const Eigen::VectorXd &field) const;
  /// Writes the part's values into a field over the whole grid.
  void put(const PatchGrid &whole, const Eigen::VectorXd &values, Eigen::VectorXd &field) const;
};

/// The smallest box with all cells where `mask` > 0, widened by `leading` columns towards larger x
/// (as far as the grid goes). At least one cell.
SubGrid boundingBox(const PatchGrid &whole, const Eigen::VectorXd &mask, int leading = 0);

} // namespace wheelrail
#endif
