// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_mca.h"

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "flat.h"
#include "force.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace LAMMPS_NS;

static constexpr int SAMPLE_CHECK = 100; // steps from one to the next

static constexpr int KAPPA = mca::stateNumber("kappa"), KEPT = mca::stateNumber("kept");
static constexpr int BROKEN = mca::stateNumber("broken");
static constexpr int FORMED = mca::stateNumber("formed");
static constexpr int LAG[] = {mca::stateNumber("lag_x"), mca::stateNumber("lag_y"),
                              mca::stateNumber("lag_z")};
static constexpr int REST[] = {mca::stateNumber("rest_x"), mca::stateNumber("rest_y"),
                               mca::stateNumber("rest_z")};
static constexpr int SPIN_LAG[] = {mca::stateNumber("spin_lag_x"), mca::stateNumber("spin_lag_y"),
                                   mca::stateNumber("spin_lag_z")};
static constexpr int SPIN_REST[] = {mca::stateNumber("spin_rest_x"),
                                    mca::stateNumber("spin_rest_y"),
                                    mca::stateNumber("spin_rest_z")};

/* ----------------------------------------------------------------------
   In set-up nothing moves on; in a step the state that the last one led to is taken over first.
------------------------------------------------------------------------- */

void PairMCA::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  check_internal_fixes();
  const bool advance = in_run();
  check_count();
  if (advance)
    commit();
  mca_step.run(automata(), update->dt, advance);
  if (!advance) { // set-up is no step
    traced = halo.sent();
    traced_step = update->ntimestep;
  }
  add_forces();
  if (!told_of_stress && update->whichflag == 1) {
    told_of_stress = true;
    warn_of_stress();
  }
  if (advance && update->ntimestep % SAMPLE_CHECK == 0)
    check_sample();
  if (eflag_either || vflag_either)
    tally();
}

void PairMCA::evaluate()
{
  mca_step.run(automata(), update->dt, false);
}

/* LAMMPS's arrays, for one call */

mca::Automata PairMCA::automata() const
{
  mca::Automata a{};
  a.x = mca::flat(atom->x);
  a.v = mca::flat(atom->v);
  a.omega = mca::flat(atom->omega);
  a.groups = atom->mask;
  a.integrated = integrated;
  a.held = held;
  a.heldSpins = held_spins;
  a.kappa = state(KAPPA);
  a.kept = state(KEPT);
  for (int m = 0; m < domain->dimension; m++) {
    a.lag[m] = state(LAG[m]);
    a.rest[m] = state(REST[m]);
  }
  for (int m = 0; m < 3; m++) {
    a.spinLag[m] = state(SPIN_LAG[m]);
    a.spinRest[m] = state(SPIN_REST[m]);
  }
  return a;
}

double *PairMCA::state(int number) const
{
  return columns[number] < 0 ? nullptr : atom->dvector[columns[number]];
}

void PairMCA::add_forces()
{
  auto *f = mca::flat(atom->f), *torque = mca::flat(atom->torque);
  const mca::RowArray &forces = mca_step.forces();
  const double *row = forces.data();
  const int n = mca_step.own();
  if (mca_step.dimension() == 2) {
    constexpr mca::RowLayout::Force at = mca::planeRows.force;
    for (int i = 0; i < n; i++, row += at.length) {
      f[i][0] += row[at.force];
      f[i][1] += row[at.force + 1];
      torque[i][2] += row[at.torque];
    }
  } else {
    constexpr mca::RowLayout::Force at = mca::spaceRows.force;
    for (int i = 0; i < n; i++, row += at.length)
      for (int m = 0; m < 3; m++) {
        f[i][m] += row[at.force + m];
        torque[i][m] += row[at.torque + m];
      }
  }
}

/* links broken and formed of each automaton, before the list changes */

void PairMCA::collect_changes()
{
  if (!mca_step.empty())
    mca_step.takeChanges(state(BROKEN), state(FORMED));
}

void PairMCA::begin_list(int border, const std::vector<mca::Halo::Guest> &guests)
{
  if (comm->nprocs > 1) {
    halo.build(world, guests);
    mca_step.setExchange(halo);
  }
  mca_step.begin(atom->nlocal, atom->nlocal + atom->nghost, atom->type, border);
}

void PairMCA::trace_messages(int ghosts)
{
  const auto steps = static_cast<double>(update->ntimestep - traced_step);
  if (!std::getenv("MCAWR_TRACE") || comm->nprocs == 1 || steps == 0.0)
    return;
  const mca::Halo::Sent sent = halo.sent();
  const AtomVec &avec = *atom->avec;
  const double own[] = {
      (sent.messages - traced.messages) / steps, (sent.bytes - traced.bytes) / steps,
      static_cast<double>(ghosts) * (avec.size_forward + avec.size_velocity) * sizeof(double)};
  double all[3], most[3];
  MPI_Allreduce(own, all, 3, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(own, most, 3, MPI_DOUBLE, MPI_MAX, world);
  if (comm->me == 0)
    utils::logmesg(
        lmp,
        "Messages of pair_style mca, a step and rank: {:.1f} of {:.0f} bytes in all (most "
        "{:.1f} of {:.0f}); places and velocities {:.0f} bytes (most {:.0f})\n",
        all[0] / comm->nprocs, all[1] / comm->nprocs, most[0], most[1], all[2] / comm->nprocs,
        most[2]);
  traced = sent;
  traced_step = update->ntimestep;
}

void PairMCA::keep_lag()
{
  mca_step.keepLag(automata());
}

void PairMCA::drop_lag(int i)
{
  for (const int *of : {LAG, REST, SPIN_LAG, SPIN_REST})
    for (int m = 0; m < 3; m++)
      if (double *const values = state(of[m]))
        values[i] = 0.0;
}

/* energy of owned automata and virials of pairs */

void PairMCA::tally()
{
  const int nlocal = atom->nlocal;
  if (eflag_either)
    for (int i = 0; i < nlocal; i++) {
      const double energy = mca_step.energy(i);
      if (eflag_global)
        eng_vdwl += energy;
      if (eflag_atom)
        eatom[i] += energy;
    }
  if (eflag_global) {
    const Count c = count();
    const double values[] = {c.links, c.welds, c.broken, c.formed, c.healed, c.plastic_work};
    std::copy_n(values, nextra, pvector);
  }
  if (!vflag_either)
    return;

  const mca::Pairs &p = links().pairs();
  double **x = atom->x;
  for (int k = 0; k < p.n; k++) {
    const mca::Vector on_i = mca_step.contactForce(k);
    const double *const xi = x[p.placeI[k]], *const xj = x[p.placeJ[k]];
    ev_tally_xyz(p.i[k], p.j[k], nlocal, 0, 0.0, 0.0, on_i.x, on_i.y, on_i.z, xi[0] - xj[0],
                 xi[1] - xj[1], xi[2] - xj[2]);
  }
}

/* ---------------------------------------------------------------------- */

void PairMCA::commit()
{
  if (mca_step.commit(automata()))
    record_events();
}

/* With what the rows and pairs of this list stand for, before it changes: commit() comes before
   the atoms migrate. Of a pair that two ranks hold the one of its first automaton records it. */

void PairMCA::record_events()
{
  happened.clear();
  const mca::LinkList &pairs = links();
  double **x = atom->x;
  for (const mca::Step::Change &change : mca_step.changes()) {
    const int k = change.pair, i = pairs.i(k), j = pairs.j(k);
    if (!mca_step.isOurs(k))
      continue;
    Event e{};
    e.step = update->ntimestep - 1;
    e.before = change.before;
    e.after = change.after;
    for (const auto &[end, automaton] : {std::pair(0, i), std::pair(1, j)}) {
      e.tag[end] = atom->tag[automaton];
      e.type[end] = atom->type[automaton];
      e.mask[end] = atom->mask[automaton];
    }
    for (int m = 0; m < 3; m++)
      e.x[m] = 0.5 * (x[pairs.placeI(k)][m] + x[pairs.placeJ(k)][m]);
    for (int m = 0; m < 3; m++) // far from the box LAMMPS's folding would not end
      if (!(std::abs(e.x[m] - domain->boxlo[m]) < 1e3 * domain->prd[m]))
        error->one(FLERR, "Automata {} {}: their place is {:.6g}, far outside the box, in step {}",
                   e.tag[0], e.tag[1], e.x[m], update->ntimestep);
    domain->remap(e.x);
    happened.push_back(e);
  }
}

void PairMCA::check_reach() const
{
  const mca::Pairs &p = mca_step.links().pairs();
  for (int k = 0; k < p.n; k++) {
    if (!mca::link::isLinked(p.now.kind[k]))
      continue;
    const int i = p.i[k], j = p.j[k];
    const double r = mca_step.distance(k);
    const double reach2 = cutsq[atom->type[i]][atom->type[j]];
    if (r * r > reach2)
      error->one(FLERR,
                 "Link of automata {} {} is stretched to {:.6g}, beyond the cutoff {:.6g}: "
                 "give pair_style mca a larger cutoff or a fracture criterion",
                 atom->tag[i], atom->tag[j], r, std::sqrt(reach2));
  }
}

/* ---------------------------------------------------------------------- */

mca::Step::Automaton PairMCA::automaton(int i) const
{
  mca::Step::Automaton a = mca_step.automaton(i);
  mca::StressTensor &s = a.stress;
  for (double *stress : {&s.xx, &s.yy, &s.xy, &s.zz, &s.xz, &s.yz, &a.mean, &a.intensity})
    *stress *= stress_unit();
  return a;
}

mca::ContactStress PairMCA::contact(int k) const
{
  mca::ContactStress s = mca_step.contact(k);
  for (double *stress : {&s.trial, &s.sigma, &s.tau, &s.normal, &s.shear})
    *stress *= stress_unit();
  return s;
}

double PairMCA::plastic_work(int i) const
{
  return mca_step.plasticWork(atom->type[i], state(KAPPA)[i]);
}

PairMCA::Count PairMCA::count() const
{
  Count c = {mca_step.count(), 0.0};
  for (int i = 0; i < atom->nlocal; i++)
    c.plastic_work += plastic_work(i);
  return c;
}

/* ---------------------------------------------------------------------- */

double PairMCA::memory_usage()
{
  return Pair::memory_usage() + mca_step.bytes();
}
