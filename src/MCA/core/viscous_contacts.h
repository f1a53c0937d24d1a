// SPDX-License-Identifier: GPL-2.0-or-later
/// \file viscous_contacts.h
/// The viscous contacts of a step: pairs that are pressed and unlinked or breaking. What they add
/// to the forces of the force pass: resistance to slip with its torque (viscosity both), and in
/// corrected steps what the velocities of the step itself change, since the force pass knows those
/// of half a step ago. No LAMMPS type in here.
/// Equations: doc/laws.md, Viscosity and Corrected steps; laws/viscosity.h. The loops over contacts
/// are kernel_viscous.cpp, the columns that they fill are kept here.
#ifndef MCA_VISCOUS_CONTACTS_H
#define MCA_VISCOUS_CONTACTS_H

#include "kernel.h"
#include "row_array.h"

#include <vector>

namespace mca {

/// The order within a step is find(), resistSlip() where laws know it, then centre() of all
/// contacts, a range each, and addCentred().
class ViscousContacts {
 public:
  /// Finds them, after the force pass of all pairs.
  void find(const Kernel &, const Pairs &);

  /// Their slip velocities of half a step ago, which the force pass saw, and what resists these.
  /// \param forces  rows of sums, added to
  void resistSlip(const Kernel &, const Pairs &, const ViscousStep &, double *forces);

  /// Velocities at the time of the step, also Pairs::separation, of contacts first to last - 1.
  /// Forces stay as they are, since all contacts see the same ones.
  /// \param step    with the whole forces and torques of both automata that the velocities before
  ///                make
  /// \param slips   after resistSlip()
  void centre(const Kernel &, const Pairs &, int first, int last, bool slips, const ViscousStep &);

  /// Adds what the centred velocities change of the forces of both automata.
  /// \param border  so many first contacts were centred last
  /// \param forces  rows of sums, added to
  void addCentred(const Kernel &, const Pairs &, int border, bool slips, double *forces) const;

  int size() const { return columns_.n; }
  /// Numbers of the pairs, for loops.
  const int *begin() const { return numbers_.data(); }
  const int *end() const { return numbers_.data() + columns_.n; }
  /// How many of them have a lower number than this pair.
  int before(int pair) const;

  /// Slip velocity of pair k, after resistSlip() [length/time]; 0 of a pair that is none of them.
  Vector slip(int k, bool plane) const;

  /// Memory held [bytes].
  double bytes() const
  {
    return static_cast<double>(numbers_.capacity() * sizeof(int)) + values_.bytes();
  }

 private:
  std::vector<int> numbers_; // room for all pairs, three more than that are read
  AlignedArray values_;      // of the columns
  ViscousColumns columns_{};
};

} // namespace mca

#endif
