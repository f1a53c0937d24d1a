// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_STATISTICS_H
#define WHEELRAIL_BASE_STATISTICS_H

namespace wheelrail {

/// Cumulative distribution of Student's t with nu > 0 (not necessarily whole) degrees of freedom,
/// dimensionless; relative accuracy of either tail about 1e-14 (Boost.Math).
/// \param t any finite or infinite number
/// \throws std::invalid_argument unless nu > 0
double studentCdf(double t, double nu);

/// The t with studentCdf(t, nu) = p.
/// \throws std::invalid_argument unless 0 < p < 1 and nu > 0
double studentQuantile(double p, double nu);

/// The normal quantile of 0.975: 95 % of the distribution lie within so many standard deviations.
constexpr double normal95 = 1.959963984540054;

} // namespace wheelrail

#endif
