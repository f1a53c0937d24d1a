// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_LINE_LINE_COUPLING_H
#define WHEELRAIL_CONTACT_LINE_LINE_COUPLING_H

#include <Eigen/Core>

namespace wheelrail {

/// How the pressure p and the traction q of unlike half-planes influence each other (Bentall and
/// Johnson, Int. J. Mech. Sci. 9 (1967) 389; Johnson, Contact Mechanics, sec. 5.4). Under a
/// pressure both surfaces move towards the load, the softer one further; a traction presses one
/// body in and lifts the other. On a line both are local in the derivative along x: the wheel's
/// displacement less the rail's changes by -2 beta p/E*, the gap by -2 beta q/E*, with beta of
/// `couplingOf` and q on the rail.
///
/// Stresses are in units of E*, lengths in cells; one value per cell.

/// What a pressure adds to the slip of each cell, relative to the way rolled: from its centre to
/// that of the next cell, where the equation of rolling holds (`HalfPlane::stretch`).
Eigen::VectorXd couplingSlip(double beta, const Eigen::VectorXd &pressure);

/// By how much a traction opens the gap, or a pressure moves the wheel against the rail: one
/// operator. Counted from the mean of both far ends.
/// \param stress traction on the rail, or pressure
Eigen::VectorXd couplingDisplacement(double beta, const Eigen::VectorXd &stress);

} // namespace wheelrail
#endif
