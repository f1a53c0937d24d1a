// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_mca_events.h"

#include "arguments.h"
#include "comm.h"
#include "error.h"
#include "pair_mca.h"
#include "restart_block.h"
#include "update.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

using namespace LAMMPS_NS;
using namespace FixConst;

static const char *const EVENT_WORDS[] = {"step",   "id1",   "id2", "type1", "type2",
                                          "before", "after", "x",   "y",     "z"};
static constexpr std::size_t WIDTH = std::size(EVENT_WORDS); // values of an event

/* N, before the attributes; 0 where nothing is given, which they refuse. */

static int steps_of(LAMMPS *lmp, int narg, char **arg)
{
  if (narg < 4)
    return 0;
  return static_cast<int>(mca::wholeNumber(lmp, "Fix mca/events N", arg[3], 1, MAXSMALLINT));
}

/* fix ID group mca/events N attribute ... */

FixMCAEvents::FixMCAEvents(LAMMPS *host, int narg, char **arg)
    : Fix(host, narg, arg), every(steps_of(host, narg, arg)),
      columns(host, "Fix mca/events", {EVENT_WORDS, EVENT_WORDS + WIDTH}, narg - 4, arg + 4),
      pair(nullptr), counts{}
{
  local_freq = every;
  local_flag = 1;
  size_local_cols = columns.lammps_columns();
  size_local_rows = 0;
  vector_flag = 1;
  size_vector = COUNTERS;
  extvector = 1;
  global_freq = 1;
  restart_global = 1;
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
    const bool was = mca::link::isLinked(e.before), is = mca::link::isLinked(e.after);
    counts[was && is ? HEALED : was ? BROKEN : FORMED]++;
    const double values[WIDTH] = {static_cast<double>(e.step),
                                  static_cast<double>(e.tag[0]),
                                  static_cast<double>(e.tag[1]),
                                  static_cast<double>(e.type[0]),
                                  static_cast<double>(e.type[1]),
                                  e.before,
                                  e.after,
                                  e.x[0],
                                  e.x[1],
                                  e.x[2]};
    collected.insert(collected.end(), values, values + WIDTH);
  }
  if (update->ntimestep % local_freq == 0)
    give_out();
}

void FixMCAEvents::give_out()
{
  size_local_rows = static_cast<int>(collected.size() / WIDTH);
  columns.grow(size_local_rows);
  for (int row = 0; row < size_local_rows; row++)
    for (int c = 0; c < columns.size(); c++)
      columns.at(row, c) = collected[row * WIDTH + columns[c]];
  vector_local = columns.vector;
  array_local = columns.array;
  collected.clear();
}

double FixMCAEvents::compute_vector(int n)
{
  double all;
  MPI_Allreduce(&counts[n], &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* counters, then rows; with the rows of all ranks in the order of ranks */

void FixMCAEvents::write_restart(FILE *fp)
{
  std::vector<double> all(COUNTERS);
  MPI_Reduce(counts, all.data(), COUNTERS, MPI_DOUBLE, MPI_SUM, 0, world);
  static constexpr std::size_t longest_word = 25; // of a number of 17 digits, with the blank
  static constexpr auto most = static_cast<bigint>(mca::longestBlock / (longest_word * WIDTH));
  const auto own_rows = static_cast<bigint>(collected.size() / WIDTH);
  bigint rows;
  MPI_Allreduce(&own_rows, &rows, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (rows >= most)
    error->all(FLERR,
               "Fix mca/events N is {}: {} events since the last output are too many for a restart "
               "file, allowed: below {}; give a smaller N",
               every, rows, most);
  const int own = static_cast<int>(collected.size());
  std::vector<int> sizes(comm->nprocs), places(comm->nprocs + 1, COUNTERS);
  MPI_Gather(&own, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, world);
  for (int rank = 0; rank < comm->nprocs; rank++)
    places[rank + 1] = places[rank] + sizes[rank];
  all.resize(places.back());
  MPI_Gatherv(collected.data(), own, MPI_DOUBLE, all.data(), sizes.data(), places.data(),
              MPI_DOUBLE, 0, world);
  if (comm->me == 0)
    mca::writeFixBlock(fp, mca::exactText(all));
}

void FixMCAEvents::restart(char *buf)
{
  const char *const what = "fix mca/events";
  const std::string text = mca::fixBlockText(lmp, buf, what);
  const std::vector<double> all =
      mca::readOrStop(lmp, [&] { return mca::numbersIn(text, std::nullopt, what); });
  if (all.size() < COUNTERS || (all.size() - COUNTERS) % WIDTH != 0)
    error->all(FLERR, "Restart file is damaged: the block of {} has {} numbers", what, all.size());
  if (comm->me != 0)
    return;
  std::copy_n(all.begin(), COUNTERS, counts);
  collected.assign(all.begin() + COUNTERS, all.end());
}

double FixMCAEvents::memory_usage()
{
  return columns.bytes() + static_cast<double>(collected.capacity() * sizeof(double));
}
