// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_TRANSIENT_H
#define WHEELRAIL_PATCH_TRANSIENT_H

#include "contact/patch/solvers/tangential.h"

namespace wheelrail {

/// A sequence of shifts and rolling steps of two bodies, each of which starts from the
/// displacements that the one before left: contact that changes in time, with roughness that
/// travels through it. Every cell's displacement is remembered, also outside of the contact:
/// material that enters is deformed already.
/// Units are those of the grid and of G. The state is traction and displacement over the whole
/// grid; a step replaces both.
///
/// A step is sought from what the tractions were going to be. Where the pressure stays in the
/// contact they change slowly there: they go on as from the step before the last to the last. Where
/// it travels, as that of roughness does, they travel along.
class TransientPatch {
 public:
  /// For a rolling step d is `cells` times dx.
  struct Step {
    Eigen::VectorXd bound; ///< friction coefficient times pressure, per cell, now
    /// Whole cells that the material travels towards smaller x; 0: a shift at rest.
    int cells = 1;
    /// Creepage of a step, per distance rolled; for a shift the shift itself (phi: the angle).
    Creepage creepage;
    std::optional<double> forceX, forceY; ///< given: xi, eta are unknown
    double spinPoint = 0.5;               ///< see TangentialProblem
    TangentialField imposed;              ///< see TangentialProblem
    EdgeCompliance edge;                  ///< see TangentialProblem; of a step of one cell
  };

  /// At rest, without traction.
  /// \param pair K is not read: what couples unlike bodies is imposed
  TransientPatch(const PatchGrid &grid, const ElasticPair &pair);

  /// Goes on from a traction: that of steady rolling, say, or the first contact of a case.
  /// \param traction one value a cell; its displacement is computed
  /// \param imposed as of a step
  void startFrom(const TangentialField &traction, const TangentialField &imposed = {});

  /// A step's tolerance of 1e-4 leaves less than 1e-5 in the forces, in the mean over steps too.
  /// Where a force is given the creepage found answers for the error, thirty times as large as the
  /// tolerance in its worst step: `attempt` then asks for no more than 3e-6.
  static TangentialOptions defaultOptions();

  /// \throws Error BadInput: contact within `cells` columns of the leading border, where the
  ///         incoming material's displacement is not known; and as TangentialSolver::solve. The
  ///         sequence can then go on as if the step had not been tried.
  /// \return as of `TangentialSolver::solve`; slip is per distance rolled, of a shift the slip
  ///         itself
  TangentialResult step(const Step &step, const TangentialOptions &options = defaultOptions());
  /// The two halves of `step`: a solution that leaves the state as it was, and making one the
  /// state. Steps are tried more than once where pressure and traction influence each other.
  TangentialResult attempt(const Step &step, const TangentialOptions &options = defaultOptions());
  void accept(const Step &step, const TangentialResult &result);

  const PatchGrid &grid() const { return solver_.grid(); }
  /// Traction and displacement of the last step, over the whole grid.
  /// Zero outside of the contact; the displacement is not.
  const TangentialField &traction() const { return traction_; }
  const TangentialField &displacement() const { return displacement_; }

 private:
  /// Where to look for the traction of a step first.
  TangentialField expected(const Step &step) const;

  TangentialSolver solver_;
  PatchHalfSpace space_;
  TangentialField traction_, displacement_;
  TangentialField before_; ///< traction of the step before the last; empty: there is none
  Eigen::VectorXd bound_;  ///< of the last step; empty: there is none
};

} // namespace wheelrail
#endif
