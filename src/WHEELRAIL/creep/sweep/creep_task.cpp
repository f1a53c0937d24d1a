// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/creep_task.h"

#include "base/program.h"
#include "creep/sweep/journal.h"

#include <algorithm>
#include <fmt/format.h>

namespace wheelrail {

std::vector<RequestedOutput> CreepTask::extraOutputs(const ExtraFiles &extra) const
{
  if (!extra.polach.empty())
    refuseFit("--polach");
  if (!extra.table.empty())
    throw Error(ExitCode::Usage, "--table: goes with a point contact (contact.load)");
  if (!extra.measured.empty())
    refuseFit("--fit-measured");
  return {};
}

std::vector<RequestedOutput> folderOutputs(const CreepTask &task, const std::string &folder)
{
  std::vector<RequestedOutput> outputs;
  for (const std::string &name : task.outputs())
    outputs.push_back({"-o", folder + "/" + name});
  outputs.push_back({"-o", folder + "/" + journalName});
  return outputs;
}

std::string screenText(const TaskReport &report, const ResultFiles &files, bool verbose)
{
  return fmt::format("{}{}{} in {:.2f} s; written to {}/: {}\n{}", verbose ? report.details : "",
                     report.text, report.count, report.seconds, files.folder(), files.names(),
                     report.extra);
}

std::string countOf(std::size_t points, int resumed)
{
  return fmt::format("{} operating points{}", points,
                     resumed ? fmt::format(" ({} of them from a run that ended early)", resumed)
                             : "");
}

void refuseFit(const char *option)
{
  throw Error(ExitCode::Usage,
              fmt::format("{}: goes with a point contact (contact.load) that rolls, without a "
                          "sequence",
                          option));
}

void reportFailures(const char *program, const TaskReport &report)
{
  const std::vector<std::string> &failures = report.failures;
  constexpr std::size_t most = 10;
  for (std::size_t k = 0; k < std::min(most, failures.size()); ++k)
    complain(program, failures[k]);
  if (!failures.empty())
    throw Error(
        ExitCode::NotConverged,
        fmt::format("{} of {} operating points did not converge and {} left out{}; the others are "
                    "written",
                    failures.size(), report.points, failures.size() == 1 ? "is" : "are",
                    failures.size() > most ? " (summary.json names all)" : ""));
}

} // namespace wheelrail
