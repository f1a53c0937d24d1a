// SPDX-License-Identifier: GPL-2.0-or-later
/// \file material_file.h
/// Reads a potential file (*.mca): one named quantity a line. No LAMMPS type in here.
#ifndef MCA_MATERIAL_FILE_H
#define MCA_MATERIAL_FILE_H

#include "laws/material.h"
#include "shared/printable.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mca {

/// One line that says what is wrong: file, line, keyword, value, what is allowed.
/// What it quotes of a file is made printable.
class MaterialError : public std::runtime_error {
 public:
  explicit MaterialError(const std::string &line)
      : std::runtime_error(mcawr::printable(mcawr::shortened(line)))
  {
  }
};

/// \param bytes  the whole file, as any editor saves it (`mcawr::plainText`). The first line holds
///               `UNITS: style` (and DATE, CITATION); then `keyword value` a line, `#` begins a
///               comment, every keyword exactly once. With a line `temperature T1 T2 ...` a keyword
///               may have as many values as there are temperatures; in between they are linear
/// \param name   for messages
/// \param units  LAMMPS's unit style in force
/// \param temperature  at which the material is wanted [temperature], within those of the file;
///                     needed where the file has temperatures, refused where it has none
/// \return values in these units, all of them checked, at every temperature of the file
/// \throw MaterialError
Material readMaterial(const std::string &bytes, const std::string &name, const std::string &units,
                      std::optional<double> temperature = {});

/// Takes the pairs `temperature T` out of keyword-value pairs of pair_coeff.
/// \param words  without these pairs on return
/// \return the last one's value [temperature], > 0; none where there is none
/// \throw MaterialError
std::optional<double> takeTemperature(std::vector<std::string> &words);

/// Takes keyword-value pairs over those of a file (pair_coeff) and checks the result.
/// \param words  keyword, value, keyword, value, ... in the same units as the material; a keyword
///               may stand twice, the last one counts
/// \throw MaterialError  as above; without file and line
Material overrideMaterial(Material, const std::vector<std::string> &words);

} // namespace mca

#endif
