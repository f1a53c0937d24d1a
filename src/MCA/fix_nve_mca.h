// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   fix nve/mca: velocity Verlet for automata; see doc/fix_nve_mca.md
------------------------------------------------------------------------- */

#ifndef LMP_FIX_NVE_MCA_H
#define LMP_FIX_NVE_MCA_H

#include "fix.h"

#include <vector>

namespace LAMMPS_NS {

class FixNVEMCA : public Fix {
 public:
  FixNVEMCA(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void initial_integrate(int) override;
  void final_integrate() override;
  void reset_dt() override;

 private:
  struct HalfStep { // half a step over mass and moment of inertia
    double over_mass, over_inertia;
  };
  class PairMCA *pair;
  double dtv;
  std::vector<HalfStep> halfstep; // by type

  template<int DIMENSION, bool MOVES>
  void step();
};

} // namespace LAMMPS_NS

#endif
