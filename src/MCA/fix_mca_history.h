/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   Internal fix MCA_HISTORY: carries the state of pairs over neighbor list builds,
   migration and restart files. It differs from FixNeighHistory where that one
   - copies stale list entries into the atoms when write_restart is called between runs;
   - knows one state only: here a rebuild carries the next step's state, a restart file the
     present one, from which the step's forces are recomputed.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_HISTORY_H
#define LMP_FIX_MCA_HISTORY_H

#include "fix_neigh_history.h"

namespace LAMMPS_NS {

class PairMCA;

class FixMCAHistory : public FixNeighHistory {
 public:
  static constexpr const char *ID = "MCA_HISTORY";

  FixMCAHistory(class LAMMPS *, int, char **);
  void attach(PairMCA *);
  void pre_exchange() override;
  void post_neighbor() override;
  void post_run() override;
  void write_restart(FILE *) override;
  void store_present(); // the pairs' present state, without that of a step

 private:
  PairMCA *mca;
};

} // namespace LAMMPS_NS

#endif
