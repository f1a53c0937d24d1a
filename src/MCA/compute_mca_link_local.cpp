// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_mca_link_local.h"

#include "atom.h"
#include "error.h"
#include "pair_mca.h"
#include "update.h"

using namespace LAMMPS_NS;

enum {
  ID1,
  ID2,
  KIND,
  STRAIN,
  PLASTIC,
  GAMMA,
  GAMMA_TOTAL,
  SIGMA,
  TAU,
  NX,
  NY,
  NZ,
  TAU_X,
  TAU_Y,
  TAU_Z,
  ORIGINAL,
  ATTRIBUTES
};
static const char *const NAMES[ATTRIBUTES] = {
    "id1", "id2", "kind", "strain", "plastic", "gamma", "gamma_total", "sigma",
    "tau", "nx",  "ny",   "nz",     "tau_x",   "tau_y", "tau_z",       "original"};

/* compute ID group mca/link/local attribute ... */

ComputeMCALinkLocal::ComputeMCALinkLocal(LAMMPS *host, int narg, char **arg)
    : Compute(host, narg, arg),
      columns(host, "Compute mca/link/local", {NAMES, NAMES + ATTRIBUTES}, narg - 3, arg + 3),
      pair(nullptr)
{
  local_flag = 1;
  size_local_cols = columns.lammps_columns();
}

void ComputeMCALinkLocal::init()
{
  pair = PairMCA::find(lmp, "Compute mca/link/local");
}

/* linked, both in the group, and counted by one rank only */

bool ComputeMCALinkLocal::mine(int k) const
{
  const mca::Pairs &p = pair->links().pairs();
  const int i = p.i[k], j = p.j[k];
  if (!mca::link::isLinked(p.now.kind[k]))
    return false;
  if (!(atom->mask[i] & groupbit) || !(atom->mask[j] & groupbit))
    return false;
  return pair->step().isOurs(k);
}

void ComputeMCALinkLocal::compute_local()
{
  pair = PairMCA::find(lmp, "Compute mca/link/local"); // it may have gone since init()
  pair->check_internal_fixes();
  pair->check_order();
  invoked_local = update->ntimestep;
  const mca::Pairs &p = pair->links().pairs();
  size_local_rows = 0;
  for (int k = 0; k < p.n; k++)
    size_local_rows += mine(k);
  columns.grow(size_local_rows);
  vector_local = columns.vector;
  array_local = columns.array;
  int row = 0;
  for (int k = 0; k < p.n; k++) {
    if (!mine(k))
      continue;
    for (int c = 0; c < columns.size(); c++)
      columns.at(row, c) = value(columns[c], k);
    row++;
  }
}

mca::Vector ComputeMCALinkLocal::tau(int k) const
{
  return pair->step().alongShear(k, pair->contact(k).tau);
}

double ComputeMCALinkLocal::value(int attribute, int k) const
{
  const mca::Pairs &p = pair->links().pairs();
  switch (attribute) {
  case ID1:
    return static_cast<double>(atom->tag[p.i[k]]);
  case ID2:
    return static_cast<double>(atom->tag[p.j[k]]);
  case KIND:
    return p.now.kind[k];
  case STRAIN:
    return p.eps[k];
  case PLASTIC:
    return p.now.plastic[k];
  case GAMMA:
    return pair->step().shear(k);
  case GAMMA_TOTAL:
    return pair->step().totalShear(k);
  case SIGMA:
    return pair->contact(k).sigma;
  case ORIGINAL:
    return pair->links().original(k);
  case TAU:
    return pair->contact(k).tau;
  case NX:
    return pair->step().normal(k).x;
  case NY:
    return pair->step().normal(k).y;
  case NZ:
    return pair->step().normal(k).z;
  case TAU_X:
    return tau(k).x;
  case TAU_Y:
    return tau(k).y;
  default:
    return tau(k).z;
  }
}

double ComputeMCALinkLocal::memory_usage()
{
  return columns.bytes();
}
