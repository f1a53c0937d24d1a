// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_RANDOM_NUMBER_H
#define WHEELRAIL_BASE_RANDOM_NUMBER_H

#include <cstdint>

namespace wheelrail {

/// Uniform number in [0, 1) that depends on (seed, index) only (SplitMix64): the same on every
/// machine and in every order of calls, unlike the standard library's distributions.
/// \param seed names a sequence
/// \param index of the number in it, from 0 on
/// \return a multiple of 2^-53
double uniformNumber(std::uint64_t seed, std::uint64_t index);

} // namespace wheelrail
#endif
