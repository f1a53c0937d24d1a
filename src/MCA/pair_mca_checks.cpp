// SPDX-License-Identifier: GPL-2.0-or-later
// The part of pair style mca that looks at the sample: what a run cannot go on with stops it, what
// is hardly meant is warned of once. All of it is called by all ranks.

#include "pair_mca.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "files/units.h"
#include "fix_mca_history.h"
#include "fix_mca_state.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "shared/pi.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

/* the pair style, for who needs it at any time */

PairMCA *PairMCA::find(LAMMPS *host, const char *who)
{
  PairMCA *const pair = found(host);
  if (!pair)
    host->error->all(FLERR, "{} requires pair_style mca", who);
  return pair;
}

PairMCA *PairMCA::found(LAMMPS *host)
{
  return dynamic_cast<PairMCA *>(host->force->pair_match("^mca", 0));
}

bool PairMCA::in_run() const
{
  return fix_history && fix_history->in_run();
}

/* they are fixes as all others, which commands can take away */

void PairMCA::check_internal_fixes() const
{
  const std::pair<const Fix *, const char *> fixes[] = {{fix_history, FixMCAHistory::ID},
                                                        {fix_state, FixMCAState::ID},
                                                        {fix_spins, FixMCAState::SPINS}};
  for (const auto &[fix, id] : fixes)
    if (!fix_history || modify->get_fix_by_id(id) != fix)
      error->all(FLERR,
                 "Fix {}, which keeps the state of pair_style mca, is gone: it must not be unfixed "
                 "or unloaded; links are lost with it, so begin with the sample or a restart file",
                 id);
}

void PairMCA::check_count() const
{
  if (atom->nlocal != mca_step.own())
    error->one(FLERR,
               "Pair style mca: automata were added or deleted since the last set-up, in which "
               "they come into the list of pairs: leave out 'pre no', or give run 0 before output");
}

void PairMCA::check_order() const
{
  check_count();
  if (!fix_history->in_order())
    error->one(FLERR,
               "Pair style mca: automata have changed ranks or order since the last set-up, as "
               "write_data makes them: give run 0 before output");
}

/* outside a run atoms migrate and change their order, of which forces, drive and account have
   lists; LAMMPS's own flag of the first run makes the next one set up in spite of 'pre no'. What
   computes have given in this step is not given again. */

void PairMCA::lose_order()
{
  modify->clearstep_compute();
  update->first_update = 0;
}

double PairMCA::wave_speed(int type) const
{
  const mca::Material m = material_inside(type);
  return std::sqrt(m.youngsModulus / m.density);
}

/* ----------------------------------------------------------------------
   Nothing is nan or infinite, and nothing jumps over its neighbours. A sum of zeros tells, so that
   the loop has no branch; who it is, is looked for only then. The plastic strain tells of automata
   that never move.
------------------------------------------------------------------------- */

void PairMCA::check_sample() const
{
  static constexpr double longest_way = 0.5; // of the smallest diameter, in a step
  double smallest = HUGE_VAL;
  for (int type = 1; type <= atom->ntypes; type++)
    smallest = std::min(smallest, materials[type].diameter);
  const double fastest = longest_way * smallest / std::abs(update->dt);

  // forces show up in the velocities; in set-up they are not there yet
  const double *x = &atom->x[0][0], *v = &atom->v[0][0], *omega = &atom->omega[0][0];
  const int n = 3 * atom->nlocal;
  double zero = 0.0, speed = 0.0;
  for (int k = 0; k < n; k++) {
    zero += 0.0 * x[k] + 0.0 * v[k] + 0.0 * omega[k];
    speed = std::max(speed, std::abs(v[k]));
  }
  const double *kappa = state(mca::stateNumber("kappa"));
  for (int i = 0; i < atom->nlocal; i++)
    zero += 0.0 * kappa[i];
  int bad = !(zero == 0.0) || !(speed < fastest), any;
  MPI_Allreduce(&bad, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any)
    return check_sizes();

  struct Array {
    const char *name;
    const double *values;
    int length;     // of the values of an automaton
    double largest; // not reached
  };
  const Array arrays[] = {{"place", x, 3, HUGE_VAL},
                          {"velocity", v, 3, fastest},
                          {"angular velocity", omega, 3, HUGE_VAL},
                          {"plastic strain", kappa, 1, HUGE_VAL}};
  constexpr int many = sizeof(arrays) / sizeof(arrays[0]);
  std::vector<tagint> found; // IDs, with the number of the array
  for (int i = 0; i < atom->nlocal; i++)
    for (int a = 0; a < many; a++) {
      const Array &array = arrays[a];
      const double *values = array.values + array.length * i;
      if (!std::all_of(values, values + array.length,
                       [&](double value) { return std::abs(value) < array.largest; })) {
        found.push_back(atom->tag[i] * many + a);
        break;
      }
    }

  static constexpr size_t named = 5; // automata in the message
  const tagint none = MAXTAGINT;
  std::sort(found.begin(), found.end());
  const bigint own = static_cast<bigint>(found.size());
  bigint all;
  MPI_Allreduce(&own, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  found.resize(named, none);
  std::vector<tagint> first(named * comm->nprocs);
  MPI_Allgather(found.data(), named, MPI_LMP_TAGINT, first.data(), named, MPI_LMP_TAGINT, world);
  std::sort(first.begin(), first.end());
  std::string ids;
  for (size_t k = 0; k < named && first[k] != none; k++)
    ids += fmt::format("{}{}", k > 0 ? ", " : "", first[k] / many);
  error->all(FLERR,
             "Automata {}{}: {} is nan, infinite or, for velocities, above {:.6g} (half a diameter "
             "in a timestep) in step {}: the sample overlaps somewhere, or timestep or load are "
             "too large",
             ids, all > static_cast<bigint>(named) ? fmt::format(" and {} more", all - named) : "",
             arrays[first[0] % many].name, fastest, update->ntimestep);
}

/* diameter and mass belong to the material, but every command and fix can write LAMMPS's arrays */

void PairMCA::check_sizes() const
{
  std::vector<std::pair<double, double>> right = {{0.0, 0.0}}; // types begin with 1
  for (int type = 1; type <= atom->ntypes; type++)
    right.emplace_back(0.5 * materials[type].diameter, mass(type));
  tagint own = 0, any;
  for (int i = 0; i < atom->nlocal && own == 0; i++)
    if (right[atom->type[i]] != std::pair(atom->radius[i], atom->rmass[i]))
      own = atom->tag[i];
  MPI_Allreduce(&own, &any, 1, MPI_LMP_TAGINT, MPI_MAX, world);
  if (any == 0)
    return;
  std::string by;
  for (const Fix *fix : modify->get_fix_list())
    if (utils::strmatch(fix->style, "^adapt"))
      by += fmt::format(", probably by fix {} {}", fix->id, fix->style);
  error->all(FLERR,
             "Diameter, mass or type of automaton {} was changed within a run, before step {}{}: "
             "diameter and mass are those of the type's material, and pair_coeff changes them "
             "between runs",
             any, update->ntimestep, by);
}

void PairMCA::take_in(const std::vector<int> &added)
{
  for (const int i : added)
    set_size(i);
  const int own = static_cast<int>(added.size());
  int all;
  MPI_Allreduce(&own, &all, 1, MPI_INT, MPI_SUM, world);
  if (all > 0)
    check_overlap();
}

/* ----------------------------------------------------------------------
   When automata are new: none may lie within a packing of others, where one is no farther than the
   hole. Flow and collapse press pairs together, too, but leave no elastic strain of that size, or
   are worn.
------------------------------------------------------------------------- */

void PairMCA::check_overlap() const
{
  static constexpr double round_off = 1e-6;               // of data files
  const double deepest = packing->hole - 1.0 + round_off; // elastic strain
  const mca::Pairs &p = mca_step.links().pairs();
  double **x = atom->x;
  struct {
    double strain;
    int rank;
  } own = {0.0, comm->me}, worst;
  double part = 0.0, pairs;
  int k_own = -1;
  for (int k = 0; k < p.n; k++) {
    if (p.now.kind[k] == mca::link::worn)
      continue;
    const double *const xi = x[p.placeI[k]], *const xj = x[p.placeJ[k]];
    const double r = std::hypot(xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]);
    const double strain = r * mca_step.law(k).invDiameter - 1.0 - p.now.plastic[k];
    if (strain >= deepest)
      continue;
    part += mca_step.share(k);
    if (strain < own.strain) {
      own.strain = strain;
      k_own = k;
    }
  }
  MPI_Allreduce(&part, &pairs, 1, MPI_DOUBLE, MPI_SUM, world);
  if (pairs == 0.0)
    return;
  MPI_Allreduce(&own, &worst, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
  const PairPlace place = place_of(k_own, worst.rank);
  error->all(
      FLERR,
      "Automata {} and {} overlap: {:.6g} apart at a diameter of {:.6g}, {:.0f} such pairs in all, "
      "allowed: farther apart than the hole of packing {}, {:.3f} diameters",
      place.ids[0], place.ids[1], place.distance, place.diameter, pairs, packing->name,
      packing->hole);
}

PairMCA::PairPlace PairMCA::place_of(int k, int rank) const
{
  tagint ids[2] = {0, 0};
  double lengths[2] = {0.0, 0.0};
  if (comm->me == rank) {
    const mca::Pairs &p = mca_step.links().pairs();
    double **x = atom->x;
    const double *const xi = x[p.placeI[k]], *const xj = x[p.placeJ[k]];
    ids[0] = atom->tag[p.i[k]];
    ids[1] = atom->tag[p.j[k]];
    lengths[0] = std::hypot(xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]);
    lengths[1] = mca_step.law(k).diameter;
  }
  MPI_Bcast(ids, 2, MPI_LMP_TAGINT, rank, world);
  MPI_Bcast(lengths, 2, MPI_DOUBLE, rank, world);
  return {{ids[0], ids[1]}, lengths[0], lengths[1]};
}

/* the list of a run's set-up is there */

void PairMCA::check_start()
{
  check_sample();
  if (told || update->whichflag != 1) // commands make lists, too, before there are links
    return;
  told = true;
  warn_of_links();
  warn_of_integrators();
  warn_of_wave_speed();
  warn_of_strength();
}

/* ----------------------------------------------------------------------
   warnings, once
------------------------------------------------------------------------- */

void PairMCA::warn_of_links() const
{
  const mca::Pairs &p = mca_step.links().pairs();
  std::vector<int> links(mca_step.rows(), 0);
  double own[2] = {0.0, 0.0}, all[2]; // links, pairs that touch
  double **x = atom->x;
  for (int k = 0; k < p.n; k++) {
    const double *const xi = x[p.placeI[k]], *const xj = x[p.placeJ[k]];
    const double r = std::hypot(xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]);
    if (r <= 1.01 * mca_step.law(k).diameter) // as mca_links has it
      own[1] += mca_step.share(k);
    if (!mca::link::isLinked(p.now.kind[k]))
      continue;
    own[0] += mca_step.share(k);
    links[p.i[k]]++;
    links[p.j[k]]++;
  }
  MPI_Allreduce(own, all, 2, MPI_DOUBLE, MPI_SUM, world);
  int most_own = 0, most;
  for (int i = 0; i < mca_step.own(); i++)
    most_own = std::max(most_own, links[i]);
  MPI_Allreduce(&most_own, &most, 1, MPI_INT, MPI_MAX, world);
  if (comm->me != 0)
    return;
  if (all[0] == 0.0)
    error->warning(FLERR,
                   "Pair style mca: no links among {} automata, of which {:.0f} pairs touch: is "
                   "mca_links create missing, or does the lattice not fit the diameter?",
                   atom->natoms, all[1]);
  else if (most < packing->coordination)
    error->warning(FLERR,
                   "Pair style mca: no automaton has the {} links of packing {}, the most is {}: "
                   "does the lattice fit packing and diameter?",
                   packing->coordination, packing->name, most);
}

/* elastic normal stresses; a sample that has flowed was loaded by intent */

void PairMCA::warn_of_stress() const
{
  const mca::Pairs &p = mca_step.links().pairs();
  const double *kappa = state(mca::stateNumber("kappa"));
  struct {
    double ratio;
    int rank;
  } own = {0.0, comm->me}, worst;
  double sums[2] = {0.0, 0.0}, all[2]; // plastic strain, pairs
  for (int i = 0; i < atom->nlocal; i++)
    sums[0] += kappa[i];
  int k_own = -1;
  for (int k = 0; k < p.n; k++) {
    const double stress = contact(k).trial;
    if (!mca::link::isLinked(p.now.kind[k]) && stress >= 0.0)
      continue; // apart
    const double ratio = std::abs(stress) / strength(atom->type[p.i[k]], atom->type[p.j[k]]);
    sums[1] += ratio > 1.0 ? mca_step.share(k) : 0.0;
    if (ratio > own.ratio) {
      own.ratio = ratio;
      k_own = k;
    }
  }
  MPI_Allreduce(sums, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (all[0] > 0.0 || all[1] == 0.0)
    return;
  MPI_Allreduce(&own, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  const PairPlace place = place_of(k_own, worst.rank);
  if (comm->me == 0)
    error->warning(
        FLERR,
        "Pair style mca: in the first step {:.0f} pairs are stressed above the strength, "
        "automata {} and {} by {:.3g} times, {:.6g} apart at a diameter of {:.6g}: does "
        "the lattice fit the diameter, does the sample overlap, also over a periodic "
        "side?",
        all[1], place.ids[0], place.ids[1], worst.ratio, place.distance, place.diameter);
}

void PairMCA::warn_of_integrators() const
{
  for (const Fix *fix : modify->get_fix_list()) {
    if (!fix->time_integrate || prescribed(fix).any || strcmp(fix->style, "nve/mca") == 0)
      continue;
    const bigint moved = group->count(fix->igroup);
    if (comm->me == 0)
      error->warning(FLERR,
                     "Pair style mca: fix {} {} moves {} automata; mass, moment of inertia and "
                     "rotation of automata are those of fix nve/mca only",
                     fix->id, fix->style, moved);
  }
}

/* slower than gels, faster than diamond: density or modulus are of other units */

void PairMCA::warn_of_wave_speed() const
{
  static constexpr double slowest = 50.0, fastest = 30000.0; // m/s
  const mca::Units *units = mca::findUnits(update->unit_style);
  for (int type = 1; type <= atom->ntypes && units && comm->me == 0; type++)
    if (const double speed = wave_speed(type) * units->velocity();
        speed < slowest || speed > fastest)
      error->warning(
          FLERR,
          "Pair style mca: waves in the material of type {} travel at {:.3g} m/s, in "
          "solids at {:.0f} to {:.0f}: density or youngs_modulus are probably not in units {}",
          type, speed, slowest, fastest, update->unit_style);
}

/* In plane strain the stress across the plane carries a sample under uniaxial pressure along the
   cone of Drucker and Prager, which it then never meets. */

void PairMCA::warn_of_strength() const
{
  if (domain->dimension != 2 || lawset.fracture.word() != mca::FractureByDruckerPrager::keyword ||
      lawset.plane.is(mca::PlaneCondition::Stress))
    return;
  const double ratio = lawset.fracture.parameter(mca::FractureByDruckerPrager::parameter);
  for (int type = 1; type <= atom->ntypes && comm->me == 0; type++)
    if (const double most = mca::mostConeRatio(materials[type].poissonsRatio); ratio >= most)
      error->warning(
          FLERR,
          "Pair style mca: with compressive_strength {:g} and the poissons_ratio {:g} of "
          "type {} fracture drucker-prager has no strength in compression in plane "
          "strain, only below {:.4g}: take fracture mohr-coulomb or plane stress",
          ratio, materials[type].poissonsRatio, type, most);
}

/* what create_atoms gives by itself, diameter and density 1, is nobody's wish; nor is what the
   material of any type gave at the last set-up */

void PairMCA::warn_of_sizes() const
{
  static constexpr double round_off = 1e-6; // of data files
  using mcawr::pi;
  const double default_mass = pi / 6.0;
  auto differ = [](double a, double b) { return std::abs(a - b) > round_off * b; };
  auto is_new = [&](double value, const std::vector<double> &former) {
    return std::none_of(former.begin(), former.end(),
                        [&](double one) { return !differ(value, one); });
  };
  bigint own[2] = {0, 0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    const mca::Material &m = materials[atom->type[i]];
    const double d = 2.0 * atom->radius[i];
    const double density = atom->rmass[i] / (pi / 6.0 * d * d * d);
    own[0] += differ(d, 1.0) && differ(d, m.diameter) && is_new(d, last_diameters);
    own[1] += differ(density, 1.0) && differ(atom->rmass[i], default_mass) &&
              differ(density, m.density) && differ(atom->rmass[i], mass(atom->type[i])) &&
              is_new(atom->rmass[i], last_masses);
  }
  MPI_Allreduce(own, all, 2, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all[0] + all[1] > 0 && comm->me == 0)
    error->warning(FLERR,
                   "Pair style mca: diameters of {} and densities of {} automata become those of "
                   "their material (pair_coeff)",
                   all[0], all[1]);
}
