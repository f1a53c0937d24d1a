// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/read_runs.h"

namespace wheelrail {

LogRuns readRuns(const std::vector<FoundLog> &logs, const AveragingOptions &options)
{
  LogRuns read;
  for (const FoundLog &found : logs) {
    try {
      const FrictionLog log = found.read();
      if (!log.note.empty())
        read.notes.push_back(log.note);
      read.runs.push_back(frictionRun(log, options));
    } catch (const Error &error) {
      if (error.code() != ExitCode::BadInput)
        throw;
      read.problems.push_back(error);
    }
  }
  return read;
}

} // namespace wheelrail
