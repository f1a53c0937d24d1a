// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/cell_influence.h"

#include "shared/pi.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {
namespace {

using mcawr::pi;

/// Antiderivatives of y^2/r^3, x^2/r^3 and x y/r^3 in x and y.
CellIntegrals corner(double x, double y)
{
  return {x == 0.0 ? 0.0 : x * std::asinh(y / std::abs(x)),
          y == 0.0 ? 0.0 : y * std::asinh(x / std::abs(y)), -std::hypot(x, y)};
}

CellIntegrals fromCorners(double x, double y, double dx, double dy)
{
  const double left = x - 0.5 * dx, right = x + 0.5 * dx;
  const double below = y - 0.5 * dy, above = y + 0.5 * dy;
  const CellIntegrals a = corner(right, above), b = corner(left, above);
  const CellIntegrals c = corner(right, below), d = corner(left, below);
  return {(a.yy - b.yy) - (c.yy - d.yy), (a.xx - b.xx) - (c.xx - d.xx),
          (a.xy - b.xy) - (c.xy - d.xy)};
}

/// Gauss-Legendre points and weights on (-1/2, 1/2), half of each symmetric pair.
struct Quadrature {
  int points;
  double place[4], weight[4];
};
constexpr Quadrature fourPoints{
    4,
    {-0.43056815579702629, -0.16999052179242813, 0.16999052179242813, 0.43056815579702629},
    {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693}};
constexpr Quadrature twoPoints{2, {-0.28867513459481288, 0.28867513459481288}, {0.5, 0.5}};

/// Sums density(u, v) * weight over the cell, the cell's area included.
template<class Sum>
void quadrature(const Quadrature &rule, double x, double y, double dx, double dy, const Sum &add)
{
  for (int j = 0; j < rule.points; ++j)
    for (int i = 0; i < rule.points; ++i)
      add(x + rule.place[i] * dx, y + rule.place[j] * dy,
          dx * dy * rule.weight[i] * rule.weight[j]);
}

/// Antiderivatives of x/r^2 and y/r^2 in x and y.
CouplingIntegrals couplingCorner(double x, double y)
{
  const double log = std::log(std::hypot(x, y));
  return {(y == 0.0 ? 0.0 : y * log) + (x == 0.0 ? 0.0 : x * std::atan(y / x)),
          (x == 0.0 ? 0.0 : x * log) + (y == 0.0 ? 0.0 : y * std::atan(x / y))};
}

/// The quadrature's error falls as (cell/distance)^(2 x points), that of the corners' rounding
/// grows as (distance/cell)^2: both are below 1e-12 at these distances, in cells.
constexpr double near = 20.0, far = 500.0;

} // namespace

CellIntegrals cellIntegrals(double x, double y, double dx, double dy)
{
  const double distance = std::hypot(x, y) / std::max(dx, dy);
  if (distance < near)
    return fromCorners(x, y, dx, dy);
  CellIntegrals sum{0.0, 0.0, 0.0};
  quadrature(distance < far ? fourPoints : twoPoints, x, y, dx, dy,
             [&](double u, double v, double weight) {
               const double r2 = u * u + v * v, density = weight / (r2 * std::sqrt(r2));
               sum.yy += density * v * v;
               sum.xx += density * u * u;
               sum.xy += density * u * v;
             });
  return sum;
}

CouplingIntegrals couplingIntegrals(double x, double y, double dx, double dy)
{
  const double distance = std::hypot(x, y) / std::max(dx, dy);
  if (distance < near) {
    const double left = x - 0.5 * dx, right = x + 0.5 * dx;
    const double below = y - 0.5 * dy, above = y + 0.5 * dy;
    const CouplingIntegrals a = couplingCorner(right, above), b = couplingCorner(left, above);
    const CouplingIntegrals c = couplingCorner(right, below), d = couplingCorner(left, below);
    return {(a.x - b.x) - (c.x - d.x), (a.y - b.y) - (c.y - d.y)};
  }
  CouplingIntegrals sum{0.0, 0.0};
  quadrature(distance < far ? fourPoints : twoPoints, x, y, dx, dy,
             [&](double u, double v, double weight) {
               const double density = weight / (u * u + v * v);
               sum.x += density * u;
               sum.y += density * v;
             });
  return sum;
}

CellInfluence cellInfluence(const ElasticPair &pair, const CellIntegrals &integrals)
{
  const double scale = 1.0 / (pi * pair.G), less = 1.0 - pair.nu;
  return {scale * less * (integrals.yy + integrals.xx),
          scale * (less * integrals.yy + integrals.xx),
          scale * (integrals.yy + less * integrals.xx), scale * pair.nu * integrals.xy};
}

} // namespace wheelrail
