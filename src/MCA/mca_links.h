/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   command mca_links: link or unlink pairs of automata; see doc/mca_links.md
------------------------------------------------------------------------- */

#ifndef LMP_MCA_LINKS_H
#define LMP_MCA_LINKS_H

#include "command.h"

namespace LAMMPS_NS {

class MCALinks : public Command {
 public:
  MCALinks(class LAMMPS *host) : Command(host) {}
  void command(int, char **) override;
};

} // namespace LAMMPS_NS

#endif
