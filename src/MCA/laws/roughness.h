// SPDX-License-Identifier: GPL-2.0-or-later
/// \file roughness.h
/// A random rough profile, periodic in x. No LAMMPS type in here.
#ifndef MCA_LAWS_ROUGHNESS_H
#define MCA_LAWS_ROUGHNESS_H

#include <complex>
#include <cstdint>
#include <vector>

namespace mca {

/// h(x) = sum_k a_k cos(2 pi k x/L + phi_k) with Gaussian autocorrelation exp(-x^2/l^2), that is
/// a_k ~ exp(-(2 pi k l/L)^2/8), random phases, scaled to the given largest |h|. Waves of 2 pi k
/// l/L > 8, whose amplitudes are below exp(-8) of the longest one's, are left out; the first wave
/// always stands. Bucher et al. give the roughness of the blocks explicitly, without a law; this
/// one is ours.
class RoughProfile {
 public:
  /// Largest L/l: making the profile takes (L/l)^2 times 80 ns, a height L/l times 4 ns.
  static constexpr int most = 4000;

  /// \param length       period L [length], > 0: the box length in x of region mca/rough
  /// \param amplitude    largest |h| [length], >= 0, found on 16 places for each wave; 0 gives a
  ///                     plane
  /// \param correlation  l [length], L/most to L
  /// \param seed         the same seed gives the same profile on every machine
  RoughProfile(double length, double amplitude, double correlation, std::uint64_t seed);

  /// Height at x [length]; mean 0, period L. Takes as long as there are waves, about 1.3 L/l.
  /// \param x  any place [length]
  double operator()(double x) const;

 private:
  double length_;
  /// a_k exp(i phi_k) [length], wave k = 1 first.
  std::vector<std::complex<double>> waves_;
};

} // namespace mca

#endif
