// SPDX-License-Identifier: GPL-2.0-or-later
#include "packing.h"

#include <cmath>
#include <cstring>
#include <string>

namespace mca {

const Packing *findPacking(const char *name)
{
  for (const Packing &p : packing::all)
    if (std::strcmp(p.name, name) == 0)
      return &p;
  return nullptr;
}

Lattice latticeOf(const Packing &p)
{
  const double half = 0.5, height = 0.5 * packing::sqrt3, side = 1.0 / packing::sqrt2;
  const std::string name = p.name;
  if (name == "sc")
    return {{{0, 0, 0}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (name == "fcc")
    return {{{0, 0, 0}}, {{0, side, side}, {side, 0, side}, {side, side, 0}}};
  if (name == "hcp") // layers A, B in the distance sqrt(2/3), B above the middle of a triangle of A
    return {{{0, 0, 0}, {half, height / 3.0, std::sqrt(2.0 / 3.0)}},
            {{1, 0, 0}, {half, height, 0}, {0, 0, std::sqrt(8.0 / 3.0)}}};
  return {{{0, 0, 0}}, {{1, 0, 0}, {half, height, 0}, {0, 0, 1}}};
}

} // namespace mca
