// SPDX-License-Identifier: GPL-2.0-or-later
/// \file step_arrays.h
/// The automata of a sample in the arrays that a step reads, in LAMMPS's place.
#ifndef STEP_ARRAYS_H
#define STEP_ARRAYS_H

#include "core/step.h"

#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): compiler-made, to copy arrays
struct StepArrays {
  static constexpr int all = 1, held = 2, heldSpins = 4; ///< bits of groups
  using Vector = double[3];
  std::vector<double> places, velocities, spins; ///< three values each
  std::vector<int> types, groups;
  std::vector<double> kappa, kept, lag[3], rest[3], spinLag[3], spinRest[3];

  /// Arrays of n rows, all values 0 and every automaton moved by its forces.
  explicit StepArrays(size_t n = 0)
      : places(3 * n), velocities(3 * n), spins(3 * n), types(n), groups(n, all), kappa(n), kept(n)
  {
    for (auto *of : {lag, rest, spinLag, spinRest})
      for (int m = 0; m < 3; m++)
        of[m].resize(n);
  }

  Vector *x() { return reinterpret_cast<Vector *>(places.data()); }
  Vector *v() { return reinterpret_cast<Vector *>(velocities.data()); }
  Vector *omega() { return reinterpret_cast<Vector *>(spins.data()); }

  /// For one call.
  mca::Automata view()
  {
    mca::Automata a{};
    a.x = x();
    a.v = v();
    a.omega = omega();
    a.groups = groups.data();
    a.integrated = all;
    a.held = held;
    a.heldSpins = heldSpins;
    a.kappa = kappa.data();
    a.kept = kept.data();
    for (int m = 0; m < 3; m++) {
      a.lag[m] = lag[m].data();
      a.rest[m] = rest[m].data();
      a.spinLag[m] = spinLag[m].data();
      a.spinRest[m] = spinRest[m].data();
    }
    return a;
  }
};

#endif
