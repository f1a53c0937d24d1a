// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_HEIGHT_MAP_PREPARATION_H
#define WHEELRAIL_PATCH_HEIGHT_MAP_PREPARATION_H

#include "contact/patch/formats/height_map_file.h"
#include "contact/patch/surfaces/height_map_steps.h"

#include <string>
#include <vector>

namespace wheelrail {

/// How a measured map becomes roughness; the order of the steps is that of the members.
struct HeightMapPreparation {
  HeightMapScale scale;
  bool turn = false;   ///< rows were measured across the rolling direction
  bool mirror = false; ///< y is turned around
  bool fill = false;   ///< fill unmeasured points (`filled`); false: they are refused
  Form form = Form::Plane;
  double cutoff = 0.0;    ///< of the low-pass filter, m; 0: none
  bool pointwise = false; ///< the points are the cells' centres; false: means over the cells
};

struct PreparedHeightMap {
  HeightMap map;
  std::vector<HeightMapStatistics> statistics; ///< after every step that was taken
  std::vector<std::string> remarks;            ///< lines for the user: `isolatedHeights`
};

/// Reads and prepares; the form is taken off before the holes are filled and again after, so that
/// the fill does not carry it.
/// \param name put before each step: "rail"
/// \throws Error (BadInput) as readHeightMap and the steps do; with the file's name for unmeasured
///         points that are not to be filled
PreparedHeightMap prepareHeightMap(const std::string &path, const HeightMapPreparation &preparation,
                                   const std::string &name);

} // namespace wheelrail
#endif
