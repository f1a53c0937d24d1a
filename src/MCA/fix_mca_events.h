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

/// Command fix mca/events: gathers PairMCA::last_events() and gives them each N steps as a local
/// vector or array, one row an event, on the rank that listed it. Events of a step are seen in the
/// next one; both automata have to be in the group.
class FixMCAEvents : public Fix {
 public:
  FixMCAEvents(class LAMMPS *, int, char **);
  int setmask() override;
  /// Stops LAMMPS without pair_style mca, which is found anew here.
  void init() override;
  /// After the evaluation, which took the last step's outcome over.
  void post_force(int) override;
  /// Of the rows on this rank [bytes].
  double memory_usage() override;

 private:
  /// Rows of the events since the last output; begun anew in the step after it.
  OutputColumns columns;
  PairMCA *pair;
  /// Rows since the last output.
  int collected;
};

} // namespace LAMMPS_NS

#endif
