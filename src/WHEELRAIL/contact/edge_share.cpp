// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/edge_share.h"

#include <cmath>

namespace wheelrail {

// With the share y that is apart p = K sqrt(1 - y) and g = (4/3) K y^(3/2), so that y solves
// y^3 + k y = k with k = (3 g/(4 p))^2.
double shareApart(double pressure, double gap)
{
  const double k = std::pow(0.75 * gap / pressure, 2);
  if (!(k > 0.0))
    return 0.0;
  // the one real root of a depressed cubic, without cancellation whatever k
  return 2.0 * std::sqrt(k / 3.0) * std::sinh(std::asinh(1.5 * std::sqrt(3.0 / k)) / 3.0);
}

} // namespace wheelrail
