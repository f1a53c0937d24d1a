// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_mca_energy.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "flat.h"
#include "force.h"
#include "pair_mca.h"
#include "restart_block.h"
#include "update.h"

#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

FixMCAEnergy::FixMCAEnergy(LAMMPS *host, int narg, char **arg)
    : Fix(host, narg, arg), pair(nullptr), start(0.0), begun(false)
{
  if (strcmp(id, ID) != 0)
    error->all(FLERR, "Fix {} is internal to compute mca/energy, which makes it itself", ID);
  nevery = 1;
  restart_global = 1;
}

int FixMCAEnergy::setmask()
{
  return POST_INTEGRATE | END_OF_STEP;
}

void FixMCAEnergy::init()
{
  pair = PairMCA::find(lmp, "Compute mca/energy");
}

void FixMCAEnergy::setup(int /*vflag*/)
{
  keep();
  if (begun)
    return;
  begun = true;
  const Balance now = balance();
  start = now.kinetic + now.elastic;
}

void FixMCAEnergy::keep()
{
  account.keep(pair->step(), mca::flat(atom->x), mca::flat(atom->f), mca::flat(atom->torque));
}

void FixMCAEnergy::end_of_step()
{
  keep();
  account.bookSecondHalf(pair->step(), update->dt);
}

/* LAMMPS has moved the automata, but neither the ghosts nor the pair list yet */

void FixMCAEnergy::post_integrate()
{
  account.bookFirstHalf(pair->step(), mca::flat(atom->x), mca::flat(atom->omega), update->dt);
}

FixMCAEnergy::Balance FixMCAEnergy::balance()
{
  double own[2 + FLOWS] = {}, all[2 + FLOWS];
  const double half = 0.5 * update->dt * force->ftm2v;
  for (int i = 0; i < atom->nlocal; i++) {
    const int type = atom->type[i];
    const double mass = pair->mass(type), inertia = pair->inertia(type);
    for (int m = 0; m < 3; m++) {
      own[0] += mca::leapfrogEnergy(mass, atom->v[i][m], half / mass * atom->f[i][m]);
      own[0] +=
          mca::leapfrogEnergy(inertia, atom->omega[i][m], half / inertia * atom->torque[i][m]);
    }
    own[1] += pair->step().automaton(i).energy;
  }
  own[0] *= force->mvv2e;
  own[1] -= account.released();
  for (int m = 0; m < FLOWS; m++)
    own[2 + m] = account.sums()[m];
  MPI_Allreduce(own, all, 2 + FLOWS, MPI_DOUBLE, MPI_SUM, world);
  Balance sum = {all[0], all[1], {}, all[0] + all[1] - start};
  for (int m = 0; m < FLOWS; m++) {
    sum.flow[m] = all[2 + m];
    sum.error += m == mca::EnergyAccount::Work ? -all[2 + m] : all[2 + m];
  }
  return sum;
}

/* ---------------------------------------------------------------------- */

void FixMCAEnergy::write_restart(FILE *fp)
{
  std::vector<double> values(1 + FLOWS, start);
  MPI_Allreduce(account.sums(), values.data() + 1, FLOWS, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me != 0)
    return;
  mca::writeFixBlock(fp, mca::exactText(values));
}

void FixMCAEnergy::restart(char *buf)
{
  const char *const what = "compute mca/energy";
  const std::string text = mca::fixBlockText(lmp, buf, what);
  const std::vector<double> values =
      mca::readOrStop(lmp, [&] { return mca::numbersIn(text, 1 + FLOWS, what); });
  start = values[0];
  for (int m = 0; m < FLOWS; m++) // each rank goes on from its own sum
    account.setSum(static_cast<mca::EnergyAccount::Channel>(m),
                   comm->me == 0 ? values[1 + m] : 0.0);
  begun = true;
}

double FixMCAEnergy::memory_usage()
{
  return account.bytes();
}
