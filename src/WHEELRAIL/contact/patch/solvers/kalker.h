// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_KALKER_H
#define WHEELRAIL_PATCH_KALKER_H

#include "contact/patch/solvers/tangential.h"

namespace wheelrail {

/// Sensitivity of forces and moment to creepages where nothing slips (Kalker's linear theory,
/// 1967):
///   Fx = -xx xi,  Fy = -yy eta - yz phi,  Mz = -zy eta - zz phi,
/// in the units of grid and G. yz and zy have opposite signs and, on a contact that is symmetric in
/// x, the same size but for the error of the cells.
struct CreepSensitivity {
  double xx = 0.0, yy = 0.0, yz = 0.0, zy = 0.0, zz = 0.0;
};

/// Sensitivity of any contact, smooth or rough: the cells where `contact` > 0. Three solutions
/// without slip. \throws Error as TangentialSolver
CreepSensitivity creepSensitivity(TangentialSolver &solver, const Eigen::VectorXd &contact);

/// Kalker's coefficients of an ellipse with semi-axes a along x and b along y:
///   Fx = -G a b C11 xi,  Fy = -G a b C22 eta - G (ab)^1.5 C23 phi,
///   Mz = G (ab)^1.5 C23 eta - G (ab)^2 C33 phi.
struct KalkerCoefficients {
  double c11, c22, c23, c33;
};

/// Kalker's coefficients from sensitivities of a contact of area pi ab; C23 the mean of both.
KalkerCoefficients kalkerCoefficients(const CreepSensitivity &sensitivity, double G, double area);

/// Computed on two grids, 2a and 2b being `cells` and cells/2 cells long, with the area of the
/// cells in place of the ellipse's, then extrapolated in the cells' length: with 128 cells within
/// 0.3 % (C33 1 %) for 0.2 <= a/b <= 5.
/// \param axesRatio a/b > 0
/// \param cells even, >= 32
KalkerCoefficients ellipseKalkerCoefficients(double axesRatio, double nu, int cells = 128);

} // namespace wheelrail
#endif
