// SPDX-License-Identifier: GPL-2.0-or-later
/// \file reference_mca.h
/// Slow, obvious MCA: one struct an automaton, one a contact, plain loops, the trigonometry of the
/// textbook. It is written from the equations, not from the kernel, which is held against it.
#ifndef REFERENCE_MCA_H
#define REFERENCE_MCA_H

#include "laws/law_set.h"

#include <vector>

namespace reference {

/// All quantities in one consistent set of units.
struct Automaton {
  double x = 0, y = 0, vx = 0, vy = 0, omega = 0;
  int type = 0;      ///< number in the table of materials
  bool held = false; ///< keeps its velocity, whatever acts on it
  double kappa = 0;
  double elasticZ = 0; ///< elastic strain across the plane (plasticity j2)

  // results of a step; forces and torque are those of all contacts
  double mean = 0, xx = 0, yy = 0, xy = 0, zz = 0, intensity = 0, factor = 1, kappaNext = 0;
  double elasticZNext = 0, trace = 0, work = 0;
  double energy = 0, fx = 0, fy = 0, torque = 0;
};

/// Kind: 0 unlinked, 1 bulk link, 2 weld, -1 unlinked and not yet unloaded since its link broke.
struct State {
  double kind = 0, plastic = 0, gamma = 0, gammaTotal = 0;
};

struct Contact {
  int i = 0, j = 0;
  State now, next;
  double speed = 0; ///< normal velocity of j seen from i that its viscosity sees
};

/// Automata beyond the first `owned` are periodic images: `owner` names their original, whose
/// contacts they share; their positions are the original's plus the shift.
struct Sample {
  std::vector<mca::Material> materials;
  mca::LawSet laws;
  double thickness = 1.0;

  std::vector<Automaton> automata;
  std::vector<Contact> contacts;
  int owned = 0;
  std::vector<int> owner;
  std::vector<double> shiftX, shiftY;

  int changed = 0; ///< result of a step: contacts whose kind changes

  /// Appends an automaton of our own.
  void add(const Automaton &);

  /// Appends an image of automaton i.
  void addImage(int i, double shiftX, double shiftY);

  /// Brings the images' state to that of their originals.
  void updateImages();
};

// Laws of one number each, the same in the plane and in space.

double shearModulus(const mca::Material &);
double bulkModulus(const mca::Material &);

/// D of the force law.
double meanWeight(const mca::LawSet &, const mca::Material &);

/// Fig. 5 against plastic strain.
double yieldStress(const mca::Material &, double kappa);

/// The kind of a contact after a step in which it has these stresses and strains.
/// \param load  local stress of the criteria equivalent and drucker-prager, reduced to tension
/// \param work  plastic work per volume while pressed together
double nextKind(const mca::LawSet &, const mca::Material &, const mca::Material &, double kind,
                double sigma, double tau, double eps, double gammaTotal, double load = 0,
                double work = 0);

/// One evaluation of the laws: takes over the next state when dt > 0, moves the shear on by dt,
/// then yielding, forces and the next state. Velocities are those of dt/2 before the positions.
void step(Sample &, double dt);

} // namespace reference

#endif
