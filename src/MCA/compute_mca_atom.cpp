// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_mca_atom.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "pair_mca.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

static constexpr int LINKS0 = mca::stateNumber("links0");
enum { LINKS, WELDS, ORIGINALS, COUNTS }; // of count_links()

/* Names stand on the page of this compute; those of states come from their table. */

std::vector<ComputeMCAAtom::Attribute> ComputeMCAAtom::attributes()
{
  auto step = [this](auto &&part) {
    return [this, part](int i) { return part(pair->automaton(i)); };
  };
  auto count = [this](int which) {
    return [this, which](int i) { return counts[COUNTS * i + which]; };
  };
  std::vector<Attribute> all = {
      {"sxx", step([](const auto &a) { return a.stress.xx; }), nullptr, false},
      {"syy", step([](const auto &a) { return a.stress.yy; }), nullptr, false},
      {"sxy", step([](const auto &a) { return a.stress.xy; }), nullptr, false},
      {"szz", step([](const auto &a) { return a.stress.zz; }), nullptr, false},
      {"sxz", step([](const auto &a) { return a.stress.xz; }), nullptr, false},
      {"syz", step([](const auto &a) { return a.stress.yz; }), nullptr, false},
      {"mean", step([](const auto &a) { return a.mean; }), nullptr, false},
      {"intensity", step([](const auto &a) { return a.intensity; }), nullptr, false},
      {"energy", step([](const auto &a) { return a.energy; }), nullptr, false},
      {"plastic_work", [this](int i) { return pair->plastic_work(i); }, nullptr, false},
      {"links", count(LINKS), nullptr, true},
      {"welds", count(WELDS), nullptr, true},
      {"damage", [this](int i) { return damage(i); }, nullptr, true},
  };
  for (int s = 0; s < mca::stateCount; s++)
    if (const mca::AutomatonState &state = mca::automatonStates[s]; state.attribute)
      all.push_back(
          {state.attribute, [this, s](int i) { return pair->state(s)[i]; }, &state, false});
  return all;
}

template<class Named>
static std::vector<std::string> names_of(const std::vector<Named> &all)
{
  std::vector<std::string> names;
  for (const auto &one : all)
    names.push_back(one.name);
  return names;
}

/* compute ID group mca/atom attribute ... */

ComputeMCAAtom::ComputeMCAAtom(LAMMPS *host, int narg, char **arg)
    : Compute(host, narg, arg), known(attributes()),
      columns(host, "Compute mca/atom", names_of(known), narg - 3, arg + 3), pair(nullptr)
{
  peratom_flag = 1;
  size_peratom_cols = columns.lammps_columns();
}

bool ComputeMCAAtom::asks_for(const std::function<bool(const Attribute &)> &what) const
{
  for (int c = 0; c < columns.size(); c++)
    if (what(known[columns[c]]))
      return true;
  return false;
}

void ComputeMCAAtom::init()
{
  pair = PairMCA::find(lmp, "Compute mca/atom");
  for (int c = 0; c < columns.size(); c++)
    if (const Attribute &a = known[columns[c]];
        a.state && !mca::existsIn(a.state->shown, domain->dimension))
      error->all(FLERR, "Compute mca/atom {} is for dimension {} only", a.name,
                 domain->dimension == 2 ? 3 : 2);
}

void ComputeMCAAtom::compute_peratom()
{
  pair = PairMCA::find(lmp, "Compute mca/atom"); // it may have gone since init()
  pair->check_internal_fixes();
  pair->check_order();
  invoked_peratom = update->ntimestep;
  columns.grow(atom->nmax);
  vector_atom = columns.vector;
  array_atom = columns.array;
  if (asks_for([](const auto &a) { return a.state && a.state->upkeep == mca::Upkeep::Collected; }))
    pair->collect_changes();
  if (asks_for([](const auto &a) { return a.counted; }))
    count_links();

  for (int i = 0; i < atom->nlocal; i++)
    for (int c = 0; c < columns.size(); c++)
      columns.at(i, c) = atom->mask[i] & groupbit ? known[columns[c]].value(i) : 0.0;
}

double ComputeMCAAtom::damage(int i) const
{
  const double made = pair->state(LINKS0)[i];
  return made > 0.0 ? 1.0 - counts[COUNTS * i + ORIGINALS] / made : 0.0;
}

void ComputeMCAAtom::count_links()
{
  counts.assign(COUNTS * static_cast<size_t>(atom->nlocal + atom->nghost), 0.0);
  const mca::Pairs &p = pair->links().pairs();
  for (int k = 0; k < p.n; k++) {
    const double kind = p.now.kind[k];
    if (!mca::link::isLinked(kind))
      continue;
    for (const int i : {p.i[k], p.j[k]}) {
      counts[COUNTS * i + LINKS] += 1.0;
      counts[COUNTS * i + WELDS] += kind == mca::link::weld;
      counts[COUNTS * i + ORIGINALS] += pair->links().original(k);
    }
  }
}

double ComputeMCAAtom::memory_usage()
{
  return columns.bytes() + static_cast<double>(counts.capacity()) * sizeof(double);
}
