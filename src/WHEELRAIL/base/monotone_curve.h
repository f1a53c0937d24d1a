// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_MONOTONE_CURVE_H
#define WHEELRAIL_BASE_MONOTONE_CURVE_H

#include <cstddef>
#include <vector>

namespace wheelrail {

/// A curve through given values with a continuous derivative that never leaves the range of the two
/// values beside it, so that it is monotone wherever they are: cubic Hermite pieces whose slopes
/// are limited. Beyond its ends a curve has the value of the end, and there the slope is 0.
struct MonotoneCurve {
  std::vector<double> x; ///< rising, at least one
  std::vector<double> y; ///< as many

  /// \return y at any finite place
  double operator()(double at) const;
};

/// Slope of such a curve where two secants meet:
///   2 s0^2 s1^2/(|s0|^3 + |s1|^3) with their sign, 0 where their signs differ.
/// At most 1.06 times the flatter one in size, which keeps both pieces monotone (three times would
/// do), and itself smooth in both secants, also where one passes 0.
double limitedSlope(double before, double after);

/// The cubic from (0, y0) with slope s0 to (width, y1) with slope s1.
/// \param at 0 .. width, of the unit in which the slopes count
double hermite(double width, double y0, double s0, double y1, double s1, double at);

/// The piece of rising places that holds a place: the number of its left end, 0 .. size - 2.
/// \param x rising, at least two
std::size_t pieceOf(const std::vector<double> &x, double at);

} // namespace wheelrail
#endif
