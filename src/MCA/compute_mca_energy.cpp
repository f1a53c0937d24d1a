// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_mca_energy.h"

#include "error.h"
#include "fix_mca_energy.h"
#include "fix_order.h"
#include "modify.h"
#include "pair_mca.h"
#include "update.h"

using namespace LAMMPS_NS;

ComputeMCAEnergy::ComputeMCAEnergy(LAMMPS *host, int narg, char **arg) : Compute(host, narg, arg)
{
  if (narg != 3)
    error->all(FLERR, "Compute mca/energy takes no arguments, got {}", arg[3]);
  if (igroup != 0)
    error->all(FLERR, "Compute mca/energy: group {}, allowed: all", arg[1]);
  PairMCA::find(lmp, "Compute mca/energy");
  if (modify->get_fix_by_id(FixMCAEnergy::ID))
    error->all(FLERR, "Only one compute mca/energy at a time allowed");
  scalar_flag = vector_flag = 1;
  size_vector = 2 + FixMCAEnergy::FLOWS;
  extscalar = extvector = 1;
  vector = new double[size_vector];
  // its books of a step are made before any other fix reads them
  mca::moveToFront(lmp,
                   modify->add_fix(fmt::format("{} all {}", FixMCAEnergy::ID, FixMCAEnergy::ID)));
}

ComputeMCAEnergy::~ComputeMCAEnergy()
{
  delete[] vector;
  if (modify->get_fix_by_id(FixMCAEnergy::ID))
    modify->delete_fix(FixMCAEnergy::ID);
}

/* commands can take it away at any time */

FixMCAEnergy &ComputeMCAEnergy::account() const
{
  auto *fix = dynamic_cast<FixMCAEnergy *>(modify->get_fix_by_id(FixMCAEnergy::ID));
  if (!fix)
    error->all(FLERR,
               "Fix {}, which sums up for compute mca/energy, is gone: it must not be unfixed or "
               "unloaded",
               FixMCAEnergy::ID);
  PairMCA::find(lmp, "Compute mca/energy")->check_internal_fixes();
  return *fix;
}

/* of a sample that has the automata of the last list */

static FixMCAEnergy::Balance balanceOf(FixMCAEnergy &account, const PairMCA *pair)
{
  pair->check_order();
  return account.balance();
}

double ComputeMCAEnergy::compute_scalar()
{
  invoked_scalar = update->ntimestep;
  return scalar = balanceOf(account(), PairMCA::found(lmp)).error;
}

void ComputeMCAEnergy::compute_vector()
{
  invoked_vector = update->ntimestep;
  const FixMCAEnergy::Balance b = balanceOf(account(), PairMCA::found(lmp));
  vector[0] = b.kinetic;
  vector[1] = b.elastic;
  for (int m = 0; m < FixMCAEnergy::FLOWS; m++)
    vector[2 + m] = b.flow[m];
}
