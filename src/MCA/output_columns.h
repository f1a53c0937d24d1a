// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   Output of attributes that the user lists: a vector for one, an array for several
------------------------------------------------------------------------- */

#ifndef LMP_MCA_OUTPUT_COLUMNS_H
#define LMP_MCA_OUTPUT_COLUMNS_H

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/// Rows by columns of doubles for computes and fixes: LAMMPS wants a plain vector where one
/// attribute is asked for, and an array otherwise.
class OutputColumns : protected Pointers {
 public:
  /// \param style  for messages, such as "Compute mca/atom"
  /// \param known  all words; what is stored is the number in this list
  /// \param arg    words arg[0] to arg[narg - 1], each one of `known`; another one, or none at all,
  ///               stops LAMMPS with one line that names the nearest or all
  OutputColumns(LAMMPS *, const std::string &style, const std::vector<std::string> &known, int narg,
                char **arg);
  ~OutputColumns() override;
  OutputColumns(const OutputColumns &) = delete;
  OutputColumns &operator=(const OutputColumns &) = delete;

  int size() const { return static_cast<int>(attributes.size()); }
  /// What LAMMPS's size_..._cols wants: 0 says vector.
  int lammps_columns() const { return size() == 1 ? 0 : size(); }
  /// Number of a column's attribute in `known`.
  int operator[](int column) const { return attributes[column]; }
  /// Whether one of the columns shows this attribute, a number in `known`.
  bool has(int attribute) const;

  /// Room for so many rows, with an eighth more; keeps what is there. Pointers that LAMMPS was
  /// given end here: they are set after it.
  void grow(int rows);
  /// Neither is checked; rows below that of the last grow().
  double &at(int row, int column) const { return size() == 1 ? vector[row] : array[row][column]; }
  /// One of both, after grow(); owned.
  double *vector = nullptr;
  double **array = nullptr;
  /// Memory held [bytes].
  double bytes() const { return static_cast<double>(nmax * attributes.size()) * sizeof(double); }

 private:
  /// Place of each column's attribute in `known`.
  std::vector<int> attributes;
  /// Rows there is room for.
  int nmax = 0;
};

} // namespace LAMMPS_NS

#endif
