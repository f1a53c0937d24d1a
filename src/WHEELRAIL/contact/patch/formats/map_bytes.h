// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_MAP_BYTES_H
#define WHEELRAIL_PATCH_MAP_BYTES_H

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace wheelrail {

/// A number of a binary file, the least byte first, on machines of either kind.
/// \param bytes sizeof(Number) of them
template<class Number>
Number littleEndian(const char *bytes)
{
  std::uint64_t bits = 0;
  for (int k = static_cast<int>(sizeof(Number)) - 1; k >= 0; --k)
    bits = bits << 8 | static_cast<unsigned char>(bytes[k]);
  using Word = std::conditional_t<
      sizeof(Number) == 8, std::uint64_t,
      std::conditional_t<sizeof(Number) == 4, std::uint32_t,
                         std::conditional_t<sizeof(Number) == 2, std::uint16_t, std::uint8_t>>>;
  const auto word = static_cast<Word>(bits);
  Number value{};
  std::memcpy(&value, &word, sizeof value);
  return value;
}

/// A height of a binary file. Instruments mark what they did not measure by NaN, by an infinite or
/// the largest float, or by the smallest integer of the type.
template<class Number>
double heightFrom(const char *bytes)
{
  const auto value = littleEndian<Number>(bytes);
  bool measured = true;
  if constexpr (std::is_floating_point_v<Number>)
    measured = std::abs(value) < std::numeric_limits<Number>::max(); // false for NaN
  else
    measured = !std::is_signed_v<Number> || value > std::numeric_limits<Number>::min();
  return measured ? static_cast<double>(value) : std::numeric_limits<double>::quiet_NaN();
}

/// How a type of number in a binary file is read.
struct HeightType {
  int bytes;                          ///< of one number
  double (*height)(const char *from); ///< `heightFrom`
};
template<class Number>
inline constexpr HeightType heightType{sizeof(Number), heightFrom<Number>};

} // namespace wheelrail
#endif
