// SPDX-License-Identifier: GPL-2.0-or-later
/// \file roughness.h
/// A random rough profile, periodic in x. No LAMMPS type in here.
#ifndef MCA_LAWS_ROUGHNESS_H
#define MCA_LAWS_ROUGHNESS_H

#include <cstdint>
#include <vector>

namespace mca {

/// h(x) = sum_k a_k cos(2 pi k x/L + phi_k) with Gaussian autocorrelation exp(-x^2/l^2), that is
/// a_k ~ exp(-(2 pi k l/L)^2/8), random phases, scaled to the given largest |h|.
class RoughProfile {
 public:
  /// \param length       period L [length], > 0
  /// \param amplitude    largest |h| [length], >= 0
  /// \param correlation  l [length], > 0
  /// \param seed         the same seed gives the same profile on every machine
  RoughProfile(double length, double amplitude, double correlation, std::uint64_t seed);

  /// Height at x [length]; mean 0.
  double operator()(double x) const;

 private:
  double length_;
  std::vector<double> amplitude_, phase_;
};

} // namespace mca

#endif
