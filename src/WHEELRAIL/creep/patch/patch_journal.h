// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_JOURNAL_H
#define WHEELRAIL_CREEP_PATCH_JOURNAL_H

#include "creep/patch/moving_patch.h"

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

/// Points and time series of a finished piece as a journal keeps them, and back to the last bit: SI
/// units, each value by the name of its column.
/// \param points of one piece of the sweep, in the order of its tasks
nlohmann::json patchPointsJson(const std::vector<PatchPoint> &points);
/// The way back. \param rows as `patchPointsJson` gives them
/// \return points that equal the written ones to the last bit
std::vector<PatchPoint> patchPointsFrom(const nlohmann::json &rows);
/// The time series of mode moving, by number of the point (from 1 on); empty in the other modes.
/// \return an object with one table for each point, SI units
nlohmann::json patchSeriesJson(const std::map<int, std::vector<PatchStep>> &series);
/// The way back, with the same numbers of the points.
std::map<int, std::vector<PatchStep>> patchSeriesFrom(const nlohmann::json &series);

/// Fields as bytes, for a file beside the journal: the numbers as they lie in memory.
std::string patchFieldsBytes(const PatchFields &fields);
/// The way back. \param cells of the grid
/// \return nothing for bytes of another length
std::optional<PatchFields> patchFieldsFrom(const std::string &bytes, int cells);

} // namespace wheelrail
#endif
