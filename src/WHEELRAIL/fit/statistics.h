#ifndef WHEELRAIL_FIT_STATISTICS_H
#define WHEELRAIL_FIT_STATISTICS_H

namespace wheelrail {

/// Cumulative distribution of Student's t with nu > 0 (not necessarily whole) degrees of freedom.
/// Relative accuracy of the tail about 1e-14 for few degrees of freedom, 1e-15 nu for many.
double studentCdf(double t, double nu);

/// The t with studentCdf(t, nu) = p, for 0 < p < 1.
double studentQuantile(double p, double nu);

/// Regularised incomplete beta function I_x(a, b), 0 <= x <= 1, a, b > 0 (continued fraction,
/// Abramowitz and Stegun 26.5.8).
double incompleteBeta(double x, double a, double b);

} // namespace wheelrail

#endif
