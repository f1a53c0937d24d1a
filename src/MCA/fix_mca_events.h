// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   fix mca/events: every link that broke, formed or healed; see doc/fix_mca_events.md
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_EVENTS_H
#define LMP_FIX_MCA_EVENTS_H

#include "fix.h"

#include "output_columns.h"

#include <vector>

namespace LAMMPS_NS {

class PairMCA;

/// Command fix mca/events: gathers PairMCA::last_events() and gives them each N steps as a local
/// vector or array, one row an event, on the rank that listed it. Events of a step are seen in the
/// next one; both automata have to be in the group. Vector of three, over all ranks: links broken,
/// formed and healed since the fix was defined. Restart files hold counters and rows.
class FixMCAEvents : public Fix {
 public:
  FixMCAEvents(class LAMMPS *, int, char **);
  int setmask() override;
  /// Stops LAMMPS without pair_style mca, which is found anew here.
  void init() override;
  /// After the evaluation, which took the last step's outcome over.
  void post_force(int) override;
  /// \param n  0 broken, 1 formed, 2 healed; called by all ranks
  double compute_vector(int) override;
  /// Counters and the rows since the last output, of all ranks.
  void write_restart(FILE *) override;
  /// They go on, rank 0 has them.
  void restart(char *) override;
  /// Memory of the rows on this rank [bytes].
  double memory_usage() override;

 private:
  /// Steps between two outputs.
  const int every;
  /// What was given out last.
  OutputColumns columns;
  PairMCA *pair;
  enum { BROKEN, FORMED, HEALED, COUNTERS };
  /// Counters of this rank.
  double counts[COUNTERS];
  /// Events since the last output: all attributes of each.
  std::vector<double> collected;

  /// The collected rows become the columns.
  void give_out();
};

} // namespace LAMMPS_NS

#endif
