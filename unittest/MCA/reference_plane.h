// SPDX-License-Identifier: GPL-2.0-or-later
/// \file reference_plane.h
/// Slow, obvious MCA in the plane: one struct an automaton, one a contact, plain loops, the
/// trigonometry of the textbook. It is written from the equations, not from the kernel, which is
/// held against it.
#ifndef REFERENCE_PLANE_H
#define REFERENCE_PLANE_H

#include "reference_laws.h"

#include <vector>

namespace reference {

/// All quantities in one consistent set of units.
struct Automaton {
  double x = 0, y = 0, vx = 0, vy = 0, omega = 0;
  int type = 0;          ///< number in the table of materials
  bool held = false;     ///< keeps its velocity, whatever acts on it
  bool heldSpin = false; ///< keeps its angular velocity, likewise
  double kappa = 0, kept = 0;

  // results of a step; forces and torque are those of all contacts
  double mean = 0, xx = 0, yy = 0, xy = 0, zz = 0, intensity = 0, factor = 1, kappaNext = 0;
  double centre = 0, trace = 0, work = 0, flowing = 0;
  double taken = 0, room = 0, left = 0, keptNext = 0; ///< room, strain that broken links left
  double energy = 0, fx = 0, fy = 0, torque = 0;
};

/// Kind: 0 unlinked, 1 bulk link, 2 weld, -1 unlinked and not yet unloaded since its link broke.
struct State {
  double kind = 0, plastic = 0, gamma = 0, gammaTotal = 0;
};

struct ReferenceContact {
  int i = 0, j = 0;
  State now, next;
  double speed = 0; ///< normal velocity of j seen from i that its viscosity sees
  double slip = 0;  ///< and of its surface along t
};

/// Automata beyond the first `owned` are periodic images: `owner` names their original, whose
/// contacts they share; their positions are the original's plus the shift.
struct Sample {
  std::vector<mca::Material> materials;
  mca::LawSet laws;
  double thickness = 1.0;

  std::vector<Automaton> automata;
  std::vector<ReferenceContact> contacts;
  int owned = 0;
  std::vector<int> owner;
  std::vector<double> shiftX, shiftY;

  int changed = 0; ///< result of a step: links that break, form or heal

  /// Appends an automaton of our own.
  void add(const Automaton &);

  /// Appends an image of automaton i.
  void addImage(int i, double sx, double sy);

  /// Brings the images' state to that of their originals.
  void updateImages();
};

/// One evaluation of the laws: takes over the next state when dt > 0, moves the shear on by dt,
/// then yielding, forces and the next state. Velocities are those of dt/2 before the positions.
void step(Sample &, double dt);

} // namespace reference

#endif
