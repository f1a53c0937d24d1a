// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   command mca_links: link or unlink pairs of automata, write and read links; see doc/mca_links.md
------------------------------------------------------------------------- */

#ifndef LMP_MCA_LINKS_H
#define LMP_MCA_LINKS_H

#include "command.h"

#include <functional>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/// Command mca_links: create and delete change the kind of pairs within the cutoff, write and read
/// take all links to and from a file. Between runs only. Each makes the list of pairs as a run's
/// set-up does; what changes it stores it with the atoms. Counts of links are messages in the log.
class MCALinks : public Command {
 public:
  explicit MCALinks(class LAMMPS *host) : Command(host) {}
  /// \param narg,arg  words behind mca_links; a wrong one stops LAMMPS with one line
  void command(int, char **) override;

 private:
  class PairMCA *pair;
  class FixMCAHistory *history;

  /// The list with the present links, by all ranks; atoms may migrate, so that pointers into
  /// LAMMPS's arrays end here.
  void list_pairs();
  /// Lists the pairs, lets the function change them, stores them, and brings the number of original
  /// links of each automaton up to date (state links0, the denominator of damage).
  /// \param pairs  sets states and originals of PairMCA::links(); alike on both ranks of a pair
  void change(const std::function<void()> &);
  /// Bulk links without shear for pairs of both groups up to `reach` mean diameters; or none.
  /// Plastic offsets stay.
  void create_or_delete(bool create, int narg, char **arg);
  /// A LAMMPS data file with links as bonds, what bonds cannot hold in comments
  /// (mca_links_file.cpp); it appears whole.
  void write(const std::string &path);
  /// Such a file, or the bonds of any data file as original links without shear and plastic offset.
  /// Automata are found by ID; a pair that is not a neighbor here stops LAMMPS. Automata of a
  /// sample that command replicate has multiplied get the links of their originals in each copy.
  /// \param copies  how many copies of the file's sample there are, 1: itself
  void read(const std::string &path, int copies);
  /// The number of copies that the words behind a file name say, nx ny nz.
  int copies_of(int narg, char **arg) const;
  /// What IDs of copies differ by; stops LAMMPS where the automata are not so many copies.
  tagint ids_of_a_copy(int copies) const;
  /// The texts of all ranks in their order, on rank 0; empty on the others.
  std::string gathered(const std::string &) const;
};

} // namespace LAMMPS_NS

#endif
