// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_RUN_COLUMNS_H
#define WHEELRAIL_FIT_RUN_COLUMNS_H

#include "fit/friction_run.h"

#include <string>
#include <vector>

/// The numbers of a run as files have them: each is one row of a table, from which the CSV file and
/// the report follow.
namespace wheelrail {

/// Whether, where and how the CSV file has a number.
struct InCsv {
  int digits = 0; ///< significant ones; 0: it has not
  /// Columns of a smaller rank come first; those of equal rank stand as in the table.
  int rank = 0;
};

/// One number of a run.
struct RunColumn {
  const char *name;
  double (*get)(const FrictionRun &run); ///< in the unit of `FrictionRun`
  InCsv csv;
  bool inReport = true; ///< among the `points` of the JSON report
  bool whole = false;   ///< a whole number
};

/// All of them, in the order of the report.
const std::vector<RunColumn> &runColumns();

/// The CSV file: a comment line with the units, a line of column names, one row a run. `file` comes
/// first, then the columns of the table that have digits.
/// t_start (ns) is nan where no stationary part was found, mu_grinding_in where there was no
/// grinding-in; what a log does not say is nan, too. Lengths in nm, stresses in MPa, velocity in
/// m/s, viscosity in Pa s, density in kg/m3, the rest is dimensionless.
std::string runsAsCsv(const std::vector<FrictionRun> &runs);

} // namespace wheelrail

#endif
