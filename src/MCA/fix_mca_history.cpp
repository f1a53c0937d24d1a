// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_mca_history.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "my_page.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_mca.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

using namespace LAMMPS_NS;

// place of motion_seal() in an automaton's own record; 0 there: not known
static constexpr int SEAL = 1;

FixMCAHistory::FixMCAHistory(LAMMPS *host, int narg, char **arg)
    : CheckedRestart(host, narg, arg), mca(nullptr)
{
  // the list holds every pair within the cutoff, touching or not, without LAMMPS's contact bit
  use_bit_flag = 0;
  comm_forward = 3;
  restart_file = 1; // write_restart_file() is called when the file is whole
  if (strcmp(id, ID) != 0)
    error->all(FLERR, "Fix {} is internal to pair_style mca, which makes it itself", ID);
}

void FixMCAHistory::attach(PairMCA *owner)
{
  mca = owner;
  pair = owner;
  mca->step().goOn(past);
}

void FixMCAHistory::init()
{
  running = false;
  for (int i = 0; i < atom->nlocal; i++)
    if (npartner[i] > 0 && valuepartner[i][SEAL] != 0.0 &&
        valuepartner[i][SEAL] != motion_seal(i)) {
      valuepartner[i][SEAL] = 0.0;
      mca->drop_lag(i);
    }
  CheckedRestart::init();
}

double FixMCAHistory::motion_seal(int i) const
{
  double motion[6];
  std::copy_n(atom->v[i], 3, motion);
  std::copy_n(atom->omega[i], 3, motion + 3);
  return mca::recordChecksum(motion, 6, 0);
}

/* before atoms migrate and the list is rebuilt: what the step just done leads to */

void FixMCAHistory::pre_exchange()
{
  mca->check_count();
  mca->check_sample(); // before LAMMPS folds places into the box, which may not end
  mca->commit();
  mca->collect_changes();
  store(true);
}

/* ----------------------------------------------------------------------
   Which of the two states goes to the atoms. A pair has the present state, which made the forces of
   this step, and the next one, to which flow, fracture and linking lead and which becomes present
   at the beginning of the following step.
   A rebuild of the list in a run stands at that very place, after commit(): it carries the next
   state, which the new list has as its present one (pre_exchange()).
   The end of a run and a restart file stand behind the step: the set-up that follows evaluates the
   laws once more at the same places, with the velocities that the forces saw (keep_lag()), and
   finds the same forces and the same next state, to the last bit. So they carry the present state;
   with the next one it would be taken over a step too early.
------------------------------------------------------------------------- */

void FixMCAHistory::store_present()
{
  mca->collect_changes();
  store(false);
}

void FixMCAHistory::post_run()
{
  bring_up_to_date();
  running = false;
}

void FixMCAHistory::bring_up_to_date()
{
  mca->check_sample();
  mca->keep_lag();
  store_present();
  const auto theirs = [this](int of) { return of >= nlocal_neigh; };
  mca->trace_messages(static_cast<int>(std::count_if(row.begin(), row.end(), theirs)));
}

void FixMCAHistory::write_restart(FILE *fp)
{
  // outside the steps post_run() has brought the atoms up to date and the list may be stale
  if (running)
    bring_up_to_date();
  else // folding into a box that moves has changed velocities since init()
    for (int i = 0; i < atom->nlocal; i++)
      if (npartner[i] > 0 && valuepartner[i][SEAL] != 0.0)
        valuepartner[i][SEAL] = motion_seal(i);
  const PairMCA::Count own = mca->count();
  std::vector<double> all = {own.broken, own.formed, own.healed};
  MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, world);
  if (comm->me == 0)
    mca::writeFixBlock(fp, mca::exactText(all));
}

/* before attach() */

void FixMCAHistory::restart(char *buf)
{
  const char *const what = "the events of pair_style mca";
  const std::string text = mca::fixBlockText(lmp, buf, what);
  const auto all = mca::readOrStop(lmp, [&] { return mca::numbersIn(text, 3, what); });
  if (comm->me == 0)
    past = {0.0, 0.0, all[0], all[1], all[2]};
}

void FixMCAHistory::write_restart_file(const char *path)
{
  mca->close_restart_file(path);
  if (!running)
    mca->lose_order();
}

void FixMCAHistory::setup_pre_exchange()
{
  if (!update->setupflag) // write_data; a run or mca_links sets up
    mca->lose_order();
}

/* ----------------------------------------------------------------------
   From the pair list to the automata: each keeps the states of its pairs under the IDs of its
   partners. The first record is its own and holds the ID under which its partners know it; IDs
   may change between runs, these keys do not. At the end of a run it holds the checksum of the
   velocities, too, by which init() knows those that a command has changed.
   A pair of automata of two ranks is known to both.
------------------------------------------------------------------------- */

void FixMCAHistory::store(bool next)
{
  const mca::LinkList &links = mca->links();
  const mca::Pairs &p = links.pairs();
  const tagint *tag = atom->tag;
  // atoms that other fixes add in this pre_exchange() come behind those of the list
  const int owned = nlocal_neigh;

  // with fix deform, images are one step behind, so that normals over periodic faces do not tell
  auto get = [&](int k, bool exchanged, double *state) {
    links.getStored(k, next, exchanged, state);
    if (domain->deform_flag && std::max(p.placeI[k], p.placeJ[k]) >= owned)
      std::fill_n(state + links.stateSize() + 1, 3, 0.0);
  };

  std::fill_n(npartner, atom->nlocal, 0);
  std::fill_n(npartner, owned, 1);
  mca->check_reach();
  for (int k = 0; k < p.n; k++)
    if (!links.blank(k, next))
      for (const int i : {p.i[k], p.j[k]})
        if (i < owned)
          npartner[i]++;

  ipage_atom->reset();
  dpage_atom->reset();
  maxpartner = 0;
  for (int i = 0; i < owned; i++) {
    partner[i] = ipage_atom->get(npartner[i]);
    valuepartner[i] = dpage_atom->get(dnum * npartner[i]);
    if (!partner[i] || !valuepartner[i])
      error->one(FLERR, "Too many partners of atom {}: raise neigh_modify one", tag[i]);
    maxpartner = std::max(maxpartner, npartner[i]);
    npartner[i] = 1;
    partner[i][0] = tag[i];
    shared[i].key = ubuf(tag[i]).d;
    std::fill_n(valuepartner[i], dnum, 0.0);
    if (!next)
      valuepartner[i][SEAL] = motion_seal(i);
  }
  maxexchange = (dnum + 1) * maxpartner + 1;
  for (int k = 0; k < p.n; k++) {
    if (links.blank(k, next))
      continue;
    for (const auto &[i, j] : {std::pair{p.i[k], p.j[k]}, std::pair{p.j[k], p.i[k]}})
      if (i < owned) {
        const int m = npartner[i]++;
        partner[i][m] = tag[j];
        get(k, i != p.i[k], valuepartner[i] + dnum * m);
      }
  }
}

void FixMCAHistory::renew_normals()
{
  mca::LinkList &links = mca->links();
  double **x = atom->x;
  for (int k = 0; k < links.size(); k++) {
    const double *const xi = x[links.placeI(k)], *const xj = x[links.placeJ(k)];
    const mca::Vector way = {xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]};
    links.setNormal(k, (1.0 / mca::length(way)) * way);
  }
}

std::vector<int> FixMCAHistory::originals() const
{
  std::vector<int> sums(atom->nlocal, 0);
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 1; m < npartner[i]; m++)
      sums[i] += valuepartner[i][dnum * m + mca->links().stateSize()] > 0.0;
  return sums;
}

/* ----------------------------------------------------------------------
   From the automata to the new pair list.

   A sum of floating-point numbers depends on its order, and LAMMPS's order of atoms, ghosts and
   neighbors changes with every build, restart, set-up and number of ranks. So the list gets an
   order of its own, that of the pairs' IDs: by the lower ID, then by the higher one; the automaton
   of the lower ID is the first of its pair, on both ranks that hold it. With that a run that is
   continued adds up the same numbers in the same order as one that was not interrupted.

   Pairs of automata that other ranks need come first, in the same order, so that the step works on
   them last, when the messages of the others are in.

   Rows: a pair stands for originals. A ghost that is an image of an automaton of this rank is
   replaced by that automaton's row, whose sums it shares, and only the place where both meet is the
   image's. A ghost of another rank is a guest, whose values come through the halo.

   So: tell the ghosts who they are, list each pair once with the state that its automata brought,
   sort, put the pairs at the borders first, fill the step's list, and tell the step and the halo.
------------------------------------------------------------------------- */

void FixMCAHistory::post_neighbor()
{
  nlocal_neigh = atom->nlocal;
  nall_neigh = nlocal_neigh + atom->nghost;
  ghosts.assign(atom->tag + nlocal_neigh, atom->tag + nall_neigh);
  share_keys();
  std::vector<Listed> pairs = listed_pairs();
  std::vector<mca::Halo::Guest> guests;
  const int border = borders_first(pairs, guests);
  mca::LinkList &links = mca->links();
  const mca::LawTables &laws = mca->step().laws();
  links.reset(static_cast<int>(pairs.size()));
  for (const Listed &p : pairs) {
    const int law = laws.number(atom->type[p.i], atom->type[p.j]);
    links.addStored(row[p.i], row[p.j], law, p.exchanged, p.stored);
    links.setPlaces(p.i, p.j);
  }
  mca->begin_list(border, guests);
  if (running)
    mca->take_in(added());
}

/* what has been in a list before has a record, at least its own */

std::vector<int> FixMCAHistory::added() const
{
  std::vector<int> own;
  for (int i = 0; i < nlocal_neigh; i++)
    if (npartner[i] == 0)
      own.push_back(i);
  return own;
}

double FixMCAHistory::key(int i) const
{
  return npartner[i] > 0 ? ubuf(partner[i][0]).d : 0.0;
}

/* keys stay with the automata, whatever commands do to order and IDs; images of one rank only give
   places */

bool FixMCAHistory::in_order() const
{
  if (atom->nlocal != nlocal_neigh)
    return false;
  for (int i = 0; i < nlocal_neigh; i++)
    if (ubuf(key(i)).i != ubuf(shared[i].key).i)
      return false;
  return comm->nprocs == 1 || are_ghosts_in_order();
}

bool FixMCAHistory::are_ghosts_in_order() const
{
  const tagint *first = atom->tag + nlocal_neigh;
  return std::equal(first, first + atom->nghost, ghosts.begin(), ghosts.end());
}

/* LAMMPS sets up a run with 'pre no' that follows such a command, but no part of a run every. Where
   a command of that one runs, LAMMPS's flag of a run is gone behind it, and with it all set-up of
   fixes. */

void FixMCAHistory::check_begin() const
{
  if (update->whichflag != 1)
    error->all(FLERR,
               "Pair style mca: a command of run every has run, too, at step {}: LAMMPS sets up no "
               "fix behind it; begin a run of its own",
               update->firststep);
  mca->check_count();
  if (!in_order() || !are_ghosts_in_order())
    error->one(
        FLERR,
        "Pair style mca: automata have changed ranks, order or IDs since the last set-up, as "
        "write_data, write_restart and reset_atoms make them: leave out 'pre no'");
}

/* ghosts learn under which key partners know their original, and where it is at home */

void FixMCAHistory::share_keys()
{
  shared.resize(nall_neigh);
  for (int i = 0; i < nlocal_neigh; i++)
    shared[i] = {key(i), static_cast<double>(comm->me), static_cast<double>(i)};
  comm->forward_comm(this, 3);
  row.resize(nall_neigh);
  for (int i = 0; i < nall_neigh; i++)
    row[i] = shared[i].rank == comm->me ? static_cast<int>(shared[i].row) : i;
}

/* what automaton i keeps of its pair with j, or nothing; 0 is no key: a new automaton */

const double *FixMCAHistory::stored(int i, int j) const
{
  static constexpr double blank[mca::LinkList::maxStoredSize] = {};
  const auto key = static_cast<tagint>(ubuf(shared[j].key).i);
  const double *state = blank;
  for (int m = 1; m < npartner[i] && key > 0; m++)
    if (partner[i][m] == key)
      state = valuepartner[i] + dnum * m;
  return state;
}

/* LAMMPS's pairs in the order of their IDs: counted, then put to the automaton of the lower ID,
   whose few pairs are sorted by the higher one. That is linear in the number of pairs, while one
   sort of all of them would take longer than the rest of a build. */

std::vector<FixMCAHistory::Listed> FixMCAHistory::listed_pairs() const
{
  const NeighList *list = mca->list;
  const tagint *tag = atom->tag;
  double **x = atom->x;
  std::vector<int> by_id(nall_neigh), place(nall_neigh); // place: where an atom stands in by_id
  std::iota(by_id.begin(), by_id.end(), 0);
  std::sort(by_id.begin(), by_id.end(), [tag, x](int a, int b) {
    // images of one atom by their places
    return tag[a] != tag[b] ? tag[a] < tag[b]
                            : std::lexicographical_compare(x[a], x[a] + 3, x[b], x[b] + 3);
  });
  for (int k = 0; k < nall_neigh; k++)
    place[by_id[k]] = k;

  auto each_pair = [&](auto &&use) {
    for (int ii = 0; ii < list->inum; ii++) {
      const int i = list->ilist[ii];
      for (int jj = 0; jj < list->numneigh[i]; jj++) {
        const int j = list->firstneigh[i][jj] & NEIGHMASK;
        if (tag[i] > tag[j] && j >= nlocal_neigh && row[j] < nlocal_neigh)
          continue; // over a periodic face: both automata list the other's image
        tag[i] < tag[j] ? use(i, j, i, j) : use(j, i, i, j);
      }
    }
  };
  std::vector<int> first(nall_neigh + 1, 0); // pair of each atom of by_id that has the lower ID
  each_pair([&](int lower, int, int, int) { first[place[lower] + 1]++; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Listed> pairs(first.back());
  std::vector<int> next(first.begin(), first.end() - 1);
  each_pair([&](int lower, int higher, int i, int j) {
    pairs[next[place[lower]]++] = {lower, higher, lower != i, stored(i, j)};
  });
  for (int k = 0; k < nall_neigh; k++)
    std::sort(pairs.begin() + first[k], pairs.begin() + first[k + 1],
              [tag](const Listed &a, const Listed &b) { return tag[a.j] < tag[b.j]; });
  return pairs;
}

/* An automaton that meets a guest is a guest of that one's rank in turn, which needs its values.
   All pairs of such automata come first, so that each one's sums are made in one part of the list.
   A pass works on the rest, the inside, while messages are on their way, and on these last. The
   partition is stable: within both parts the order of IDs stays. Returns their number. */

int FixMCAHistory::borders_first(std::vector<Listed> &pairs,
                                 std::vector<mca::Halo::Guest> &guests) const
{
  std::vector<char> needed(nall_neigh, 0), is_guest(nall_neigh, 0);
  for (const Listed &p : pairs)
    for (const auto &[i, j] : {std::pair{p.i, p.j}, std::pair{p.j, p.i}})
      if (row[j] >= nlocal_neigh) {
        needed[row[i]] = 1;
        is_guest[j] = 1;
      }
  for (int i = nlocal_neigh; i < nall_neigh; i++)
    if (is_guest[i])
      guests.push_back({static_cast<int>(shared[i].rank), static_cast<int>(shared[i].row), i});
  const auto inside = std::stable_partition(pairs.begin(), pairs.end(), [&](const Listed &p) {
    return needed[row[p.i]] || needed[row[p.j]];
  });
  return static_cast<int>(inside - pairs.begin());
}

void FixMCAHistory::setup_post_neighbor()
{
  check_period();
  post_neighbor();
  check_lost();
  check_turned();
  mca->take_in(added());
  mca->check_start();
  first_step = true;
}

/* states are found by the partner's ID, so no automaton may meet two images of another one */

void FixMCAHistory::check_period() const
{
  for (int m = 0; m < domain->dimension; m++)
    if (domain->periodicity[m] && domain->prd[m] < 2.0 * neighbor->cutneighmax)
      error->all(FLERR,
                 "Pair style mca: the periodic box is {:.6g} long in direction {}, below twice the "
                 "cutoff with the neighbor skin, {:.6g}",
                 domain->prd[m], "xyz"[m], 2.0 * neighbor -> cutneighmax);
}

/* ----------------------------------------------------------------------
   Between runs automata may have been deleted, whose links end, or moved out of reach of their
   links, which is refused.
------------------------------------------------------------------------- */

void FixMCAHistory::check_lost() const
{
  const mca::Pairs &p = mca->links().pairs();
  double own[2] = {0.0, 0.0}, all[2]; // links in the list, ends of links stored
  for (int k = 0; k < p.n; k++)
    if (mca::link::isLinked(p.now.kind[k]))
      own[0] += mca->step().share(k);
  std::vector<tagint> keys, partners;
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < npartner[i]; m++)
      if (m == 0)
        keys.push_back(partner[i][0]);
      else if (mca::link::isLinked(valuepartner[i][dnum * m])) {
        own[1] += 1.0;
        partners.push_back(partner[i][m]);
      }
  MPI_Allreduce(own, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (all[1] <= 2.0 * all[0])
    return;

  // which partners are there? a rare case, so every rank gets all keys
  int n = static_cast<int>(keys.size());
  std::vector<int> counts(comm->nprocs), starts(comm->nprocs, 0);
  MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  for (int r = 1; r < comm->nprocs; r++)
    starts[r] = starts[r - 1] + counts[r - 1];
  std::vector<tagint> existing(starts.back() + counts.back());
  MPI_Allgatherv(keys.data(), n, MPI_LMP_TAGINT, existing.data(), counts.data(), starts.data(),
                 MPI_LMP_TAGINT, world);
  std::sort(existing.begin(), existing.end());
  double ended = 0.0, all_ended;
  for (const tagint key : partners)
    ended += !std::binary_search(existing.begin(), existing.end(), key);
  MPI_Allreduce(&ended, &all_ended, 1, MPI_DOUBLE, MPI_SUM, world);
  if (const double torn = 0.5 * (all[1] - all_ended) - all[0]; torn > 0.0)
    error->all(FLERR,
               "{:.0f} links of pair_style mca are stretched beyond the cutoff by moving their "
               "automata between runs: delete them by mca_links first",
               torn);
  if (comm->me == 0)
    utils::logmesg(lmp, "{:.0f} links ended with automata that were deleted\n", all_ended);
}

/* ----------------------------------------------------------------------
   A link's normal strain follows from positions, its shear from velocities in a run. What turned a
   link between runs (displace_atoms, change_box with remap) is therefore refused.
------------------------------------------------------------------------- */

void FixMCAHistory::check_turned() const
{
  // far above the round-off of positions, far below every strain that matters
  static constexpr double smallest = 1e-8;
  const mca::Pairs &p = mca->links().pairs();
  double **x = atom->x;
  double own = 0.0, largest;
  for (int k = 0; k < p.n; k++) {
    if (!mca::link::isLinked(p.now.kind[k]))
      continue;
    const double *const xi = x[p.placeI[k]], *const xj = x[p.placeJ[k]];
    const mca::Vector now = {xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]};
    const mca::Vector before = {p.normal[0][k], p.normal[1][k], p.normal[2][k]};
    own = std::max(own, mca::length(mca::cross(before, now)) / mca::length(now));
  }
  MPI_Allreduce(&own, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  if (largest > smallest)
    error->all(FLERR,
               "Links of pair_style mca were turned by up to {:.3g} rad between runs; their shear "
               "follows only motion in a run: move linked fragments as a whole, deform by fix "
               "deform with remap v, or delete the links by mca_links first",
               largest);
}

/* ----------------------------------------------------------------------
   The same in a run, of fixes that set places without velocities (fix move variable). The first
   step of a run is looked at, and some later ones, for motion that begins later.
------------------------------------------------------------------------- */

int FixMCAHistory::setmask()
{
  return FixNeighHistory::setmask() | FixConst::INITIAL_INTEGRATE | FixConst::POST_INTEGRATE;
}

void FixMCAHistory::initial_integrate(int /*vflag*/)
{
  if (!running)
    check_begin();
  running = true;
  static constexpr int from_check_to_check = 100; // steps
  start.clear();
  looks = first_step || update->ntimestep % from_check_to_check == 0;
  first_step = false;
  if (!looks)
    return;
  start.reserve(6 * static_cast<size_t>(atom->nlocal));
  for (int i = 0; i < atom->nlocal; i++) {
    start.insert(start.end(), atom->x[i], atom->x[i] + 3);
    start.insert(start.end(), atom->v[i], atom->v[i] + 3);
  }
}

void FixMCAHistory::post_integrate()
{
  if (!looks)
    return;
  // of the way, beside what integrators of second order make, and of the diameter, for round-off
  static constexpr double part = 0.5, round_off = 1e-9;
  const mca::LinkList &links = mca->links();
  const int own = static_cast<int>(start.size() / 6);
  auto apart = [](const double *a, const double *b) {
    return mca::Vector{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  };
  tagint found[2] = {0, 0};
  for (int k = 0; k < links.size() && found[0] == 0; k++) {
    const int i = links.placeI(k), j = links.placeJ(k);
    if (i >= own || j >= own || !mca::link::isLinked(links.pairs().now.kind[k]))
      continue;
    const double *const was_i = &start[6 * static_cast<size_t>(i)];
    const double *const was_j = &start[6 * static_cast<size_t>(j)];
    const mca::Vector distance = apart(atom->x[i], atom->x[j]);
    const mca::Vector way = distance - apart(was_i, was_j);
    const mca::Vector after = update->dt * apart(atom->v[i], atom->v[j]);
    const mca::Vector mean = 0.5 * (after + update->dt * apart(was_i + 3, was_j + 3));
    const double missed = std::min(mca::length(way - after), mca::length(way - mean));
    if (missed > part * std::max(mca::length(way), mca::length(after)) &&
        missed > round_off * mca::length(distance)) {
      found[0] = atom->tag[i];
      found[1] = atom->tag[j];
    }
  }
  start.clear();
  tagint all[2];
  MPI_Allreduce(found, all, 2, MPI_LMP_TAGINT, MPI_MAX, world);
  if (all[0] > 0) // of two ranks that found one, either may be named
    error->all(FLERR,
               "The link of automata {} and {} is not moved by their velocities in step {}, which "
               "its shear follows: is one with a velocity not in the group of fix nve/mca, or does "
               "a fix set places only, as fix move variable without velocities?",
               found[0] > 0 ? found[0] : all[0], found[0] > 0 ? found[1] : all[1],
               update->ntimestep);
}

/* ---------------------------------------------------------------------- */

int FixMCAHistory::pack_forward_comm(int n, int *index, double *buf, int /*pbc_flag*/,
                                     int * /*pbc*/)
{
  for (int k = 0; k < n; k++) {
    const Shared &s = shared[index[k]];
    *buf++ = s.key;
    *buf++ = s.rank;
    *buf++ = s.row;
  }
  return 3 * n;
}

void FixMCAHistory::unpack_forward_comm(int n, int first, double *buf)
{
  for (int k = first; k < first + n; k++, buf += 3)
    shared[k] = {buf[0], buf[1], buf[2]};
}
