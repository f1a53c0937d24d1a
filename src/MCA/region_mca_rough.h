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

class RegionMCARough : public Region {
 public:
  RegionMCARough(class LAMMPS *, int, char **);
  ~RegionMCARough() override;
  int inside(double, double, double) override;
  int surface_interior(double *, double) override;
  int surface_exterior(double *, double) override;

 private:
  bool below;
  double height;
  std::unique_ptr<mca::RoughProfile> profile;
};

} // namespace LAMMPS_NS

#endif
