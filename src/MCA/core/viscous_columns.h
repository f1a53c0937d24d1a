// SPDX-License-Identifier: GPL-2.0-or-later
/// \file viscous_columns.h
/// The viscous contacts of a step as the kernel's passes over them see them. ViscousContacts owns
/// the columns. No LAMMPS type in here.
#ifndef MCA_VISCOUS_COLUMNS_H
#define MCA_VISCOUS_COLUMNS_H

#include "row_view.h"

namespace mca {

/// What loops over viscous contacts know of their step.
struct ViscousStep {
  RowView rows;        ///< motion in the rows where pairs meet; sums of forces and answers
  const PairLaw *laws; ///< table of PairLaw, indexed by Pairs::law
  bool oneLaw;         ///< the table has one entry
  // read where velocities are centred only
  double dt;                       ///< [time]
  const int *groups;               ///< bits of each automaton
  int integrated, held, heldSpins; ///< as Automata of step.h has them
};

/// The viscous contacts of a step, a value each, in the order of the list of pairs. A view.
struct ViscousColumns {
  int n;
  const int *pair; ///< number in the list; three more are read
  double *slip[3]; ///< slip velocity of the second automaton [length/time]; z in space only
  /// What a contact adds to its first automaton [force, force length]: the change of its normal
  /// force, and of its resistance to slip with the torque. Rows as RowLayout::Force has them from
  /// `force` on; the former without torques.
  double *normal, *along;
};

} // namespace mca

#endif
