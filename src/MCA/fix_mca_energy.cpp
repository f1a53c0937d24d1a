#include "fix_mca_energy.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "laws/pair_motion.h"
#include "pair_mca.h"
#include "restart_block.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace LAMMPS_NS;
using namespace FixConst;

// way and rotation, or force and torque; strain or mean stress
static constexpr int rowLength = 7, scalar = 6;

static mca::Vector vector(const double *values)
{
  return {values[0], values[1], values[2]};
}

static void store(const mca::Vector &v, double *values)
{
  values[0] = v.x;
  values[1] = v.y;
  values[2] = v.z;
}

FixMCAEnergy::FixMCAEnergy(LAMMPS *host, int narg, char **arg)
    : Fix(host, narg, arg), pair(nullptr), flow{}, start(0.0), begun(false)
{
  nevery = 1;
  restart_global = 1;
  comm_forward = rowLength;
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

/* where an automaton was when the forces of the step just done were computed */

mca::Vector FixMCAEnergy::place(int i) const
{
  const double *row =
      pair->motion.get() + static_cast<size_t>(pair->kernel->rows.motion.length) * i;
  return {row[0], row[1], pair->kernel->dimension == 2 ? 0.0 : row[2]};
}

/* what it moved in that step */

FixMCAEnergy::Motion FixMCAEnergy::step_done(int i) const
{
  const int dimension = pair->kernel->dimension;
  const double *row =
      pair->motion.get() + static_cast<size_t>(pair->kernel->rows.motion.length) * i;
  const double *v = row + dimension, dt = update->dt, spin = pair->spin.get()[i];
  if (dimension == 2)
    return {dt * mca::Vector{v[0], v[1], 0.0}, {0.0, 0.0, dt * spin}};
  return {dt * vector(v), dt * mca::Vector{row[6], row[7], spin}};
}

void FixMCAEnergy::add_work(int i, const Motion &moved)
{
  flow[WORK] += 0.5 * (dot(external[i].way, moved.way) + dot(external[i].turn, moved.turn));
}

/* the step just done: its second half */

void FixMCAEnergy::end_of_step()
{
  keep();
  for (int i = 0; i < atom->nlocal; i++)
    add_work(i, step_done(i));
  add_contacts(true);
}

/* The coming step: its first half, and the change of state between both. LAMMPS has moved the
   automata, but neither the ghosts nor the pair list yet. */

void FixMCAEnergy::post_integrate()
{
  for (int i = 0; i < atom->nlocal; i++) {
    const Motion moved = {vector(atom->x[i]) - before[i], update->dt * vector(atom->omega[i])};
    store(moved.way, &rows[rowLength * i]);
    store(moved.turn, &rows[rowLength * i + 3]);
    add_work(i, moved);
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
  const bool plane = pair->kernel->dimension == 2;
  for (int i = 0; i < nall; i++) {
    const double *from =
        pair->forces.get() + static_cast<size_t>(pair->kernel->rows.force.length) * i;
    double *row = &rows[rowLength * i];
    std::copy_n(from, plane ? 2 : 6, row);
    if (plane)
      row[5] = from[2];
  }
  const mca::Pairs &p = pair->pairs.pairs();
  for (int k = 0; k < p.n; k++) {
    const double e = strain(k, true).normal;
    rows[rowLength * p.i[k] + scalar] += e;
    rows[rowLength * p.j[k] + scalar] += e;
  }

  for (int i = 0; i < nlocal; i++) {
    double *row = &rows[rowLength * i];
    const mca::AutomatonLaw &law = pair->autolaw[atom->type[i]];
    external[i] = {vector(atom->f[i]) - vector(row), vector(atom->torque[i]) - vector(row + 3)};
    before[i] = vector(atom->x[i]);
    row[scalar] = mca::meanStress(row[scalar], law.bulkModulus, law.weight);
    if (pair->j2())
      row[scalar] += law.bulkModulus * pair->elastic_z_next.get()[i];
  }
}

/* elastic strains of pair k in the present or the next state at the present place */

mca::ElasticStrain FixMCAEnergy::strain(int k, bool next) const
{
  double state[mca::LinkList::maxStateSize];
  pair->pairs.getState(k, next, state);
  const bool linked = mca::link::isLinked(state[0]);
  const double e = pair->pairs.pairs().eps[k] - state[1];
  const double shear = pair->kernel->dimension == 2 ? state[2] : mca::length(vector(state + 2));
  return {mca::touchingStrain(linked, e), linked ? shear : 0.0};
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
  const double unit = force->nktv2p, sign = back ? 1.0 : -1.0;
  const double *response = pair->response.get();
  const int length = pair->kernel->rows.response.length;
  for (int k = 0; k < p.n; k++) {
    const int i = p.i[k], j = p.j[k];
    const mca::PairLaw &law = pair->pairlaw[p.law[k]];
    const double *ri = &rows[rowLength * i], *rj = &rows[rowLength * j];
    // of the step that is looked at, from the other end to the one where the forces are known
    const Motion mi = back ? step_done(i) : Motion{vector(ri), vector(ri + 3)};
    const Motion mj = back ? step_done(j) : Motion{vector(rj), vector(rj + 3)};
    const mca::Vector here_at = place(p.placeJ[k]) - place(p.placeI[k]),
                      way = sign * (mj.way - mi.way);
    const mca::PairMotion motion =
        mca::pairMotion(here_at, 1.0 / mca::length(here_at), way, 0.5 * sign * (mi.turn + mj.turn));
    const double eps = p.eps[k], other = mca::length(here_at - way) * law.invDiameter - 1.0;
    const double growth = sign * mca::dot(mca::shearGrowth(motion), pair->along_shear(k, 1.0));

    double state[mca::LinkList::maxStateSize];
    pair->pairs.getState(k, !back, state);
    const bool linked = mca::link::isLinked(state[0]);
    const mca::ElasticStrain moved = {sign * (eps - other), growth};
    const mca::ElasticStrain here = strain(k, !back);
    const double there = mca::touchingStrain(linked, other - state[1]);
    const mca::ElasticStrain strained = {sign * (here.normal - there), linked ? moved.shear : 0.0};
    const double means[2] = {response[length * i], response[length * j]};
    const double next[2] = {ri[scalar], rj[scalar]};
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
  const double mean = pair->response.get()[pair->kernel->rows.response.length * i];
  const double twoG = 2.0 * law.shearModulus;
  const double first = mca::normalResponse(now, twoG, law.D, mean);
  const double last = mca::normalResponse(next, twoG, law.D, rows[rowLength * i + scalar]);
  return 0.5 * (first + last) * (now - next) * pair->cell(type).cellVolume();
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
  return static_cast<double>(external.capacity() * sizeof(Motion) +
                             before.capacity() * sizeof(mca::Vector) +
                             rows.capacity() * sizeof(double));
}
