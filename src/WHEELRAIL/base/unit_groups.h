// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_UNIT_GROUPS_H
#define WHEELRAIL_BASE_UNIT_GROUPS_H

#include <string>
#include <vector>

/// The units of a table's columns, said once for all that share one.
namespace wheelrail {

/// A column and its unit as files say it; "1": pure number.
struct NamedUnit {
  std::string name, unit;
};

/// A unit with its columns: {"N", "load, force_x"}.
struct UnitGroup {
  std::string unit, names;
};

/// In the order of the units' first columns.
std::vector<UnitGroup> unitGroups(const std::vector<NamedUnit> &columns);

/// "speed: m/s; traction, load: N; others: 1"
std::string unitsText(const std::vector<NamedUnit> &columns);

} // namespace wheelrail
#endif
