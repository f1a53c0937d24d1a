// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/hertz_ellipse.h"

#include "shared/pi.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {
namespace {

using mcawr::pi;

/// A/B (the larger over the smaller) of an ellipse whose minor axis lies along x, m = 1 - (a/b)^2.
double steepness(double m)
{
  const EllipticIntegrals e = ellipticIntegrals(m);
  return e.B / ((1.0 - m) * e.D);
}

HertzEllipse completed(double load, double modulus, const GapCurvatures &curvatures, double ratio,
                       double major)
{
  const double m = 1.0 - ratio * ratio;
  const bool minorAlongX = curvatures.A >= curvatures.B;
  HertzEllipse h{load, modulus, curvatures, 0.0, 0.0, 0.0, 0.0};
  h.a = minorAlongX ? ratio * major : major;
  h.b = minorAlongX ? major : ratio * major;
  h.hertzPressure = 1.5 * load / (pi * h.a * h.b);
  h.approach = 1.5 * load * ellipticIntegrals(m).K / (pi * modulus * major);
  return h;
}

} // namespace

EllipticIntegrals ellipticIntegrals(double m)
{
  // Arithmetic-geometric mean (Abramowitz, Stegun 17.6); K - E = K sum of 2^(j-1) c_j^2, whose
  // first term is m/2, so that D needs no difference
  double a = 1.0, b = std::sqrt(1.0 - m);
  double c = m / (2.0 * (1.0 + b)); // (a - b)/2 without cancellation
  double sum = 0.0, weight = 1.0;   // of c_j^2/m
  while (true) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    const double term = m > 0.0 ? weight * c * c / m : 0.0;
    sum += term;
    if (c <= 1e-9 * a)
      break;
    weight *= 2.0;
    c = c * c / (4.0 * (0.5 * (a + b)));
  }
  EllipticIntegrals e;
  e.K = pi / (2.0 * a);
  e.D = e.K * (0.5 + sum);
  e.E = e.K - m * e.D;
  e.B = e.K - e.D;
  return e;
}

GapCurvatures gapOfRadii(double wheelRolling, double wheelProfile, double railProfile)
{
  return {0.5 / wheelRolling, 0.5 / wheelProfile + 0.5 / railProfile};
}

double HertzEllipse::pressure(double x, double y) const
{
  const double inside = 1.0 - x * x / (a * a) - y * y / (b * b);
  return inside > 0.0 ? hertzPressure * std::sqrt(inside) : 0.0;
}

double HertzEllipse::gap(double x, double y) const
{
  return curvatures.A * x * x + curvatures.B * y * y;
}

double curvatureRatio(double ratio)
{
  const double small = std::min(ratio, 1.0 / ratio);
  const double steep = steepness((1.0 - small) * (1.0 + small));
  return ratio <= 1.0 ? steep : 1.0 / steep;
}

// Bisection, for the curvatures' ratio is monotone in the semi-axes'; halving the logarithms'
// interval finds thin ellipses as fast as round ones.
double axesRatio(double ratio)
{
  const double steep = std::max(ratio, 1.0 / ratio);
  // (a/b)^(-3/2) is close to the ratio for nearly round ellipses, (a/b)^-2 bounds it for thin ones
  double low = 1.0 / steep, high = 1.0; // of the logarithms' interval
  for (int step = 0; step < 200 && high - low > 1e-16 * high; ++step) {
    const double middle = std::sqrt(low * high);
    if (!(middle > low && middle < high))
      break;
    (steepness((1.0 - middle) * (1.0 + middle)) > steep ? low : high) = middle;
  }
  const double small = 0.5 * (low + high);
  return ratio >= 1.0 ? small : 1.0 / small;
}

HertzEllipse hertzEllipse(double load, double modulus, const GapCurvatures &curvatures)
{
  const double ratio = axesRatio(curvatures.A / curvatures.B);
  const double small = std::min(ratio, 1.0 / ratio), m = (1.0 - small) * (1.0 + small);
  const double cube = 1.5 * load * ellipticIntegrals(m).E /
                      (pi * modulus * (1.0 - m) * (curvatures.A + curvatures.B));
  return completed(load, modulus, curvatures, small, std::cbrt(cube));
}

HertzEllipse hertzEllipseOfAxes(double load, double modulus, double a, double b)
{
  const double small = std::min(a, b) / std::max(a, b), m = (1.0 - small) * (1.0 + small);
  const double sum = 1.5 * load * ellipticIntegrals(m).E /
                     (pi * modulus * (1.0 - m) * std::pow(std::max(a, b), 3));
  const double ratio = curvatureRatio(a / b);
  const GapCurvatures curvatures{sum * ratio / (1.0 + ratio), sum / (1.0 + ratio)};
  HertzEllipse h = completed(load, modulus, curvatures, small, std::max(a, b));
  h.a = a;
  h.b = b;
  return h;
}

} // namespace wheelrail
