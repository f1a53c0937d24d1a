// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_TANGENTIAL_H
#define WHEELRAIL_PATCH_TANGENTIAL_H

#include "base/errors.h"
#include "contact/patch/elasticity/patch_half_space.h"

#include <memory>
#include <optional>
#include <vector>

namespace wheelrail {

/// Rigid slip of the bodies, divided by the rolling speed.
struct Creepage {
  /// Signs: xi and eta > 0 give forces to negative x and y.
  double xi = 0.0;  ///< longitudinal, -
  double eta = 0.0; ///< lateral, -
  double phi = 0.0; ///< spin, 1/length
};

/// Symmetric 2 x 2 matrices, one a cell; see `edgeCompliance`.
struct EdgeCompliance {
  Eigen::VectorXd xx, yy, xy; ///< displacement over traction
};

/// Tangential contact of two half-spaces under a known bound of the traction. Over a distance
/// d (length) the bodies slip at a cell by
///   S = d (xi - phi y, eta + phi (x + c d)) + u(x) - u'(x + d),
/// u the displacement difference of the tractions q (and of the pressure, where the bodies are
/// unlike) and u' that before. Where the bodies stick,
/// S = 0 and |q| <= bound; where they slip, |q| = bound and q points against S (so that xi > 0
/// gives a force to negative x).
/// Units: any consistent set, with G of the half-spaces in force per length squared.
struct TangentialProblem {
  enum class Kind {
    Steady, ///< u' = u: fixed pattern of contact, material flows through it; d is one cell
    Step    ///< u' is `previous`: a step of transient rolling, or a shift at rest
  };
  Kind kind = Kind::Steady;
  /// Friction coefficient times pressure, per cell, >= 0; 0 outside the contact. May be infinite
  /// (no slip at all).
  Eigen::VectorXd bound;
  Creepage creepage;            ///< the value of an unknown one is where the search begins
  std::optional<double> forceX; ///< given: xi is unknown; sum of qx times cell area
  std::optional<double> forceY; ///< given: eta is unknown
  double distance = 0.0;        ///< d of a step, > 0; for a shift 1, with the shift as creepage
  TangentialField previous;     ///< u'(x + d) at the cells, of a step; empty: zero
  /// The part of u that is not of the tractions: `PatchCoupling::tangential`. Empty: zero.
  TangentialField imposed;
  /// Compliance of edge cells beyond the half-spaces', per cell; empty: none.
  EdgeCompliance edge;
  /// c: where in the step the spin's lever is taken; 1/2 is the midpoint. (CONTACT takes 1/6.)
  double spinPoint = 0.5;
};

/// State of a cell: outside of the contact (bound 0), without slip, or with |q| = bound.
enum class PatchState : signed char { Apart, Stick, Slip };

struct TangentialOptions {
  /// Error of traction and slip, relative to the bound or the rigid slip. Forces are off by a tenth
  /// of it or less.
  double tolerance = 1e-5;
  int maxSteps = 60;     ///< Newton steps on the finest grid
  TangentialField start; ///< tractions to start from; empty: coarser grids first
  /// Steady rolling that changes by degrees from call to call: the search goes on along the steps
  /// between the last solutions, while the cells in contact are the same.
  bool followsSteps = false;
};

struct TangentialResult {
  /// On the wheel, against its slip; one value a cell, 0 outside of the contact.
  TangentialField traction;
  TangentialField slip; ///< S/d in contact, 0 elsewhere
  std::vector<PatchState> state;
  Creepage creepage;      ///< the given ones, and those found
  int newtonSteps = 0;    ///< on the finest grid
  int products = 0;       ///< with the influence of the tractions, on the finest grid
  int coarseProducts = 0; ///< on all coarser grids together
  /// Relative, as `TangentialOptions::tolerance`; of the finest grid.
  double residual = 0.0;

  /// Number of cells in that state.
  int stickCells() const;
  /// Together with stickCells() all cells in contact.
  int slipCells() const;
};

/// A force that friction cannot carry, in the units of the problem. The contact's own units and the
/// user's keyword are its caller's to say.
class ForceTooLarge : public Error {
 public:
  ForceTooLarge(double given, double most);
  double force, capacity; ///< length of what was asked for, and what friction carries
};

/// Solver on one grid; keeps its work space from one call to the next. One object per thread.
///
/// Semismooth Newton (Alart, Curnier 1991) on q - P(q - r S) = 0, P the projection on the disc of
/// radius `bound`. Its linear systems by GMRES on the cells in contact, preconditioned from the
/// left by the sum along each stick segment, the inverse of the upwind difference u(x) - u(x + d),
/// and from the right by the half-space's symbol, in slip under a soft layer, so that the number of
/// products hardly grows with the grid.
/// Where the bound is infinite everywhere nothing slips, and the problem is linear.
class TangentialSolver {
 public:
  /// \param pair of `combinedPair`
  TangentialSolver(const PatchGrid &grid, const ElasticPair &pair);
  ~TangentialSolver();
  TangentialSolver(TangentialSolver &&) noexcept;
  TangentialSolver &operator=(TangentialSolver &&) noexcept;

  /// As given to the constructor.
  const PatchGrid &grid() const;

  /// Without a start it solves the same problem on grids of half the cells first, as long as the
  /// longer side has 48 cells. Zero bound everywhere gives zero traction, not an error.
  /// \return fields over the whole grid, forces and creepages in the units of the problem
  /// \throws ForceTooLarge. Error BadInput: contact in the leading column (steady rolling: no
  ///         material comes in from outside the box). NotConverged: with the
  ///         residual. Internal: a bound of another size than the grid, a step
  ///         without a distance
  TangentialResult solve(const TangentialProblem &problem, const TangentialOptions &options = {});

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

} // namespace wheelrail
#endif
