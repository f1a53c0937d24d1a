// SPDX-License-Identifier: GPL-2.0-or-later
#include "roughness.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace mca {

static const double pi = std::acos(-1.0);

RoughProfile::RoughProfile(double length, double amplitude, double correlation, std::uint64_t seed)
    : length_(length)
{
  std::mt19937_64 random(seed);
  // beyond q l = 8 the amplitudes are below exp(-8) of the largest
  const int waves = std::max(1, static_cast<int>(8.0 * length / (2.0 * pi * correlation)));
  for (int k = 1; k <= waves; k++) {
    const double ql = 2.0 * pi * k * correlation / length;
    amplitude_.push_back(std::exp(-ql * ql / 8.0));
    phase_.push_back(2.0 * pi * std::ldexp(static_cast<double>(random() >> 11), -53));
  }
  double largest = 0.0;
  const int samples = 16 * waves;
  for (int s = 0; s < samples; s++)
    largest = std::max(largest, std::abs((*this)(length * s / samples)));
  for (auto &a : amplitude_)
    a *= amplitude / largest;
}

double RoughProfile::operator()(double x) const
{
  double sum = 0.0;
  for (size_t k = 0; k < amplitude_.size(); k++)
    sum +=
        amplitude_[k] * std::cos(2.0 * pi * static_cast<double>(k + 1) * x / length_ + phase_[k]);
  return sum;
}

} // namespace mca
