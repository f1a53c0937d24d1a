// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_PI_H
#define MCAWR_SHARED_PI_H

namespace mcawr {

/// Ratio of a circle's circumference to its diameter, rounded to double precision.
constexpr double pi = 3.14159265358979323846;

} // namespace mcawr
#endif
