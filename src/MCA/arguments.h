// SPDX-License-Identifier: GPL-2.0-or-later
/// \file arguments.h
/// Numbers in the commands of an input script, for all styles of ours: decimal only, finite, with
/// nothing behind them, whatever the locale. What is wrong stops LAMMPS with one line that names
/// style, keyword, value and what is allowed.
#ifndef LMP_MCA_ARGUMENTS_H
#define LMP_MCA_ARGUMENTS_H

#include "lmptype.h"

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mca {

/// Which numbers are taken.
enum class Sign { Any, NotNegative, Positive };

/// A number whose size is 0 or 1e-60 to 1e60: products of a few do not overflow.
/// \param what  style and keyword, "Fix mca/drive pressure"
/// \param more  what is allowed beside it, for the message: " (MPa) or v_name"
double number(LAMMPS_NS::LAMMPS *, const std::string &what, const std::string &word,
              Sign = Sign::Any, const std::string &more = "");

/// A whole number from `least` to `most`; no power of ten.
LAMMPS_NS::bigint wholeNumber(LAMMPS_NS::LAMMPS *, const std::string &what, const std::string &word,
                              LAMMPS_NS::bigint least, LAMMPS_NS::bigint most);

/// A range of types as LAMMPS writes it, n, *, n*, *n or m*n, from 1 to `most`.
struct TypeRange {
  int first, last;
};
TypeRange typeRange(LAMMPS_NS::LAMMPS *, const std::string &what, const std::string &word,
                    int most);

} // namespace mca

#endif
