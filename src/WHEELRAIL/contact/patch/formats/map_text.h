// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_MAP_TEXT_H
#define WHEELRAIL_PATCH_MAP_TEXT_H

#include <string>
#include <string_view>

namespace wheelrail {

/// What the readers of height maps share: sizes and numbers of their heads.

/// Fewest points along each side, most points of a map.
constexpr long fewestMapPoints = 4;
/// 2^27 points are 1 GiB of heights.
constexpr long mostMapPoints = 1L << 27;

/// \throws Error (BadInput) unless fewestMapPoints x fewestMapPoints .. mostMapPoints
/// \param line of the file, for the message; 0: none
/// \param nx, ny as the head states them, before anything of that size is allocated
void checkMapSize(const std::string &path, int line, const std::string &keyword, long nx, long ny);

/// A whole number >= 0 that a head states. \throws Error (BadInput)
/// \param keyword as the head has it, for the message
long wholeNumber(const std::string &path, int line, const std::string &keyword,
                 const std::string &text);

/// A positive length with its unit, in m. \throws Error (BadInput)
/// \param text number and unit: "5 um"
double positiveLength(const std::string &path, int line, const std::string &keyword,
                      const std::string &text);

/// A decimal number that fills the whole text; finite. \return whether it is one
/// \param value set only if it is one
bool readDecimal(std::string_view text, double &value);

} // namespace wheelrail
#endif
