// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/fitted_law.h"

#include "law/covariance.h"
#include "law/kappa_law.h"

namespace wheelrail {

template<int Size>
LawDraws FittedLaw<Size>::draws() const
{
  return [law = this, root = rootOfCovariance(*covariance_)](const Eigen::VectorXd &normal) {
    return law->changed(root * normal);
  };
}

template class FittedLaw<lawParameters>;
template class FittedLaw<Eigen::Dynamic>;

} // namespace wheelrail
