// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_QUANTITY_H
#define WHEELRAIL_BASE_QUANTITY_H

#include <string>

namespace wheelrail {

/// A number with its unit, such as "4000 N/mm", converted to `unit` by UDUNITS-2: the one place
/// where quantities of case files, profiles and command lines are read.
///
/// The number is decimal ("-1.5e-3"); blanks around it and before the unit are skipped. The unit is
/// as UDUNITS-2 spells it ("kg/m3", "W/(m K)", "km/h"), but without a number of its own: "1 500
/// N/mm" is refused, not taken for 500 N/mm. A reciprocal is written "1/mm" or "mm-1".
/// \param unit what the caller wants ("N/m"); "" or "1" for pure numbers, which carry no unit
/// \return finite, in `unit`
/// \throws std::invalid_argument that says what is wrong: no number, not finite, hexadecimal, no
///         unit, an unknown unit, one with a number in it, one of another dimension, a scale with
///         an offset (degC for a difference)
double parseQuantity(const std::string &text, const std::string &unit);

/// A plain decimal number; the whole text has to be one, but for blanks around it.
/// \return finite
/// \throws std::invalid_argument for anything else: words, units, "0x10", nan, inf
double parseNumber(const std::string &text);

/// A plain number, or one in per cent: "0.005" and "0.5 %" are the same.
/// \return finite
/// \throws std::invalid_argument for anything else
double parseRatio(const std::string &text);

/// The SI unit of the same dimension, without a prefix: "N m" of "N mm", "1/m" of "1/mm".
/// \param unit of a file's column: m, N, Pa, W, s, K and pure numbers, with or without a prefix
std::string siUnit(const std::string &unit);

} // namespace wheelrail
#endif
