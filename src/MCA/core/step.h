// SPDX-License-Identifier: GPL-2.0-or-later
/// \file step.h
/// One evaluation of the laws of a sample: from places, velocities and the present state of
/// automata and pairs to forces, torques and the next state.
///
/// Rank by rank: a step knows the automata that its rank owns, which are the first rows, and the
/// guests, which others own; what these answer comes through an Exchange. It owns its rows, which
/// are plain arrays of stated length, the list of pairs and the tables of laws, and keeps no
/// pointer to what it is given. No LAMMPS type in here.
///
/// Invariants:
/// - The forces are a pure function of places, velocities and the present state. What flow,
///   fracture and linking change goes to the next state, which commit() makes the present one. So a
///   restarted run computes the forces of its first step again, to the last bit.
/// - Sums are taken in the order of the list of pairs. A list in the same order gives the same
///   sums, whatever the order of LAMMPS's atoms and neighbors.
/// - A pair of two ranks is in the list of both, with the same first automaton, and both decide
///   alike on its next state.
///
/// One consistent set of units, in which a stress is an energy per volume and mass times
/// acceleration a force; dimensions stand in brackets.
#ifndef MCA_STEP_H
#define MCA_STEP_H

#include "contact_friction.h"
#include "exchange.h"
#include "kernel.h"
#include "law_tables.h"
#include "laws/elasticity.h"
#include "laws/vector.h"
#include "link_list.h"
#include "row_spans.h"
#include "row_view.h"
#include "viscous_contacts.h"

#include <utility>
#include <vector>

namespace mca {

/// The automata as their owner keeps them, for one call. Vectors have three components, also in the
/// plane, where z of places and velocities and x, y of spins are not read. Own automata are the
/// rows 0 to own - 1; behind them come those of guests and images, as LAMMPS's ghosts do. All
/// belong to the caller.
struct Automata {
  const double (*x)[3];     ///< places [length], of all rows
  const double (*v)[3];     ///< velocities [length/time], of all rows
  const double (*omega)[3]; ///< angular velocities [1/time], of all rows
  /// Bits of LAMMPS's groups, of all rows; read where viscous contacts are centred.
  const int *groups;
  /// Automata with a bit of `integrated` and none of `held` follow the forces, with none of
  /// `heldSpins` the torques; the others keep their velocities, whatever acts on them.
  int integrated, held, heldSpins;
  /// Equivalent plastic strain [-], of own automata; read by run(), written by commit().
  double *kappa;
  /// Normal strains that broken links left to the mean stress [-], >= 0; as kappa. Read with
  /// plasticity isochoric only.
  double *kept;
  /// By how much the velocities differ from those that the present forces saw, which are of half a
  /// step before: `lag`, and `rest`, what rounding took from it [length/time]. One array a
  /// dimension, of all rows. Written by keepLag(), read in set-up.
  double *lag[3], *rest[3];
  /// Lag and rest of the angular velocities [1/time], where laws see slip; else, and of the
  /// components that a dimension does not have, nullptr.
  double *spinLag[3], *spinRest[3];
};

/// The step of one rank. Order of calls: setLaws(), setExchange(); for each new list
/// links().reset() and add(), then begin(); then run() for set-up and for each step, commit() by
/// run() or, before the list changes, by the caller. What it answers is of the last run(). Rows and
/// pairs are numbered from 0; numbers of pairs are not checked.
class Step {
 public:
  /// \param dimension  2 or 3; all but 2 counts as space
  /// \param kernel     of this dimension; nullptr: the fastest that this processor runs
  explicit Step(int dimension, const Kernel *kernel = nullptr);

  /// 2 or 3.
  int dimension() const { return kernel_->dimension; }

  // ---- what it is made of

  /// Replaces the laws, before begin(). The list of pairs holds numbers of their entries: it has to
  /// be made anew where their number or order changes.
  /// \param tables  in units in which a stress is an energy per volume
  void setLaws(LawTables tables);
  const LawTables &laws() const { return laws_; }

  /// \param exchange  outlives the step; without a call the step is alone. Before the begin() of
  ///                  the list that has guests
  void setExchange(Exchange &exchange) { exchange_ = &exchange; }
  Exchange &exchange() const { return *exchange_; }

  /// The list of pairs, with their present and next states.
  LinkList &links() { return links_; }
  const LinkList &links() const { return links_; }

  /// The list was made anew, of present states. What the old one led to is dropped: it was taken
  /// over by commit() and takeChanges(), or is found again in set-up. Sizes all rows; sums come
  /// with the next run().
  /// \param own     automata of this rank
  /// \param all     rows with those of guests and periodic images, at which pairs may meet
  /// \param types   of own automata, numbers in the tables of laws; copied
  /// \param border  so many first pairs may have guests; the others wait for no message. Rounded up
  ///                to whole blocks
  void begin(int own, int all, const int *types, int border);

  /// Rows of own automata, of the present list.
  int own() const { return static_cast<int>(types_.size()); }

  /// Rows that are in pairs: of own automata, and unless the step is alone of all others.
  int rows() const { return response_.rows(); }

  /// No list was made yet.
  bool empty() const { return !begun_; }

  // ---- what it does

  /// One evaluation; called by all ranks, with the same dt and advance.
  /// \param dt       the step [time], > 0; CriticalStep says how long it may be, which is not
  ///                 checked here
  /// \param advance  true: the automata have moved by dt, and what the last evaluation led to
  ///                 becomes present. false: set-up, the same forces as before: velocities less lag
  ///                 and rest, and no shear grows
  void run(const Automata &, double dt, bool advance);

  /// Makes the next state of the automata the present one and finds the pairs that change their
  /// kind. The pairs themselves go on by LinkList::advance() or a new list. run() does it with
  /// advance; a caller does it first where it needs changes() or will make the list anew.
  /// \return false if this was done since the last run(); then nothing changes
  bool commit(const Automata &);

  /// After a step: writes lag and rest of own automata, velocity now less the one that the forces
  /// saw. The rest is what the subtraction rounded off, so that v - lag - rest is that velocity
  /// exactly.
  void keepLag(const Automata &) const;

  /// A pair whose kind changed, linked before or after or both: a break, a new link, or one that
  /// healed.
  struct Change {
    int pair;
    double before, after; ///< kinds
  };
  /// By the last commit(); until the next one. Pairs of two ranks are in the lists of both, see
  /// isOurs().
  const std::vector<Change> &changes() const { return changed_; }

  /// Adds the links broken and formed of each own automaton since the last call or begin(), and
  /// begins to count anew. Called before the list changes, else they are lost.
  /// \param broken,formed  of own automata, added to; a link counts at both of its ends
  void takeChanges(double *broken, double *formed);

  // ---- what it answers, of the last evaluation

  const RowLayout &layout() const { return kernel_->rows; }

  /// All rows of the last evaluation, for loops whose bounds are own() or rows(); not checked.
  RowView view() const;

  /// Rows with the forces and torques [force, force length] of own automata, as layout() says.
  /// Only the contacts' are in it; rows behind them hold parts that are not complete.
  const RowArray &forces() const { return sums_; }

  /// The state of automaton i in this evaluation. Stresses are energies per volume, tension
  /// positive.
  struct Automaton {
    StressTensor stress; ///< averaged, elastic, before the return [stress]
    double mean;         ///< mean stress [stress]
    /// By which it yields [stress]: of `stress`, in the plane with plasticity isochoric of
    /// flowStress().
    double intensity;
    /// Elastic energy [energy]; before the return, as the stress.
    double energy;
  };
  /// \throw std::out_of_range  not an own automaton; the same below
  Automaton automaton(int i) const;
  double energy(int i) const; ///< that of automaton(i), alone [energy]
  /// Force of all contacts on it [force]; z is 0 in the plane.
  Vector force(int i) const;
  /// Torque of all contacts on it [force length]; only z in the plane.
  Vector torque(int i) const;
  /// What broken links leave to the mean stress of own automaton i, in this step and from the next
  /// one on [-]; 0 but with plasticity isochoric.
  double kept(int i) const { return laws_.keepsVolume ? *kept_.row(i) : 0.0; }
  double keptNext(int i) const { return laws_.keepsVolume ? *keptNext_.row(i) : 0.0; }
  /// Number of its material in the tables of laws.
  int type(int i) const { return types_.at(i); }

  /// Plastic work [energy] of an automaton of this type that has flowed by kappa [-]: V times the
  /// area below the yield curve up to there.
  double plasticWork(int type, double kappa) const
  {
    return laws_.automata[type].curve.work(kappa) * laws_.volumes[type];
  }

  /// Where a row of a pair was [length]; of images, too. This and what follows to factor() is of
  /// all rows that are in pairs.
  /// \throw std::out_of_range  there is no such row
  Vector place(int row) const;
  Vector velocity(int row) const; ///< that the forces saw [length/time]
  Vector spin(int row) const;     ///< [1/time]
  double mean(int row) const;     ///< mean stress [stress]
  double factor(int row) const;   ///< M of the radial return [-]

  // of pair k
  const PairLaw &law(int k) const { return laws_.pairs[links_.pairs().law[k]]; }
  ContactStress contact(int k) const; ///< [stress]; shears are lengths of vectors in space
  /// Its viscous shear stress (viscosity both), which contact() has not [stress].
  Vector slipStress(int k) const;
  /// Elastic shear of its friction, perpendicular to the normal [-]: before it slides, or (next)
  /// what it holds, which makes the force; 0 of a contact without.
  Vector frictionShear(int k, bool next) const;
  Vector contactForce(int k) const;            ///< on its first automaton [force]
  Vector normal(int k) const;                  ///< unit vector to its second automaton [-]
  Vector alongShear(int k, double size) const; ///< of this size, along the shear
  double shear(int k) const;                   ///< elastic shear [-]
  double totalShear(int k) const;              ///< since linking, not reduced by plasticity [-]
  double distance(int k) const;                ///< [length]

  /// 1, or 1/2 for a pair that two ranks hold.
  double share(int k) const;

  /// Whether a pair counts here; of one that two ranks hold, true on one of them.
  bool isOurs(int k) const;

  /// Numbers on this rank; pairs that two ranks hold count half on each.
  struct Count {
    double links = 0.0, welds = 0.0;                 ///< at present
    double broken = 0.0, formed = 0.0, healed = 0.0; ///< since the beginning, see goOn()
  };
  Count count() const;
  /// Events are counted on from these; without a call from 0. Links and welds are not read.
  void goOn(const Count &events)
  {
    events_ = {0.0, 0.0, events.broken, events.formed, events.healed};
  }

  double bytes() const;

 private:
  const Kernel *usual_, *kernel_; // of the dimension; of the laws
  Exchange *exchange_;
  LawTables laws_;
  LinkList links_;
  int border_ = 0; // so many first pairs may have guests; whole blocks
  bool begun_ = false, committed_ = false;
  std::vector<int> types_;

  RowArray motion_, spin_;                             // of all rows
  RowArray strains_, response_, sums_, taken_, local_; // of rows that are in pairs
  RowArray kappaNext_, kept_, keptNext_;               // of own automata
  RowArray linkChanges_; // broken and formed of own automata, since takeChanges()
  RowSpans spans_;
  // of each span: its automata may flow; lack room; may have something kept, now or next; the
  // return pass adds to them
  std::vector<char> flows_, crowded_, keeps_, touched_;
  // Sums of e^2 + gamma^2 over the contacts of own automata [-], found when they are asked for.
  mutable RowArray squares_;
  mutable bool squaresKnown_ = false;
  ViscousContacts viscous_;
  ContactFriction friction_;

  double changing_ = 0.0; // pairs whose next state is another kind; 0 after commit()
  std::vector<Change> changed_;
  Count events_; // links and welds stay 0

  void packMotion(const Automata &, bool advance);
  void packPlane(const Automata &, bool advance);
  void packSpace(const Automata &, bool advance);
  double &spinOf(int row, int component);
  void findMeans();
  void findSquares() const;
  void findReturns(const Automata &);
  bool yield(const double *kappa, bool flowed, int from, int to);
  void clearTaken();
  void addKept(const double *kept);
  void findKept();
  void leaveStrains();
  void yieldAgain(const Automata &, const Pairs &border, const Pairs &inside);
  const double *showLocal(const Automata &);
  void centreViscosity(const Pairs &, const ViscousStep &);
  void rub(double dt, bool moves);
  void findChanges();
};

} // namespace mca

#endif
