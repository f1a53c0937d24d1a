// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/step_space.h"

#include <utility>

namespace wheelrail {
namespace {

using Eigen::VectorXd;

constexpr double dependent = 1e-5; ///< of its length is left of an image
constexpr double hardly = 0.95;    ///< a residual falls

} // namespace

StepSpace::StepSpace(VectorXd b, int most)
    : triangle_(Eigen::MatrixXd::Zero(most, most)), residual_(std::move(b)),
      share_(VectorXd::Zero(most))
{
}

bool StepSpace::add(VectorXd image)
{
  const double whole = image.norm();
  const int k = size();
  for (int j = 0; j < k; ++j) { // modified Gram-Schmidt
    triangle_(j, k) = image.dot(basis_[j]);
    image -= triangle_(j, k) * basis_[j];
  }
  const double length = image.norm();
  if (!(length > dependent * whole))
    return false;
  triangle_(k, k) = length;
  image *= 1.0 / length;
  const double before = residual_.norm();
  share_[k] = image.dot(residual_);
  residual_ -= share_[k] * image;
  stalled_ = asked_ && residual_.norm() > hardly * before;
  asked_ = false;
  basis_.push_back(std::move(image));
  return true;
}

VectorXd StepSpace::next()
{
  asked_ = true;
  return stalled_ ? VectorXd(basis_.back()) : residual_;
}

VectorXd StepSpace::weights() const
{
  const int k = size();
  return triangle_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(share_.head(k));
}

} // namespace wheelrail
