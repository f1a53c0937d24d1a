// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_TEST_NIST_H
#define WHEELRAIL_TEST_NIST_H

#include <Eigen/Core>

#include <string>
#include <vector>

/// One NIST StRD nonlinear regression problem as its .dat file states it.
struct NistProblem {
  std::vector<Eigen::VectorXd> starts; ///< start 1, start 2
  Eigen::VectorXd certified;
  Eigen::VectorXd deviation; ///< certified standard deviations of the parameters
  double sumOfSquares = 0.0; ///< certified residual sum of squares
  std::vector<double> y, x;
};

NistProblem readNist(const std::string &path);

#endif
