// SPDX-License-Identifier: GPL-2.0-or-later
// mca_links write and read: links as the bonds of a LAMMPS data file. What a bond cannot hold
// stands in comments of the file's header, which read_data and viewers skip.

#include "mca_links.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "pair_mca.h"
#include "restart_block.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <unordered_map>

using namespace LAMMPS_NS;

std::string MCALinks::gathered(const std::string &own) const
{
  const int n = static_cast<int>(own.size());
  std::vector<int> counts(comm->nprocs), starts(comm->nprocs, 0);
  MPI_Gather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
  for (int r = 1; r < comm->nprocs; r++)
    starts[r] = starts[r - 1] + counts[r - 1];
  std::string all(comm->me == 0 ? starts.back() + counts.back() : 0, ' ');
  MPI_Gatherv(own.data(), n, MPI_CHAR, all.data(), counts.data(), starts.data(), MPI_CHAR, 0,
              world);
  return all;
}

void MCALinks::write(const std::string &path)
{
  list_pairs();
  std::string atoms, velocities, automata, states, bonds;
  double **x = atom->x, **v = atom->v, **omega = atom->omega;
  for (int i = 0; i < atom->nlocal; i++) {
    const tagint id = atom->tag[i];
    atoms += fmt::format("{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} 0 {} {} {}\n", id,
                         atom->type[i], x[i][0], x[i][1], x[i][2], 2.0 * atom->radius[i],
                         pair->material(atom->type[i]).density, (atom->image[i] & IMGMASK) - IMGMAX,
                         ((atom->image[i] >> IMGBITS) & IMGMASK) - IMGMAX,
                         (atom->image[i] >> IMG2BITS) - IMGMAX);
    velocities += fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", id, v[i][0],
                              v[i][1], v[i][2], omega[i][0], omega[i][1], omega[i][2]);
    for (int s = 0; s < mca::stateCount; s++)
      if (const double *values = pair->state(s); values && values[i] != 0.0)
        automata +=
            fmt::format("# automaton {} {} {:.17g}\n", id, mca::automatonStates[s].name, values[i]);
  }
  const mca::LinkList &links = pair->links();
  const mca::Pairs &p = links.pairs();
  const int n = links.stateSize();
  for (int k = 0; k < p.n; k++) {
    if (links.blank(k, false) || !pair->step().isOurs(k))
      continue;
    double state[mca::LinkList::maxStateSize];
    links.getState(k, false, state);
    const tagint i = atom->tag[p.i[k]], j = atom->tag[p.j[k]];
    states += fmt::format("# pair {} {} {} {}", i, j, state[0], links.original(k) ? 1 : 0);
    for (int m = 1; m < n; m++)
      states += fmt::format(" {:.17g}", state[m]);
    states += "\n";
    if (mca::link::isLinked(state[0]))
      bonds += fmt::format("{:.0f} {} {}\n", state[0], i, j);
  }
  atoms = gathered(atoms);
  velocities = gathered(velocities);
  automata = gathered(automata);
  states = gathered(states);
  bonds = gathered(bonds);

  int failed = 0;
  if (comm->me == 0) {
    std::string numbered;
    bigint count = 0;
    std::istringstream lines(bonds);
    for (std::string line; std::getline(lines, line);)
      numbered += fmt::format("{} {}\n", ++count, line);
    std::string box = fmt::format("{:.17g} {:.17g} xlo xhi\n{:.17g} {:.17g} ylo yhi\n{:.17g} "
                                  "{:.17g} zlo zhi\n",
                                  domain->boxlo[0], domain->boxhi[0], domain->boxlo[1],
                                  domain->boxhi[1], domain->boxlo[2], domain->boxhi[2]);
    if (domain->triclinic)
      box += fmt::format("{:.17g} {:.17g} {:.17g} xy xz yz\n", domain->xy, domain->xz, domain->yz);
    std::string text = fmt::format(
        "LAMMPS data file by mca_links, for atom_style hybrid sphere bond; bond type = kind of "
        "link\n\n{} atoms\n{} atom types\n{} bonds\n2 bond types\n{}\n"
        "# mca-links 1: pair id1 id2 kind original plastic shears; automaton id name value\n{}{}",
        atom->natoms, atom->ntypes, count, box, states, automata);
    text += fmt::format("\nAtoms # hybrid\n\n{}\nVelocities\n\n{}", atoms, velocities);
    if (count > 0)
      text += fmt::format("\nBonds\n\n{}", numbered);
    const std::string beside = path + ".tmp";
    std::ofstream out(beside, std::ios::binary);
    out << text;
    out.close();
    failed = !out || std::rename(beside.c_str(), path.c_str()) != 0;
    if (!failed)
      utils::logmesg(lmp, "Wrote {} links\n", count);
  }
  MPI_Bcast(&failed, 1, MPI_INT, 0, world);
  if (failed)
    error->all(FLERR, "Command mca_links: cannot write file {}", path);
}

namespace {
struct Entry {
  std::vector<double> state;
  bool original;
};
struct Links { // of a file, by the lower and the higher ID
  std::map<std::pair<tagint, tagint>, Entry> pairs;
  std::unordered_map<tagint, std::vector<std::pair<std::string, double>>> automata;
};
} // namespace

// the comments of mca_links write, or the Bonds of any data file
static std::string parse(const std::string &text, int stateSize, Links &links)
{
  std::istringstream lines(text);
  bool ours = false, bonds = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    number++;
    ours = ours || line.rfind("# mca-links 1", 0) == 0;
    std::istringstream words(line);
    std::string first, second;
    words >> first;
    const std::string where = fmt::format("line {}: {}", number, line);
    tagint i = 0, j = 0;
    if (ours && first == "#" && words >> second && second == "pair") {
      Entry entry;
      entry.state.resize(stateSize);
      words >> i >> j >> entry.state[0] >> entry.original;
      for (int m = 1; m < stateSize; m++)
        words >> entry.state[m];
      if (!words)
        return where + ", allowed: # pair id1 id2 kind original plastic shears";
      links.pairs[{std::min(i, j), std::max(i, j)}] = entry;
    } else if (ours && first == "#" && second == "automaton") {
      std::string name;
      double value;
      if (!(words >> i >> name >> value))
        return where + ", allowed: # automaton id name value";
      links.automata[i].emplace_back(name, value);
    } else if (!ours && !first.empty() && first[0] != '#') {
      if (first.find_first_not_of("0123456789") != std::string::npos)
        bonds = first == "Bonds";
      else if (bonds) {
        double kind;
        if (!(words >> kind >> i >> j) || (kind != mca::link::bulk && kind != mca::link::weld))
          return where + ", allowed in Bonds: ID, type 1 (bulk link) or 2 (weld), both atoms";
        Entry entry{std::vector<double>(stateSize, 0.0), true};
        entry.state[0] = kind;
        links.pairs[{std::min(i, j), std::max(i, j)}] = entry;
      }
    }
  }
  return links.pairs.empty() ? "neither comments of mca_links write nor a section Bonds" : "";
}

void MCALinks::read(const std::string &path)
{
  lmp->init(); // the dimension fixes what a pair's state holds
  Links file;
  const std::string problem =
      parse(mca::fileText(lmp, path, "file " + path), pair->links().stateSize(), file);
  if (!problem.empty())
    error->all(FLERR, "Command mca_links: {}: {}", path, problem);
  double found = 0.0, linked = 0.0;
  change([&]() {
    mca::LinkList &links = pair->links();
    const mca::Pairs &p = links.pairs();
    for (int k = 0; k < p.n; k++) {
      const tagint i = atom->tag[p.i[k]], j = atom->tag[p.j[k]];
      const auto entry = file.pairs.find({std::min(i, j), std::max(i, j)});
      if (entry == file.pairs.end())
        continue;
      links.setState(k, entry->second.state.data());
      links.setOriginal(k, entry->second.original);
      found += pair->step().share(k);
      if (mca::link::isLinked(entry->second.state[0]))
        linked += pair->step().share(k);
    }
  });
  for (int i = 0; i < atom->nlocal; i++) {
    const auto entry = file.automata.find(atom->tag[i]);
    if (entry == file.automata.end())
      continue;
    for (const auto &[name, value] : entry->second) {
      const auto known = std::find_if(
          std::begin(mca::automatonStates), std::end(mca::automatonStates),
          [&name = name](const mca::AutomatonState &state) { return name == state.name; });
      double *values = known == std::end(mca::automatonStates)
                           ? nullptr
                           : pair->state(static_cast<int>(known - mca::automatonStates));
      if (!values)
        error->one(FLERR, "Command mca_links: {}: automata have no value {}", path, name);
      values[i] = value;
    }
  }
  const double own[2] = {found, linked};
  double all[2];
  MPI_Allreduce(own, all, 2, MPI_DOUBLE, MPI_SUM, world);
  if (all[0] != static_cast<double>(file.pairs.size()))
    error->all(FLERR,
               "Command mca_links: {} of {} pairs of {} are not neighbors here: other IDs, or "
               "stretched beyond the cutoff",
               file.pairs.size() - all[0], file.pairs.size(), path);
  if (comm->me == 0)
    utils::logmesg(lmp, "Read {:.0f} links\n", all[1]);
}
