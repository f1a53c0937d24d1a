// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_table.h"

#include "base/errors.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>

namespace wheelrail {
namespace {

constexpr int digits = 10;

struct Axis {
  const char *name;
  const std::vector<double> &values; ///< SI
};

/// In the order of `patchTasks`, the last one fastest; named as columns of `patchColumns`.
std::vector<Axis> axesOf(const PatchSpecification &asked)
{
  return {{"load", asked.contact.load},
          {"speed", asked.speed},
          {"spin", asked.spin},
          {"lateral", asked.lateral},
          {"creep", asked.creep}};
}

/// The coordinates, in the order of the axes.
FileColumns<PatchPoint> coordinatesOf(const std::vector<Axis> &axes)
{
  std::vector<std::string> names;
  for (const Axis &axis : axes)
    names.emplace_back(axis.name);
  return columnsNamed(patchColumns(), names, digits);
}

FileColumns<PatchPoint> forceColumns()
{
  return columnsNamed(patchColumns(), {"force_x", "force_y", "moment_z"}, digits);
}

std::string withoutEnd(std::string line)
{
  line.pop_back();
  return line;
}

[[noreturn]] void fail(const std::string &problem)
{
  throw Error(ExitCode::Usage, "--table: " + problem);
}

} // namespace

void checkPatchTable(const PatchSpecification &asked)
{
  if (asked.mode == PatchMode::Static || asked.sequence.any())
    fail("goes with a point contact (contact.load) that rolls, without a sequence");
  if (!asked.forceX.empty() || !asked.forceY.empty())
    fail("goes with creepages, not with force: they are the table's coordinates");
  if (asked.roughness.surfaces() > 1)
    fail(fmt::format("goes with one surface; {} are given", asked.roughness.surfaces()));
  for (const Axis &axis : axesOf(asked))
    if (std::adjacent_find(axis.values.begin(), axis.values.end(), std::greater_equal<>()) !=
        axis.values.end())
      fail(fmt::format("the values of {} must increase",
                       axis.name == std::string("load") ? "contact.load" : axis.name));
}

std::string patchTable(const PatchSpecification &asked, const PatchCurves &curves,
                       const ResultHead &head)
{
  const std::vector<Axis> axes = axesOf(asked);
  const FileColumns<PatchPoint> coordinates = coordinatesOf(axes), forces = forceColumns();
  FileColumns<PatchPoint> all = coordinates;
  all.insert(all.end(), forces.begin(), forces.end());
  std::vector<std::string> sizes;
  for (const Axis &axis : axes)
    sizes.push_back(fmt::format("{} {}", axis.values.size(), axis.name));
  std::string text = "# wr_creep-table 1: forces on the wheel over load, speed and creepages\n# ";
  for (const auto &[unit, names] : unitGroups(namedUnits(all)))
    text += fmt::format("{}: {}; ", names, unit);
  text += fmt::format("converged: 1, or 0 and no forces\n# grid: {}; creep varies fastest\n",
                      fmt::join(sizes, " x "));
  text += tableHead(head) + withoutEnd(headOf(all)) + ",converged\n";
  const std::string none = std::string(forces.size(), ',') + ",0\n";
  for (const PatchPoint &point : curves.points) {
    text += withoutEnd(rowOf(coordinates, point));
    text += point.converged() ? "," + withoutEnd(rowOf(forces, point)) + ",1\n" : none;
  }
  return text;
}

} // namespace wheelrail
