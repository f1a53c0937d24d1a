// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_HEIGHT_MAP_H
#define WHEELRAIL_PATCH_HEIGHT_MAP_H

#include <Eigen/Core>

namespace wheelrail {

/// Heights of a surface at the points of a rectangular raster; SI units (m), positive outwards from
/// the body. What was not measured is NaN.
///
/// Point (ix, iy) lies at x = ix dx, y = iy dy and has the index ix + nx iy: x, the rolling
/// direction, runs fastest, and iy = 0 is the smallest y. `readHeightMap` turns the rows of formats
/// that run downwards.
///
/// Both bodies' maps are read in the coordinates of the contact, seen from above it; a wheel
/// measured from outside has to be mirrored first.
struct HeightMap {
  int nx = 0, ny = 0;        ///< points, >= 2
  double dx = 0.0, dy = 0.0; ///< spacing, m, > 0
  Eigen::VectorXd height;    ///< nx*ny values, m

  int index(int ix, int iy) const { return ix + nx * iy; }
  double width() const { return (nx - 1) * dx; } ///< from the first point to the last, m
  double depth() const { return (ny - 1) * dy; }
  int unmeasured() const; ///< number of points that are NaN
};

/// What a file may not know of itself. SI units.
struct HeightMapScale {
  double spacingX = 0.0, spacingY = 0.0; ///< m; 0: not given. Both or none
  double heightUnit = 0.0;               ///< m that a height of 1 in the file is; 0: not given
};

/// The map seen in a mirror: y -> -y. For a wheel whose map was taken looking at the wheel.
HeightMap mirrored(const HeightMap &map);

} // namespace wheelrail
#endif
