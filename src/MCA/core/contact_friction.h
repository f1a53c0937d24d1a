// SPDX-License-Identifier: GPL-2.0-or-later
/// \file contact_friction.h
/// The friction of a step (keyword friction): what unlinked contacts that are pressed add along
/// their tangent to the forces, by springs that stick or slide. One code for the plane and for
/// space, and without a cost where no law has friction. No LAMMPS type in here.
/// Equations: doc/laws.md, Friction; laws/coulomb.h.
#ifndef MCA_CONTACT_FRICTION_H
#define MCA_CONTACT_FRICTION_H

#include "link_list.h"
#include "row_view.h"
#include "viscous_contacts.h"

#include <vector>

namespace mca {

/// The springs of an evaluation, which LinkList keeps from one to the next. As with the shear of
/// links the present state is what the motion of the step made of a spring, the next one what
/// friction holds of it, and the force is that of the latter.
class ContactFriction {
 public:
  /// Moves the springs on and finds what each contact holds; springs of contacts that do not touch
  /// any more let go. A contact that becomes a link gives it its spring as its shear, so that the
  /// force goes on.
  /// \param touching  pairs that are pressed and unlinked, in the order of the list
  /// \param rows      with the answers of all automata; motion in the rows where pairs meet
  /// \param laws      table of PairLaw, indexed by Pairs::law
  /// \param own       automata whose energies are asked for
  /// \param dt        [time]
  /// \param moves     false keeps the present springs as they are (set-up)
  void find(LinkList &, const ViscousContacts &touching, const RowView &rows, const PairLaw *laws,
            int own, double dt, bool moves);

  /// Adds forces and torques of all springs to both of their automata.
  /// \param forces  rows.force.length values an automaton
  void addForces(const LinkList &, const RowLayout &rows, const PairLaw *laws,
                 double *forces) const;

  /// No contact rubs.
  void clear() { energies_.clear(); }

  /// Elastic energy of half of each spring of own automaton i [energy], before it slides.
  double energy(int i) const { return energies_.empty() ? 0.0 : energies_[i]; }

  /// Memory held [bytes].
  double bytes() const { return static_cast<double>(energies_.capacity() * sizeof(double)); }

 private:
  std::vector<double> energies_; // by own automaton
};

/// The spring of pair k as a vector [-], perpendicular to its normal; 0 without one.
/// \param next  of the next state, else of the present one
Vector springOf(const LinkList &, int k, bool plane, bool next);

} // namespace mca

#endif
