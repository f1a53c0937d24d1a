// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_CREEP_TASK_H
#define WHEELRAIL_CREEP_SWEEP_CREEP_TASK_H

#include "base/errors.h"
#include "base/program_files.h"
#include "creep/sweep/result_files.h"
#include "creep/sweep/sweep.h"
#include "law/law_choice.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

/// Files that the command line asks for beside those in the folder; empty: not asked for.
struct ExtraFiles {
  std::string polach; ///< parameters of Polach's law (JSON); the points lie beside it
  std::string table;  ///< forces over a grid of creepages (CSV)
  /// A measured traction curve, which is read: laws are fitted to it.
  std::string measured;
};

/// The options of wr_creep that name them.
struct ExtraFileOption {
  const char *name;
  std::string ExtraFiles::*file;
  const char *help;
};
constexpr ExtraFileOption extraFileOptions[] = {
    {"--polach", &ExtraFiles::polach,
     "fit Polach's law to the curves of a point contact; writes FILE (JSON) and its points beside "
     "it (CSV)"},
    {"--table", &ExtraFiles::table,
     "write the forces of a point contact as a table over load, speed, spin, lateral and creep, "
     "for a multibody code (CSV)"},
    {"--fit-measured", &ExtraFiles::measured,
     "fit Polach's form and an interfacial layer to a measured traction curve (CSV: creep, speed, "
     "traction_ratio); measured_fit.json and .csv in the folder"},
};

/// What a report says about, beside the results.
struct ReportContext {
  const std::string &text; ///< of the case, for summary.json
  const FrictionLaw &law;
  ExtraFiles extra;
  std::function<bool()> goOn; ///< asked often; false to stop
};

/// What a task says of itself.
struct TaskReport {
  std::string text, details; ///< for the screen; the second with --verbose
  std::string count;         ///< "21 operating points"
  double seconds = 0.0;
  std::string extra; ///< lines on extra files, after those on the folder
  /// One line for each point that did not converge, out of so many.
  std::vector<std::string> failures;
  std::vector<std::string> warnings; ///< beside those of `CreepTask::solve`; one line each
  std::size_t points = 0;
  std::optional<Error> shortfall; ///< to be thrown when everything is in place
};

/// What a case asks for: one contact in one mode. Each contact exports its own; a program asks for
/// the names of what is read and written, solves, reports, in this order.
class CreepTask {
 public:
  CreepTask() = default;
  CreepTask(const CreepTask &) = delete;
  CreepTask &operator=(const CreepTask &) = delete;
  virtual ~CreepTask() = default;

  virtual const LawChoice &friction() const = 0;
  /// What x, y, a force and a creepage of the results mean, in one line; the page wr_creep_axes.
  virtual std::string axes() const = 0;
  /// Surfaces that are read, by the path that will be opened.
  virtual std::vector<std::string> files() const = 0;
  /// Names of all files that a run may leave in its folder.
  virtual std::vector<std::string> outputs() const = 0;
  /// Extra files with the options that name them.
  /// \throws Error (Usage) for those that do not go with the task: here for any
  virtual std::vector<RequestedOutput> extraOutputs(const ExtraFiles &extra) const;
  /// Computes everything. \return warnings, one line each
  /// \throws what the contact's sweep throws
  virtual std::vector<std::string> solve(const LawPointer &law, const SweepOptions &options) = 0;
  /// Reports what `solve` found: adds all files.
  /// \throws Error (NotConverged) for a result that is not finite; Error (Interrupted) when asked
  ///         to stop; mcawr::OutputError
  virtual TaskReport report(const ReportContext &context, ResultFiles &files) const = 0;
};

/// What a run may leave in its folder, as -o asks for it: the outputs of the task, the journal.
std::vector<RequestedOutput> folderOutputs(const CreepTask &task, const std::string &folder);

/// The words on the screen when all files are in place.
/// \param files that were written
/// \param verbose with the details
std::string screenText(const TaskReport &report, const ResultFiles &files, bool verbose);

/// "21 operating points (8 of them from a run that ended early)"
std::string countOf(std::size_t points, int resumed);

/// Names the points that have no results, when those of the others are in place.
/// \param program whose name begins each line
/// \throws Error (NotConverged) if there are any
void reportFailures(const char *program, const TaskReport &report);

/// Why nothing is fitted to a task's points. \throws Error (Usage)
/// \param option that asks for the fit: "--polach"
[[noreturn]] void refuseFit(const char *option);

} // namespace wheelrail
#endif
