// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_order.h"

#include "atom.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

#include <algorithm>
#include <utility>

void mca::moveToFront(LAMMPS_NS::LAMMPS *lmp, const LAMMPS_NS::Fix *fix)
{
  LAMMPS_NS::Modify &modify = *lmp->modify;
  LAMMPS_NS::Atom &atom = *lmp->atom;
  const auto at = std::find(modify.fix, modify.fix + modify.nfix, fix) - modify.fix;
  std::rotate(modify.fix, modify.fix + at, modify.fix + at + 1);
  std::rotate(modify.fmask, modify.fmask + at, modify.fmask + at + 1);
  // class Atom knows the fixes that keep values of atoms by their numbers
  for (const auto &[numbers, n] : {std::pair(atom.extra_grow, atom.nextra_grow),
                                   std::pair(atom.extra_restart, atom.nextra_restart),
                                   std::pair(atom.extra_border, atom.nextra_border)}) {
    for (int k = 0; k < n; k++)
      numbers[k] = numbers[k] == at ? 0 : numbers[k] + (numbers[k] < at);
    std::sort(numbers, numbers + n);
  }
}
