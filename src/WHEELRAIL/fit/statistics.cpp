#include "fit/statistics.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace wheelrail {

namespace {

/// Continued fraction of I_x(a, b), by the modified Lentz method; converges fast for
/// x < (a + 1)/(a + b + 2).
double betaFraction(double x, double a, double b)
{
  constexpr double tiny = std::numeric_limits<double>::min();
  constexpr double eps = std::numeric_limits<double>::epsilon();
  constexpr int mostTerms = 10000;
  const auto guard = [](double y) { return std::abs(y) < tiny ? tiny : y; };
  double c = 1.0;
  double d = 1.0 / guard(1.0 - (a + b) * x / (a + 1.0));
  double result = d;
  for (int m = 1; m < mostTerms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1.0 / guard(1.0 + even * d);
    c = guard(1.0 + even / c);
    result *= c * d;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1.0 / guard(1.0 + odd * d);
    c = guard(1.0 + odd / c);
    result *= c * d;
    if (std::abs(c * d - 1.0) < eps)
      return result;
  }
  throw std::runtime_error("incomplete beta function: no convergence");
}

} // namespace

double incompleteBeta(double x, double a, double b)
{
  if (!(x >= 0.0 && x <= 1.0 && a > 0.0 && b > 0.0))
    throw std::invalid_argument("incompleteBeta: needs 0 <= x <= 1 and a, b > 0");
  if (x == 0.0 || x == 1.0)
    return x;
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                a * std::log(x) + b * std::log1p(-x));
  if (x < (a + 1.0) / (a + b + 2.0))
    return front * betaFraction(x, a, b) / a;
  return 1.0 - front * betaFraction(1.0 - x, b, a) / b;
}

double studentCdf(double t, double nu)
{
  const double tail = 0.5 * incompleteBeta(nu / (nu + t * t), 0.5 * nu, 0.5);
  return t > 0.0 ? 1.0 - tail : tail;
}

double studentQuantile(double p, double nu)
{
  if (!(p > 0.0 && p < 1.0 && nu > 0.0))
    throw std::invalid_argument("studentQuantile: needs 0 < p < 1 and nu > 0");
  if (p > 0.5)
    return -studentQuantile(1.0 - p, nu);
  double low = -1.0;
  while (studentCdf(low, nu) > p)
    low *= 2.0;
  double high = 0.0;
  for (int i = 0; i < 200; ++i) { // ends when the interval cannot be halved any more
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high)
      break;
    (studentCdf(middle, nu) > p ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace wheelrail
