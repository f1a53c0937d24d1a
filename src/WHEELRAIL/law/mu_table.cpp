// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/mu_table.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {

MuCurves::MuCurves(const MuTable &table)
    : referenceSpeed_(table.speed.reference), speed_(table.speed.range)
{
  for (const double ratio : table.speed.ratio)
    speedExponent_.x.push_back(std::log(ratio));
  speedExponent_.y = table.speed.exponent;
  for (const MuTable::Row &row : table.rows) {
    temperature_.push_back(row.temperature);
    const std::size_t n = row.ratio.size();
    Row made{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n, 0.0)};
    for (std::size_t k = 0; k < n; ++k) {
      made.place[k] = std::log(row.ratio[k]);
      made.value[k] = std::log(row.mu[k]);
    }
    const auto secant = [&](std::size_t k) {
      return (made.value[k + 1] - made.value[k]) / (made.place[k + 1] - made.place[k]);
    };
    for (std::size_t k = 0; n > 1 && k < n; ++k)
      made.slope[k] = k == 0       ? secant(0)
                      : k + 1 == n ? secant(n - 2)
                                   : limitedSlope(secant(k - 1), secant(k));
    rows_.push_back(std::move(made));
  }
}

double MuCurves::Row::at(double u) const
{
  const std::size_t n = place.size();
  // over a factor of e in pressure: to a slope of 0 below, to one of -1 above
  if (const double below = u - place[0]; below <= 0.0)
    return value[0] + slope[0] * std::expm1(below);
  if (const double above = u - place[n - 1]; above >= 0.0)
    return value[n - 1] - above - (1.0 + slope[n - 1]) * std::expm1(-above);
  const std::size_t k = pieceOf(place, u);
  return hermite(place[k + 1] - place[k], value[k], slope[k], value[k + 1], slope[k + 1],
                 u - place[k]);
}

double MuCurves::operator()(double ratio, double temperature, double slidingSpeed) const
{
  // far below the table a row is constant: ln 0 is not needed
  constexpr double least = 1e-30;
  const double u = std::log(std::max(ratio, least));
  const std::vector<double> &x = temperature_;
  const std::size_t last = x.size() - 1;
  double result = 0.0;
  if (temperature <= x.front() || last == 0) {
    result = rows_.front().at(u);
  } else if (temperature >= x.back()) {
    result = rows_.back().at(u);
  } else { // as `MonotoneCurve` over the rows, of which only those beside the temperature count
    const std::size_t k = pieceOf(x, temperature);
    const double here = rows_[k].at(u), next = rows_[k + 1].at(u);
    const double secant = (next - here) / (x[k + 1] - x[k]);
    const double before =
        k == 0 ? 0.0 : limitedSlope((here - rows_[k - 1].at(u)) / (x[k] - x[k - 1]), secant);
    const double after =
        k + 1 == last ? 0.0
                      : limitedSlope(secant, (rows_[k + 2].at(u) - next) / (x[k + 2] - x[k + 1]));
    result = hermite(x[k + 1] - x[k], here, before, next, after, temperature - x[k]);
  }
  if (!speedExponent_.x.empty())
    result += speedExponent_(u) *
              std::log(std::clamp(slidingSpeed, speed_[0], speed_[1]) / referenceSpeed_);
  return std::exp(result);
}

double MuTable::operator()(double ratio, double temperature, double slidingSpeed) const
{
  return MuCurves(*this)(ratio, temperature, slidingSpeed);
}

Eigen::Index MuTable::parameters() const
{
  auto count = static_cast<Eigen::Index>(speed.exponent.size());
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
  for (const double error : speed.exponentSe)
    errors[k++] = error;
  return errors;
}

MuTable MuTable::changed(const Eigen::VectorXd &change) const
{
  MuTable other = *this;
  Eigen::Index k = 0;
  for (Row &row : other.rows)
    for (double &mu : row.mu)
      mu += change[k++];
  for (double &exponent : other.speed.exponent)
    exponent += change[k++];
  return other;
}

} // namespace wheelrail
