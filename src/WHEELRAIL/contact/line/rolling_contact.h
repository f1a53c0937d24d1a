// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_LINE_ROLLING_CONTACT_H
#define WHEELRAIL_CONTACT_LINE_ROLLING_CONTACT_H

#include "contact/line/contact_interval.h"
#include "contact/line/halfplane.h"

#include <vector>

namespace wheelrail {

/// Tangential contact of a rolling cylinder with creep `creep` = sliding / rolling speed. Stresses
/// in units of E*, lengths in cells. Material enters at the largest x (the leading edge) and
/// travels towards smaller x.

enum class Adhesion : signed char { Apart, Stick, Slip, BackwardSlip };

struct RollingOptions {
  double tolerance = 1e-8; ///< of the slip in the stick zone, relative to what drives it
  int maxActiveSets = 100;
  std::vector<Adhesion> start; ///< states to start from (those of a nearby creep); empty: all stick
  Eigen::VectorXd startTraction;
  std::vector<ContactInterval> contact; ///< with edges inside cells; empty: cells count as a whole
  /// Slip of each cell beside the creep, by the pressure of unlike bodies (`couplingSlip`); empty:
  /// 0
  Eigen::VectorXd imposed;
  double layer = 0.0; ///< compliance of a layer between the bodies, in cells per E*, >= 0
};

struct RollingResult {
  Eigen::VectorXd traction; ///< per cell, in E*, positive for positive creep
  Eigen::VectorXd slip;     ///< per cell: sliding distance / rolling distance; ~0 in stick
  std::vector<Adhesion> state;
  int activeSets = 0;
  int products = 0;      ///< products with the operator, all sets
  double residual = 0.0; ///< slip left in the stick zone / what drives it

  double force() const { return traction.sum(); } ///< in E* cells
};

/// Steady rolling with the roughness fixed in the contact frame ("frozen", the paper's mode): one
/// pressure distribution for all time, through which the material flows. In the stick zone a
/// particle's displacement grows with every cell it travels by exactly the creep,
///   creep - (u_i - u_(i+1)) = 0,   |q| <= bound;   where |q| = bound, slip goes along with q.
/// The pressure of unlike bodies drives each cell, too (`RollingOptions::imposed`).
/// Sets {stick, slip, backward slip} are tried until none changes, on coarser grids first. On a set
/// the equation is a finite Hilbert transform; GMRES with FFT products solves it, preconditioned by
/// the continuous inverse w H (1/w), w = prod sqrt((leading_j - x)/(x - trailing_j)), so that it
/// needs about 15 products whatever n is.
///
/// A layer of the compliance l adds l q to the displacement u, and l (q_i - q_(i+1)) to what a
/// particle gives way in a cell; material comes in with an unsheared layer at the leading edge. The
/// inverse is smoothed by A (A + l)^-1 then, A of `HalfPlane::displacement`.
///
/// With the edges of the contact inside their cells (`RollingOptions::contact`) the force is of
/// second order in the cell size; without them each cell counts as a whole and it is of first
/// order. An edge cell of whose panel only the share w is in contact gets the compliance
/// 2 (1 - w)/w in addition (4 (1 - w)/(pi w) where it is the only cell), from the staggered
/// operator's inverse: the product of the solutions with rolling to either side is pi/8 in an edge
/// cell, the inverse's diagonal 1/2. The initial slope then is (pi E*/4) x contact length.
/// \param bound friction coefficient times pressure per cell, >= 0; 0 outside the contact
/// \param creep >= 0
/// \throws Error (NotConverged)
RollingResult solveFrozenRolling(HalfPlane &halfPlane, const Eigen::VectorXd &bound, double creep,
                                 const RollingOptions &options = {});

/// One step of transient rolling ("moving"): the material has moved on by one cell,
///   slip = creep - [u(q) - u(previous traction, moved along)],  |q| <= bound.
/// The half-plane's free constant in two dimensions matters here: displacements are counted
/// against a point `referenceLength` cells away. The steady state does not depend on it.
class TransientRolling {
 public:
  /// \param layer compliance of a layer between the bodies, in cells per E*, >= 0
  TransientRolling(HalfPlane &plane, double referenceLength, double layer = 0.0);

  /// \param imposed slip of each cell beside the creep, by the pressure of unlike bodies; empty: 0
  /// \return the new traction; call with the bound of the new position
  RollingResult step(const Eigen::VectorXd &bound, double creep,
                     const Eigen::VectorXd &imposed = {});

  /// Goes on with other cells: the first of the new plane is cell `shift` of the old one.
  void moveTo(HalfPlane &plane, int shift);

 private:
  Eigen::VectorXd displacement(const Eigen::VectorXd &q);
  /// Conjugate gradients on the stick cells; `residual`, the slip, is kept up to date everywhere.
  int solveStick(const Eigen::VectorXd &stick, Eigen::VectorXd &residual, Eigen::VectorXd &q,
                 double scale);

  HalfPlane *halfPlane_;
  double constant_; ///< added to the influence of every cell
  double layer_;
  Eigen::VectorXd traction_;
};

} // namespace wheelrail
#endif
