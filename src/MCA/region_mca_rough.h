// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   region mca/rough: the half-plane below or above a rough line; see doc/region_mca_rough.md
------------------------------------------------------------------------- */

#ifndef LMP_REGION_MCA_ROUGH_H
#define LMP_REGION_MCA_ROUGH_H

#include "region.h"

#include "laws/roughness.h"

#include <memory>

namespace LAMMPS_NS {

/// Command region mca/rough: the half-plane below or above y = height + h(x) with the random
/// profile of laws/roughness.h, whose period is the box length in x when the region is made; a
/// later change of the box does not change it. z does not count. It has no surface, so that it is
/// no wall.
class RegionMCARough : public Region {
 public:
  /// region ID mca/rough below|above height amplitude correlation seed [keywords of region]; after
  /// the box is made. A value out of its range stops LAMMPS with one line.
  RegionMCARough(class LAMMPS *, int, char **);
  ~RegionMCARough() override;
  /// 1 inside, else 0; a place on the line counts as below it.
  /// \param x,y  place [length]
  int inside(double, double, double) override;
  /// Stop LAMMPS: no wall.
  int surface_interior(double *, double) override;
  int surface_exterior(double *, double) override;

 private:
  /// The side that is inside.
  bool below;
  /// Height of the line's mean [length].
  double height;
  /// The lower face of the box in x when the region is made [length].
  double origin;
  /// The line about its mean; x counts from there.
  std::unique_ptr<mca::RoughProfile> profile;
};

} // namespace LAMMPS_NS

#endif
