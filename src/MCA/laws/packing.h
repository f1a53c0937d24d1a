/// \file packing.h
/// Geometry of the packing of movable cellular automata: what one automaton's cell holds and
/// through which area it meets a neighbour.
///
/// Any consistent set of units; dimensions stand in brackets. No LAMMPS type in here.
#ifndef MCA_LAWS_PACKING_H
#define MCA_LAWS_PACKING_H

#include <cmath>

namespace mca {

/// Plane hexagonal packing of discs of diameter d [length] and thickness h [length].
///
/// Cell volume V and contact area S are chosen so that the averaged stress
/// (1/V) sum_j q S n (sigma n + tau t), q = d/2, returns the stress tensor of a homogeneously
/// strained lattice exactly (physics of Psakhie et al., Phys. Mesomech. 14 (2011) 224).
struct HexagonalPacking {
  static constexpr int coordination = 6;

  double diameter;  ///< d [length], > 0
  double thickness; ///< h [length], > 0; all forces are proportional to it

  /// V = (sqrt(3)/2) d^2 h [length^3]
  double cellVolume() const { return 0.5 * std::sqrt(3.0) * diameter * diameter * thickness; }

  /// S = d h / sqrt(3) [length^2]
  double contactArea() const { return diameter * thickness / std::sqrt(3.0); }

  /// q S / V = 1/3 [-]: the weight of one contact in the averaged stress tensor
  static constexpr double stressWeight() { return 1.0 / 3.0; }

  /// rho V [mass]: the mass of the cell, not of the disc (2 sqrt(3)/pi = 1.1027 times that),
  /// so that the packing has the density of the solid
  double mass(double density) const { return density * cellVolume(); }

  /// m d^2/8 [mass length^2], the disc's moment of inertia about its axis
  double inertia(double density) const { return mass(density) * diameter * diameter / 8.0; }
};

} // namespace mca

#endif
