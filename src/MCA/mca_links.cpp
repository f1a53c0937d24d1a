// SPDX-License-Identifier: GPL-2.0-or-later
#include "mca_links.h"

#include "arguments.h"
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_mca_history.h"
#include "group.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_mca.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

/* mca_links create|delete group1 group2 [reach factor], mca_links write file, mca_links read file
 * [replicate nx ny nz] */

void MCALinks::command(int narg, char **arg)
{
  pair = PairMCA::find(lmp, "Command mca_links");
  const std::string style = narg > 0 ? arg[0] : "";
  if (style == "create" || style == "delete") {
    if (narg < 3)
      error->all(FLERR, "Command mca_links needs: {} group1 group2", style);
    create_or_delete(style == "create", narg, arg);
  } else if (style == "write" || style == "read") {
    const bool copies = style == "read" && narg == 6 && strcmp(arg[2], "replicate") == 0;
    if (narg != 2 && !copies)
      error->all(FLERR, "Command mca_links needs: {} file{}", style,
                 style == "read" ? " or read file replicate nx ny nz" : "");
    style == "write" ? write(arg[1]) : read(arg[1], copies ? copies_of(narg, arg) : 1);
  } else {
    error->all(FLERR, "Command mca_links: '{}' is unknown, allowed: create, delete, write, read",
               style);
  }
  pair->evaluate(); // of the list that was made
  pair->lose_order();
}

/* the pair list with the present links, as a run's set-up makes it */

void MCALinks::list_pairs()
{
  lmp->init();
  if (domain->triclinic)
    domain->x2lamda(atom->nlocal);
  domain->pbc();
  domain->reset_box();
  comm->setup();
  if (neighbor->style)
    neighbor->setup_bins();
  comm->exchange();
  comm->borders();
  if (domain->triclinic)
    domain->lamda2x(atom->nlocal + atom->nghost);
  neighbor->build(1);
  history = dynamic_cast<FixMCAHistory *>(modify->get_fix_by_id(FixMCAHistory::ID));
  history->setup_post_neighbor();
}

/* changes the pairs of the list, and with them each automaton's number of original links */

void MCALinks::change(const std::function<void()> &pairs)
{
  list_pairs();
  const std::vector<int> before = history->originals();
  pairs();
  history->renew_normals();
  history->store_present();
  const std::vector<int> after = history->originals();
  double *made = pair->state(mca::stateNumber("links0"));
  for (int i = 0; i < atom->nlocal; i++)
    made[i] += after[i] - before[i];
}

void MCALinks::create_or_delete(bool create, int narg, char **arg)
{
  int bit[2];
  for (int g = 0; g < 2; g++) {
    const int found = group->find(arg[1 + g]);
    if (found < 0)
      error->all(FLERR, "Command mca_links: no group {}", arg[1 + g]);
    bit[g] = group->bitmask[found];
  }
  double reach = 1.01;
  for (int iarg = 3; iarg < narg; iarg += 2) {
    if (strcmp(arg[iarg], "reach") != 0 || iarg + 1 == narg)
      error->all(FLERR, "Command mca_links: unknown keyword {} or no value, allowed: reach factor",
                 arg[iarg]);
    reach = mca::number(lmp, "Command mca_links reach", arg[iarg + 1], mca::Sign::Positive);
  }

  double changed = 0.0;
  change([&]() {
    const mca::Pairs &p = pair->links().pairs();
    double **x = atom->x;
    const int *mask = atom->mask, *type = atom->type;
    for (int k = 0; k < p.n; k++) {
      const int i = p.i[k], j = p.j[k];
      const bool match =
          ((mask[i] & bit[0]) && (mask[j] & bit[1])) || ((mask[i] & bit[1]) && (mask[j] & bit[0]));
      const bool linked = mca::link::isLinked(p.now.kind[k]);
      if (!match || linked == create)
        continue;
      const double *const xi = x[p.placeI[k]], *const xj = x[p.placeJ[k]];
      const double r = std::hypot(xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]);
      const double d = 0.5 * (pair->material(type[i]).diameter + pair->material(type[j]).diameter);
      if (create && r > reach * d)
        continue;
      const double state[mca::LinkList::maxStateSize] = {create ? mca::link::bulk : mca::link::none,
                                                         p.now.plastic[k]}; // no shear
      pair->links().setState(k, state);
      pair->links().setOriginal(k, create);
      changed += pair->step().share(k);
    }
  });

  double all;
  MPI_Allreduce(&changed, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me == 0)
    utils::logmesg(lmp, "{} {:.0f} links\n", create ? "Created" : "Deleted", all);
}
