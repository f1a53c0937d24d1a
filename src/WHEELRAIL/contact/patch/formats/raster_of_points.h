// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_RASTER_OF_POINTS_H
#define WHEELRAIL_PATCH_RASTER_OF_POINTS_H

#include "contact/patch/formats/height_map.h"

#include <string>
#include <vector>

namespace wheelrail {

/// The map of points that a file lists one by one, in any order. Places that the list leaves out
/// are NaN.
/// \param points x, y, z of each, one after the other, m
/// \throws Error (BadInput) where they are less than half of the places; for points that do not lie
///         on a raster of equal distances along x and along y, to a hundredth of them; for two at
///         one place
HeightMap rasterOfPoints(const std::string &path, const std::vector<double> &points);

} // namespace wheelrail
#endif
