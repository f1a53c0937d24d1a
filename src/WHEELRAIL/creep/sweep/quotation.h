// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_QUOTATION_H
#define WHEELRAIL_CREEP_SWEEP_QUOTATION_H

#include "creep/sweep/law_spread.h"

#include <string>
#include <vector>

namespace wheelrail {

/// A point of a sweep as far as it is quoted.
struct QuotedPoint {
  double speed = 0.0; ///< m/s
  double creep = 0.0; ///< of any sign
  double ratio = 0.0; ///< T/N
  Band band;          ///< of T/N, by the law's errors
};

/// T/N near 10 % of creep at the first speed, in one line that a user can quote with its
/// uncertainty: the mean over the surfaces, its 95 % interval by the law's errors (the mean of
/// theirs; left out where none are known), and the least and largest of the surfaces (left out of
/// one):
///   T/N at 10 % creep, 10 m/s: 0.296, 95 % of law 0.256..0.305, of roughness 0.283..0.302
/// \param points converged; those of one speed and creep differ by their surface only
/// \return with a line's end; empty where no creep is within a factor of 2 of 10 %
std::string quotation(const std::vector<QuotedPoint> &points);

} // namespace wheelrail
#endif
