// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_FRICTION_NEWTON_H
#define WHEELRAIL_PATCH_FRICTION_NEWTON_H

#include "contact/patch/elasticity/patch_half_space.h"
#include "contact/patch/solvers/step_space.h"

#include <vector>

namespace wheelrail {

/// The equations of tangential contact on the cells in contact, scaled: tractions in units of
/// `unit`, slips in what a cell of that traction moves under itself, so that both are of order 1.
///   S = drive + sum_j c_j direction_j + B q,  q = P(q - S),  sum of component j of q = force_j
/// B = A (a step), or A - A moved by a cell (steady). A vector holds x and y of each cell in
/// contact, then the unknown creepages c_j (none, one or two).
/// Semismooth Newton (Alart, Curnier 1991); P is the projection on the disc of radius `bound`. The
/// state of a cell (stick or slip) is predicted from q - r S, r the `prediction_`; a smaller r is
/// slower and safer.
///
/// Derivative of a slipping cell's equation with z = q - r S, lambda = bound/|z| and the tangent t
/// at z: dq - lambda t (t . dz). Derivative of a sticking cell's: dS.
class FrictionNewton {
 public:
  using Vector = Eigen::VectorXd;

  struct Equations {
    /// B = A - A moved by a cell; false: B = A.
    bool steady = true;
    std::vector<int> cells; ///< in contact: indices in the half-space's grid
    /// Friction coefficient times pressure of each of them, scaled; infinite: no slip at all.
    Vector bound;
    /// Rigid slip less the displacement that was there before, scaled; 2 per cell.
    Vector drive;
    /// Scaled slip that a cell's own traction makes beyond the half-spaces', 3 per cell: xx, yy,
    /// xy; empty: none.
    Vector edge;
    std::vector<int> unknown;  ///< components (0: x, 1: y) whose force is given
    std::vector<double> force; ///< scaled: sum of the scaled tractions
    double scale = 1.0;        ///< that the residual's norm is measured against
  };

  /// \param halfSpace on the box of the cells in contact; must outlive the object. Steady: with a
  ///         column more at the leading edge than the contact
  FrictionNewton(PatchHalfSpace &halfSpace, Equations equations);

  /// Where no attempt converges and forces are given, they are approached in parts.
  /// \param x start on entry, solution on return: 2 per cell, then the unknown creepages, scaled
  /// \param tolerance of the residual's norm, relative to `scale`
  /// \param maxSteps Newton steps of one attempt; a second and a third are more careful
  /// \param known steps of solutions before on the same cells, with the same unknowns: a step
  ///        along them costs no product
  /// \return true when the tolerance is met; never throws
  bool solve(Vector &x, double tolerance, int maxSteps, const std::vector<KnownStep> &known = {});

  /// Newton steps of all attempts.
  int steps() const { return newtonSteps_; }
  /// From the start to the solution.
  const KnownStep &wholeStep() const { return wholeStep_; }
  /// Products with B, those of the inner iterations included.
  int products() const { return operatorProducts_; }
  /// Relative to `scale`.
  double residual() const { return relativeResidual_; }
  /// Does cell i of the solution slip?
  /// \param i position in `Equations::cells`
  bool slips(int i) const { return linear_.slips[i] != 0; }
  /// Scaled slip of the solution, 2 per cell.
  const Vector &slip() const { return scaledSlip_; }

 private:
  /// Which linear system a step solves: stick, or slip along `tangent`.
  struct Linearisation {
    std::vector<char> slips;
    Vector tangent; ///< 2 per cell, unit length in slip
    Vector lambda;  ///< bound/|q - r S| in slip
    /// How much more a cell's slip gives way along the tangent than its surface does under its own
    /// traction, (1 - lambda)/(lambda r): slip must turn with the traction.
    Vector softness;

    /// Part of (vx, vy) along the tangent of cell i.
    double along(int i, double vx, double vy) const
    {
      return tangent[2 * i] * vx + tangent[2 * i + 1] * vy;
    }
    /// Changes that part of a vector's cell i.
    void setAlong(int i, double value, Vector &v) const
    {
      const double change = value - along(i, v[2 * i], v[2 * i + 1]);
      v[2 * i] += change * tangent[2 * i];
      v[2 * i + 1] += change * tangent[2 * i + 1];
    }
  };

  /// r of cell i.
  double predictionOf(int i) const { return prediction_ * stiffness_[i]; }
  /// Attempts with ever smaller `prediction_`, until one converges.
  bool tryAttempts(const Vector &start, Vector &x, double tolerance, int maxSteps);
  bool iterate(Vector &x, double tolerance, int maxSteps);
  /// Slip that tractions and unknown creepages make, without the drive.
  enum class Precision { Single, Double };
  Vector operatorB(const Vector &x, Precision precision);
  /// The residual at x, whose slip is that of `image_`: S where a cell sticks, q - P(q - r S) where
  /// it slips, forces last.
  Vector evaluate(const Vector &x, Linearisation &linear);
  /// Product of the residual's derivative with x. \param s B x
  Vector jacobian(const Linearisation &linear, const Vector &x, const Vector &s) const;
  /// Steady: sums along each stick segment, the inverse of the upwind difference.
  Vector fromLeft(const Linearisation &linear, const Vector &residual) const;
  /// Approximate inverse of the equations after `fromLeft`, where cells stick that of the
  /// half-space.
  Vector fromRight(const Linearisation &linear, const Vector &x);
  void fillStep(const Linearisation &linear, const Vector &x, Vector &result);
  void fillStick(const Linearisation &linear, const Vector &x, Vector &result);
  /// Steady: along the tangent of slip the inverse of a half-space under a soft layer, where the
  /// softness is of the size of its own.
  void fillSlip(const Linearisation &linear, const Vector &x, Vector &result);
  /// Solves the linear system and goes there with x and `image_`.
  /// \param tolerance relative to its right-hand side
  /// \param known steps that take part from the beginning
  void newtonStep(const Linearisation &linear, const Vector &f, double tolerance,
                  const std::vector<KnownStep> &known, Vector &x);

  PatchHalfSpace &space_;
  Equations eq_;
  int n_;                     ///< cells in contact
  double compliance_;         ///< of a cell under itself
  Vector stiffness_;          ///< of a cell with its edge, in units of a cell's without one
  std::vector<int> upstream_; ///< position in `cells` of the cell one further in x, -1: none
  TangentialField field_;
  Vector image_;                 ///< B x of the iterate
  double doubt_ = 0.0;           ///< its error by products in single precision
  std::vector<KnownStep> known_; ///< given to `solve`
  KnownStep wholeStep_;
  Vector scaledSlip_;
  Linearisation linear_; ///< at the last x
  double prediction_ = 0.5;
  int newtonSteps_ = 0, operatorProducts_ = 0;
  double relativeResidual_ = 0.0;
};

} // namespace wheelrail
#endif
