// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_FITTED_LAW_H
#define WHEELRAIL_LAW_FITTED_LAW_H

#include "law/friction_law.h"

#include <Eigen/Core>

#include <optional>
#include <utility>

namespace wheelrail {

/// A law with parameters that are known to a covariance: what bands around results need of it. The
/// law itself adds `changed`, and `isDefined` and `isSound` where not all parameters make a law.
/// \tparam Size  number of parameters, or Eigen::Dynamic; one that stands at the end of
///         fitted_law.cpp, so that decompositions are compiled there alone
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
  LawDraws draws() const final;

 protected:
  /// \param covariance symmetric, positive semi-definite; absent: none is known
  explicit FittedLaw(std::optional<Covariance> covariance) : covariance_(std::move(covariance)) {}

 private:
  std::optional<Covariance> covariance_;
};

} // namespace wheelrail
#endif
