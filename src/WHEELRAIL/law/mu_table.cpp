// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/mu_table.h"

#include "base/monotone_curve.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {

namespace {

/// ln mu of a row at u = ln(p/sigma_0).
double logMu(const MuTable::Row &row, double u)
{
  const std::size_t n = row.ratio.size();
  const auto place = [&](std::size_t k) { return std::log(row.ratio[k]); };
  const auto value = [&](std::size_t k) { return std::log(row.mu[k]); };
  const auto secant = [&](std::size_t k) {
    return (value(k + 1) - value(k)) / (place(k + 1) - place(k));
  };
  const auto slope = [&](std::size_t k) {
    if (n == 1)
      return 0.0;
    return k == 0 ? secant(0) : k + 1 == n ? secant(n - 2) : limitedSlope(secant(k - 1), secant(k));
  };
  // over a factor of e in pressure: to a slope of 0 below, to one of -1 above
  if (const double below = u - place(0); below <= 0.0)
    return value(0) + slope(0) * std::expm1(below);
  if (const double above = u - place(n - 1); above >= 0.0)
    return value(n - 1) - above - (1.0 + slope(n - 1)) * std::expm1(-above);
  std::size_t k = 0;
  while (k + 2 < n && u > place(k + 1))
    ++k;
  return hermite(place(k + 1) - place(k), value(k), slope(k), value(k + 1), slope(k + 1),
                 u - place(k));
}

} // namespace

double MuTable::operator()(double ratio, double temperature, double slidingSpeed) const
{
  // far below the table a row is constant: ln 0 is not needed
  constexpr double least = 1e-30;
  const double u = std::log(std::max(ratio, least));
  // only the rows beside the temperature, and theirs, count
  std::size_t first = 0, last = rows.size() - 1;
  while (last - first > 3 && temperature > rows[first + 2].temperature)
    ++first;
  last = std::min(last, first + 3);
  MonotoneCurve along;
  for (std::size_t k = first; k <= last; ++k) {
    along.x.push_back(rows[k].temperature);
    along.y.push_back(logMu(rows[k], u));
  }
  double result = along(temperature);
  if (speedExponent != 0.0)
    result +=
        speedExponent * std::log(std::clamp(slidingSpeed, speed[0], speed[1]) / referenceSpeed);
  return std::exp(result);
}

Eigen::Index MuTable::parameters() const
{
  Eigen::Index count = 1;
  for (const Row &row : rows)
    count += static_cast<Eigen::Index>(row.mu.size());
  return count;
}

Eigen::VectorXd MuTable::standardErrors() const
{
  Eigen::VectorXd errors(parameters());
  Eigen::Index k = 0;
  for (const Row &row : rows)
    for (const double error : row.muSe)
      errors[k++] = error;
  errors[k] = speedExponentSe;
  return errors;
}

MuTable MuTable::changed(const Eigen::VectorXd &change) const
{
  MuTable other = *this;
  Eigen::Index k = 0;
  for (Row &row : other.rows)
    for (double &mu : row.mu)
      mu += change[k++];
  other.speedExponent += change[k];
  return other;
}

} // namespace wheelrail
