/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   pair_style mca: movable cellular automata; see doc/pair_mca.md
------------------------------------------------------------------------- */

#ifndef LMP_PAIR_MCA_H
#define LMP_PAIR_MCA_H

#include "atom.h"
#include "pair.h"

#include "halo.h"
#include "laws/law_set.h"
#include "link_list.h"
#include "viscous_contacts.h"

#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class FixMCAHistory;

class PairMCA : public Pair {
  friend class FixMCAEnergy; // keeps the books of what is inside

 public:
  PairMCA(class LAMMPS *);
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

  // ---- for the history fix: the flat pair list follows LAMMPS's neighbor list

  void commit();            // the next state becomes the present one; what it changes are events
  void keep_lag();          // after a step: velocities less those that made its forces
  void check_reach() const; // no link is longer than the cutoff
  // the list is new: its first pairs are those at the borders to other ranks
  void begin_list(int border, const std::vector<mca::Halo::Guest> &);
  int law_number(int i, int j) const
  {
    return lawnumber[atom->type[i] * (atom->ntypes + 1) + atom->type[j]];
  }

  // ---- for computes, fixes and commands

  const mca::LinkList &links() const { return pairs; }
  mca::LinkList &links() { return pairs; }
  const mca::Material &material(int type) const { return materials[type]; }
  const mca::LawSet &laws() const { return lawset; }
  double thickness() const { return depth > 0.0 ? depth : 1.0; }
  mca::Cell cell(int type) const;
  double mass(int type) const;    // of an automaton: the packing, not the disc, fixes it
  double inertia(int type) const; // about its axis, in space about any

  struct Automaton { // of an owned automaton, in pressure units; valid after compute()
    mca::StressTensor stress;
    double mean, intensity, energy;
  };
  Automaton automaton(int) const;

  double plastic_work(int) const; // of an owned automaton since the beginning, in energy units
  void collect_changes();         // brings the custom values mca_broken, mca_formed up to date
  // of pair k, in pressure units; in space gamma and tau are lengths of vectors
  mca::ContactStress contact(int) const;
  double shear(double *const *of, int) const;      // in space the length of the vector
  mca::Vector normal(int) const;                   // unit vector of pair k
  mca::Vector along_shear(int, double size) const; // of this size, along the shear of pair k
  double owned_share(int) const;                   // 1, or 1/2 for a pair that two ranks hold
  bool on_this_rank(int) const; // of a pair that two ranks hold, true on one of them

  struct Count { // of this rank; pairs held twice count half on each
    double links = 0.0, welds = 0.0;
    double broken = 0.0, formed = 0.0, healed = 0.0; // since the pair style was created
    double plastic_work = 0.0;                       // of the automata since the beginning
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

  std::vector<mca::PairLaw> pairlaw;      // of unlike pairs of materials
  std::vector<int> lawnumber;             // in pairlaw, by itype * (ntypes+1) + jtype
  std::vector<mca::AutomatonLaw> autolaw; // by type
  bool onelaw;                            // one material for all types
  const mca::Kernel *kernel;

  mca::LinkList pairs;
  mca::AlignedArray motion, spin, strains, stresses, response, local, forces;
  mca::AlignedArray kappa_next, elastic_z_next;
  mca::AlignedArray link_changes; // links broken and formed of each automaton, not collected yet
  std::vector<std::pair<int, int>> flowing; // ranges of rows whose equivalent plastic strain grows
  mca::Halo halo;
  mca::ViscousContacts viscous;
  int integrated, held;        // groups whose automata a fix moves by their forces, or otherwise
  int edge;                    // so many first pairs of the list are at borders to other ranks
  Count events;                // since creation; links and welds stay 0
  std::vector<Event> happened; // taken over in this step
  double changes;              // pairs whose next state is another kind
  bool committed;              // the state is already that of the coming step

  FixMCAHistory *fix_history;
  int icustom_kappa, icustom_elastic_z, icustom_changes[2], icustom_lag[3], icustom_rest[3];
  int listed; // automata of the list

  void allocate();
  void choose_packing();
  void make_laws();
  void check_step();
  void check_commands() const;
  void find_held();
  double *kappa() const;
  double *elastic_z() const;
  bool j2() const { return lawset.strainsAcross(kernel->dimension); }
  double stress_unit() const;
  void pack_motion(int nall, bool advance);
  void pack_space_motion(int nall, bool advance);
  void find_means();
  void yield(int from, int to);
  void yield_again(const mca::Pairs &border, const mca::Pairs &inside);
  const double *further_laws();
  void centre_viscosity(const mca::Pairs &border, const mca::Pairs &inside);
  void add_forces();
  void record_events();
  void tally(int, int);
};

} // namespace LAMMPS_NS

#endif
