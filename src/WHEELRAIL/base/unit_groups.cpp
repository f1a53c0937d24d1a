// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/unit_groups.h"

#include <algorithm>

namespace wheelrail {

std::vector<UnitGroup> unitGroups(const std::vector<NamedUnit> &columns)
{
  std::vector<UnitGroup> groups;
  for (const auto &[name, unit] : columns) {
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [&, &own = unit](const UnitGroup &g) { return g.unit == own; });
    if (found == groups.end())
      groups.push_back({unit, name});
    else
      found->names += ", " + name;
  }
  return groups;
}

std::string unitsText(const std::vector<NamedUnit> &columns)
{
  std::string text;
  for (const auto &[unit, names] : unitGroups(columns))
    if (unit != "1")
      text += names + ": " + unit + "; ";
  return text + "others: 1";
}

} // namespace wheelrail
