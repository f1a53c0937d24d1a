// SPDX-License-Identifier: GPL-2.0-or-later
/// \file material_file.h
/// Reads a potential file (*.mca): one named quantity a line. No LAMMPS type in here.
#ifndef MCA_MATERIAL_FILE_H
#define MCA_MATERIAL_FILE_H

#include "laws/material.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace mca {

/// One line that says what is wrong: file, line, keyword, value, what is allowed.
class MaterialError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// \param text   the whole file. The first line holds `UNITS: style` (and DATE, CITATION); then
///               `keyword value` a line, `#` begins a comment, every keyword exactly once.
/// \param name   for messages
/// \param units  LAMMPS's unit style in force
/// \return values in these units, all of them checked
/// \throws MaterialError
Material readMaterial(const std::string &text, const std::string &name, const std::string &units);

/// Takes keyword-value pairs over those of a file (pair_coeff) and checks the result.
/// \throws MaterialError
Material overrideMaterial(Material, const std::vector<std::string> &words);

} // namespace mca

#endif
