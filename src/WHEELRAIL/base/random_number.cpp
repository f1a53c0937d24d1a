// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/random_number.h"

namespace wheelrail {

double uniformNumber(std::uint64_t seed, std::uint64_t index)
{
  std::uint64_t z = seed * 0xD1342543DE82EF95ull + (index + 1) * 0x9E3779B97F4A7C15ull;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1.0p-53;
}

} // namespace wheelrail
