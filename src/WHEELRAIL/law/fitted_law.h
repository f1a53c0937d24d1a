// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_FITTED_LAW_H
#define WHEELRAIL_LAW_FITTED_LAW_H

#include "law/friction_law.h"

#include <Eigen/Eigenvalues>

#include <optional>
#include <utility>

namespace wheelrail {

/// A law with parameters that are known to a covariance: what bands around results need of it. The
/// law itself adds `changed`, and `isSound` where not all parameters make a law.
/// \tparam Size  number of parameters, or Eigen::Dynamic
template<int Size>
class FittedLaw : public FrictionLaw {
 public:
  using Covariance = Eigen::Matrix<double, Size, Size>;
  using Parameters = Eigen::Matrix<double, Size, 1>;

  Eigen::VectorXd standardErrors() const final
  {
    return covariance_ ? Eigen::VectorXd(covariance_->diagonal().cwiseSqrt()) : Eigen::VectorXd();
  }
  double variance(const Eigen::VectorXd &derivative) const final
  {
    return derivative.dot(*covariance_ * derivative);
  }
  LawDraws draws() const final
  {
    return [law = this, root = rootOf(*covariance_)](const Eigen::VectorXd &normal) {
      return law->changed(root * normal);
    };
  }

 protected:
  /// \param covariance symmetric, positive semi-definite; absent: none is known
  explicit FittedLaw(std::optional<Covariance> covariance) : covariance_(std::move(covariance)) {}

 private:
  /// A matrix whose product with its transpose is the covariance. Parameters differ by orders of
  /// magnitude: the root is taken of the correlation matrix.
  static Covariance rootOf(const Covariance &covariance)
  {
    const Parameters deviation = covariance.diagonal().cwiseSqrt();
    Covariance correlation = Covariance::Identity(covariance.rows(), covariance.cols());
    for (Eigen::Index i = 0; i < covariance.rows(); ++i)
      for (Eigen::Index j = 0; j < covariance.cols(); ++j)
        if (i != j && deviation[i] > 0.0 && deviation[j] > 0.0)
          correlation(i, j) = covariance(i, j) / (deviation[i] * deviation[j]);
    const Eigen::SelfAdjointEigenSolver<Covariance> eigen(correlation);
    return deviation.asDiagonal() * eigen.eigenvectors() *
           eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal().toDenseMatrix();
  }

  std::optional<Covariance> covariance_;
};

} // namespace wheelrail
#endif
