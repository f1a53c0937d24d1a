// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_HEIGHT_MAP_STEPS_H
#define WHEELRAIL_PATCH_HEIGHT_MAP_STEPS_H

#include "contact/patch/elasticity/grid.h"
#include "contact/patch/formats/height_map.h"

#include <string>

namespace wheelrail {

/// What a step of preparation left, printed after each of them.
struct HeightMapStatistics {
  std::string step;                ///< such as "rail: as read"
  int unmeasured = 0;              ///< points without a height
  double rmsHeight = 0.0;          ///< about the mean of what was measured, m
  double rmsSlopeX = 0.0;          ///< between neighbours along x
  double rmsSlopeY = 0.0;          ///< and along y
  double shortestWavelength = 0.0; ///< two points, or the cut-off if longer, m
};

/// \param cutoff applied so far, m; 0: none
HeightMapStatistics heightMapStatistics(const std::string &step, const HeightMap &map,
                                        double cutoff = 0.0);

/// The map turned by a quarter to the left: what lay along x lies along y. For surfaces that were
/// measured with their rows across the rolling direction.
HeightMap turned(const HeightMap &map);

/// Form that is taken off a map: a polynomial in x and y, by least squares over what was measured.
enum class Form {
  None,       ///< nothing
  Mean,       ///< 1
  Plane,      ///< 1, x, y
  SecondOrder ///< 1, x, y, x^2, x y, y^2: the curvatures of wheel and rail
};

/// \throws Error (BadInput) where fewer points were measured than the form has terms, or they lie
///         so that they do not determine it
HeightMap withoutForm(const HeightMap &map, Form form);

/// Holes filled by the membrane that spans them: in every unmeasured point the discrete Laplace
/// equation (the mean of its neighbours along x and y, weighted by 1/dx^2 and 1/dy^2), zero slope
/// where a hole meets the border of the map. No new extremes arise; inside a large hole the surface
/// is too smooth, so count `unmeasured()` and say it.
/// \throws Error (BadInput) where less than half of the points were measured
HeightMap filled(const HeightMap &map);

/// Gaussian low-pass filter of ISO 16610-61: weight exp(-pi r^2/(alpha cutoff)^2), alpha =
/// sqrt(ln 2/pi), so that half of a wave's amplitude is left at the cut-off, whatever its
/// direction. Near the borders the weights are normalised again (ISO 16610-28).
/// \param cutoff m
/// \throws Error (BadInput) for a cut-off below two points or above the map's smaller side; for a
///         map with unmeasured points: fill it first
HeightMap lowPassed(const HeightMap &map, double cutoff);

/// Means over the cells of a grid: the exact integral, over each cell, of the surface that is
/// bilinear between the map's points, divided by the cell's area. The middle of the map lies at
/// (0, 0) of the grid's coordinates, moved by (shiftX, shiftY).
/// \param lengthUnit what a length 1 of the grid is in m: 1e-3 for a grid in mm
/// \param shiftX, shiftY where the map's middle lies, in the grid's unit
/// \return per cell of the grid, in its unit
/// \throws Error (BadInput) where the map does not cover the grid, or has unmeasured points
Eigen::VectorXd resampled(const HeightMap &map, const PatchGrid &grid, double lengthUnit,
                          double shiftX = 0.0, double shiftY = 0.0);

/// The largest grid of such cells that the map covers, centred on its middle, a cell centre or
/// border at 0 as the number of cells makes it: for surfaces that travel through the contact.
/// \param dx, dy in units of lengthUnit (m)
/// \throws Error (BadInput) where not even one cell fits, or more than 2^31 do
PatchGrid coveredGrid(const HeightMap &map, double dx, double dy, double lengthUnit);

} // namespace wheelrail
#endif
