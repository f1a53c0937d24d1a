// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/formats/height_map.h"

namespace wheelrail {

int HeightMap::unmeasured() const
{
  return static_cast<int>(height.array().isNaN().count());
}

HeightMap mirrored(const HeightMap &map)
{
  HeightMap result = map;
  for (int iy = 0; iy < map.ny; ++iy)
    result.height.segment(map.index(0, iy), map.nx) =
        map.height.segment(map.index(0, map.ny - 1 - iy), map.nx);
  return result;
}

} // namespace wheelrail
