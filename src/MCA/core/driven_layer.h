// SPDX-License-Identifier: GPL-2.0-or-later
/// \file driven_layer.h
/// Mechanics of the layer that fix mca/drive drives: one rigid body with a prescribed velocity in x
/// and a constant pressure in y, which neither moves in z nor rotates. No LAMMPS type in here.
#ifndef MCA_DRIVEN_LAYER_H
#define MCA_DRIVEN_LAYER_H

#include <vector>

namespace mca {

/// The layer as one rank has it. Where ranks share it, each pulls for its own automata, and the sum
/// of all pulls goes to carry().
struct DrivenLayer {
  /// Rows of own automata, in an order that is always the same: that of all sums.
  std::vector<int> members;
  double area = 0.0;       ///< nominal contact area A [length^2], > 0; of the whole layer
  double mass = 0.0;       ///< of the whole layer [mass], > 0
  double stressUnit = 1.0; ///< pressure units in an energy per volume [-]

  /// The automata as their owner keeps them, for one call; rows as in `members`.
  struct Arrays {
    double (*v)[3];      ///< velocities [length/time]
    double (*f)[3];      ///< forces [force]
    double (*omega)[3];  ///< angular velocities [1/time]
    double (*torque)[3]; ///< [force length]
    const double *mass;  ///< [mass]
  };

  /// Sums over automata of the layer: forces in x and y [force], momentum in y [mass velocity].
  struct Pull {
    double x = 0.0, y = 0.0, momentum = 0.0;
  };
  /// Pull on this rank's automata.
  Pull pull(const Arrays &) const;

  /// Stresses on the layer [pressure]: tau = -sum F_x/A, sigma_n = sum F_y/A.
  struct Stress {
    double shear = 0.0, normal = 0.0;
  };
  /// \param pull  of this rank for its part, of all for the whole
  Stress stress(const Pull &pull) const;

  /// What drives it now.
  struct Load {
    double velocity = 0.0; ///< in x [velocity]
    double pressure = 0.0; ///< in -y [pressure], >= 0
  };
  /// Makes the forces and velocities of this rank's automata those of the rigid body: the same
  /// acceleration in y from all forces and the pressure, the mean velocity in y, the prescribed one
  /// in x, nothing else.
  /// \param whole  sum of the pulls of all ranks
  void carry(const Arrays &, const Pull &whole, const Load &) const;

  /// Work of the drive in a step [energy].
  /// \param shear     on the layer, or this rank's part of it [pressure]
  /// \param velocity  in x [velocity]
  double work(double shear, double velocity, double dt) const
  {
    return shear * area / stressUnit * velocity * dt;
  }
};

} // namespace mca

#endif
