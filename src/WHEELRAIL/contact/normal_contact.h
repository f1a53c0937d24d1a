#ifndef WHEELRAIL_CONTACT_NORMAL_CONTACT_H
#define WHEELRAIL_CONTACT_NORMAL_CONTACT_H

#include "contact/line/halfplane.h"

#include <limits>
#include <vector>

namespace wheelrail {

/// Frictionless contact of a rigid profile with an elastic half-plane of modulus E* (or of two
/// bodies with the profiles' sum): 0 <= p <= limit, gap >= 0 where p = 0, the load prescribed.
///
/// All stresses are in units of E*, all lengths in cells: `load` is the sum of the cells'
/// pressures. `profile` is the undeformed gap at the cell centres (larger: further apart); its
/// mean does not matter.
struct NormalContactProblem {
  Eigen::VectorXd profile;
  double load = 0.0; ///< > 0
  /// Hardness/E*; p stops there and the material flows. Infinite: elastic.
  double pressureLimit = std::numeric_limits<double>::infinity();
};

struct NormalContactOptions {
  double tolerance = 1e-8;    ///< of the pressure, relative to the mean pressure in contact
  int maxActiveSets = 200;    ///< changes of the set of cells in contact
  int maxIterations = 100000; ///< conjugate-gradient steps over all grids
  Eigen::VectorXd start;      ///< pressures to start from; empty: coarser grids first
};

enum class CellState : signed char { Apart, Contact, Plastic };

struct NormalContactResult {
  Eigen::VectorXd pressure;     ///< per cell, in E*
  Eigen::VectorXd gap;          ///< per cell, in cells; 0 in contact
  Eigen::VectorXd plasticDepth; ///< per cell, in cells: how far the profile is pressed in for good
  std::vector<CellState> state;
  double approach = 0.0; ///< rigid displacement; in two dimensions up to a constant
  int iterations = 0;    ///< conjugate-gradient steps, all grids
  int activeSets = 0;    ///< sets tried on the finest grid
  double residual = 0.0; ///< estimated pressure error / mean pressure in contact
  double seconds = 0.0;

  int contactCells() const;
  double peakPressure() const { return pressure.maxCoeff(); }
};

/// Active sets (primal-dual, as in Hintermueller, Ito, Kunisch, SIAM J. Optim. 13 (2002) 865):
/// on the cells in contact, conjugate gradients that keep the load exactly, with FFT products and
/// a |k| preconditioner cut to the set, so that their number hardly grows with n; then cells
/// that pull are released, cells that overlap join, cells above the limit are set to it.
/// Starts on a coarse grid. Should the sets cycle, a projected gradient method that cannot
/// (every step lowers the energy) takes over.
/// @throws Error (BadInput) for a load above what the limit can carry,
///         Error (NotConverged) with iterations and residual
NormalContactResult solveNormalContact(HalfPlane &halfPlane, const NormalContactProblem &problem,
                                       const NormalContactOptions &options = {});

/// One stretch of neighbouring cells in contact.
struct ContactInterval {
  int first, last;    ///< cells, both included
  double left, right; ///< edges; cell i spans i - 1/2 .. i + 1/2
  double length() const { return right - left; }
  void shift(int cells) { first += cells, last += cells, left += cells, right += cells; }
};

/// Intervals of cells with pressure > 0, their edges placed inside cells. Counting cells makes
/// every interval too long by 0.35 cells on average. At an edge the pressure inside is
/// K sqrt(distance) and the gap outside (4/3) (K/E*) distance^(3/2) (Johnson, sec. 4.2 and 5.1):
/// the last cell's pressure and its neighbour's gap place it to 0.07 cells, however short the
/// interval. Long smooth intervals do better with a polynomial fitted to p^2: a hundredth of a
/// cell. Edges at the pressure limit have no such root and stay at the face of their cell.
std::vector<ContactInterval> contactIntervals(const NormalContactResult &contact,
                                              Boundary boundary);

/// Sum of the intervals' lengths, in cells.
double contactLength(const std::vector<ContactInterval> &intervals);

} // namespace wheelrail
#endif
