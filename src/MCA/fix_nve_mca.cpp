// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_nve_mca.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "flat.h"
#include "force.h"
#include "pair_mca.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr int THETA = mca::stateNumber("theta");

FixNVEMCA::FixNVEMCA(LAMMPS *host, int narg, char **arg) : Fix(host, narg, arg), pair(nullptr)
{
  if (narg != 3)
    error->all(FLERR, "Fix nve/mca takes no arguments, got {}", arg[3]);
  if (!atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "Fix nve/mca requires atom style sphere");
  dynamic_group_allow = 1;
  time_integrate = 1;
}

int FixNVEMCA::setmask()
{
  return INITIAL_INTEGRATE | FINAL_INTEGRATE;
}

void FixNVEMCA::init()
{
  pair = PairMCA::find(lmp, "Fix nve/mca");
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "Fix nve/mca does not work with run_style respa");
  reset_dt();
}

void FixNVEMCA::reset_dt()
{
  dtv = update->dt;
  const double dtf = 0.5 * update->dt * force->ftm2v;
  // one division a type, not two an automaton and half step
  halfstep.assign(atom->ntypes + 1, {0.0, 0.0});
  for (int type = 1; type <= atom->ntypes; type++)
    halfstep[type] = {dtf / pair->mass(type), dtf / pair->inertia(type)};
}

/* Half a step of the velocities, and a step of the places. A ball turns alike about any axis, so
   that its angular velocity follows the torque as a disc's does. */

template<int DIMENSION, bool MOVES>
void FixNVEMCA::step()
{
  constexpr int first_axis = DIMENSION == 2 ? 2 : 0;
  auto *x = mca::flat(atom->x), *v = mca::flat(atom->v), *f = mca::flat(atom->f);
  auto *omega = mca::flat(atom->omega), *torque = mca::flat(atom->torque);
  double *theta = pair->state(THETA);
  const int *mask = atom->mask, *type = atom->type;
  const int n = igroup == atom->firstgroup ? atom->nfirst : atom->nlocal;
  for (int i = 0; i < n; i++) {
    if (!(mask[i] & groupbit))
      continue;
    const HalfStep half = halfstep[type[i]];
    for (int m = 0; m < DIMENSION; m++) {
      v[i][m] += half.over_mass * f[i][m];
      if (MOVES)
        x[i][m] += dtv * v[i][m];
    }
    for (int m = first_axis; m < 3; m++)
      omega[i][m] += half.over_inertia * torque[i][m];
    if (DIMENSION == 2 && MOVES)
      theta[i] += dtv * omega[i][2];
  }
}

void FixNVEMCA::initial_integrate(int /*vflag*/)
{
  domain->dimension == 2 ? step<2, true>() : step<3, true>();
}

void FixNVEMCA::final_integrate()
{
  domain->dimension == 2 ? step<2, false>() : step<3, false>();
}
