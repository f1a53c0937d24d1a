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
#include "restart_block.h"

#include <vector>

namespace LAMMPS_NS {

class Fix;
class FixMCAHistory;

/// Command pair_style mca. It hands LAMMPS's arrays to mca::Step for one call at a time, adds what
/// comes back to atom->f and atom->torque of own atoms, and keeps laws and materials; ghosts get no
/// forces. At most one at a time, also within pair_style hybrid. Stresses inside the step are
/// energies per volume; what this class gives out is in pressure units, which differ in units such
/// as metal and real (force->nktv2p).
class PairMCA : public Pair {
 public:
  explicit PairMCA(class LAMMPS *);
  ~PairMCA() override;
  /// One evaluation of the laws. In set-up nothing moves on, and the forces are those of before.
  void compute(int, int) override;
  /// pair_style mca keyword value ...; what is not packing, thickness or cutoff is a keyword of
  /// laws/law_set.h.
  void settings(int, char **) override;
  /// pair_coeff I I file.mca [quantity value] ...; a material belongs to a type. And pair_coeff I J
  /// interface [keyword value] ...
  void coeff(int, char **) override;
  /// Before each run: refuses commands that move automata without their velocities, makes the laws,
  /// sets radius and mass of own atoms, and at the first time the two internal fixes.
  void init_style() override;
  /// Refuses a timestep above the critical one of any material (laws/critical_step.h); the same
  /// when the timestep changes.
  void setup() override;
  void reset_dt() override;
  /// The cutoff of two types [length]: as given, at least the breaking distance; else with room for
  /// links that compression of their neighbours keeps.
  double init_one(int, int) override;
  /// Blocks of text with checksums (restart_block.h): the laws as the words of pair_style, then the
  /// materials. A damaged one stops LAMMPS with one line.
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  /// Memory of the step on this rank [bytes], beside LAMMPS's own.
  double memory_usage() override;

  // ---- for the history fix: the list of pairs follows LAMMPS's neighbor list

  /// The next state becomes the present one; what it changes are events, last_events(). Once a
  /// step: by compute(), or before it where the list of pairs is about to be made anew.
  void commit();
  /// After a step: velocities less those that made its forces, into the states lag and rest of own
  /// automata.
  void keep_lag();
  /// Own automaton i has other velocities than at the end of the run: lag and rest become 0.
  void drop_lag(int i);
  /// Stops LAMMPS where a link is longer than the cutoff: its pair would not be in the next list.
  void check_reach() const;
  /// Own automata that are new, also those that a fix added in a run: their diameter and mass are
  /// those of their material from now on, and none may overlap. Called by all ranks, with the list
  /// that has them.
  /// \param added  numbers of those of this rank
  void take_in(const std::vector<int> &added);
  /// After the first list of a run: stops LAMMPS where automata are nan, warns of what is hardly
  /// meant. Called by all ranks.
  void check_start();
  /// Puts the checksum into a restart file that is whole; rank 0 does.
  /// \param path  as given by the user, with % for a file in several parts
  void close_restart_file(const char *path);
  /// The list is new: its first pairs are those at the borders to other ranks. On several ranks the
  /// halo is built, by all of them.
  /// \param border  number of these pairs
  /// \param guests  automata of other ranks in pairs of this one, each once
  void begin_list(int border, const std::vector<mca::Halo::Guest> &);
  /// With MCAWR_TRACE in the environment: a line in the log on what ranks have sent each other in
  /// the steps since the last one. Called by all ranks at the end of a run.
  /// \param ghosts  automata of other ranks whose places and velocities LAMMPS brings here
  void trace_messages(int ghosts);

  // ---- for computes, fixes and commands

  /// The pair style of this LAMMPS; stops it where there is none.
  /// \param who  needs it, for the message
  static PairMCA *find(LAMMPS *, const char *who);
  /// The same; nullptr where there is none.
  static PairMCA *found(LAMMPS *);
  /// Whether a fix gives its automata their motion, whatever the forces: in any or all components
  /// of the dimension, in y, and in rotation.
  struct Prescribed {
    bool any, all, y, spin;
  };
  Prescribed prescribed(const Fix *) const;
  /// Whether packing and materials of all types are known, so that mass() and cell() are.
  bool knows_masses() const;
  /// Stops LAMMPS where the internal fixes are gone, which hold the state of links and automata.
  void check_internal_fixes() const;
  /// Stops LAMMPS where own automata are more or less than those of the list of pairs.
  void check_count() const;
  /// The same for output, after check_internal_fixes(): nor may they stand in another order.
  void check_order() const;
  /// After what puts automata into another order outside a run: the next run sets up, whatever its
  /// 'pre' says.
  void lose_order();
  /// FixMCAHistory::in_run(); false before the first set-up.
  bool in_run() const;
  /// After a command that made a new list of pairs: evaluates the laws as a set-up does, so that
  /// the present values are those of this list. Called by all ranks.
  void evaluate();
  /// Stops LAMMPS, naming the automata, where a place or velocity is nan or infinite, or one moves
  /// by more than half a diameter in a step, or where diameter or mass are not those of the
  /// material. Called by all ranks.
  void check_sample() const;

  /// The step itself, rows as LAMMPS's atoms: own ones, then ghosts. All values are in units of
  /// energy, length, time, mass; present after compute().
  mca::Step &step() { return mca_step; }
  /// The pairs of this rank; made anew in each set-up and whenever LAMMPS builds its neighbor list.
  mca::LinkList &links() { return mca_step.links(); }
  /// As given by pair_coeff, in the units of the input script.
  /// \param type  1 to atom->ntypes; not checked, here and below
  const mca::Material &material(int type) const { return materials[type]; }
  /// What types have of their own where they meet, likewise.
  const mca::Interfaces &all_interfaces() const { return interfaces; }
  /// The laws of the last pair_style command or restart file.
  const mca::LawSet &laws() const { return lawset; }
  /// h of the discs [length]; 1 where it was not given, and in space, where nothing depends on it.
  double thickness() const { return depth > 0.0 ? depth : 1.0; }
  /// Packing, diameter and thickness of an automaton of this type, from which mass and area follow.
  /// After init_style(), when the packing is known.
  mca::Cell cell(int type) const;
  /// Mass of an automaton [mass]: the packing, not the disc, fixes it.
  double mass(int type) const;
  /// Its moment of inertia about its axis, in space about any [mass length^2].
  double inertia(int type) const;
  /// Speed of waves along a thin rod, sqrt(E/rho) [velocity].
  double wave_speed(int type) const;
  /// Whether a fix moves own automaton i by its velocity.
  bool is_integrated(int i) const;
  /// Whether the forces of contacts do not move own automaton i in y: a fix prescribes its motion,
  /// or none integrates it.
  bool is_held_in_y(int i) const;

  /// Values of a state of own and ghost automata, in LAMMPS's order of atoms; nullptr: not in this
  /// dimension. Valid until LAMMPS moves or adds atoms. When they are up to date stands in their
  /// table; those of ghosts are as of the last exchange.
  /// \param number  mca::stateNumber() of its name
  double *state(int number) const;
  /// Brings the states of mca::Upkeep::Collected, broken and formed, up to date.
  void collect_changes();

  /// Stresses of an owned automaton in pressure units, its energy in energy units; valid after
  /// compute().
  mca::Step::Automaton automaton(int) const;
  /// Stresses of pair k in pressure units; valid after compute().
  mca::ContactStress contact(int k) const;
  /// Plastic work of an owned automaton since the beginning [energy]: V times the area below its
  /// yield curve up to kappa.
  double plastic_work(int) const;

  /// Sums of this rank, whose sum over all ranks is that of the sample: links and welds now, links
  /// broken, formed and healed since the pair style was created. Pairs of two ranks count half on
  /// each.
  struct Count : mca::Step::Count {
    /// Plastic work of its automata since the beginning [energy].
    double plastic_work;
  };
  /// Present after compute(); every rank for itself.
  Count count() const;

  /// A pair that changed its kind: a link that broke, formed or healed. It is listed by one rank
  /// only, that of its first automaton, so that it is once in the sample.
  struct Event {
    /// The last step in the old kind, in which the criterion was met.
    bigint step;
    /// IDs of both automata, those of the pair's first and second.
    tagint tag[2];
    /// Their types.
    int type[2];
    /// Kinds of mca::link.
    double before, after;
    /// Middle of the pair [length], folded into the box.
    double x[3];
    /// Groups of both automata, bits.
    int mask[2];
  };
  /// Events of the step before this one, on this rank; from commit() of a step to that of the next.
  const std::vector<Event> &last_events() const { return happened; }

 protected:
  mca::LawSet lawset;
  /// nullptr until it is known: the default depends on the dimension.
  const mca::Packing *packing;
  /// Thickness of the discs [length], 0: not given.
  double depth;
  /// Cutoff [length] as given, 0: by default.
  double cut_user;
  /// By type, [0] unused, in the units of the input script.
  std::vector<mca::Material> materials;
  /// What pairs of types have of their own, in the units of the input script.
  mca::Interfaces interfaces;

  mca::Step mca_step;
  /// Outlives the step's use of it; built by begin_list() on several ranks.
  mca::Halo halo;
  /// What the last line of trace_messages() was about.
  mca::Halo::Sent traced;
  bigint traced_step = 0;
  /// Groups, as bits, whose automata a fix moves by their forces; and otherwise: in all components,
  /// in y, in rotation.
  int integrated, held, held_in_y, held_spins;
  /// Taken over in this step.
  std::vector<Event> happened;
  /// Owned by LAMMPS; nullptr before the first init_style().
  FixMCAHistory *fix_history;
  /// The others, likewise; spins only with laws that see them.
  Fix *fix_state, *fix_spins;
  /// Checksum of the restart file that is being written.
  mca::FileSeal seal;
  /// What the material of each type gave at the last set-up; empty before the first.
  std::vector<double> last_diameters, last_masses;
  /// Warnings were given; that of stresses, too, which are known after the first forces.
  bool told, told_of_stress;
  /// Columns of the states among LAMMPS's custom values; -1: none. Found anew before each run.
  int columns[mca::stateCount];

  void allocate();
  /// The packing by default; refuses laws that do not act in this dimension.
  void choose_packing();
  /// The material of a type in the units of the step: a stress is an energy per volume, a density
  /// times a squared velocity, too.
  mca::Material material_inside(int type) const;
  /// What two types have of their own, likewise.
  mca::Interface interface_inside(int typeI, int typeJ) const;
  /// The strength of links of two types [pressure]: of their interface, or of the weaker material.
  double strength(int typeI, int typeJ) const;
  /// Of a restart file.
  void read_interfaces(FILE *);
  /// Reads pair_coeff: the words behind I J interface.
  void coeff_interface(int narg, char **arg);
  /// The tables of laws.
  void make_laws();
  /// For setup() and reset_dt(): checks against the critical step of each material under these
  /// laws.
  void check_step();
  /// Refuses minimize, rerun and fixes that move automata without their velocities: the shear of
  /// links follows only motion in a run.
  void check_commands() const;
  /// Whose velocities follow from the forces of contacts, as viscous forces need to know.
  void find_held();
  /// A pair for messages: IDs, distance of the images that meet, mean diameter [length].
  struct PairPlace {
    tagint ids[2];
    double distance, diameter;
  };
  /// On all ranks, called by them.
  /// \param k     a pair of the rank that knows it
  /// \param rank  that one
  PairPlace place_of(int k, int rank) const;
  /// Stops LAMMPS where automata overlap.
  void check_overlap() const;
  /// Warnings of what is hardly meant: links that are missing, integrators other than fix nve/mca,
  /// materials of other units, diameters and densities that the material replaces, stress.
  void warn_of_links() const;
  /// After the first forces of a sample that is new: a pair is stressed above the strength. Called
  /// by all ranks.
  void warn_of_stress() const;
  void warn_of_integrators() const;
  void warn_of_wave_speed() const;
  void warn_of_strength() const;
  void warn_of_sizes() const;
  /// Keeps what materials give, once the packing is known.
  void keep_sizes();
  /// Radius and mass of own automaton i, those of its material.
  void set_size(int i);
  /// Stops LAMMPS, naming an automaton, where something else has changed them in a run.
  void check_sizes() const;
  /// Looks up the states among LAMMPS's custom values by name.
  void find_columns();
  /// Pressure units in an energy per volume [-], force->nktv2p.
  double stress_unit() const;
  /// LAMMPS's arrays as they are now, for one call.
  mca::Automata automata() const;
  /// To atom->f and atom->torque of own atoms, which hold what others have added.
  void add_forces();
  /// With what rows and pairs of this list stand for, before it changes.
  void record_events();
  /// Energy of owned automata, virials of pairs, the vector of compute pair; only in steps that ask
  /// for them.
  void tally();
};

} // namespace LAMMPS_NS

#endif
