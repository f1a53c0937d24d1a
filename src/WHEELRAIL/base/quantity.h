#ifndef WHEELRAIL_BASE_QUANTITY_H
#define WHEELRAIL_BASE_QUANTITY_H

#include <string>

namespace wheelrail {

/// A number with its unit, such as "4000 N/mm", converted to `unit` by UDUNITS-2.
/// @param unit what the caller wants ("N/m"); "" or "1" for pure numbers, which carry no unit
/// @throws std::invalid_argument that says what is wrong: no number, not finite, no unit, an
/// unknown
///         unit, a unit of another dimension, a scale with an offset (degC for a difference)
double parseQuantity(const std::string &text, const std::string &unit);

/// A plain number; the whole text has to be one.
/// @throws std::invalid_argument for anything else, and for nan and inf
double parseNumber(const std::string &text);

} // namespace wheelrail
#endif
