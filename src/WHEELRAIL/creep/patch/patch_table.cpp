// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_table.h"

#include "base/errors.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>

namespace wheelrail {
namespace {

constexpr double newtonMm = 1e-3, perMm = 1e3;

struct Axis {
  const char *name;
  const std::vector<double> &values; ///< SI
};

/// In the order of `patchTasks`, the last one fastest.
std::vector<Axis> axesOf(const PatchSpecification &asked)
{
  return {{"load", asked.contact.load},
          {"speed", asked.speed},
          {"spin", asked.spin},
          {"lateral", asked.lateral},
          {"creep", asked.creep}};
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

std::string patchTable(const PatchSpecification &asked, const PatchCurves &curves)
{
  std::vector<std::string> sizes;
  for (const Axis &axis : axesOf(asked))
    sizes.push_back(fmt::format("{} {}", axis.values.size(), axis.name));
  std::string text = fmt::format(
      "# wr_creep-table 1: forces on the wheel over load, speed and creepages\n"
      "# load, force_x, force_y: N; speed: m/s; spin: 1/mm; lateral, creep: 1; moment_z: N mm; "
      "converged: 1, or 0 and no forces\n"
      "# grid: {}; creep varies fastest\n"
      "load,speed,spin,lateral,creep,force_x,force_y,moment_z,converged\n",
      fmt::join(sizes, " x "));
  for (const PatchPoint &p : curves.points) {
    text += fmt::format("{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},", p.load, p.speed,
                        p.creepage.phi / perMm, p.creepage.eta, p.creepage.xi);
    text += p.converged() ? fmt::format("{:.10g},{:.10g},{:.10g},1\n", p.forceX, p.forceY,
                                        p.momentZ / newtonMm)
                          : ",,,0\n";
  }
  return text;
}

} // namespace wheelrail
