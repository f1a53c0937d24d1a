#include "pair_mca.h"

#include "atom.h"
#include "comm.h"
#include "core/further_laws.h"
#include "domain.h"
#include "error.h"
#include "flat.h"
#include "force.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

static constexpr int ANSWERED = 256; // automata at a time; without flow their state stays

static void clear(mca::AlignedArray &array, int n, int row)
{
  array.reserve(static_cast<size_t>(n) * row);
  std::fill_n(array.get(), static_cast<size_t>(n) * row, 0.0);
}

/* ----------------------------------------------------------------------
   The forces of a step are a pure function of positions, velocities and the present state.
   In set-up nothing moves on; in a step the state that the last one led to is taken over first.

   What other ranks need is on its way while the inside of the sample is worked on; the pairs at the
   borders, which need what the others answer, come last in a pass.
------------------------------------------------------------------------- */

void PairMCA::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  const bool advance = update->whichflag == 1 && !update->setupflag;
  if (advance) {
    commit();
    pairs.advance();
  }
  committed = false;

  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost,
            answers = kernel->rows.response.length;
  const int answers_after =
      kernel->rows.response.answers; // the stress pass: M, in space the centre, too
  const bool alone = comm->nprocs == 1;
  const int summed = alone ? nlocal : nall; // images only give places
  const mca::PairLaw *laws = pairlaw.data();
  const mca::Pairs border = pairs.part(0, edge), inside = pairs.part(edge, pairs.size() - edge);
  response.reserve(static_cast<size_t>(nall) * answers);
  kappa_next.reserve(nlocal);
  elastic_z_next.reserve(nlocal);
  pack_motion(nall, advance);

  clear(strains, summed, kernel->rows.strain.length);
  kernel->strain(pairs.part(0, pairs.size()), update->dt, advance, laws, motion.get(), spin.get(),
                 strains.get());
  find_means();
  if (!alone)
    halo.begin(response.get(), answers, 1);

  clear(stresses, summed, kernel->rows.stress.length);
  kernel->stress(inside, laws, response.get(), stresses.get());
  if (!alone)
    halo.finish(response.get(), answers, 1);
  kernel->stress(border, laws, response.get(), stresses.get());

  flowing.clear();
  for (int from = 0; from < nlocal; from += ANSWERED)
    yield(from, std::min(from + ANSWERED, nlocal));
  if (lawset.returnsTwice()) {
    if (!alone)
      halo.begin(response.get() + 1, answers, answers_after);
    yield_again(border, inside);
  }
  const double *around = further_laws();
  if (!alone)
    halo.begin(response.get() + 1, answers, answers_after);

  clear(forces, summed, kernel->rows.force.length);
  changes = kernel->force(inside, laws, response.get(), around, forces.get());
  if (!alone)
    halo.finish(response.get() + 1, answers, answers_after);
  changes += kernel->force(border, laws, response.get(), around, forces.get());
  if (lawset.centresViscosity())
    centre_viscosity(border, inside);
  add_forces();

  if (eflag_either || vflag_either)
    tally(eflag, vflag);
}

void PairMCA::find_means()
{
  const int n = atom->nlocal;
  kernel->mean(n, atom->type, autolaw.data(), onelaw, strains.get(), response.get());
  if (j2())
    mca::addElasticZ(n, atom->type, autolaw.data(), elastic_z(), response.get());
}

/* radial returns of automata */

void PairMCA::yield(int from, int to)
{
  const mca::RowLayout &rows = kernel->rows;
  double next[ANSWERED];
  const bool flows = kernel->yield(to - from, atom->type + from, autolaw.data(), onelaw,
                                   strains.get() + from * rows.strain.length,
                                   stresses.get() + from * rows.stress.length, kappa() + from, next,
                                   response.get() + from * rows.response.length) > 0.0;
  if (flows)
    flowing.emplace_back(from, to);
  if (flows || lawset.needsLocal())
    std::copy_n(next, to - from, kappa_next.get() + from);
}

/* The same again, now that the returns of neighbours are known; these are on their way. What flows
   on this rank is a neighbour's affair, too, hence only one rank alone may pass over it. */

void PairMCA::yield_again(const mca::Pairs &border, const mca::Pairs &inside)
{
  const mca::RowLayout &rows = kernel->rows;
  const bool alone = comm->nprocs == 1;
  if (alone && flowing.empty())
    return;
  mca::AlignedArray &taken = forces; // which are not needed before the force pass
  clear(taken, alone ? atom->nlocal : atom->nlocal + atom->nghost, rows.stress.length);
  kernel->returns(inside, pairlaw.data(), response.get(), taken.get());
  if (!alone)
    halo.finish(response.get() + 1, rows.response.length, kernel->rows.response.answers);
  kernel->returns(border, pairlaw.data(), response.get(), taken.get());
  for (const auto &[from, to] : flowing)
    kernel->yieldAgain(to - from, atom->type + from, autolaw.data(),
                       stresses.get() + from * rows.stress.length,
                       taken.get() + from * rows.stress.length, kappa() + from,
                       kappa_next.get() + from, response.get() + from * rows.response.length);
}

/* of the plane only; what the criteria of local stress need, if any acts */

const double *PairMCA::further_laws()
{
  const int nlocal = atom->nlocal, *type = atom->type;
  if (j2())
    mca::flowElasticZ(nlocal, type, autolaw.data(), strains.get(), stresses.get(), response.get(),
                      elastic_z(), elastic_z_next.get());
  if (!lawset.needsLocal())
    return nullptr;
  local.reserve(static_cast<size_t>(nlocal + atom->nghost) * mca::planeRows.local.length);
  mca::showLocal(kernel->rows, nlocal, type, autolaw.data(), stresses.get(), response.get(),
                 kappa(), kappa_next.get(), local.get());
  if (comm->nprocs > 1) {
    halo.begin(local.get(), mca::planeRows.local.length, mca::planeRows.local.length);
    halo.finish(local.get(), mca::planeRows.local.length, mca::planeRows.local.length);
  }
  return local.get();
}

/* what forces change in half a step, of both automata of a viscous contact */

void PairMCA::centre_viscosity(const mca::Pairs &border, const mca::Pairs &inside)
{
  const int stride = kernel->rows.force.length, moved = kernel->dimension;
  if (comm->nprocs > 1)
    halo.begin(forces.get(), stride, moved);
  const mca::ViscousContacts::Step step = {kernel,       update->dt, pairlaw.data(), response.get(),
                                           forces.get(), atom->mask, integrated,     held};
  viscous.clear();
  viscous.add(inside, step);
  if (comm->nprocs > 1)
    halo.finish(forces.get(), stride, moved);
  viscous.add(border, step);
  viscous.addForces(*kernel, forces.get());
}

void PairMCA::add_forces()
{
  auto *f = mca::flat(atom->f), *torque = mca::flat(atom->torque);
  const int length = kernel->rows.force.length;
  const double *row = forces.get();
  if (kernel->dimension == 2)
    for (int i = 0; i < atom->nlocal; i++, row += length) {
      f[i][0] += row[0];
      f[i][1] += row[1];
      torque[i][2] += row[2];
    }
  else
    for (int i = 0; i < atom->nlocal; i++, row += length)
      for (int m = 0; m < 3; m++) {
        f[i][m] += row[m];
        torque[i][m] += row[3 + m];
      }
}

/* links broken and formed of each automaton, before the list changes */

void PairMCA::collect_changes()
{
  if (listed < 0)
    return; // no list was built yet
  for (int m = 0; m < 2; m++) {
    double *sum = atom->dvector[icustom_changes[m]];
    for (int i = 0; i < listed; i++)
      sum[i] += link_changes.get()[2 * i + m];
  }
  clear(link_changes, listed, 2);
}

void PairMCA::begin_list(int border, const std::vector<mca::Halo::Guest> &guests)
{
  listed = atom->nlocal; // other fixes may add atoms behind these
  clear(link_changes, listed, 2);
  if (comm->nprocs > 1)
    halo.build(world, guests);
  // whole blocks
  edge =
      std::min((border + mca::blockLength - 1) / mca::blockLength * mca::blockLength, pairs.size());
}

/* Within a step forces see the velocities of half a step ago. In set-up the lag that they had when
   the forces of this step were computed gives them again, so that viscous forces do not change; the
   rest makes that exact, where the lag is a rounded difference. */

void PairMCA::pack_motion(int nall, bool advance)
{
  motion.reserve(static_cast<size_t>(nall) * kernel->rows.motion.length);
  spin.reserve(nall);
  if (kernel->dimension == 3)
    return pack_space_motion(nall, advance);
  double *row = motion.get(), *turn = spin.get();
  const auto *x = mca::flat(atom->x), *v = mca::flat(atom->v), *omega = mca::flat(atom->omega);
  const double *lag_x = atom->dvector[icustom_lag[0]], *lag_y = atom->dvector[icustom_lag[1]];
  const double *rest_x = atom->dvector[icustom_rest[0]], *rest_y = atom->dvector[icustom_rest[1]];
  const int length = kernel->rows.motion.length;
  for (int i = 0; i < nall; i++, row += length) {
    row[0] = x[i][0];
    row[1] = x[i][1];
    row[2] = advance ? v[i][0] : v[i][0] - lag_x[i] - rest_x[i];
    row[3] = advance ? v[i][1] : v[i][1] - lag_y[i] - rest_y[i];
    turn[i] = omega[i][2];
  }
}

void PairMCA::pack_space_motion(int nall, bool advance)
{
  double *row = motion.get(), *turn = spin.get();
  const auto *x = mca::flat(atom->x), *v = mca::flat(atom->v), *omega = mca::flat(atom->omega);
  const int length = kernel->rows.motion.length;
  for (int i = 0; i < nall; i++, row += length) {
    for (int m = 0; m < 3; m++) {
      row[m] = x[i][m];
      row[3 + m] = v[i][m];
    }
    row[6] = omega[i][0];
    row[7] = omega[i][1];
    turn[i] = omega[i][2];
  }
  for (int m = 0; m < 3 && !advance; m++) {
    const double *lag = atom->dvector[icustom_lag[m]], *rest = atom->dvector[icustom_rest[m]];
    row = motion.get() + 3 + m;
    for (int i = 0; i < nall; i++, row += length)
      *row = *row - lag[i] - rest[i];
  }
}

void PairMCA::keep_lag()
{
  for (int m = 0; m < kernel->dimension; m++) {
    double *lag = atom->dvector[icustom_lag[m]];
    double *rest = atom->dvector[icustom_rest[m]];
    const double *row = motion.get() + kernel->dimension + m;
    for (int i = 0; i < atom->nlocal; i++, row += kernel->rows.motion.length) {
      lag[i] = atom->v[i][m] - *row;
      rest[i] = atom->v[i][m] - lag[i] - *row;
    }
  }
}

/* energy of owned automata and virials of pairs */

void PairMCA::tally(int /*eflag*/, int /*vflag*/)
{
  const int nlocal = atom->nlocal;
  if (eflag_either)
    for (int i = 0; i < nlocal; i++) {
      const double energy = automaton(i).energy;
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

  const mca::Pairs &p = pairs.pairs();
  double **x = atom->x;
  for (int k = 0; k < p.n; k++) {
    const int i = p.i[k], j = p.j[k];
    const mca::PairLaw &law = pairlaw[p.law[k]];
    const mca::ContactStress s = contact(k);
    const mca::Vector stress =
        s.normal * normal(k) + 1.0 / (1.0 + p.eps[k]) * along_shear(k, s.shear);
    const mca::Vector on_i = law.area / stress_unit() * stress;
    const double *const xi = x[p.placeI[k]], *const xj = x[p.placeJ[k]];
    ev_tally_xyz(i, j, nlocal, 0, 0.0, 0.0, on_i.x, on_i.y, on_i.z, xi[0] - xj[0], xi[1] - xj[1],
                 xi[2] - xj[2]);
  }
}

/* ---------------------------------------------------------------------- */

/* Events count when their step's outcome is taken over: once, also those of the first step,
   whatever runs and restart files the steps belong to. */

void PairMCA::commit()
{
  if (committed)
    return;
  happened.clear();
  if (changes > 0.0)
    record_events();
  changes = 0.0;
  for (const auto &[from, to] : flowing)
    std::copy(kappa_next.get() + from, kappa_next.get() + to, kappa() + from);
  if (j2())
    std::copy_n(elastic_z_next.get(), listed, elastic_z());
  committed = true;
}

void PairMCA::record_events()
{
  const mca::Pairs p = pairs.part(0, pairs.size());
  double **x = atom->x;
  for (int k = 0; k < p.n; k++) {
    if (!p.blocks[k / mca::blockLength].moves)
      continue;
    const double before = p.now.kind[k], after = p.next.kind[k];
    const bool was = mca::link::isLinked(before), is = mca::link::isLinked(after);
    if (before == after || (!was && !is))
      continue;
    (was && is ? events.healed : was ? events.broken : events.formed) += owned_share(k);
    if (!is)
      pairs.setOriginal(k, false);
    if (was != is)
      for (const int i : {p.i[k], p.j[k]})
        if (i < atom->nlocal) // else the owner holds the pair, too
          link_changes.get()[2 * i + (was ? 0 : 1)] += 1.0;
    if (!on_this_rank(k))
      continue;
    const int i = p.i[k], j = p.j[k];
    Event e{update->ntimestep - 1,         {atom->tag[i], atom->tag[j]}, before, after, {},
            {atom->mask[i], atom->mask[j]}};
    for (int m = 0; m < 3; m++)
      e.x[m] = 0.5 * (x[p.placeI[k]][m] + x[p.placeJ[k]][m]);
    domain->remap(e.x);
    happened.push_back(e);
  }
}

void PairMCA::check_reach() const
{
  const mca::Pairs &p = pairs.pairs();
  for (int k = 0; k < p.n; k++) {
    if (!mca::link::isLinked(p.now.kind[k]))
      continue;
    const int i = p.i[k], j = p.j[k];
    const double r = pairlaw[p.law[k]].diameter * (1.0 + p.eps[k]);
    const double reach2 = cutsq[atom->type[i]][atom->type[j]];
    if (r * r > reach2)
      error->one(FLERR,
                 "Link of automata {} {} is stretched to {:.6g}, beyond the cutoff {:.6g}: "
                 "give pair_style mca a larger cutoff or a fracture criterion",
                 atom->tag[i], atom->tag[j], r, std::sqrt(reach2));
  }
}

/* ---------------------------------------------------------------------- */

PairMCA::Automaton PairMCA::automaton(int i) const
{
  const mca::AutomatonLaw &law = autolaw[atom->type[i]];
  const bool plane = kernel->dimension == 2;
  const double *row = stresses.get() + static_cast<size_t>(i) * kernel->rows.stress.length;
  const double unit = stress_unit(), mean = response.get()[i * kernel->rows.response.length];
  const mca::StressTensor s =
      plane ? mca::automatonStress(row[0], row[1], row[2], mean) : mca::weighted(row, law.weight);
  const double z = j2() ? elastic_z()[i] : 0.0;
  const double density = mca::energyDensity(row[kernel->rows.stress.squares], mean,
                                            law.shearModulus, law.bulkModulus, law.D, law.weight) +
                         law.shearModulus * z * z;
  return {{s.xx * unit, s.yy * unit, s.xy * unit, s.zz * unit, s.xz * unit, s.yz * unit},
          mean * unit,
          mca::stressIntensity(s) * unit,
          density * cell(atom->type[i]).cellVolume()};
}

mca::Vector PairMCA::normal(int k) const
{
  double *const *n = pairs.pairs().normal;
  return {n[0][k], n[1][k], kernel->dimension == 2 ? 0.0 : n[2][k]};
}

static mca::Vector shear_of(double *const *values, int k)
{
  return {values[0][k], values[1][k], values[2][k]};
}

double PairMCA::shear(double *const *of, int k) const
{
  return kernel->dimension == 2 ? of[0][k] : mca::length(shear_of(of, k));
}

mca::Vector PairMCA::along_shear(int k, double size) const
{
  const mca::Vector n = normal(k);
  if (kernel->dimension == 2)
    return {-size * n.y, size * n.x, 0.0};
  const mca::Vector gamma = shear_of(pairs.pairs().now.gamma, k);
  const double length = mca::length(gamma);
  return length > 0.0 ? size / length * gamma : mca::Vector{0.0, 0.0, 0.0};
}

double PairMCA::plastic_work(int i) const
{
  const int type = atom->type[i];
  return autolaw[type].curve.work(kappa()[i]) * cell(type).cellVolume();
}

mca::ContactStress PairMCA::contact(int k) const
{
  const mca::Pairs &p = pairs.pairs();
  const double *ri = response.get() + static_cast<size_t>(p.i[k]) * kernel->rows.response.length;
  const double *rj = response.get() + static_cast<size_t>(p.j[k]) * kernel->rows.response.length;
  const mca::RowLayout::Response &row = kernel->rows.response;
  const bool moves = p.blocks[k / mca::blockLength].moves;
  const mca::ContactStress s = mca::contactStress(
      pairlaw[p.law[k]],
      {p.now.kind[k], p.eps[k], p.now.plastic[k], shear(p.now.gamma, k), shear(p.now.gammaTotal, k),
       p.separation[k]},
      {ri[row.mean], ri[row.factor], ri[row.centre]},
      {rj[row.mean], rj[row.factor], rj[row.centre]}, moves ? p.next.kind[k] : p.now.kind[k]);
  const double unit = stress_unit();
  return {s.trial * unit,  s.sigma * unit, s.tau * unit,
          s.normal * unit, s.shear * unit, s.kindNext};
}

double PairMCA::owned_share(int k) const
{
  const bool both = std::max(pairs.i(k), pairs.j(k)) < atom->nlocal;
  return both ? 1.0 : 0.5;
}

bool PairMCA::on_this_rank(int k) const
{
  const int i = pairs.i(k), j = pairs.j(k);
  if (owned_share(k) == 1.0)
    return true;
  return (atom->tag[i] < atom->tag[j]) == (i < atom->nlocal);
}

PairMCA::Count PairMCA::count() const
{
  Count c = events;
  for (int i = 0; i < atom->nlocal; i++)
    c.plastic_work += plastic_work(i);
  const mca::Pairs &p = pairs.pairs();
  for (int k = 0; k < p.n; k++) {
    if (mca::link::isLinked(p.now.kind[k]))
      c.links += owned_share(k);
    if (p.now.kind[k] == mca::link::weld)
      c.welds += owned_share(k);
  }
  return c;
}

/* ---------------------------------------------------------------------- */

double PairMCA::memory_usage()
{
  return Pair::memory_usage() + pairs.bytes() + motion.bytes() + spin.bytes() + strains.bytes() +
         stresses.bytes() + response.bytes() + local.bytes() + forces.bytes() + kappa_next.bytes() +
         elastic_z_next.bytes() + link_changes.bytes();
}
