// SPDX-License-Identifier: GPL-2.0-or-later
/// \file flat.h
/// LAMMPS's arrays of vectors without their row pointers, which would be one more load for each
/// automaton in the loops that every step runs.
#ifndef MCA_FLAT_H
#define MCA_FLAT_H

namespace mca {

/// x, v, f, omega or torque of class Atom as n x 3 doubles that follow each other; LAMMPS allocates
/// them so. Valid until LAMMPS grows the array.
/// \return nullptr where the atom style has no such array
inline double (*flat(double **array))[3]
{
  return array ? reinterpret_cast<double(*)[3]>(array[0]) : nullptr;
}

} // namespace mca

#endif
