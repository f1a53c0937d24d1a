// SPDX-License-Identifier: GPL-2.0-or-later
/// \file packing.h
/// Geometry of the packing of movable cellular automata: what one automaton's cell holds and
/// through which area it meets a neighbour.
///
/// Any consistent set of units; dimensions stand in brackets. No LAMMPS type in here.
#ifndef MCA_LAWS_PACKING_H
#define MCA_LAWS_PACKING_H

#include <vector>

namespace mca {

/// A regular packing of equal automata: discs in a plane, balls in space.
///
/// Its N contacts fulfil sum n n = (N/D) 1 in D dimensions, so that with q S/V = D/N, q = d/2, the
/// averaged stress (1/V) sum_j q S n (sigma n + tau t) of a homogeneously strained packing is the
/// stress tensor of the solid exactly (physics of Psakhie et al., Phys. Mesomech. 14 (2011) 224).
struct Packing {
  const char *name;
  int dimension;    ///< D: 2 in the plane, 3 in space
  int coordination; ///< N, contacts of an automaton inside
  double volume;    ///< V/(d^2 h) in the plane, V/d^3 in space [-]
  double inertia;   ///< J/(m d^2) [-]: a disc about its axis, a ball; of the cell's mass
  /// Distance of the place in its largest hole from the nearest centres [d]: an automaton that is
  /// added to a packing is at most that far from another one.
  double hole;

  /// q S/V = D/N [-]: the weight of one contact in the averaged stress tensor
  constexpr double stressWeight() const { return static_cast<double>(dimension) / coordination; }

  /// How many of its N contacts resist that all automata turn alike [-], f N: each one slips by
  /// d omega x n, which about an axis in space is two thirds of a turn's square in the mean.
  constexpr double slippingContacts() const
  {
    return dimension == 2 ? coordination : 2.0 / 3.0 * coordination;
  }

  /// A contact's own part in the damping of that turning [-]: (1 + 4 J/(m d^2))/(f N).
  constexpr double ownSlipShare() const { return (1.0 + 4.0 * inertia) / slippingContacts(); }
};

/// The packings that keyword packing knows. In the plane the densest one, in space both densest
/// ones and the simple cubic one.
namespace packing {
constexpr double sqrt2 = 1.41421356237309504880, sqrt3 = 1.73205080756887729353;
/// hexagonal, of the plane: V = (sqrt(3)/2) d^2 h
constexpr Packing hex = {"hex", 2, 6, 0.5 * sqrt3, 1.0 / 8.0, 1.0 / sqrt3};
/// face-centred cubic: V = d^3/sqrt(2)
constexpr Packing fcc = {"fcc", 3, 12, 0.5 * sqrt2, 1.0 / 10.0, 0.5 * sqrt2};
/// hexagonal close-packed: the numbers of fcc, another lattice
constexpr Packing hcp = {"hcp", 3, 12, 0.5 * sqrt2, 1.0 / 10.0, 0.5 * sqrt2};
/// simple cubic: V = d^3
constexpr Packing sc = {"sc", 3, 6, 1.0, 1.0 / 10.0, 0.5 * sqrt3};
/// In the order of messages.
constexpr Packing all[] = {hex, fcc, hcp, sc};
} // namespace packing

/// The packing of this name, or nullptr if there is none.
/// \param name  compared exactly, with its case: hex, fcc, hcp, sc
const Packing *findPacking(const char *name);

/// A lattice of the packing with d = 1: places of its automata in one period and the three edges of
/// that period. In the plane all z are 0 and the third edge is (0, 0, 1). The critical step is
/// found from it; what a run fills its box with is up to LAMMPS's command lattice.
struct Lattice {
  struct Point {
    double x, y, z;
  };
  /// Places [d] within the period.
  std::vector<Point> basis;
  /// Edges of the period [d].
  Point edges[3];
};
/// The lattice of one of packing::all: neighbours stand exactly 1 apart, N of them about each
/// place.
Lattice latticeOf(const Packing &);

/// One automaton's cell in a packing. Holds a reference to it, so that the packing has to outlive
/// the cell: those of packing::all do.
struct Cell {
  const Packing &packing;
  double diameter;        ///< d [length], > 0
  double thickness = 1.0; ///< h [length], > 0, of a plane packing; forces are proportional to it

  /// V = (sqrt(3)/2) d^2 h (hex), d^3/sqrt(2) (fcc, hcp), d^3 (sc) [length^3]: cells fill the plane
  /// or space without gaps.
  double cellVolume() const
  {
    return packing.volume * diameter * diameter * (packing.dimension == 2 ? thickness : diameter);
  }

  /// S = 2 (D/N) V/d [length^2]: d h/sqrt(3) (hex), d^2/(2 sqrt(2)) (fcc, hcp), d^2 (sc); from q
  /// S/V = D/N with q = d/2.
  double contactArea() const { return 2.0 * packing.stressWeight() * cellVolume() / diameter; }

  /// rho V [mass]: the mass of the cell, not of the disc or ball, so that the packing has the
  /// density of the solid.
  /// \param density  of the solid [mass/length^3], > 0
  double mass(double density) const { return density * cellVolume(); }

  /// m d^2/8 (disc about its axis), m d^2/10 (ball about any) [mass length^2], of the cell's mass
  /// m; the ball's is our choice.
  /// \param density  of the solid [mass/length^3], > 0
  double inertia(double density) const
  {
    return packing.inertia * mass(density) * diameter * diameter;
  }
};

} // namespace mca

#endif
