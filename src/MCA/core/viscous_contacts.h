// SPDX-License-Identifier: GPL-2.0-or-later
/// \file viscous_contacts.h
/// The viscous forces of a step with the velocities of that step: the force pass knows those of
/// half a step ago. No LAMMPS type in here.
/// Equations: doc/laws.md, Corrected steps; centredSeparation() of laws/viscosity.h. Only with
/// steps corrected and a viscosity, see LawSet::centresViscosity().
#ifndef MCA_VISCOUS_CONTACTS_H
#define MCA_VISCOUS_CONTACTS_H

#include "pairs.h"
#include "row_view.h"

#include <vector>

namespace mca {

/// The numbers of the viscous pairs of a step, in the order of the list: pressed and
/// unlinked or breaking.
class ViscousPairs {
 public:
  /// Finds the viscous contacts of all pairs, after their force pass.
  void find(const Pairs &);

  /// A range of them, for loops.
  struct Range {
    const int *first, *last;
    const int *begin() const { return first; }
    const int *end() const { return last; }
    int size() const { return static_cast<int>(last - first); }
  };
  Range all() const { return {numbers_.data(), numbers_.data() + numbers_.size()}; }
  Range before(int pair) const; ///< those of lower number than this pair
  Range from(int pair) const;   ///< this pair and those behind it

 private:
  std::vector<int> numbers_;
};

/// The viscous contacts of a step, which few pairs are. First all are collected, while the forces
/// are still those of the force pass; then what their velocities change is added to these. The
/// order within a step is clear(), add() for each part of the list, addForces().
class ViscousContacts {
 public:
  /// What a step knows of its automata.
  struct Conditions {
    /// With the forces of the force pass, complete on both automata of a pair.
    RowView rows;
    double dt; ///< [time]
    /// Table of PairLaw, indexed by Pairs::law.
    const PairLaw *laws;
    const int *groups; ///< bits of each automaton
    /// Automata with a bit of `integrated` and none of `held` follow the forces; the others keep
    /// their velocity, whatever acts on them.
    int integrated, held;

    /// 1 for an automaton that follows the forces, else 0.
    double follows(int i) const
    {
      return (groups[i] & integrated) && !(groups[i] & held) ? 1.0 : 0.0;
    }
  };

  /// Forgets the contacts of the last step.
  void clear() { changes_.clear(); }

  /// Collects these viscous pairs, and centres their velocities Pairs::separation. Called after
  /// the force pass of all pairs, as it needs the whole force on both automata.
  void add(const Pairs &, ViscousPairs::Range, const Conditions &);

  /// Adds to both automata of each contact what the centred velocity changes of its force.
  /// \param forces  rows.force.length values an automaton [force]
  void addForces(const RowLayout &, double *forces) const;

 private:
  /// Rows of both automata of a viscous contact and the change of its force.
  struct Change {
    int i, j;
    /// Change of the force on i [force]; that on j is its opposite, since viscosity acts along the
    /// normal and there is no torque.
    double force[3];
  };
  std::vector<Change> changes_;
};

} // namespace mca

#endif
