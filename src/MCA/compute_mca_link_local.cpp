#include "compute_mca_link_local.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "laws/nearest_word.h"
#include "memory.h"
#include "pair_mca.h"
#include "update.h"

#include <cstring>
#include <string>

using namespace LAMMPS_NS;

enum { ID1, ID2, KIND, STRAIN, PLASTIC, GAMMA, GAMMA_TOTAL, SIGMA, TAU, ATTRIBUTES };
static const char *const NAMES[ATTRIBUTES] = {"id1",   "id2",         "kind",  "strain", "plastic",
                                              "gamma", "gamma_total", "sigma", "tau"};

/* compute ID group mca/link/local attribute ... */

ComputeMCALinkLocal::ComputeMCALinkLocal(LAMMPS *host, int narg, char **arg)
    : Compute(host, narg, arg), pair(nullptr), nmax(0), single(nullptr), several(nullptr)
{
  std::string known;
  for (const char *name : NAMES)
    known += std::string(" ") + name;
  if (narg < 4)
    error->all(FLERR, "Compute mca/link/local needs at least one of:{}", known);
  for (int iarg = 3; iarg < narg; iarg++) {
    int found = 0;
    while (found < ATTRIBUTES && strcmp(arg[iarg], NAMES[found]) != 0)
      found++;
    if (found == ATTRIBUTES)
      error->all(FLERR, "Compute mca/link/local: {}",
                 mca::unknownWord(arg[iarg], {NAMES, NAMES + ATTRIBUTES}));
    columns.push_back(found);
  }
  local_flag = 1;
  size_local_cols = columns.size() == 1 ? 0 : static_cast<int>(columns.size());
}

ComputeMCALinkLocal::~ComputeMCALinkLocal()
{
  memory->destroy(single);
  memory->destroy(several);
}

void ComputeMCALinkLocal::init()
{
  pair = dynamic_cast<PairMCA *>(force->pair_match("^mca", 0));
  if (!pair)
    error->all(FLERR, "Compute mca/link/local requires pair_style mca");
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
  return pair->on_this_rank(k);
}

void ComputeMCALinkLocal::compute_local()
{
  invoked_local = update->ntimestep;
  const mca::Pairs &p = pair->links().pairs();
  size_local_rows = 0;
  for (int k = 0; k < p.n; k++)
    size_local_rows += mine(k);
  if (size_local_rows > nmax) {
    nmax = size_local_rows + size_local_rows / 8;
    if (columns.size() == 1) {
      memory->destroy(single);
      memory->create(single, nmax, "mca/link/local:vector");
      vector_local = single;
    } else {
      memory->destroy(several);
      memory->create(several, nmax, size_local_cols, "mca/link/local:array");
      array_local = several;
    }
  }
  int row = 0;
  for (int k = 0; k < p.n; k++) {
    if (!mine(k))
      continue;
    for (size_t c = 0; c < columns.size(); c++)
      (columns.size() == 1 ? single[row] : several[row][c]) = value(columns[c], k);
    row++;
  }
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
    return p.now.gamma[0][k];
  case GAMMA_TOTAL:
    return p.now.gammaTotal[0][k];
  case SIGMA:
    return pair->contact(k).sigma;
  default:
    return pair->contact(k).tau;
  }
}

double ComputeMCALinkLocal::memory_usage()
{
  return static_cast<double>(nmax * columns.size()) * sizeof(double);
}
