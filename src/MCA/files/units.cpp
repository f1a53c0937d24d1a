// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/units.h"

#include <map>

namespace mca {

const Units *findUnits(const std::string &style)
{
  // nm, ns, MPa (LAMMPS's doc page "units"); nktv2p and mvv2e as in its update.cpp, since the
  // acceleration in a run follows from them
  static const std::map<std::string, Units> table = {
      {"nano", {1.0, 1.0, 1.0, 1.0}},
      {"si", {1e9, 1e9, 1e-6, 1.0}},
      {"cgs", {1e7, 1e9, 1e-7, 1.0}},
      {"micro", {1e3, 1e3, 1e-3, 1.0}},
      {"metal", {0.1, 1e-3, 0.1, 1.6021765e6 * 1.0364269e-4}},
      {"real", {0.1, 1e-6, 0.101325, 68568.415 * 48.88821291 * 48.88821291}},
  };
  const auto found = table.find(style);
  return found == table.end() ? nullptr : &found->second;
}

} // namespace mca
