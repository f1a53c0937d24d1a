// SPDX-License-Identifier: GPL-2.0-or-later
/// \file reference_mca.h
/// Slow, obvious MCA: one struct an automaton, one a contact, plain loops, the trigonometry of the
/// textbook. It is written from the equations, not from the kernel, which is held against it.
#ifndef REFERENCE_MCA_H
#define REFERENCE_MCA_H

#include "laws/law_set.h"

#include <Eigen/Dense>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace reference {

/// All quantities in one consistent set of units.
struct Automaton {
  double x = 0, y = 0, vx = 0, vy = 0, omega = 0;
  int type = 0;      ///< number in the table of materials
  bool held = false; ///< keeps its velocity, whatever acts on it
  double kappa = 0;

  // results of a step; forces and torque are those of all contacts
  double mean = 0, xx = 0, yy = 0, xy = 0, zz = 0, intensity = 0, factor = 1, kappaNext = 0;
  double centre = 0, trace = 0, work = 0;
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
  double slip = 0;  ///< and of its surface along t
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
  void addImage(int i, double sx, double sy);

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

/// Plastic work per volume, the area below the yield curve.
double plasticWork(const mca::Material &, double kappa);

/// Normal stress of a linked contact that lengthens by `times` the growth of its squared plastic
/// shear, as far as that brings the stress nearer to 0.
double stretched(double sigma, double twoG, double times, double squareBefore, double squareAfter);

/// A contact as a criterion of fracture sees it, after the returns. In space shears are lengths.
struct LinkView {
  const mca::LawSet &laws;
  const mca::Material &a, &b;
  int dimension;
  double eps, gammaTotal; ///< total strains
  double e, gamma;        ///< elastic strains
  double sigma, tau;      ///< stresses
  double meanA, meanB;    ///< mean stresses of both automata
  Eigen::Matrix3d stress; ///< local stress tensor, in any frame
};

/// The criteria of bulk links by their words. A test of a new one adds its own.
std::map<std::string, std::function<bool(const LinkView &)>> &criteria();

/// Whether it breaks as a bulk link: by the criterion of its laws, or it has collapsed.
bool bulkBreaks(const LinkView &);

/// The kind of a contact after a step in which it has these stresses.
/// \param work  plastic work per volume while pressed together
double nextKind(const mca::LawSet &, const mca::Material &, const mca::Material &, double kind,
                double sigma, double tau, bool bulkBreaks, double work);

/// The rule for worn contacts, in the place of what nextKind() says.
/// \param far  beyond the breaking distance of the tougher material
double wornKind(const mca::LawSet &, double kind, double next, bool far);

/// One evaluation of the laws: takes over the next state when dt > 0, moves the shear on by dt,
/// then yielding, forces and the next state. Velocities are those of dt/2 before the positions.
void step(Sample &, double dt);

} // namespace reference

#endif
