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
#include "core/step.h"
#include "fix_neigh_history.h"
#include "restart_block.h"

#include <vector>

namespace LAMMPS_NS {

class PairMCA;

/// The list of pairs follows LAMMPS's neighbor list, and the state of pairs follows the automata.
/// Two places hold it: in a run the list of the step (PairMCA::links()), else the atoms, in
/// FixNeighHistory's storage, as one record of LinkList::storedSize() doubles for each partner that
/// an automaton has more than nothing with. pre_exchange() goes from the list to the atoms,
/// post_neighbor() back.
class FixMCAHistory : public mca::CheckedRestart<FixNeighHistory> {
 public:
  static constexpr const char *ID = "MCA_HISTORY";

  FixMCAHistory(class LAMMPS *, int, char **);
  /// The pair style whose pairs it keeps; once, right after it was made.
  void attach(PairMCA *);
  /// In set-up: as post_neighbor(), and checks what commands between runs did to links: a box below
  /// twice the cutoff, automata moved out of reach of their links, links that were turned. Each
  /// stops LAMMPS with one line; links of deleted automata end, with a line in the log. Then the
  /// pair style looks at the sample, PairMCA::check_start().
  void setup_post_neighbor() override;
  /// LAMMPS's, and both hooks around the motion of a step.
  int setmask() override;
  /// Before a set-up, and before commands that migrate atoms; no step is under way. Automata whose
  /// velocities are not those of the end of the last run lose their lag, which belongs to them.
  void init() override;
  /// Before automata move: the first step of a run, or of a part of it, stops where the list is not
  /// that of the automata; it and some later ones keep their places.
  void initial_integrate(int) override;
  /// After they moved: stops LAMMPS where a fix moved the ends of a link by anything but their
  /// velocities, which the link's shear follows. Called by all ranks.
  void post_integrate() override;
  /// Before atoms migrate and the list is built anew: what the step just done leads to goes to the
  /// atoms.
  void pre_exchange() override;
  /// The list of pairs anew, in the order of IDs, from the states that came with the atoms.
  void post_neighbor() override;
  /// The present state goes to the atoms: set-up of the next run computes the forces of this step
  /// again.
  void post_run() override;
  /// Makes the records of restart files hold the present state; LAMMPS packs them from the atoms
  /// afterwards. Writes the events so far, of all ranks.
  void write_restart(FILE *) override;
  /// They go on; rank 0 has them.
  void restart(char *) override;
  /// The file is whole: the pair style puts its checksum there. Between runs LAMMPS has put the
  /// atoms into another order for it.
  void write_restart_file(const char *path) override;
  /// LAMMPS is about to put the atoms into another order, for a set-up, or between runs for
  /// write_data.
  void setup_pre_exchange() override;
  /// Packs `shared`: three doubles an automaton, key, rank and row.
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  /// The pairs' present state goes to the atoms, without that of a step: after commands that change
  /// links.
  void store_present();
  /// Normals of all pairs as they lie now, by which a link that is turned before the first run is
  /// known: after commands that make links, which no evaluation has seen.
  void renew_normals();
  /// Number of original links of each owned automaton, as stored with the atoms; see
  /// store_present().
  std::vector<int> originals() const;
  /// Whether the automata of this rank, and those of others beside it, are those of the list, in
  /// its order: commands that migrate atoms between runs change it.
  bool in_order() const;
  /// From the first step of a run, or of a part of it, to its end. LAMMPS's own flag is set in
  /// commands of a run every, too.
  bool in_run() const { return running; }

 protected:
  bool isSound(const mca::Record &record) const override
  {
    return mca::isPartnerRecord(record, dnum);
  }

 private:
  PairMCA *mca;
  /// What owned and ghost automata show, so that ghosts know their original.
  struct Shared {
    /// By which partners know the automaton: its ID when the states were stored, as the bits of a
    /// tagint; 0: a new automaton. IDs may change between runs, keys do not.
    double key;
    /// The original's place: the rank that owns it and the atom's number there.
    double rank, row;
  };
  std::vector<Shared> shared;
  /// Shared::key of an own automaton, as stored with it.
  double key(int i) const;
  /// IDs of the ghosts of the list.
  std::vector<tagint> ghosts;
  /// Row of owned and ghost automata: that of the original, where it is ours, else its own number.
  std::vector<int> row;
  /// A pair of LAMMPS's list.
  struct Listed {
    /// Atoms, the lower ID first.
    int i, j;
    /// LAMMPS's list has the higher one first, which has its state.
    bool exchanged;
    /// Its state, storedSize() doubles kept with the atoms.
    const double *stored;
  };

  /// Checksum of the velocities of an own automaton.
  double motion_seal(int i) const;
  /// From the list to both automata of each pair, where they are owned.
  /// \param next  the next states, else the present ones
  void store(bool next);
  /// Places and velocities of own automata before they move, where the step is looked at: six a
  /// row; else empty.
  std::vector<double> start;
  bool running = false;
  /// The present state of the list goes to the atoms, with the lag that belongs to it.
  void bring_up_to_date();
  /// The ghosts are those of the list; of one rank, too, where they give the places of images.
  bool are_ghosts_in_order() const;
  /// Stops where the list is not that of the automata as they are now.
  void check_begin() const;
  /// The next step is the first one after a set-up.
  bool first_step = false;
  /// This step is looked at.
  bool looks = false;
  /// Events of the run that wrote the restart file, for attach().
  mca::Step::Count past;
  /// Fills `shared` of ghosts and `row`; a message between ranks.
  void share_keys();
  /// What automaton i keeps of its pair with j; zeros where it has nothing.
  const double *stored(int i, int j) const;
  /// LAMMPS's pairs, each once on a rank, by the lower ID, then by the higher one.
  std::vector<Listed> listed_pairs() const;
  /// Puts pairs of automata that other ranks need first, without another change of order, and finds
  /// the guests.
  /// \return number of these pairs
  int borders_first(std::vector<Listed> &, std::vector<mca::Halo::Guest> &) const;
  /// Numbers of own automata that were in no list before.
  std::vector<int> added() const;
  /// States are found by the partner's ID, so no automaton may meet two images of another one.
  void check_period() const;
  /// No link may have left the list but with its automata.
  void check_lost() const;
  /// No link may have turned between runs, since its shear would not have followed.
  void check_turned() const;
};

} // namespace LAMMPS_NS

#endif
