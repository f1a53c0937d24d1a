#ifndef WHEELRAIL_FIT_LAW_PROBLEM_H
#define WHEELRAIL_FIT_LAW_PROBLEM_H

#include "fit/law_fit.h"

namespace wheelrail {

/// Place of each parameter in a vector.
enum LawParameter { Mu0, Mu1, Mu2, B, C, N };

/// Eq. 2's parameters of a vector.
void setParameters(FrictionLaw &law, const Eigen::VectorXd &x);

/// Eq. 2 times (kappa3/reference)^n at a point, with the parameters x. reference > 0.
double modelMu(const Eigen::VectorXd &x, const LawPoint &point, double reference);

/// What a model fits, as a weighted least-squares problem in (mu0, mu1, mu2, b, c, n), with
/// analytic derivatives. Bounds: mu0, b, c >= 0; b and c at most a hundred times the inverse of the
/// smallest positive kappa, where their terms are constant.
class LawProblem {
 public:
  /// @param deviations standard deviation of each point, > 0
  /// @param kappa3 reference of the model Kappa3, > 0
  /// The points must outlive the problem.
  LawProblem(LawModel model, const std::vector<LawPoint> &points, Eigen::VectorXd deviations,
             double kappa3);

  /// For solveLeastSquares; refers to *this.
  LeastSquaresProblem make() const;

  /// Starts: n = 0 and a grid over b and c with the linear parameters by linear least squares, the
  /// best three.
  std::vector<Eigen::VectorXd> starts(const LeastSquaresProblem &problem) const;

 private:
  double smallest(double LawPoint::*kappa) const;
  std::vector<double> grid(int parameter, double upper) const;
  std::pair<double, Eigen::VectorXd> linearFit(double b, double c) const;
  void evaluate(const Eigen::VectorXd &x, Eigen::VectorXd &r, Eigen::MatrixXd *jacobian) const;

  const std::vector<LawPoint> &points;
  Eigen::VectorXd sigma;
  double reference;
  std::array<bool, fitParameters> free;
};

} // namespace wheelrail

#endif
