// SPDX-License-Identifier: GPL-2.0-or-later
/// \file reference_space.h
/// Slow, obvious MCA in space, the sibling of reference_plane.h: written from the equations with
/// the rotations of Eigen, not from the kernel, which is held against it.
#ifndef REFERENCE_SPACE_H
#define REFERENCE_SPACE_H

#include "reference_laws.h"

#include <Eigen/Dense>

#include <vector>

namespace reference::space {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// All quantities in one consistent set of units.
struct Automaton {
  Vector3d x{0, 0, 0}, v{0, 0, 0}, omega{0, 0, 0};
  int type = 0;          ///< number in the table of materials
  bool held = false;     ///< keeps its velocity, whatever acts on it
  bool heldSpin = false; ///< keeps its angular velocity, likewise
  double kappa = 0, kept = 0;

  // results of a step; force and torque are those of all contacts
  double mean = 0, intensity = 0, factor = 1, kappaNext = 0, energy = 0;
  double centre = 0;           ///< mean normal stress of the contacts that flow
  double sum = 0, flowing = 0; ///< normal strains, weights of the contacts that flow
  double taken = 0, room = 0, left = 0, keptNext = 0; ///< room, strain that broken links left
  double work = 0;                                    ///< plastic work per volume of the step
  Matrix3d stress = Matrix3d::Zero();
  Vector3d force{0, 0, 0}, torque{0, 0, 0};
};

/// Kinds as in the plane; the shears are perpendicular to the pair's axis.
struct State {
  double kind = 0, plastic = 0;
  Vector3d gamma{0, 0, 0}, gammaTotal{0, 0, 0};
};

struct ReferenceContact {
  int i = 0, j = 0;
  State now, next;
  double speed = 0;       ///< normal velocity of j seen from i that its viscosity sees
  Vector3d slip{0, 0, 0}; ///< and of its surface past that of i
};

/// Automata beyond the first `owned` are periodic images, as in the plane.
struct Sample {
  std::vector<mca::Material> materials;
  mca::LawSet laws;
  mca::Packing packing = mca::packing::fcc;

  std::vector<Automaton> automata;
  std::vector<ReferenceContact> contacts;
  int owned = 0;
  std::vector<int> owner;
  std::vector<Vector3d> shift;

  int changed = 0; ///< result of a step: links that break, form or heal

  void updateImages(); ///< brings the images' state to that of their originals
};

/// One evaluation of the laws: takes over the next state when dt > 0, moves the shear on by dt,
/// then yielding, forces and the next state. Velocities are those of dt/2 before the positions.
void step(Sample &, double dt);

} // namespace reference::space

#endif
