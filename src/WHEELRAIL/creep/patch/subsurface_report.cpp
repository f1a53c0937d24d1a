// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/subsurface_report.h"

#include "base/si.h"
#include "contact/patch/elasticity/subsurface_stress.h"

#include <fmt/format.h>

namespace wheelrail {
namespace {

struct StressColumn {
  const char *name;
  StressPeak StressPeaks::*peak;
};
constexpr StressColumn columns[] = {{"von_mises", &StressPeaks::vonMises},
                                    {"max_shear", &StressPeaks::maximumShear},
                                    {"orthogonal_shear", &StressPeaks::orthogonalShear}};

} // namespace

std::string subsurfaceName(int number)
{
  return fmt::format("subsurface_{:04d}.csv", number);
}

// The traction acts on the wheel; on the rail, the other way.
std::string subsurfaceCsv(const PatchSpecification &asked, const PatchContact &contact,
                          const PatchFields &fields)
{
  std::string text = "# depth, x, y: mm; stresses: MPa, largest at that depth\nbody,depth";
  for (const StressColumn &column : columns)
    text += fmt::format(",{0},{0}_x,{0}_y", column.name);
  text += "\n";
  for (const auto &[name, body, sign] : {std::tuple{"wheel", 0, 1.0}, {"rail", 1, -1.0}}) {
    SubsurfaceStress space(contact.grid, asked.contact.bodies[body].poissonsRatio);
    const TangentialField traction{sign * fields.traction.x, sign * fields.traction.y};
    for (const double depth : asked.depths) {
      const StressPeaks peaks =
          stressPeaks(contact.grid, space.at(depth, fields.pressure, traction));
      text += fmt::format("{},{:.8g}", name, depth / mm);
      for (const StressColumn &column : columns) {
        const StressPeak &peak = peaks.*column.peak;
        text += fmt::format(",{:.8g},{:.8g},{:.8g}", peak.value / MPa, peak.x / mm, peak.y / mm);
      }
      text += "\n";
    }
  }
  return text;
}

} // namespace wheelrail
