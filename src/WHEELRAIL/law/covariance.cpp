// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/covariance.h"

#include <Eigen/Eigenvalues>

namespace wheelrail {

Eigen::MatrixXd rootOfCovariance(const Eigen::MatrixXd &covariance)
{
  const Eigen::VectorXd deviation = covariance.diagonal().cwiseSqrt();
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols());
  for (Eigen::Index i = 0; i < covariance.rows(); ++i)
    for (Eigen::Index j = 0; j < covariance.cols(); ++j)
      if (i != j && deviation[i] > 0.0 && deviation[j] > 0.0)
        correlation(i, j) = covariance(i, j) / (deviation[i] * deviation[j]);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(correlation);
  return deviation.asDiagonal() * eigen.eigenvectors() *
         eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

double leastEigenvalue(const Eigen::MatrixXd &symmetric)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

} // namespace wheelrail
