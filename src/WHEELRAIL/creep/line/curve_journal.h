// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_CURVE_JOURNAL_H
#define WHEELRAIL_CREEP_LINE_CURVE_JOURNAL_H

#include "creep/line/curve_point.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace wheelrail {

/// Points of a contact along a line as a journal keeps them, to the last bit: SI units, each value
/// by the name of its column.
/// \param points of one piece of the sweep, in the order of its creeps
nlohmann::json curvePointsJson(const std::vector<CurvePoint> &points);
/// The way back.
/// \param rows  as `curvePointsJson` gives them
/// \return points that equal the written ones to the last bit
/// \throws nlohmann::json::exception for rows of another kind
std::vector<CurvePoint> curvePointsFrom(const nlohmann::json &rows);

} // namespace wheelrail
#endif
