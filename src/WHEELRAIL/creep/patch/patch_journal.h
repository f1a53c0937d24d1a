// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_JOURNAL_H
#define WHEELRAIL_CREEP_PATCH_JOURNAL_H

#include "creep/patch/moving_patch.h"

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace wheelrail {

/// Points and time series of a finished piece as a journal keeps them, and back to the last bit.
nlohmann::json patchPointsJson(const std::vector<PatchPoint> &points);
std::vector<PatchPoint> patchPointsFrom(const nlohmann::json &rows);
nlohmann::json patchSeriesJson(const std::map<int, std::vector<PatchStep>> &series);
std::map<int, std::vector<PatchStep>> patchSeriesFrom(const nlohmann::json &series);

} // namespace wheelrail
#endif
