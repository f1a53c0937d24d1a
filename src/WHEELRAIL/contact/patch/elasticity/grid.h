// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_GRID_H
#define WHEELRAIL_PATCH_GRID_H

#include "contact/half_space.h"

namespace wheelrail {

/// A box of cells in the plane of contact and where it lies. Lengths in any unit, the same
/// everywhere (with tractions in force per length squared of that unit: mm, N and MPa, for
/// example); nothing in the solvers depends on the choice.
struct PatchGrid : CellGrid {
  /// With `centredGrid` the origin is the middle of the box, about which moments are taken.
  double left = 0.0;   ///< x of the box's border at ix = 0 (the trailing side)
  double bottom = 0.0; ///< y of the box's border at iy = 0

  /// In the unit of the box; ix = 0 .. nx - 1.
  double x(int ix) const { return left + (ix + 0.5) * dx; } ///< centre of a cell
  double y(int iy) const { return bottom + (iy + 0.5) * dy; }
  /// What turns a sum of tractions over the cells into a force.
  double cellArea() const { return dx * dy; }
};

/// Box of the given width and height around the origin.
/// \param nx, ny number of cells, >= 1
/// \param width, height of all cells, > 0; a cell's border lies at 0 where the number is even, a
///         cell's centre where it is odd
PatchGrid centredGrid(int nx, int ny, double width, double height);

/// Values at the centres of the cells. \param function of (x, y)
/// \return one value a cell, x fastest
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
/// One step in x (stepX = 1) is what rolling by a cell does: material comes from larger x.
Eigen::VectorXd shifted(const PatchGrid &grid, const Eigen::VectorXd &field, int stepX,
                        int stepY = 0, double outside = 0.0);

/// A part of a grid's cells: those of `grid` begin at (firstX, firstY) of the larger one.
/// Cells are those of the whole grid, of the same size and at the same place.
struct SubGrid {
  PatchGrid grid;
  int firstX = 0, firstY = 0;

  /// \param field over the whole grid
  /// \return its values on the cells of the part
  Eigen::VectorXd part(const PatchGrid &whole, const Eigen::VectorXd &field) const;
  /// Writes the part's values into a field over the whole grid.
  /// \param values one for each cell of the part; the field keeps its others
  void put(const PatchGrid &whole, const Eigen::VectorXd &values, Eigen::VectorXd &field) const;
};

/// The smallest box with all cells where `mask` > 0, widened by `leading` columns towards larger x
/// (as far as the grid goes). At least one cell.
/// \param mask per cell of the whole grid; pressure or bound, for example
SubGrid boundingBox(const PatchGrid &whole, const Eigen::VectorXd &mask, int leading = 0);

} // namespace wheelrail
#endif
