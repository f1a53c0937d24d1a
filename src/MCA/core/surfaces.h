// SPDX-License-Identifier: GPL-2.0-or-later
/// \file surfaces.h
/// Where the surfaces of a pair meet and how they move past each other in a step, for loops over
/// few pairs: vectors in space, whose third component is 0 in the plane. No LAMMPS type in here.
#ifndef MCA_SURFACES_H
#define MCA_SURFACES_H

#include "kernel.h"

namespace mca {

/// What a step knows of its automata, in rows as the kernel has them. Rows are those of `placeI`
/// and `placeJ`, where pairs meet.
struct Surfaces {
  const Kernel &kernel;
  const PairLaw *laws;  ///< by Pairs::law
  const double *motion; ///< rows.motion.length values an automaton
  const double *spin;   ///< angular velocities as the kernel has them [1/time]

  /// Unit normal of pair k, from its first to its second automaton [-].
  Vector normal(const Pairs &p, int k) const
  {
    return {p.normal[0][k], p.normal[1][k], plane() ? 0.0 : p.normal[2][k]};
  }

  /// From a centre to the contact point, r/2 [length].
  double arm(const Pairs &p, int k) const
  {
    return 0.5 * laws[p.law[k]].diameter * (1.0 + p.eps[k]);
  }

  /// Velocity of the second surface past the first, half a step ago [length/time]; slipOf().
  Vector slip(const Pairs &p, int k) const
  {
    const int i = p.placeI[k], j = p.placeJ[k];
    return slipOf(normal(p, k), velocity(j) - velocity(i), turning(i) + turning(j), arm(p, k));
  }

 private:
  bool plane() const { return kernel.dimension == 2; }
  const double *row(int i) const
  {
    return motion + static_cast<size_t>(i) * kernel.rows.motion.length;
  }
  Vector velocity(int i) const
  {
    const double *v = row(i) + kernel.rows.motion.velocity;
    return {v[0], v[1], plane() ? 0.0 : v[2]};
  }
  // in space the last component stands in an array of its own
  Vector turning(int i) const
  {
    const double *first = row(i) + kernel.rows.motion.spin;
    return plane() ? Vector{0.0, 0.0, spin[i]} : Vector{first[0], first[1], spin[i]};
  }
};

} // namespace mca

#endif
