// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_STEP_SPACE_H
#define WHEELRAIL_PATCH_STEP_SPACE_H

#include <Eigen/Core>

#include <vector>

namespace wheelrail {

/// A change of the unknowns, and what a linear operator makes of it.
struct KnownStep {
  Eigen::VectorXd x, image;
};

/// The combination of directions that leaves least of a right-hand side, direction by direction:
/// "simpler GMRES" (Walker, Zhou, Numer. Linear Algebra Appl. 1 (1994) 571) without the rule for
/// the next direction, which is its caller's, so that directions of any origin may take part, such
/// as those of an earlier system. Units are those of b and its images; the object knows no
/// operator.
class StepSpace {
 public:
  /// \param b right-hand side \param most directions, at most
  StepSpace(Eigen::VectorXd b, int most);

  /// One more direction. \param image of it, of the size of b
  /// \return false where it is one of those before but for rounding; then nothing is added
  bool add(Eigen::VectorXd image);

  bool isFull() const { return size() == static_cast<int>(triangle_.cols()); }
  int size() const { return static_cast<int>(basis_.size()); }
  /// b less the combination's image.
  const Eigen::VectorXd &residual() const { return residual_; }
  /// From what the next direction of a Krylov space follows: the residual, or, where it hardly fell
  /// along the direction that followed from the last call, the image of that one without those
  /// before (Jiranek, Rozloznik, SIAM J. Sci. Comput. 32 (2010) 1482).
  Eigen::VectorXd next();
  /// How much of each direction, in the order of `add`.
  Eigen::VectorXd weights() const;

 private:
  std::vector<Eigen::VectorXd> basis_; ///< orthonormal
  Eigen::MatrixXd triangle_;           ///< images in the basis
  Eigen::VectorXd residual_, share_;   ///< share: of b in the basis
  bool asked_ = false;                 ///< for the direction that is added next
  bool stalled_ = false;               ///< the residual, along the last one that was asked for
};

} // namespace wheelrail
#endif
