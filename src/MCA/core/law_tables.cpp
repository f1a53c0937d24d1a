// SPDX-License-Identifier: GPL-2.0-or-later
#include "law_tables.h"

#include <algorithm>

namespace mca {

LawTables::LawTables(const LawSet &laws, const std::vector<Material> &materials, double thickness,
                     const Packing &packing, const Interfaces &interfaces)
    : returnsTwice(laws.returnsTwice()), centresViscosity(laws.centresViscosity()),
      resistsSlip(laws.resistsSlip()), keepsVolume(laws.keepsVolume()),
      needsLocal(laws.needsLocal())
{
  for (const Material &m : materials) {
    automata.push_back(makeAutomatonLaw(laws, m, packing));
    volumes.push_back(Cell{packing, m.diameter, thickness}.cellVolume());
  }
  struct Meeting {
    Material a, b;
    Interface interface;
  };
  std::vector<Meeting> first; // of each law
  for (int i = 0; i < types(); i++)
    for (int j = 0; j < types(); j++) {
      const Material &a = materials[i], &b = materials[j];
      const Interface *const own = findInterface(interfaces, i, j);
      const Interface interface = own ? *own : Interface();
      const auto same = std::find_if(first.begin(), first.end(), [&](const Meeting &known) {
        return known.a == a && known.b == b && known.interface == interface;
      });
      numbers.push_back(static_cast<int>(same - first.begin()));
      if (same == first.end()) {
        first.push_back({a, b, interface});
        pairs.push_back(makePairLaw(laws, a, b, thickness, packing, interface));
        rubs = rubs || pairs.back().friction > 0.0;
      }
      oneMaterial = oneMaterial && a == b;
    }
}

} // namespace mca
