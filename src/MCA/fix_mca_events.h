// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   fix mca/events: every link that broke, formed or healed; see doc/fix_mca_events.md
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_EVENTS_H
#define LMP_FIX_MCA_EVENTS_H

#include "fix.h"

#include "output_columns.h"

namespace LAMMPS_NS {

class PairMCA;

class FixMCAEvents : public Fix {
 public:
  FixMCAEvents(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void post_force(int) override;
  double memory_usage() override;

 private:
  OutputColumns columns;
  PairMCA *pair;
  int collected; // rows since the last output
};

} // namespace LAMMPS_NS

#endif
