// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_CELL_INFLUENCE_H
#define WHEELRAIL_PATCH_CELL_INFLUENCE_H

namespace wheelrail {

/// Two half-spaces by what their displacement differences need: a shear modulus G (> 0, force per
/// area) and Poisson's ratio nu (0 <= nu <= 1/2) of both together, and K (-1/2 .. 1/2), by which
/// the normal and the tangential problem influence each other. K = 0 for equal bodies.
struct ElasticPair {
  double G = 0.0;
  double nu = 0.0;
  double K = 0.0;
  /// Compliance of a layer between the bodies against shear, thickness over shear modulus: length
  /// per traction, >= 0. Each place of it gives way by that times its own traction (Winkler).
  double layer = 0.0;
};

/// Integrals over a cell of dx x dy, centred at a distance (x, y), that make up its influence
/// (Boussinesq 1885, Cerruti 1882; Kalker, Three-dimensional elastic bodies in rolling contact,
/// 1990, sec. 3.3), r^2 = x^2 + y^2; a length each:
struct CellIntegrals {
  double yy; ///< of y^2/r^3
  double xx; ///< of x^2/r^3; yy + xx is that of 1/r
  double xy; ///< of x y/r^3
};

/// Near the cell the antiderivatives at its four corners, x asinh(y/|x|), y asinh(x/|y|) and -r;
/// far away, where their differences would cancel, Gauss's quadrature. Relative error 1e-12.
/// \param x, y centre to the point, any sign; (0, 0) is the cell itself
/// \param dx, dy > 0, in the unit of x and y
CellIntegrals cellIntegrals(double x, double y, double dx, double dy);

/// Displacement differences (both bodies') at a distance (x, y) from a cell with unit traction.
/// Length per traction. zz = (1 - nu)/(pi G) (yy + xx), xx = [(1 - nu) yy + xx]/(pi G), yy likewise
/// with both exchanged, xy = nu xy/(pi G), with the integrals on the right.
struct CellInfluence {
  double zz, xx, yy, xy;
};
/// \param integrals of `cellIntegrals` at that distance
CellInfluence cellInfluence(const ElasticPair &pair, const CellIntegrals &integrals);

/// Integrals over the cell of x/r^2 and y/r^2, a length each: what couples pressure and tangential
/// displacement, traction and normal displacement of unlike bodies, times K/(pi G) (Kalker 1990,
/// sec. 1.7). Relative error 1e-12 of 1/r's integral.
/// It is for a place (x, y) seen from the centre of a cell of the size dx x dy.
struct CouplingIntegrals {
  double x; ///< of x/r^2; odd in x, even in y
  double y; ///< of y/r^2
};
CouplingIntegrals couplingIntegrals(double x, double y, double dx, double dy);

} // namespace wheelrail
#endif
