// SPDX-License-Identifier: GPL-2.0-or-later
/// \file viscous_contacts.h
/// The viscous forces of a step with the velocities of that step: the force pass knows those of
/// half a step ago. No LAMMPS type in here.
#ifndef MCA_VISCOUS_CONTACTS_H
#define MCA_VISCOUS_CONTACTS_H

#include "kernel.h"

#include <vector>

namespace mca {

/// The viscous contacts of a step, which few pairs are. First all are collected, while the forces
/// are still those of the force pass; then what their velocities change is added to these.
class ViscousContacts {
 public:
  /// What a step knows of its automata, in rows as the kernel has them.
  struct Conditions {
    const Kernel *kernel;
    double dt; ///< [time]
    const PairLaw *laws;
    const double *response;
    const double *forces; ///< of the force pass, complete on both automata of a pair
    const int *groups;    ///< bits of each automaton
    /// Automata with a bit of `integrated` and none of `held` follow the forces; the others keep
    /// their velocity, whatever acts on them.
    int integrated, held;
  };

  void clear() { contacts_.clear(); }

  /// Collects the viscous ones of these pairs, and centres their velocities Pairs::separation.
  void add(const Pairs &, const Conditions &);

  void addForces(const Kernel &, double *forces) const;

 private:
  struct Contact {
    int i, j;
    double force[3]; ///< on i
  };
  std::vector<Contact> contacts_;
};

} // namespace mca

#endif
