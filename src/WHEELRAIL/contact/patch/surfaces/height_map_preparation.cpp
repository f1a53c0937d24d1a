// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/surfaces/height_map_preparation.h"

#include "base/errors.h"
#include "contact/measured_file.h"

#include <fmt/format.h>

namespace wheelrail {

PreparedHeightMap prepareHeightMap(const std::string &path, const HeightMapPreparation &preparation,
                                   const std::string &name)
{
  refuseTransverseProfile(path);
  PreparedHeightMap result{readHeightMap(path, preparation.scale), {}, {}};
  HeightMap &map = result.map;
  const auto note = [&](const std::string &step, double cutoff = 0.0) {
    result.statistics.push_back(heightMapStatistics(name + ": " + step, map, cutoff));
  };
  if (const std::string doubt =
          isolatedHeights(path, map.height, "Write nan where nothing was measured");
      !doubt.empty())
    result.remarks.push_back(doubt);
  if (preparation.turn)
    map = turned(map);
  if (preparation.mirror)
    map = mirrored(map);
  note("as read");
  const int holes = map.unmeasured();
  if (holes > 0 && !preparation.fill)
    throw badInput(path, 0, "",
                   fmt::format("{} of {} points are not measured; fill them or measure again",
                               holes, map.height.size()));
  if (preparation.form != Form::None) {
    map = withoutForm(map, preparation.form);
    note("form removed");
  }
  if (holes > 0) {
    map = withoutForm(filled(map), preparation.form);
    note(fmt::format("{} points filled", holes));
  }
  if (preparation.cutoff > 0.0) {
    map = lowPassed(map, preparation.cutoff);
    note("low-passed", preparation.cutoff);
  }
  return result;
}

} // namespace wheelrail
