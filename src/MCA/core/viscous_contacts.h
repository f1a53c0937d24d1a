// SPDX-License-Identifier: GPL-2.0-or-later
/// \file viscous_contacts.h
/// The viscous forces of a step with the velocities of that step: the force pass knows those of
/// half a step ago. No LAMMPS type in here.
/// Equations: doc/laws.md, Corrected steps; centredSeparation() of laws/viscosity.h. Only with
/// steps corrected and a viscosity, see LawSet::centresViscosity().
#ifndef MCA_VISCOUS_CONTACTS_H
#define MCA_VISCOUS_CONTACTS_H

#include "kernel.h"

#include <algorithm>
#include <vector>

namespace mca {

/// Whether pair k of a block is a viscous contact in this step: pressed, e < 0, and unlinked or
/// breaking. After the force pass; no block of bulk links that none of its pairs leaves has one.
inline bool isViscous(const Pairs &p, const Block &block, int k)
{
  const double next = block.moves ? p.next.kind[k] : p.now.kind[k];
  return !(link::isLinked(p.now.kind[k]) & link::isLinked(next)) &
         (p.eps[k] - p.now.plastic[k] < 0.0);
}

/// Calls visit(k) for each viscous contact of this step, in the order of the pairs.
template<class Visit>
void eachViscous(const Pairs &p, Visit &&visit)
{
  for (int first = 0; first < p.n; first += blockLength) {
    const Block &block = p.blocks[first / blockLength];
    if (block.bulk && !block.moves)
      continue;
    const int last = std::min(first + blockLength, p.n);
    for (int k = first; k < last; k++)
      if (isViscous(p, block, k))
        visit(k);
  }
}

/// The viscous contacts of a step, which few pairs are. First all are collected, while the forces
/// are still those of the force pass; then what their velocities change is added to these. The
/// order within a step is clear(), add() for each part of the list, addForces().
class ViscousContacts {
 public:
  /// What a step knows of its automata, in rows as the kernel has them.
  struct Conditions {
    /// Of this dimension; its row lengths are those of the arrays below.
    const Kernel *kernel;
    double dt; ///< [time]
    /// Table of PairLaw, indexed by Pairs::law.
    const PairLaw *laws;
    /// Rows of what automata answer.
    const double *response;
    const double *forces; ///< of the force pass, complete on both automata of a pair
    const int *groups;    ///< bits of each automaton
    /// Automata with a bit of `integrated` and none of `held` follow the forces; the others keep
    /// their velocity, whatever acts on them.
    int integrated, held;

    /// What automaton i answers.
    Answer answer(int i) const
    {
      const RowLayout::Response &at = kernel->rows.response;
      const double *row = response + static_cast<size_t>(i) * at.length;
      return {row[at.mean], row[at.factor], row[at.centre]};
    }

    /// 1 for an automaton that follows the forces, else 0.
    double follows(int i) const
    {
      return (groups[i] & integrated) && !(groups[i] & held) ? 1.0 : 0.0;
    }
  };

  /// Forgets the contacts of the last step.
  void clear() { contacts_.clear(); }

  /// Collects the viscous ones of these pairs, and centres their velocities Pairs::separation.
  /// Viscous are contacts that are pressed, e < 0, and unlinked or break in this step. Called after
  /// the force pass of all pairs, as it needs the whole force on both automata.
  void add(const Pairs &, const Conditions &);

  /// Adds to both automata of each contact what the centred velocity changes of its force.
  /// \param forces  rows.force.length values an automaton [force]
  void addForces(const Kernel &, double *forces) const;

 private:
  /// A viscous contact: rows of both automata and the change of its force.
  struct Contact {
    int i, j;
    /// Change of the force on i [force]; that on j is its opposite, since viscosity acts along the
    /// normal and there is no torque.
    double force[3];
  };
  std::vector<Contact> contacts_;
};

} // namespace mca

#endif
