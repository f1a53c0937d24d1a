// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   Internal fix MCA_HISTORY: carries the state of pairs over neighbor list builds,
   migration and restart files, kept with both automata of a pair. It takes FixNeighHistory's
   storage with the atoms and differs where that one
   - copies stale list entries into the atoms when write_restart is called between runs;
   - knows one state only: here a rebuild carries the next step's state, a restart file the
     present one, from which the step's forces are recomputed;
   - passes states between ranks with comm_style brick only;
   - loses all states when IDs change between runs (reset_atoms, delete_atoms).
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_HISTORY_H
#define LMP_FIX_MCA_HISTORY_H

#include "core/halo.h"
#include "core/link_list.h"
#include "fix_neigh_history.h"
#include "restart_block.h"

#include <vector>

namespace LAMMPS_NS {

class PairMCA;

class FixMCAHistory : public mca::CheckedRestart<FixNeighHistory> {
 public:
  static constexpr const char *ID = "MCA_HISTORY";

  FixMCAHistory(class LAMMPS *, int, char **);
  void attach(PairMCA *);
  void setup_post_neighbor() override;
  void pre_exchange() override;
  void post_neighbor() override;
  void post_run() override;
  void write_restart(FILE *) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void store_present();               // the pairs' present state, without that of a step
  std::vector<int> originals() const; // original links of owned automata, as stored

 private:
  PairMCA *mca;
  struct Shared {     // of owned and ghost automata
    double key;       // by which partners know the automaton
    double rank, row; // of the original
  };
  std::vector<Shared> shared;
  std::vector<int> row;   // of owned and ghost automata: that of the original, where it is ours
  struct Listed {         // a pair of LAMMPS's list
    int i, j;             // atoms, the lower ID first
    bool exchanged;       // LAMMPS's list has the higher one first, which has its state
    const double *stored; // its state
  };

  void store(bool next);
  void share_keys();
  const double *stored(int i, int j) const;
  std::vector<Listed> listed_pairs() const;
  int borders_first(std::vector<Listed> &, std::vector<mca::Halo::Guest> &) const;
  void check_period() const;
  void check_lost() const;
  void check_turned() const;
};

} // namespace LAMMPS_NS

#endif
