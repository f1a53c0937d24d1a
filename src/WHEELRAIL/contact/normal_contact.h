// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_NORMAL_CONTACT_H
#define WHEELRAIL_CONTACT_NORMAL_CONTACT_H

#include "contact/half_space.h"

#include <limits>
#include <optional>
#include <vector>

namespace wheelrail {

/// Frictionless contact of a rigid profile with an elastic half-space (or of two bodies with the
/// profiles' sum): 0 <= p <= limit, gap >= 0 where p = 0, the load or the approach prescribed.
/// Serves a line of cells and a patch of them alike.
///
/// Units are those of the half-space: stresses in the unit of its tractions (E* on the line),
/// lengths in that of its cells' size.
struct NormalContactProblem {
  /// Undeformed gap at the cell centres, one value per cell of the half-space's grid, finite;
  /// larger: further apart. Its mean does not matter.
  Eigen::VectorXd profile;
  double load = 0.0; ///< sum of the cells' pressures, > 0: the force over the area of a cell
  /// Given: the bodies come nearer by this much from where profile = 0 would touch, and `load` is
  /// not read. On a line it has no meaning by itself (its displacements have a free constant).
  std::optional<double> approach;
  /// What a stress of 1 is in Pa; for messages only.
  double pascals = 1.0;
  /// Hardness, > 0; p stops there and the material flows. Infinite: elastic.
  double pressureLimit = std::numeric_limits<double>::infinity();
  /// Hardness of each cell where it is not one for all, as hot cells are softer: takes the place of
  /// `pressureLimit`. Empty: that is.
  Eigen::VectorXd cellLimits;
};

struct NormalContactOptions {
  double tolerance = 1e-8;    ///< of the pressure, relative to the mean pressure in contact
  int maxActiveSets = 200;    ///< changes of the set of cells in contact
  int maxIterations = 100000; ///< conjugate-gradient steps over all grids
  Eigen::VectorXd start;      ///< pressures to start from, per cell; empty: coarser grids first
};

enum class CellState : signed char { Apart, Contact, Plastic };

struct NormalContactResult {
  Eigen::VectorXd pressure;     ///< per cell, >= 0
  Eigen::VectorXd gap;          ///< per cell, >= 0; 0 in contact
  Eigen::VectorXd plasticDepth; ///< per cell, >= 0: how far the profile is pressed in for good
  std::vector<CellState> state;
  double approach = 0.0; ///< rigid displacement; on a line up to a constant
  int iterations = 0;    ///< conjugate-gradient steps, all grids
  int activeSets = 0;    ///< sets tried on the finest grid
  double residual = 0.0; ///< estimated pressure error / mean pressure in contact
  double seconds = 0.0;

  /// Cells with pressure, plastic ones included.
  int contactCells() const;
  double peakPressure() const { return pressure.maxCoeff(); }
};

/// Active sets (primal-dual, as in Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2002) 865):
/// on the cells in contact, conjugate gradients that keep the load exactly, with FFT products and
/// a |k| preconditioner cut to the set, so that their number hardly grows with n; then cells
/// that pull are released, cells that overlap join, cells above the limit are set to it.
/// Starts on a coarse grid. Should the sets cycle, a projected gradient method that cannot
/// (every step lowers the energy) takes over.
/// \throws Error (BadInput) for a load above what the limit can carry,
///         Error (NotConverged) with iterations and residual, Error (Internal) for a profile of
///         another size
NormalContactResult solveNormalContact(HalfSpace &halfSpace, const NormalContactProblem &problem,
                                       const NormalContactOptions &options = {});

} // namespace wheelrail
#endif
