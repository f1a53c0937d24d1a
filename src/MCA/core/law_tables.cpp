// SPDX-License-Identifier: GPL-2.0-or-later
#include "law_tables.h"

#include <algorithm>
#include <utility>

namespace mca {

LawTables::LawTables(const LawSet &laws, const std::vector<Material> &materials, double thickness,
                     const Packing &packing)
    : returnsTwice(laws.returnsTwice()), centresViscosity(laws.centresViscosity()),
      resistsSlip(laws.resistsSlip()), keepsVolume(laws.keepsVolume()),
      needsLocal(laws.needsLocal())
{
  for (const Material &m : materials) {
    automata.push_back(makeAutomatonLaw(laws, m, packing));
    volumes.push_back(Cell{packing, m.diameter, thickness}.cellVolume());
  }
  std::vector<std::pair<Material, Material>> first; // materials of each law
  for (const Material &a : materials)
    for (const Material &b : materials) {
      const auto same = std::find_if(first.begin(), first.end(), [&](const auto &known) {
        return known.first == a && known.second == b;
      });
      numbers.push_back(static_cast<int>(same - first.begin()));
      if (same == first.end()) {
        first.emplace_back(a, b);
        pairs.push_back(makePairLaw(laws, a, b, thickness, packing));
      }
      oneMaterial = oneMaterial && a == b;
    }
}

} // namespace mca
