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

/// Command fix nve/mca: velocity Verlet for places, velocities and angular velocities of the group,
/// and in the plane for the state theta. Mass and moment of inertia are those of the packing's
/// cell, by type, not LAMMPS's of a disc or ball.
class FixNVEMCA : public Fix {
 public:
  FixNVEMCA(class LAMMPS *, int, char **);
  /// Both halves of a Verlet step; before the forces and after them.
  int setmask() override;
  /// Needs pair_style mca, and no rRESPA; stops LAMMPS with one line otherwise.
  void init() override;
  /// Half a step of the velocities, a step of places and angles.
  void initial_integrate(int) override;
  /// The other half step of the velocities, with the new forces.
  void final_integrate() override;
  /// At the beginning of a run and whenever the timestep changes.
  void reset_dt() override;

 private:
  /// Half a step over mass and moment of inertia, in units that make a velocity of a force.
  struct HalfStep {
    double over_mass, over_inertia;
  };
  class PairMCA *pair;
  /// The step [time].
  double dtv;
  /// By type, [0] unused.
  std::vector<HalfStep> halfstep;
  /// All types have the same ones, and all automata are integrated.
  bool alike = false;

  /// Both of them; MOVES: places and angles, too.
  template<int DIMENSION, bool MOVES>
  void step();
  template<int DIMENSION, bool MOVES>
  void step_alike();
  template<bool MOVES>
  void step_of_dimension();
};

} // namespace LAMMPS_NS

#endif
