// SPDX-License-Identifier: GPL-2.0-or-later
// mca_links write and read: LAMMPS's side of links_text.h

#include "mca_links.h"

#include "arguments.h"
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "files/links_text.h"
#include "pair_mca.h"
#include "restart_block.h"
#include "shared/output_file.h"

#include <algorithm>
#include <sstream>

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
        automata += mca::automatonLine(id, s, values[i]);
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
    states += mca::pairLine(i, j, state, n, links.original(k));
    if (mca::link::isLinked(state[0]))
      bonds += fmt::format("{:.0f} {} {}\n", state[0], i, j);
  }
  atoms = gathered(atoms);
  velocities = gathered(velocities);
  automata = gathered(automata);
  states = gathered(states);
  bonds = gathered(bonds);

  std::string problem;
  if (comm->me == 0) {
    std::string numbered;
    bigint count = 0;
    int types = 2;
    std::istringstream lines(bonds);
    for (std::string line; std::getline(lines, line);) {
      numbered += fmt::format("{} {}\n", ++count, line);
      types = std::max(types, line[0] - '0');
    }
    std::string box = fmt::format("{:.17g} {:.17g} xlo xhi\n{:.17g} {:.17g} ylo yhi\n{:.17g} "
                                  "{:.17g} zlo zhi\n",
                                  domain->boxlo[0], domain->boxhi[0], domain->boxlo[1],
                                  domain->boxhi[1], domain->boxlo[2], domain->boxhi[2]);
    if (domain->triclinic)
      box += fmt::format("{:.17g} {:.17g} {:.17g} xy xz yz\n", domain->xy, domain->xz, domain->yz);
    std::string text =
        mca::linksHead(fmt::format("{} atoms\n{} atom types\n{} bonds\n{} bond types\n{}",
                                   atom->natoms, atom->ntypes, count, types, box),
                       states + automata);
    text += fmt::format("\nAtoms # hybrid\n\n{}\nVelocities\n\n{}", atoms, velocities);
    if (count > 0)
      text += fmt::format("\nBonds\n\n{}", numbered);
    try {
      mcawr::writeOutputFile(path, mca::sealedLinks(text));
      utils::logmesg(lmp, "Wrote {} links\n", count);
    } catch (const mcawr::OutputError &e) {
      problem = e.what();
    }
  }
  int failed = problem.empty() ? 0 : 1;
  MPI_Bcast(&failed, 1, MPI_INT, 0, world);
  if (failed) // rank 0 prints
    error->all(FLERR, "Command mca_links: {}", problem);
}

int MCALinks::copies_of(int narg, char **arg) const
{
  int copies = 1;
  for (int iarg = 3; iarg < narg; iarg++)
    copies *= static_cast<int>(
        mca::wholeNumber(lmp, "Command mca_links replicate", arg[iarg], 1, MAXSMALLINT / copies));
  return copies;
}

/* command replicate gives copy c the IDs of the original and c times the largest of them */

tagint MCALinks::ids_of_a_copy(int copies) const
{
  tagint own = 0, largest;
  for (int i = 0; i < atom->nlocal; i++)
    own = std::max(own, atom->tag[i]);
  MPI_Allreduce(&own, &largest, 1, MPI_LMP_TAGINT, MPI_MAX, world);
  if (largest % copies != 0 || atom->natoms % copies != 0)
    error->all(FLERR,
               "Command mca_links replicate: {} automata with IDs up to {} are not {} copies of a "
               "sample: give it right after command replicate with the same numbers",
               atom->natoms, largest, copies);
  return largest / copies;
}

void MCALinks::read(const std::string &path, int copies)
{
  lmp->init(); // the dimension fixes what a pair's state holds
  mca::Links file;
  const std::string text = mca::fileText(lmp, path, "file " + path);
  try {
    file = mca::linksIn(text, pair->links().stateSize(), MAXTAGINT);
  } catch (const mca::LinksError &e) {
    error->all(FLERR, "Command mca_links: {}: {}", path, e.what());
  }
  const tagint ids = ids_of_a_copy(copies);
  const auto original = [ids](tagint id) { return (id - 1) % ids + 1; };
  double found = 0.0, linked = 0.0;
  change([&]() {
    mca::LinkList &links = pair->links();
    const mca::Pairs &p = links.pairs();
    for (int k = 0; k < p.n; k++) {
      const tagint i = original(atom->tag[p.i[k]]), j = original(atom->tag[p.j[k]]);
      const auto entry = file.pairs.find({std::min(i, j), std::max(i, j)});
      if (entry == file.pairs.end()) { // which leaves out pairs that have nothing
        const double none[mca::LinkList::maxStateSize] = {mca::link::none};
        links.setState(k, none);
        links.setOriginal(k, false);
        continue;
      }
      std::vector<double> state = entry->second.state;
      if ((i < j) != (atom->tag[p.i[k]] < atom->tag[p.j[k]]))
        links.exchange(state.data()); // over a face of the original the order of IDs may turn
      links.setState(k, state.data());
      links.setOriginal(k, entry->second.original);
      found += pair->step().share(k);
      if (mca::link::isLinked(entry->second.state[0]))
        linked += pair->step().share(k);
    }
  });
  for (int i = 0; i < atom->nlocal; i++) {
    for (int s = 0; s < mca::stateCount && file.hasStates; s++) // which leaves out zeros
      if (double *values = pair->state(s))
        values[i] = 0.0;
    const auto entry = file.automata.find(original(atom->tag[i]));
    if (entry == file.automata.end())
      continue;
    for (const auto &[number, value] : entry->second) {
      const mca::AutomatonState &state = mca::automatonStates[number];
      double *values = pair->state(number);
      if (!values && !state.always)
        continue; // of a law that does not act here
      if (!values)
        error->one(FLERR, "Command mca_links: {}: automata have no value {}", path, state.name);
      values[i] = value;
    }
  }
  const double own[2] = {found, linked};
  double all[2];
  MPI_Allreduce(own, all, 2, MPI_DOUBLE, MPI_SUM, world);
  const double expected = static_cast<double>(file.pairs.size()) * copies;
  if (all[0] != expected)
    error->all(FLERR,
               "Command mca_links: {:.0f} of {:.0f} pairs of {} are not neighbors here: other IDs, "
               "stretched beyond the cutoff, or copies without a periodic face",
               expected - all[0], expected, path);
  if (comm->me == 0)
    utils::logmesg(lmp, "Read {:.0f} links\n", all[1]);
}
