// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_mca_fragment_atom.h"

#include "arguments.h"
#include "atom.h"
#include "comm.h"
#include "core/fragments.h"
#include "error.h"
#include "pair_mca.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

static const char *const WHO = "Compute mca/fragment/atom";

/* compute ID group mca/fragment/atom [single yes|no] */

ComputeMCAFragmentAtom::ComputeMCAFragmentAtom(LAMMPS *host, int narg, char **arg)
    : Compute(host, narg, arg), pair(nullptr), single(false)
{
  for (int iarg = 3; iarg < narg; iarg += 2) {
    const char *const value = iarg + 1 < narg ? arg[iarg + 1] : "";
    single = strcmp(value, "yes") == 0;
    if (strcmp(arg[iarg], "single") != 0 || !(single || strcmp(value, "no") == 0))
      error->all(FLERR, "{}: '{} {}' is not allowed, must be: single yes|no", WHO, arg[iarg],
                 value);
  }
  peratom_flag = 1;
  size_peratom_cols = 0;
  comm_forward = 1;
}

void ComputeMCAFragmentAtom::init()
{
  pair = PairMCA::find(lmp, WHO);
}

/* Links of two ranks are in the lists of both, and join own automata to ghosts. Each rank finds the
   lowest ID of its parts; what ghosts hear from their owners lowers it, until none does. */

void ComputeMCAFragmentAtom::compute_peratom()
{
  pair = PairMCA::find(lmp, WHO); // it may have gone since init()
  pair->check_internal_fixes();
  pair->check_order();
  invoked_peratom = update->ntimestep;
  const int own = atom->nlocal, all = own + atom->nghost;
  lowest.resize(std::max(atom->nmax, 1));
  vector_atom = lowest.data();

  // ghosts learn from their owners whether they are in the group, which may be a dynamic one
  for (int i = 0; i < own; i++)
    lowest[i] = atom->mask[i] & groupbit ? static_cast<double>(atom->tag[i]) : 0.0;
  comm->forward_comm(this);

  mca::Fragments parts(all);
  const mca::Pairs &p = pair->links().pairs();
  for (int k = 0; k < p.n; k++)
    if (mca::link::isLinked(p.now.kind[k]) && lowest[p.i[k]] > 0.0 && lowest[p.j[k]] > 0.0)
      parts.join(p.i[k], p.j[k]);

  for (int changed = 1; changed;) {
    for (int i = 0; i < all; i++) {
      double &root = lowest[parts.root(i)];
      root = std::min(root, lowest[i]);
    }
    changed = 0;
    for (int i = 0; i < all; i++) {
      const double found = lowest[parts.root(i)];
      changed |= i < own && found < lowest[i];
      lowest[i] = found;
    }
    MPI_Allreduce(MPI_IN_PLACE, &changed, 1, MPI_INT, MPI_MAX, world);
    if (changed)
      comm->forward_comm(this);
  }
  for (int i = 0; i < own && !single; i++)
    if (parts.size(i) == 1)
      lowest[i] = 0.0;
}

int ComputeMCAFragmentAtom::pack_forward_comm(int n, int *list, double *buf, int /*pbc_flag*/,
                                              int * /*pbc*/)
{
  for (int m = 0; m < n; m++)
    buf[m] = lowest[list[m]];
  return n;
}

void ComputeMCAFragmentAtom::unpack_forward_comm(int n, int first, double *buf)
{
  std::copy_n(buf, n, &lowest[first]);
}

double ComputeMCAFragmentAtom::memory_usage()
{
  return static_cast<double>(lowest.capacity() * sizeof(double));
}
