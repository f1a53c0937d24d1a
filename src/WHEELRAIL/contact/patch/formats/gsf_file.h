// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_GSF_FILE_H
#define WHEELRAIL_PATCH_GSF_FILE_H

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace wheelrail {

/// A raster of values over a rectangle, as Gwyddion's "Simple Field 1.0" holds it; see the user
/// guide of Gwyddion, "Simple Field Files". Values here run upwards (iy = 0 is the smallest y), in
/// the file downwards.
struct SimpleField {
  int nx = 0, ny = 0;                  ///< >= 1
  double width = 0.0, height = 0.0;    ///< of all cells, in xyUnit; > 0
  double xOffset = 0.0, yOffset = 0.0; ///< of the left and of the top border, in xyUnit. y of the
                                       ///< file runs downwards, so that yOffset = -(largest y)
  std::string xyUnit, zUnit;           ///< such as "m"; empty: pure numbers
  std::string title;                   ///< one line, may be empty
  /// Other lines of the head, name and value, which Gwyddion shows among the metadata; written
  /// only.
  std::vector<std::pair<std::string, std::string>> notes;
  Eigen::VectorXd value; ///< nx*ny, x fastest; stored as float32
};

/// The bytes of a .gsf file.
std::string gsfBytes(const SimpleField &field);

/// \param path for messages only
/// \param bytes of the whole file
/// \throws Error (BadInput) with the line of the head, or the byte of the data
SimpleField parseGsf(const std::string &path, const std::string &bytes);

} // namespace wheelrail
#endif
