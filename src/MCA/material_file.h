// SPDX-License-Identifier: GPL-2.0-or-later
/// \file material_file.h
/// Reads a potential file (*.mca): one named quantity a line. No LAMMPS type in here.
#ifndef MCA_MATERIAL_FILE_H
#define MCA_MATERIAL_FILE_H

#include "laws/material.h"
#include "shared/printable.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace mca {

/// One line that says what is wrong: file, line, keyword, value, what is allowed.
/// What it quotes of a file is made printable.
class MaterialError : public std::runtime_error {
 public:
  explicit MaterialError(const std::string &line) : std::runtime_error(mcawr::printable(line)) {}
};

/// \param text   the whole file. The first line holds `UNITS: style` (and DATE, CITATION); then
///               `keyword value` a line, `#` begins a comment, every keyword exactly once.
/// \param name   for messages
/// \param units  LAMMPS's unit style in force
/// \return values in these units, all of them checked
/// \throws MaterialError
Material readMaterial(const std::string &text, const std::string &name, const std::string &units);

/// Takes keyword-value pairs over those of a file (pair_coeff) and checks the result.
/// \param words  keyword, value, keyword, value, ... in the same units as the material; a keyword
///               may stand twice, the last one counts
/// \throws MaterialError  as above; without file and line
Material overrideMaterial(Material, const std::vector<std::string> &words);

} // namespace mca

#endif
