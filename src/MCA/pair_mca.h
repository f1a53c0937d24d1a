// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   pair_style mca: movable cellular automata; see doc/pair_mca.md
   Glue: what a step computes stands in core/step.h
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_MCA_H
#define LMP_PAIR_MCA_H

#include "pair.h"

#include "core/automaton_states.h"
#include "core/halo.h"
#include "core/step.h"

#include <vector>

namespace LAMMPS_NS {

class FixMCAHistory;

class PairMCA : public Pair {
 public:
  explicit PairMCA(class LAMMPS *);
  ~PairMCA() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  void setup() override;
  void reset_dt() override;
  double init_one(int, int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  double memory_usage() override;

  // ---- for the history fix: the list of pairs follows LAMMPS's neighbor list

  void commit();            // the next state becomes the present one; what it changes are events
  void keep_lag();          // after a step: velocities less those that made its forces
  void check_reach() const; // no link is longer than the cutoff
  // the list is new: its first pairs are those at the borders to other ranks
  void begin_list(int border, const std::vector<mca::Halo::Guest> &);

  // ---- for computes, fixes and commands

  mca::Step &step() { return mca_step; } // all values are in units of energy, length, time, mass
  mca::LinkList &links() { return mca_step.links(); }
  const mca::Material &material(int type) const { return materials[type]; }
  const mca::LawSet &laws() const { return lawset; }
  double thickness() const { return depth > 0.0 ? depth : 1.0; }
  mca::Cell cell(int type) const;
  double mass(int type) const;    // of an automaton: the packing, not the disc, fixes it
  double inertia(int type) const; // about its axis, in space about any

  // values of own and ghost automata, by mca::stateNumber(); nullptr: not in this dimension
  double *state(int number) const;
  void collect_changes(); // brings the states of mca::Upkeep::Collected up to date

  // of an owned automaton, of pair k, in pressure units; valid after compute()
  mca::Step::Automaton automaton(int) const;
  mca::ContactStress contact(int k) const;
  double plastic_work(int) const; // of an owned automaton since the beginning, in energy units

  struct Count : mca::Step::Count { // of this rank
    double plastic_work;            // of its automata since the beginning
  };
  Count count() const;

  struct Event { // a pair that changed its kind
    bigint step; // the last one in the old kind
    tagint tag[2];
    double before, after;
    double x[3]; // middle of the pair
    int mask[2]; // groups of both automata
  };
  const std::vector<Event> &last_events() const { return happened; } // of the step before this one

 protected:
  mca::LawSet lawset;
  const mca::Packing *packing;          // nullptr until it is known
  double depth;                         // thickness of the discs, 0: not given
  double cut_user;                      // 0 = default
  std::vector<mca::Material> materials; // by type, in the units of the input script

  mca::Step mca_step;
  mca::Halo halo;
  int integrated, held;        // groups whose automata a fix moves by their forces, or otherwise
  std::vector<Event> happened; // taken over in this step
  FixMCAHistory *fix_history;
  int columns[mca::stateCount]; // of the states among LAMMPS's custom values; -1: none

  void allocate();
  void choose_packing();
  void make_laws();
  void check_step();
  void check_commands() const;
  void find_held();
  void find_columns();
  double stress_unit() const;
  mca::Automata automata() const;
  void add_forces();
  void record_events();
  void tally();
};

} // namespace LAMMPS_NS

#endif
