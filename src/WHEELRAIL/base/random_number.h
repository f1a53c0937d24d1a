// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_RANDOM_NUMBER_H
#define WHEELRAIL_BASE_RANDOM_NUMBER_H

#include <cstdint>

namespace wheelrail {

/// Uniform number in [0, 1) that depends on (seed, index) only (SplitMix64): the same on every
/// machine, unlike the standard library's distributions.
double uniformNumber(std::uint64_t seed, std::uint64_t index);

} // namespace wheelrail
#endif
