// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/creep_task.h"

#include <fmt/format.h>

namespace wheelrail {

std::vector<RequestedOutput> CreepTask::extraOutputs(const ExtraFiles &extra) const
{
  if (!extra.polach.empty())
    refusePolach();
  if (!extra.table.empty())
    throw Error(ExitCode::Usage, "--table: goes with a contact in a point (contact.load)");
  return {};
}

std::string countOf(std::size_t points, int resumed)
{
  return fmt::format("{} points{}", points,
                     resumed ? fmt::format(" ({} of them from a run that ended early)", resumed)
                             : "");
}

void refusePolach()
{
  throw Error(ExitCode::Usage, "--polach: goes with a contact in a point (contact.load) that "
                               "rolls, without a sequence");
}

} // namespace wheelrail
