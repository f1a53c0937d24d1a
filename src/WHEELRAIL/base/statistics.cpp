// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/statistics.h"

#include <boost/math/distributions/students_t.hpp>

#include <stdexcept>

namespace wheelrail {

double studentCdf(double t, double nu)
{
  if (!(nu > 0.0))
    throw std::invalid_argument("studentCdf: needs nu > 0");
  return boost::math::cdf(boost::math::students_t(nu), t);
}

double studentQuantile(double p, double nu)
{
  if (!(p > 0.0 && p < 1.0 && nu > 0.0))
    throw std::invalid_argument("studentQuantile: needs 0 < p < 1 and nu > 0");
  return boost::math::quantile(boost::math::students_t(nu), p);
}

} // namespace wheelrail
