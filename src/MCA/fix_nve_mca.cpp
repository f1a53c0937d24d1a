// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_nve_mca.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "flat.h"
#include "force.h"
#include "pair_mca.h"
#include "update.h"

#include <algorithm>

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
  PairMCA::find(lmp, "Fix nve/mca");
  reset_dt();
}

/* The command timestep comes here between runs, too: before init(), or with a pair style that is
   gone or is not complete yet. Then the next init() does it. */

void FixNVEMCA::reset_dt()
{
  pair = PairMCA::found(lmp);
  if (!pair || !pair->knows_masses())
    return;
  dtv = update->dt;
  const double dtf = 0.5 * update->dt * force->ftm2v;
  // one division a type, not two an automaton and half step
  halfstep.assign(atom->ntypes + 1, {0.0, 0.0});
  for (int type = 1; type <= atom->ntypes; type++)
    halfstep[type] = {dtf / pair->mass(type), dtf / pair->inertia(type)};
  alike = igroup == 0 &&
          std::all_of(halfstep.begin() + 1, halfstep.end(), [this](const HalfStep &half) {
            return half.over_mass == halfstep[1].over_mass &&
                   half.over_inertia == halfstep[1].over_inertia;
          });
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

/* Half a step of all automata of the rank, whose types are alike: arrays as plain numbers, two
   automata at a time. The third components that the plane does not have get a factor of 0. */

template<int DIMENSION, bool MOVES>
void FixNVEMCA::step_alike()
{
  constexpr int both = 6;
  constexpr bool plane = DIMENSION == 2;
  const HalfStep half = halfstep[1];
  const double third = plane ? 0.0 : half.over_mass, third_way = plane ? 0.0 : dtv;
  const double push[both] = {half.over_mass, half.over_mass, third,
                             half.over_mass, half.over_mass, third};
  const double way[both] = {dtv, dtv, third_way, dtv, dtv, third_way};
  double *const __restrict x = atom->x[0], *const __restrict v = atom->v[0];
  double *const __restrict omega = atom->omega[0];
  const double *const __restrict f = atom->f[0], *const __restrict torque = atom->torque[0];
  const int n = 3 * atom->nlocal, whole = n / both * both;
  auto move = [=](int from, int to) {
    for (int m = 0; m < to; m++) {
      v[from + m] += push[m] * f[from + m];
      if (MOVES)
        x[from + m] += way[m] * v[from + m];
    }
  };
  for (int k = 0; k < whole; k += both)
    move(k, both);
  move(whole, n - whole);
  if (!plane) {
    for (int k = 0; k < n; k++)
      omega[k] += half.over_inertia * torque[k];
    return;
  }
  double *const theta = pair->state(THETA);
  for (int i = 0; i < atom->nlocal; i++) {
    omega[3 * i + 2] += half.over_inertia * torque[3 * i + 2];
    if (MOVES)
      theta[i] += dtv * omega[3 * i + 2];
  }
}

template<bool MOVES>
void FixNVEMCA::step_of_dimension()
{
  const bool plane = domain->dimension == 2;
  if (alike && atom->nlocal > 0)
    plane ? step_alike<2, MOVES>() : step_alike<3, MOVES>();
  else
    plane ? step<2, MOVES>() : step<3, MOVES>();
}

void FixNVEMCA::initial_integrate(int /*vflag*/)
{
  step_of_dimension<true>();
}

void FixNVEMCA::final_integrate()
{
  step_of_dimension<false>();
}
