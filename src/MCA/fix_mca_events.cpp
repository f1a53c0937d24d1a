// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_mca_events.h"

#include "arguments.h"
#include "atom.h"
#include "error.h"
#include "pair_mca.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

enum { STEP, ID1, ID2, BEFORE, AFTER, X, Y, Z, ATTRIBUTES };
static const char *const NAMES[ATTRIBUTES] = {"step",  "id1", "id2", "before",
                                              "after", "x",   "y",   "z"};

/* fix ID group mca/events N attribute ... */

FixMCAEvents::FixMCAEvents(LAMMPS *host, int narg, char **arg)
    : Fix(host, narg, arg),
      columns(host, "Fix mca/events", {NAMES, NAMES + ATTRIBUTES}, narg - 4, arg + 4),
      pair(nullptr), collected(0)
{
  local_freq = static_cast<int>(mca::wholeNumber(lmp, "Fix mca/events N", arg[3], 1, MAXSMALLINT));
  local_flag = 1;
  size_local_cols = columns.lammps_columns();
  size_local_rows = 0;
}

int FixMCAEvents::setmask()
{
  return POST_FORCE;
}

void FixMCAEvents::init()
{
  pair = PairMCA::find(lmp, "Fix mca/events");
}

/* What a step leads to is taken over at the beginning of the next one, where the pair style lists
   it (PairMCA::record_events()), so events of step n come here in step n + 1. Rows are kept until
   the step of output; the next step begins anew. */

void FixMCAEvents::post_force(int /*vflag*/)
{
  for (const PairMCA::Event &e : pair->last_events()) {
    if (!((e.mask[0] & groupbit) && (e.mask[1] & groupbit)))
      continue;
    columns.grow(collected + 1);
    const double values[ATTRIBUTES] = {static_cast<double>(e.step),
                                       static_cast<double>(e.tag[0]),
                                       static_cast<double>(e.tag[1]),
                                       e.before,
                                       e.after,
                                       e.x[0],
                                       e.x[1],
                                       e.x[2]};
    for (int c = 0; c < columns.size(); c++)
      columns.at(collected, c) = values[columns[c]];
    collected++;
  }
  if (update->ntimestep % local_freq == 0) {
    vector_local = columns.vector;
    array_local = columns.array;
    size_local_rows = collected;
    collected = 0;
  }
}

double FixMCAEvents::memory_usage()
{
  return columns.bytes();
}
