// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_mca_atom.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "pair_mca.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

enum {
  SXX,
  SYY,
  SXY,
  SZZ,
  SXZ,
  SYZ,
  MEAN,
  INTENSITY,
  PLASTIC,
  LINKS,
  WELDS,
  DAMAGE,
  ENERGY,
  THETA,
  PLASTIC_WORK,
  BROKEN,
  FORMED,
  ATTRIBUTES
};
static const char *const NAMES[ATTRIBUTES] = {
    "sxx",   "syy",   "sxy",    "szz",    "sxz",   "syz",          "mean",   "intensity", "plastic",
    "links", "welds", "damage", "energy", "theta", "plastic_work", "broken", "formed"};
static constexpr int COUNTS = 3;

/* compute ID group mca/atom attribute ... */

ComputeMCAAtom::ComputeMCAAtom(LAMMPS *host, int narg, char **arg)
    : Compute(host, narg, arg),
      columns(host, "Compute mca/atom", {NAMES, NAMES + ATTRIBUTES}, narg - 3, arg + 3),
      pair(nullptr)
{
  peratom_flag = 1;
  size_peratom_cols = columns.lammps_columns();
}

void ComputeMCAAtom::init()
{
  pair = dynamic_cast<PairMCA *>(force->pair_match("^mca", 0));
  if (!pair)
    error->all(FLERR, "Compute mca/atom requires pair_style mca");
  if (columns.has(THETA) && domain->dimension == 3)
    error->all(FLERR, "Compute mca/atom theta is for dimension 2: in space rotations do not add up "
                      "to an angle");
}

void ComputeMCAAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  columns.grow(atom->nmax);
  vector_atom = columns.vector;
  array_atom = columns.array;
  if (columns.has(BROKEN) || columns.has(FORMED))
    pair->collect_changes();
  if (columns.has(LINKS) || columns.has(WELDS) || columns.has(DAMAGE))
    count_links();

  for (int i = 0; i < atom->nlocal; i++)
    for (int c = 0; c < columns.size(); c++)
      columns.at(i, c) = atom->mask[i] & groupbit ? value(columns[c], i) : 0.0;
}

double ComputeMCAAtom::value(int attribute, int i) const
{
  int is_double, cols;
  auto state = [&](const char *name) {
    return atom->dvector[atom->find_custom(name, is_double, cols)][i];
  };
  switch (attribute) {
  case SXX:
    return pair->automaton(i).stress.xx;
  case SYY:
    return pair->automaton(i).stress.yy;
  case SXY:
    return pair->automaton(i).stress.xy;
  case SZZ:
    return pair->automaton(i).stress.zz;
  case SXZ:
    return pair->automaton(i).stress.xz;
  case SYZ:
    return pair->automaton(i).stress.yz;
  case MEAN:
    return pair->automaton(i).mean;
  case INTENSITY:
    return pair->automaton(i).intensity;
  case PLASTIC:
    return state("mca_kappa");
  case LINKS:
    return counts[COUNTS * i];
  case WELDS:
    return counts[COUNTS * i + 1];
  case DAMAGE: {
    const double made = state("mca_links0");
    return made > 0.0 ? 1.0 - counts[COUNTS * i + 2] / made : 0.0;
  }
  case ENERGY:
    return pair->automaton(i).energy;
  case PLASTIC_WORK:
    return pair->plastic_work(i);
  case BROKEN:
    return state("mca_broken");
  case FORMED:
    return state("mca_formed");
  default:
    return state("mca_theta");
  }
}

void ComputeMCAAtom::count_links()
{
  counts.assign(COUNTS * static_cast<size_t>(atom->nlocal + atom->nghost), 0.0);
  const mca::Pairs &p = pair->links().pairs();
  for (int k = 0; k < p.n; k++) {
    const double kind = p.now.kind[k];
    if (!mca::link::isLinked(kind))
      continue;
    for (const int i : {p.i[k], p.j[k]}) {
      counts[COUNTS * i] += 1.0;
      counts[COUNTS * i + 1] += kind == mca::link::weld;
      counts[COUNTS * i + 2] += pair->links().original(k);
    }
  }
}

double ComputeMCAAtom::memory_usage()
{
  return columns.bytes() + static_cast<double>(counts.capacity()) * sizeof(double);
}
