// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/line/line_coupling.h"

namespace wheelrail {

using Vector = Eigen::VectorXd;

Vector couplingSlip(double beta, const Vector &pressure)
{
  const auto n = pressure.size();
  Vector slip = beta * pressure;
  slip.head(n - 1) += beta * pressure.tail(n - 1);
  return slip;
}

// -beta sum over j of sign(i - j) p_j
Vector couplingDisplacement(double beta, const Vector &stress)
{
  Vector displacement(stress.size());
  double below = -0.5 * stress.sum();
  for (Eigen::Index i = 0; i < stress.size(); ++i) {
    displacement[i] = -2.0 * beta * (below + 0.5 * stress[i]);
    below += stress[i];
  }
  return displacement;
}

} // namespace wheelrail
