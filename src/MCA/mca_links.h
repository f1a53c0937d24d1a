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

class MCALinks : public Command {
 public:
  explicit MCALinks(class LAMMPS *host) : Command(host) {}
  void command(int, char **) override;

 private:
  class PairMCA *pair;
  class FixMCAHistory *history;

  void list_pairs();
  void change(const std::function<void()> &);
  void create_or_delete(bool create, int narg, char **arg);
  void write(const std::string &path); // mca_links_file.cpp
  void read(const std::string &path);
  std::string gathered(const std::string &) const;
};

} // namespace LAMMPS_NS

#endif
