// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/fitted_law.h"

#include "law/kappa_law.h"

#include <Eigen/Eigenvalues>

namespace wheelrail {

namespace {

/// A matrix whose product with its transpose is the covariance. Parameters differ by orders of
/// magnitude: the root is taken of the correlation matrix.
template<class Covariance>
Covariance rootOf(const Covariance &covariance)
{
  using Parameters = Eigen::Matrix<double, Covariance::RowsAtCompileTime, 1>;
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

} // namespace

template<int Size>
LawDraws FittedLaw<Size>::draws() const
{
  return [law = this, root = rootOf(*covariance_)](const Eigen::VectorXd &normal) {
    return law->changed(root * normal);
  };
}

template class FittedLaw<lawParameters>;
template class FittedLaw<Eigen::Dynamic>;

} // namespace wheelrail
