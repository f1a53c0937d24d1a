// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_COVARIANCE_H
#define WHEELRAIL_LAW_COVARIANCE_H

#include <Eigen/Core>

/// What laws need of the covariance of their parameters. For matrices of any size, so that the
/// solver of eigenvalues, which costs the compiler seconds, is compiled once.
namespace wheelrail {

/// A matrix whose product with its transpose is the covariance. Parameters differ by orders of
/// magnitude: the root is taken of the correlation matrix. Eigenvalues below 0 count as 0.
/// \param covariance symmetric, with variances >= 0
Eigen::MatrixXd rootOfCovariance(const Eigen::MatrixXd &covariance);

/// The least eigenvalue of a symmetric matrix; its lower triangle is read.
double leastEigenvalue(const Eigen::MatrixXd &symmetric);

} // namespace wheelrail

#endif
