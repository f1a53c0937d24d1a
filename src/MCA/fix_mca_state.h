// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   Internal fix MCA_STATE: the state of automata, a fix property/atom with checksums
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_STATE_H
#define LMP_FIX_MCA_STATE_H

#include "fix_property_atom.h"
#include "restart_block.h"

namespace LAMMPS_NS {

class FixMCAState : public mca::CheckedRestart<FixPropertyAtom> {
 public:
  static constexpr const char *ID = "MCA_STATE";
  using CheckedRestart::CheckedRestart;
};

} // namespace LAMMPS_NS

#endif
