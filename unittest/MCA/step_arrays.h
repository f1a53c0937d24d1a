// SPDX-License-Identifier: GPL-2.0-or-later
/// \file step_arrays.h
/// The automata of a sample in the arrays that a step reads, in LAMMPS's place.
#ifndef STEP_ARRAYS_H
#define STEP_ARRAYS_H

#include "core/step.h"

#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): compiler-made, to copy arrays
struct StepArrays {
  static constexpr int all = 1, held = 2; ///< bits of groups
  using Vector = double[3];
  std::vector<double> places, velocities, spins; ///< three values each
  std::vector<int> types, groups;
  std::vector<double> kappa, lag[3], rest[3], spinLag[3], spinRest[3];

  /// Of n rows, all values 0 and every automaton moved by its forces.
  explicit StepArrays(size_t n = 0)
      : places(3 * n), velocities(3 * n), spins(3 * n), types(n), groups(n, all), kappa(n)
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
    return {x(),
            v(),
            omega(),
            groups.data(),
            all,
            held,
            kappa.data(),
            {lag[0].data(), lag[1].data(), lag[2].data()},
            {rest[0].data(), rest[1].data(), rest[2].data()},
            {spinLag[0].data(), spinLag[1].data(), spinLag[2].data()},
            {spinRest[0].data(), spinRest[1].data(), spinRest[2].data()}};
  }
};

#endif
