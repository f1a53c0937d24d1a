// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_TANGENTIAL_FIELD_H
#define WHEELRAIL_PATCH_TANGENTIAL_FIELD_H

#include <Eigen/Core>
#include <cmath>

namespace wheelrail {

/// Both components of a tangential traction, or of a tangential displacement, per cell.
struct TangentialField {
  Eigen::VectorXd x, y;
  /// Length of each cell's vector.
  Eigen::VectorXd length() const
  {
    return x.binaryExpr(y, [](double a, double b) { return std::hypot(a, b); });
  }
};

} // namespace wheelrail
#endif
