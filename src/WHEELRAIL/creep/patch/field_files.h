// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_FIELD_FILES_H
#define WHEELRAIL_CREEP_PATCH_FIELD_FILES_H

#include "contact/patch/elasticity/grid.h"
#include "contact/patch/solvers/tangential.h"
#include "creep/sweep/result_head.h"
#include "shared/output_file.h"

#include <string>
#include <vector>

namespace wheelrail {

/// Everything that one point of a patch contact knows of its cells; mm, N, MPa, K. Every vector has
/// one value a cell, or none where the model does not compute it.
/// Cells are those of the grid that goes with them, x fastest.
struct PatchFields {
  std::vector<PatchState> state; ///< written as 0 apart, 1 stick, 2 slip
  Eigen::VectorXd gap;           ///< mm, of the deformed surfaces; 0 in contact
  Eigen::VectorXd pressure;      ///< MPa
  TangentialField traction;      ///< MPa
  TangentialField slip;          ///< sliding/rolling speed, or what `slipIsShift` says
  /// Friction coefficient, a pure number, >= 0.
  Eigen::VectorXd mu;
  Eigen::VectorXd temperature; ///< rise, K
  bool slipIsShift = false;    ///< `slip` is a length, mm: nothing rolls
};

/// The fields that there are, in the order and with the names of the .gsf files, each with one
/// value a cell, in the unit of `fields`.
struct NamedField {
  std::string name; ///< "traction_x"
  Eigen::VectorXd values;
};
std::vector<NamedField> namedFields(const PatchFields &fields);

/// VTK image data (.vti, XML, version 1.0) with cell data `state`, `gap`, `pressure`, `traction`
/// and `slip` (three components, the third 0), `mu`, `temperature`; fields that are empty are left
/// out. Doubles (`state`: bytes), raw, appended, little endian: the numbers are those of the
/// computation to the last bit. Opens in ParaView and with VTK's vtkXMLImageDataReader. x and y in
/// mm.
/// \param title one line, written as a comment with the units
/// \param head a comment for each of its lines
std::string vtiBytes(const PatchGrid &grid, const PatchFields &fields, const std::string &title,
                     const ResultHead &head);

/// Names of the fields that `gsfFields` may write: state, gap, pressure, traction_x, traction_y,
/// slip_x, slip_y, mu, temperature.
std::vector<std::string> gsfNames();

/// Fields as Gwyddion Simple Fields, one file each, in SI units (m, Pa, K) and as float32.
struct NamedBytes {
  std::string name; ///< "pressure"
  std::string bytes;
};
/// \param title one line, put into each file
/// \param head likewise, each of its lines under its name
std::vector<NamedBytes> gsfFields(const PatchGrid &grid, const PatchFields &fields,
                                  const std::string &title, const ResultHead &head);

/// Adds STEM.vti and STEM_NAME.gsf for each field to files that will appear together.
/// \param stem path without its ending: "out/fields_0003"
/// \param head, title for both formats
/// \throws mcawr::OutputError; Error (NotConverged) for a field that is not finite
void addFieldFiles(mcawr::OutputFiles &files, const std::string &stem, const PatchGrid &grid,
                   const PatchFields &fields, const ResultHead &head, const std::string &title);

} // namespace wheelrail
#endif
