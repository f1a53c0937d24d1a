#include "compute_mca_atom.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "laws/nearest_word.h"
#include "memory.h"
#include "pair_mca.h"
#include "update.h"

#include <cstring>
#include <string>

using namespace LAMMPS_NS;

enum { SXX, SYY, SXY, SZZ, MEAN, INTENSITY, PLASTIC, LINKS, WELDS, ENERGY, THETA, ATTRIBUTES };
static const char *const NAMES[ATTRIBUTES] = {"sxx",   "syy",       "sxy",     "szz",
                                              "mean",  "intensity", "plastic", "links",
                                              "welds", "energy",    "theta"};

/* compute ID group mca/atom attribute ... */

ComputeMCAAtom::ComputeMCAAtom(LAMMPS *host, int narg, char **arg)
    : Compute(host, narg, arg), pair(nullptr), nmax(0), single(nullptr), several(nullptr)
{
  std::string known;
  for (const char *name : NAMES)
    known += std::string(" ") + name;
  if (narg < 4)
    error->all(FLERR, "Compute mca/atom needs at least one of:{}", known);
  for (int iarg = 3; iarg < narg; iarg++) {
    int found = 0;
    while (found < ATTRIBUTES && strcmp(arg[iarg], NAMES[found]) != 0)
      found++;
    if (found == ATTRIBUTES)
      error->all(FLERR, "Compute mca/atom: {}",
                 mca::unknownWord(arg[iarg], {NAMES, NAMES + ATTRIBUTES}));
    columns.push_back(found);
  }
  peratom_flag = 1;
  size_peratom_cols = columns.size() == 1 ? 0 : static_cast<int>(columns.size());
  comm_reverse = 2;
}

ComputeMCAAtom::~ComputeMCAAtom()
{
  memory->destroy(single);
  memory->destroy(several);
}

void ComputeMCAAtom::init()
{
  pair = dynamic_cast<PairMCA *>(force->pair_match("^mca", 0));
  if (!pair)
    error->all(FLERR, "Compute mca/atom requires pair_style mca");
}

void ComputeMCAAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  if (atom->nmax > nmax) {
    nmax = atom->nmax;
    if (columns.size() == 1) {
      memory->destroy(single);
      memory->create(single, nmax, "mca/atom:vector");
      vector_atom = single;
    } else {
      memory->destroy(several);
      memory->create(several, nmax, size_peratom_cols, "mca/atom:array");
      array_atom = several;
    }
  }
  bool counts = false;
  for (const int c : columns)
    counts = counts || c == LINKS || c == WELDS;
  if (counts)
    count_links();

  for (int i = 0; i < atom->nlocal; i++)
    for (size_t c = 0; c < columns.size(); c++) {
      const double v = atom->mask[i] & groupbit ? value(columns[c], i) : 0.0;
      (columns.size() == 1 ? single[i] : several[i][c]) = v;
    }
}

double ComputeMCAAtom::value(int attribute, int i) const
{
  int is_double, cols;
  switch (attribute) {
  case SXX:
    return pair->automaton(i).stress.xx;
  case SYY:
    return pair->automaton(i).stress.yy;
  case SXY:
    return pair->automaton(i).stress.xy;
  case SZZ:
    return pair->automaton(i).stress.zz;
  case MEAN:
    return pair->automaton(i).mean;
  case INTENSITY:
    return pair->automaton(i).intensity;
  case PLASTIC:
    return atom->dvector[atom->find_custom("mca_kappa", is_double, cols)][i];
  case LINKS:
    return linked[2 * i];
  case WELDS:
    return linked[2 * i + 1];
  case ENERGY:
    return pair->automaton(i).energy;
  default:
    return atom->dvector[atom->find_custom("mca_theta", is_double, cols)][i];
  }
}

void ComputeMCAAtom::count_links()
{
  linked.assign(2 * static_cast<size_t>(atom->nlocal + atom->nghost), 0.0);
  const mca::Pairs &p = pair->links().pairs();
  for (int k = 0; k < p.n; k++)
    for (const int i : {p.i[k], p.j[k]}) {
      if (mca::link::isLinked(p.now.kind[k]))
        linked[2 * i] += 1.0;
      if (p.now.kind[k] == mca::link::weld)
        linked[2 * i + 1] += 1.0;
    }
  if (force->newton_pair)
    comm->reverse_comm(this);
}

int ComputeMCAAtom::pack_reverse_comm(int n, int first, double *buf)
{
  for (int k = 0; k < 2 * n; k++)
    buf[k] = linked[2 * first + k];
  return 2 * n;
}

void ComputeMCAAtom::unpack_reverse_comm(int n, int *index, double *buf)
{
  for (int k = 0; k < n; k++)
    for (int m = 0; m < 2; m++)
      linked[2 * index[k] + m] += *buf++;
}

double ComputeMCAAtom::memory_usage()
{
  return static_cast<double>(nmax * columns.size() + linked.capacity()) * sizeof(double);
}
