// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_SUMS_H
#define WHEELRAIL_PATCH_SUMS_H

#include "contact/patch/solvers/tangential.h"

namespace wheelrail {

/// Integrals over the contact, in the units of the grid and of the tractions.
struct PatchSums {
  double forceX = 0.0, forceY = 0.0; ///< force
  double momentZ = 0.0;              ///< integral of x qy - y qx, about the origin (not about the
                                     ///< centre of pressure); force x length
  double contactArea = 0.0, stickArea = 0.0, slipArea = 0.0; ///< length^2
  /// Heat by friction in a unit of time at rolling speed 1: minus the integral of q . S/d, >= 0.
  double frictionalPower = 0.0;
  /// What the drive gives at rolling speed 1: -(xi Fx + eta Fy + phi Mz), of unlike bodies and
  /// `couplingPower`. In steady rolling the exact solution has both powers equal; on a grid the
  /// heat is too small by O(cell).
  double drivingPower = 0.0;

  /// frictionalPower/drivingPower; 1 where there is no power at all.
  /// A measure of the grid: 0.80, 0.89, 0.94, 0.97 on a circle with 16, 32, 64, 128 cells a
  /// diameter.
  double powerClosure() const;
};

/// \param result of `TangentialSolver` or `TransientPatch` on this grid
/// \return forces on the wheel, against its slip; multiply the powers by v0 for a power in W
PatchSums patchSums(const PatchGrid &grid, const TangentialResult &result);

/// Unlike bodies: what the pressure gives through the displacements that it imposes, at rolling
/// speed 1; minus the integral of q . (c(x) - c'(x + dx))/dx. In steady rolling it is the power of
/// the rolling resistance, the moment of a pressure that the traction has made lopsided.
/// \param imposed, before displacements of `PatchCoupling::tangential` now and a step of one cell
///        earlier; empty where the bodies do not couple
/// \return force; add it to `PatchSums::drivingPower`
double couplingPower(const PatchGrid &grid, const TangentialField &traction,
                     const TangentialField &imposed, const TangentialField &before);

} // namespace wheelrail
#endif
