// SPDX-License-Identifier: GPL-2.0-or-later
/// \file fix_order.h
/// Where a fix stands among those of the input script.
#ifndef LMP_MCA_FIX_ORDER_H
#define LMP_MCA_FIX_ORDER_H

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
} // namespace LAMMPS_NS

namespace mca {

/// Makes a fix the first of all, so that LAMMPS calls it before those that the input script defined
/// earlier. Between runs only; LAMMPS's lists of fixes by their calls follow in its next init().
void moveToFront(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::Fix *);

} // namespace mca

#endif
