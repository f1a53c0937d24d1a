#ifndef WHEELRAIL_LAW_PROBLEM_H
#define WHEELRAIL_LAW_PROBLEM_H

#include "law_fit.h"

namespace wheelrail {

/// Place of each parameter of Eq. 2 in a vector.
enum LawParameter { Mu0, Mu1, Mu2, B, C };

Eigen::VectorXd asVector(const FrictionLaw &law);
void setParameters(FrictionLaw &law, const Eigen::VectorXd &x);

/// Eq. 2, or the part of it that a model fits, as a weighted least-squares problem in
/// (mu0, mu1, mu2, b, c), with analytic derivatives. Bounds: mu0, b, c >= 0; b and c at most a
/// hundred times the inverse of the smallest positive kappa, where their terms are constant.
class LawProblem {
 public:
  /// @param deviations standard deviation of each point, > 0
  /// The points must outlive the problem.
  LawProblem(LawModel model, const std::vector<LawPoint> &points, Eigen::VectorXd deviations);

  /// For solveLeastSquares; refers to *this.
  LeastSquaresProblem make() const;

  /// Starts: a grid over b and c with the linear parameters by linear least squares, the best
  /// three.
  std::vector<Eigen::VectorXd> starts(const LeastSquaresProblem &problem) const;

 private:
  double smallest(double LawPoint::*kappa) const;
  std::vector<double> grid(int parameter, double upper) const;
  std::pair<double, Eigen::VectorXd> linearFit(double b, double c) const;
  void evaluate(const Eigen::VectorXd &x, Eigen::VectorXd &r, Eigen::MatrixXd *jacobian) const;

  const std::vector<LawPoint> &points;
  Eigen::VectorXd sigma;
  std::array<bool, lawParameters> free;
};

} // namespace wheelrail

#endif
