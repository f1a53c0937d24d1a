// SPDX-License-Identifier: GPL-2.0-or-later
/// \file slip_viscosity.h
/// The viscous resistance to slip of a step (viscosity both): what unlinked contacts that are
/// pressed add along their tangent to the forces of the force pass, with its torque. One code for
/// the plane and for space, since few pairs are viscous. No LAMMPS type in here.
/// Equations: doc/laws.md, Viscosity and Corrected steps; laws/viscosity.h.
#ifndef MCA_SLIP_VISCOSITY_H
#define MCA_SLIP_VISCOSITY_H

#include "viscous_contacts.h"

#include <vector>

namespace mca {

/// The contacts of a step that resist slip. First all are found, with the velocities that the force
/// pass saw; then, in corrected steps, these are centred with the whole forces of both automata.
class SlipViscosity {
 public:
  /// Begins a step with its viscous pairs and their slip velocities of half a step ago.
  /// \param rows  motion is read, in the rows Pairs::placeI and placeJ, where pairs meet
  /// \param laws  table of PairLaw, indexed by Pairs::law
  void begin(const Pairs &, ViscousPairs::Range, const RowView &rows, const PairLaw *laws);

  /// The slip velocities at the time of the step.
  /// \param step  with the forces and torques, complete on both automata, that the velocities
  ///              before make
  void centre(const ViscousContacts::Conditions &step);

  /// Brings forces and torques of both automata of each contact up to its slip velocity.
  /// \param forces  rows.force.length values an automaton, added to
  void addForces(const RowLayout &, double *forces);

  /// Shear stress of pair k on the face of its first automaton [stress]; 0 where it resists none.
  Vector stress(int k) const;

  /// Memory held [bytes].
  double bytes() const { return static_cast<double>(contacts_.capacity() * sizeof(Sliding)); }

 private:
  /// A contact that resists slip.
  struct Sliding {
    int pair, i, j;   ///< number in the list, rows of both automata
    int law;          ///< number in the table of PairLaw
    double viscosity; ///< eta/d [stress time/length]
    double area;      ///< S [length^2]
    double arm;       ///< from a centre to the contact point, r/2 [length]
    Vector normal;    ///< from i to j [-]
    Vector slip;      ///< [length/time]
    Vector force;     ///< on i, that forces have already [force]
  };
  std::vector<Sliding> contacts_; // in the order of the list

  template<int Dimension>
  void addForces(const RowLayout::Force &, double *forces);
};

} // namespace mca

#endif
