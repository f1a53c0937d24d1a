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

/// Which lists of the JSON report have a number.
enum class InReport {
  No,
  Runs,         ///< `points`
  AndConditions ///< `conditions`, too: all runs of a condition have the same
};

/// One number of a run.
struct RunColumn {
  const char *name;
  const char *unit;                      ///< as files say it; "1": pure number
  double (*get)(const FrictionRun &run); ///< in that unit
  InCsv csv;
  InReport report = InReport::Runs;
  bool whole = false; ///< a whole number
};

/// All of them, in the order of the report.
const std::vector<RunColumn> &runColumns();

/// One of them. \throws std::out_of_range for a name that the table does not have
const RunColumn &runColumn(const std::string &name);

/// The CSV file: a comment line with the units, a line of column names, one row a run. `file` comes
/// first, then the columns of the table that have digits.
/// t_start is nan where no stationary part was found, mu_grinding_in where there was no
/// grinding-in; what a log does not say is nan, too.
std::string runsAsCsv(const std::vector<FrictionRun> &runs);

} // namespace wheelrail

#endif
