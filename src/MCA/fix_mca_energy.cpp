#include "fix_mca_energy.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "pair_mca.h"
#include "restart_block.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace LAMMPS_NS;
using namespace FixConst;

static constexpr int rowLength = 4; // motion or force in x, y and rotation; strain or mean stress

FixMCAEnergy::FixMCAEnergy(LAMMPS *host, int narg, char **arg)
    : Fix(host, narg, arg), pair(nullptr), flow{}, start(0.0), begun(false), icustom_theta(-1)
{
  nevery = 1;
  restart_global = 1;
  comm_forward = comm_reverse = rowLength;
}

int FixMCAEnergy::setmask()
{
  return POST_INTEGRATE | END_OF_STEP;
}

void FixMCAEnergy::init()
{
  pair = dynamic_cast<PairMCA *>(force->pair_match("^mca", 0));
  if (!pair)
    error->all(FLERR, "Compute mca/energy requires pair_style mca");
  if (domain->dimension != 2)
    error->all(FLERR, "Compute mca/energy requires dimension 2");
  int is_double, columns;
  icustom_theta = atom->find_custom("mca_theta", is_double, columns);
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

/* the step just done: its second half */

void FixMCAEnergy::end_of_step()
{
  keep();
  const double dt = update->dt;
  const double *motion = pair->motion.get(), *spin = pair->spin.get();
  const int length = pair->kernel->rows.motion;
  for (int i = 0; i < atom->nlocal; i++)
    flow[WORK] += 0.5 * dt *
                  (external[i].x * motion[length * i + 2] + external[i].y * motion[length * i + 3] +
                   external[i].theta * spin[i]);
  add_contacts(true);
}

/* The coming step: its first half, and the change of state between both. LAMMPS has moved the
   automata, but neither the ghosts nor the pair list yet. */

void FixMCAEnergy::post_integrate()
{
  const double *theta = atom->dvector[icustom_theta];
  for (int i = 0; i < atom->nlocal; i++) {
    double *row = &rows[rowLength * i];
    row[0] = atom->x[i][0] - before[i].x;
    row[1] = atom->x[i][1] - before[i].y;
    row[2] = theta[i] - before[i].theta;
    flow[WORK] +=
        0.5 * (external[i].x * row[0] + external[i].y * row[1] + external[i].theta * row[2]);
    flow[PLASTIC] += in_elastic_z(i);
  }
  comm->forward_comm(this);
  add_contacts(false);
}

/* External forces and the places, and the mean stresses that the next state will have. */

void FixMCAEnergy::keep()
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  rows.assign(static_cast<size_t>(rowLength) * nall, 0.0);
  external.resize(nlocal);
  before.resize(nlocal);
  const double *forces = pair->forces.get();
  const int length = pair->kernel->rows.force;
  for (int i = 0; i < nall; i++)
    std::copy_n(forces + length * i, 3, &rows[rowLength * i]);
  const mca::Pairs &p = pair->pairs.pairs();
  for (int k = 0; k < p.n; k++) {
    const double e = strain(k, true).normal;
    rows[rowLength * p.i[k] + 3] += e;
    rows[rowLength * p.j[k] + 3] += e;
  }
  if (force->newton_pair)
    comm->reverse_comm(this);

  const double *theta = atom->dvector[icustom_theta];
  for (int i = 0; i < nlocal; i++) {
    double *row = &rows[rowLength * i];
    const mca::AutomatonLaw &law = pair->autolaw[atom->type[i]];
    external[i] = {atom->f[i][0] - row[0], atom->f[i][1] - row[1], atom->torque[i][2] - row[2]};
    before[i] = {atom->x[i][0], atom->x[i][1], theta[i]};
    row[3] = mca::meanStress(row[3], law.bulkModulus);
    if (pair->j2())
      row[3] += law.bulkModulus * pair->elastic_z_next.get()[i];
  }
}

/* elastic strains of pair k in the present or the next state at the present place */

mca::ElasticStrain FixMCAEnergy::strain(int k, bool next) const
{
  double state[mca::LinkList::maxStateSize];
  pair->pairs.getState(k, next, state);
  const bool linked = mca::link::isLinked(state[0]);
  const double e = pair->pairs.pairs().eps[k] - state[1];
  return {mca::touchingStrain(linked, e), linked ? state[2] : 0.0};
}

/* where the energy goes that pair k dissipates */

int FixMCAEnergy::channel(int k) const
{
  double now[mca::LinkList::maxStateSize], next[mca::LinkList::maxStateSize];
  pair->pairs.getState(k, false, now);
  pair->pairs.getState(k, true, next);
  const bool was = mca::link::isLinked(now[0]), is = mca::link::isLinked(next[0]);
  return was && !is ? FRACTURE : was ? PLASTIC : VISCOUS;
}

/* What the contacts dissipate in the second half of the step just done (back), or in the first
   half of the coming one and by the change of state before it. */

void FixMCAEnergy::add_contacts(bool back)
{
  const mca::Pairs &p = pair->pairs.pairs();
  const double dt = update->dt, unit = force->nktv2p;
  const double *motion = pair->motion.get(), *spin = pair->spin.get();
  const double *response = pair->response.get();
  const int mrow = pair->kernel->rows.motion, rrow = pair->kernel->rows.response;
  for (int k = 0; k < p.n; k++) {
    const int i = p.i[k], j = p.j[k];
    const mca::PairLaw &law = pair->pairlaw[p.law[k]];
    const double *xi = motion + mrow * i, *xj = motion + mrow * j;
    const double dx = xj[0] - xi[0], dy = xj[1] - xi[1]; // at the end of the step just done
    const double *ri = &rows[rowLength * i], *rj = &rows[rowLength * j];
    // way of j seen from i in the step that is looked at, and what both turn
    const double sx = back ? (xj[2] - xi[2]) * dt : rj[0] - ri[0];
    const double sy = back ? (xj[3] - xi[3]) * dt : rj[1] - ri[1];
    const double turns = back ? (spin[i] + spin[j]) * dt : ri[2] + rj[2];
    const double ox = back ? dx - sx : dx + sx, oy = back ? dy - sy : dy + sy; // its other end
    const double eps = p.eps[k], other = std::hypot(ox, oy) * law.invDiameter - 1.0;
    const double sign = back ? 1.0 : -1.0;
    const double turned = std::atan2(sign * (ox * dy - oy * dx), ox * dx + oy * dy);

    double state[mca::LinkList::maxStateSize];
    pair->pairs.getState(k, !back, state);
    const bool linked = mca::link::isLinked(state[0]);
    const mca::ElasticStrain moved = {sign * (eps - other), mca::shearIncrement(turned, turns)};
    const mca::ElasticStrain here = strain(k, !back);
    const double there = mca::touchingStrain(linked, other - state[1]);
    const mca::ElasticStrain strained = {sign * (here.normal - there), linked ? moved.shear : 0.0};
    const double means[2] = {response[rrow * i], response[rrow * j]};
    const double next[2] = {ri[3], rj[3]};
    const mca::ContactStress s = pair->contact(k);
    double loss = mca::stepLoss(law, s.normal / unit, s.shear / unit, here, back ? means : next,
                                moved, strained);
    if (!back)
      loss += mca::changeLoss(law, strain(k, false), here, means, next);
    flow[channel(k)] += loss * law.area * law.diameter * pair->owned_share(k);
  }
}

/* what the change of the elastic strain across the plane sets free (plasticity j2) */

double FixMCAEnergy::in_elastic_z(int i) const
{
  if (!pair->j2())
    return 0.0;
  const int type = atom->type[i];
  const mca::AutomatonLaw &law = pair->autolaw[type];
  const double now = pair->elastic_z()[i], next = pair->elastic_z_next.get()[i];
  const double mean = pair->response.get()[pair->kernel->rows.response * i];
  const double twoG = 2.0 * law.shearModulus;
  const double first = mca::normalResponse(now, twoG, law.D, mean);
  const double last = mca::normalResponse(next, twoG, law.D, rows[rowLength * i + 3]);
  return 0.5 * (first + last) * (now - next) * pair->cell(type).cellVolume();
}

FixMCAEnergy::Balance FixMCAEnergy::balance()
{
  double own[2 + FLOWS] = {}, all[2 + FLOWS];
  const double half = 0.5 * update->dt * force->ftm2v;
  for (int i = 0; i < atom->nlocal; i++) {
    const int type = atom->type[i];
    const double mass = pair->mass(type), inertia = pair->inertia(type);
    for (int m = 0; m < 2; m++)
      own[0] += mca::leapfrogEnergy(mass, atom->v[i][m], half / mass * atom->f[i][m]);
    own[0] += mca::leapfrogEnergy(inertia, atom->omega[i][2], half / inertia * atom->torque[i][2]);
    own[1] += pair->automaton(i).energy;
  }
  own[0] *= force->mvv2e;
  for (int m = 0; m < FLOWS; m++)
    own[2 + m] = flow[m];
  MPI_Allreduce(own, all, 2 + FLOWS, MPI_DOUBLE, MPI_SUM, world);
  Balance sum = {all[0], all[1], {}, all[0] + all[1] - start};
  for (int m = 0; m < FLOWS; m++) {
    sum.flow[m] = all[2 + m];
    sum.error += m == WORK ? -all[2 + m] : all[2 + m];
  }
  return sum;
}

/* ---------------------------------------------------------------------- */

int FixMCAEnergy::pack_forward_comm(int n, int *index, double *buf, int /*pbc_flag*/, int * /*pbc*/)
{
  for (int k = 0; k < n; k++)
    std::copy_n(&rows[rowLength * index[k]], rowLength, buf + rowLength * k);
  return rowLength * n;
}

void FixMCAEnergy::unpack_forward_comm(int n, int first, double *buf)
{
  std::copy_n(buf, rowLength * n, &rows[rowLength * first]);
}

int FixMCAEnergy::pack_reverse_comm(int n, int first, double *buf)
{
  std::copy_n(&rows[rowLength * first], rowLength * n, buf);
  return rowLength * n;
}

void FixMCAEnergy::unpack_reverse_comm(int n, int *index, double *buf)
{
  for (int k = 0; k < n; k++)
    for (int m = 0; m < rowLength; m++)
      rows[rowLength * index[k] + m] += *buf++;
}

void FixMCAEnergy::write_restart(FILE *fp)
{
  double all[FLOWS];
  MPI_Allreduce(flow, all, FLOWS, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me != 0)
    return;
  const std::string bytes = mca::blockBytes(
      mca::exactText({start, all[PLASTIC], all[FRACTURE], all[VISCOUS], all[WORK]}));
  const int size = static_cast<int>(bytes.size());
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(bytes.data(), 1, size, fp);
}

void FixMCAEnergy::restart(char *buf)
{
  std::istringstream text(mca::readBlockBytes(lmp, buf, "compute mca/energy"));
  text >> start;
  for (double &f : flow) {
    text >> f;
    if (comm->me != 0)
      f = 0.0; // each rank goes on from its own sum
  }
  begun = true;
}

double FixMCAEnergy::memory_usage()
{
  return static_cast<double>((external.capacity() + before.capacity()) * sizeof(Place) +
                             rows.capacity() * sizeof(double));
}
