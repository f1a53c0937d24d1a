// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   Internal fix MCA_STATE: the state of automata, a fix property/atom with checksums
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_STATE_H
#define LMP_FIX_MCA_STATE_H

#include "error.h"
#include "fix_property_atom.h"
#include "restart_block.h"

#include <cstring>

namespace LAMMPS_NS {

/// Holds the columns of mca::automatonStates, one custom property of type double each, for own
/// atoms and ghosts. PairMCA makes it in its first init_style(), in a place before all fixes of the
/// input script. Migration, deletion and data in restart files are fix property/atom's; a record
/// whose checksum does not match stops LAMMPS.
class FixMCAState : public mca::CheckedRestart<FixPropertyAtom> {
 public:
  /// Its ID, by which a restart file's records find it.
  static constexpr const char *ID = "MCA_STATE";
  static constexpr const char *SPINS = "MCA_SPINS"; // states of laws that see angular velocities
  FixMCAState(LAMMPS *host, int narg, char **arg) : CheckedRestart(host, narg, arg)
  {
    if (strcmp(id, ID) != 0 && strcmp(id, SPINS) != 0)
      error->all(FLERR, "Fix {} is internal to pair_style mca, which makes it itself", ID);
  }

 protected:
  bool isSound(const mca::Record &record) const override
  {
    return mca::isStateRecord(record, nvalue);
  }
};

} // namespace LAMMPS_NS

#endif
