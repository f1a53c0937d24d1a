// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/solvers/step_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheelrail {
namespace {

using Eigen::VectorXd;
using Eigen::VectorXf;

constexpr double dependent = 1e-5; ///< of its length is left of an image: rounding is 1e-7 of it
constexpr double hardly = 0.95;    ///< a residual falls

/// Summed in parts in double: its error is that of 4096 terms.
double innerProduct(const VectorXf &a, const VectorXf &b)
{
  double sum = 0.0;
  constexpr Eigen::Index part = 4096;
  for (Eigen::Index i = 0; i < a.size(); i += part) {
    const Eigen::Index length = std::min(part, a.size() - i);
    sum += a.segment(i, length).dot(b.segment(i, length));
  }
  return sum;
}

} // namespace

StepSpace::StepSpace(VectorXd b, int most)
    : triangle_(Eigen::MatrixXd::Zero(most, most)), residual_(std::move(b)),
      share_(VectorXd::Zero(most))
{
}

bool StepSpace::add(VectorXf image)
{
  const double whole = std::sqrt(innerProduct(image, image));
  const int k = size();
  for (int j = 0; j < k; ++j) { // modified Gram-Schmidt
    triangle_(j, k) = innerProduct(image, basis_[j]);
    image -= static_cast<float>(triangle_(j, k)) * basis_[j];
  }
  const double length = std::sqrt(innerProduct(image, image));
  if (!(length > dependent * whole))
    return false;
  triangle_(k, k) = length;
  image *= static_cast<float>(1.0 / length);
  const double before = residual_.norm();
  const VectorXd direction = image.cast<double>();
  share_[k] = direction.dot(residual_);
  residual_ -= share_[k] * direction;
  stalled_ = asked_ && residual_.norm() > hardly * before;
  asked_ = false;
  basis_.push_back(std::move(image));
  return true;
}

VectorXd StepSpace::next()
{
  asked_ = true;
  return stalled_ ? VectorXd(basis_.back().cast<double>()) : residual_;
}

VectorXd StepSpace::weights() const
{
  const int k = size();
  return triangle_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(share_.head(k));
}

} // namespace wheelrail
