// SPDX-License-Identifier: GPL-2.0-or-later
#include "roughness.h"

#include "shared/pi.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace mca {

using mcawr::pi;

RoughProfile::RoughProfile(double length, double amplitude, double correlation, std::uint64_t seed)
    : length_(length)
{
  std::mt19937_64 random(seed);
  // beyond q l = 8 the amplitudes are below exp(-8) of the largest
  const int waves = std::max(1, static_cast<int>(8.0 * length / (2.0 * pi * correlation)));
  for (int k = 1; k <= waves; k++) {
    const double ql = 2.0 * pi * k * correlation / length;
    waves_.push_back(std::polar(std::exp(-ql * ql / 8.0),
                                2.0 * pi * std::ldexp(static_cast<double>(random() >> 11), -53)));
  }
  double largest = 0.0;
  const int samples = 16 * waves;
  for (int s = 0; s < samples; s++)
    largest = std::max(largest, std::abs((*this)(length * s / samples)));
  for (auto &wave : waves_)
    wave *= amplitude / largest;
}

// The real part of a polynomial in exp(2 pi i x/L), by Horner's rule: a cosine for each wave would
// take ten times as long. Real and imaginary part by hand: products of std::complex look for nan.
double RoughProfile::operator()(double x) const
{
  const double angle = 2.0 * pi * x / length_;
  const double c = std::cos(angle), s = std::sin(angle);
  double re = 0.0, im = 0.0;
  for (auto wave = waves_.rbegin(); wave != waves_.rend(); ++wave) {
    const double a = re + wave->real(), b = im + wave->imag();
    re = a * c - b * s;
    im = a * s + b * c;
  }
  return re;
}

} // namespace mca
