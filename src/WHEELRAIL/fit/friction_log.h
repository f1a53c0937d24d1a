// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_FRICTION_LOG_H
#define WHEELRAIL_FIT_FRICTION_LOG_H

#include "shared/friction_log_format.h"

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace wheelrail {

/// A friction log (*.friction, format "mca-friction 1"): what was slid, how, and the time series.
/// Units are those of the file, whatever the unit style of the run was: ns, nm, MPa, m/s, kg/m3,
/// Pa s. Every row is the mean over the steps since the row before it.
struct FrictionLog {
  std::string file;

  /// Numbers that the log does not state are 0; those that a reader needs are there.
  mcawr::friction_log::Head head;
  /// What computed the run, as in the head: "program.lammps" -> "20250204", "laws.steps" ->
  /// "corrected" and so on; empty if the head has neither section.
  std::map<std::string, std::string> madeBy;
  /// What was simulated, word by word: the head's sections material, loading and geometry by their
  /// names, those of further materials and of interfaces, and its "timestep". With `madeBy` all of
  /// the head that decides a run, but for the seed.
  std::map<std::string, std::string> condition;

  /// Strengths of the materials beside that of the head, MPa; empty where there is one material.
  /// The head has the weakest, and so have all kappas.
  std::vector<double> otherStrengths;
  std::string packing; ///< its name; empty: not stated
  std::string command; ///< that made the run, of a packed log; else empty
  /// K, of a packed log whose plan took the material at one; else nan.
  double temperature = std::numeric_limits<double>::quiet_NaN();

  std::vector<long> step;   ///< strictly increasing, evenly spaced
  std::vector<double> time; ///< ns, end of the row's interval
  /// shear_stress / pressure, 0 at pressure 0; positive where it opposes the velocity, so that a
  /// layer that is driven backwards has the same friction.
  std::vector<double> mu;

  /// The whole rows, as they stand there; columns that the log does not have are 0.
  std::vector<mcawr::friction_log::Row> rows;
  bool hasState = false; ///< it has those that not every log has: room, lost, the energies

  /// One line for the user when a cut last line was dropped, else empty.
  std::string note;

  double kappa1() const;   ///< rho E v^2 / sigma_0^2
  double kappa2() const;   ///< p E / sigma_0^2
  double kappa3() const;   ///< E / sigma_0
  double interval() const; ///< ns between rows
  double origin() const;   ///< ns, where the interval of the first row begins
};

/// Reads and checks one log. A row of step 0 is the state before the first step, not a mean: it is
/// checked and then left out of the series. A last line that was cut by the death of the machine
/// (too few columns, or no end of line) is dropped if it is the only defect, and `note` says so.
/// \throws Error (BadInput) naming file and line: missing or empty file, no regular file, another
///         format, version or unit, a key that is missing, misspelt or given twice, a missing
///         column, a value out of range, text or nan among the numbers, steps that do not increase
///         or are unevenly spaced, mu that is not shear_stress/pressure, no row at all
FrictionLog readFrictionLog(const std::string &path);

/// The log that stands in a text, as readFrictionLog reads one.
/// \param file what the text is called in messages, and in `FrictionLog::file`
/// \param bytes of the whole log; marks, codes and line ends of other machines as `plainTextOf`
/// \throws Error (BadInput) for all that a text can have wrong; an empty one, too
FrictionLog parseFrictionLog(const std::string &file, const std::string &bytes);

} // namespace wheelrail

#endif
