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

class OutputColumns : protected Pointers {
 public:
  // the words are arg[0] to arg[narg-1], each one of `known`
  OutputColumns(LAMMPS *, const std::string &style, const std::vector<std::string> &known, int narg,
                char **arg);
  ~OutputColumns() override;
  OutputColumns(const OutputColumns &) = delete;
  OutputColumns &operator=(const OutputColumns &) = delete;

  int size() const { return static_cast<int>(attributes.size()); }
  int lammps_columns() const { return size() == 1 ? 0 : size(); } // 0 says vector
  int operator[](int column) const { return attributes[column]; } // number in `known`
  bool has(int attribute) const;

  void grow(int rows); // keeps what is there
  double &at(int row, int column) const { return size() == 1 ? vector[row] : array[row][column]; }
  double *vector = nullptr; // one of both, after grow()
  double **array = nullptr;
  double bytes() const { return static_cast<double>(nmax * attributes.size()) * sizeof(double); }

 private:
  std::vector<int> attributes;
  int nmax = 0;
};

} // namespace LAMMPS_NS

#endif
