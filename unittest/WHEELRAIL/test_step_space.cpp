// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/step_space.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace wheelrail;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Definite and far from symmetric.
MatrixXd matrixOf(int n)
{
  MatrixXd matrix = MatrixXd::Identity(n, n);
  for (int i = 0; i + 1 < n; ++i)
    matrix(i, i + 1) = 0.7;
  matrix(n - 1, 0) = -0.4;
  return matrix;
}

} // namespace

TEST(StepSpace, LeavesAsLittleAsLeastSquares)
{
  const MatrixXd matrix = matrixOf(12), directions = MatrixXd::Identity(12, 5);
  const VectorXd b = VectorXd::LinSpaced(12, 1.0, 3.0);
  const MatrixXd images = matrix * directions;
  const VectorXd best = images.colPivHouseholderQr().solve(b);
  StepSpace space(b, 5);
  for (int i = 0; i < 5; ++i)
    EXPECT_TRUE(space.add(images.col(i)));
  EXPECT_TRUE(space.isFull());
  EXPECT_LT((space.weights() - best).norm(), 1e-12 * best.norm());
  EXPECT_LT((space.residual() - (b - images * best)).norm(), 1e-12 * b.norm());
}

TEST(StepSpace, RefusesADirectionThatItHas)
{
  StepSpace space(VectorXd::Ones(4), 4);
  VectorXd image(4);
  image << 1.0, 2.0, 0.0, -1.0;
  EXPECT_TRUE(space.add(image));
  EXPECT_FALSE(space.add(-3.0 * image));
  EXPECT_FALSE(space.add(0.0 * image));
  EXPECT_EQ(space.size(), 1);
}

/// The directions that follow from the residual solve a system of n unknowns in n of them, also one
/// whose first residual is at right angles to its image, where a residual alone would not go on.
TEST(StepSpace, AKrylovSpaceSolves)
{
  MatrixXd turn = MatrixXd::Zero(6, 6);
  for (int i = 0; i < 6; ++i)
    turn((i + 1) % 6, i) = 1.0;
  for (const MatrixXd &matrix : {matrixOf(6), turn}) {
    const VectorXd b = VectorXd::Unit(6, 2);
    StepSpace space(b, 6);
    VectorXd x = VectorXd::Zero(6);
    std::vector<VectorXd> directions;
    for (int i = 0; i < 6 && space.residual().norm() > 1e-12; ++i) {
      directions.push_back(space.next());
      EXPECT_TRUE(space.add((matrix * directions.back())));
    }
    const VectorXd weights = space.weights();
    for (std::size_t i = 0; i < directions.size(); ++i)
      x += weights[i] * directions[i];
    EXPECT_LT((b - matrix * x).norm(), 1e-10);
  }
}
