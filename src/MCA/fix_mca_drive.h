// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   fix mca/drive: rigid driven layer and friction log; see doc/fix_mca_drive.md
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_DRIVE_H
#define LMP_FIX_MCA_DRIVE_H

#include "fix.h"

#include "core/layer_room.h"
#include "files/drive_sums.h"
#include "shared/layer_health.h"

#include <array>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class PairMCA;

/// Command fix mca/drive: the group is a rigid layer with a prescribed velocity in x and a constant
/// pressure in y; it writes the friction log and gives a scalar, the friction coefficient of the
/// step, and a vector of six. Behind all fixes that set forces; fix nve/mca moves the layer.
class FixMCADrive : public Fix {
 public:
  FixMCADrive(class LAMMPS *, int, char **);
  int setmask() override;
  /// Checks group and variables; stops LAMMPS with one line where one is missing.
  void init() override;
  void setup_post_neighbor() override;
  /// Finds the automata of the layer on this rank, in the order of their IDs, so that sums do not
  /// depend on LAMMPS's order of atoms.
  void post_neighbor() override;
  /// Area, mass and start height of the layer; begins the log or continues it after a restart.
  void setup(int) override;
  /// Takes the stresses on the layer from the forces of this step, then makes these forces, and
  /// velocities, those of a rigid body.
  void post_force(int) override;
  /// Stops LAMMPS where the step changes while a log is open.
  void reset_dt() override;
  /// Sums up displacement, work and stresses; writes a row each `every` steps.
  void end_of_step() override;
  /// Warns once of a layer that was worn smooth.
  void post_run() override;
  /// Shear stress over the prescribed pressure in this step [-]; 0 without pressure.
  double compute_scalar() override;
  /// 0 before the first run. 0 to 7: shear and normal stress [pressure], friction coefficient [-],
  /// displacement [length], rise of the layer [length], work [energy], room of the automata between
  /// the held and the driven rows [-], automata beyond those [-]. Called by all ranks.
  double compute_vector(int) override;
  /// State of the layer and the sums of the row in progress, with a checksum. Afterwards the sums
  /// are on rank 0, as in the run that continues.
  void write_restart(FILE *) override;
  /// Reads them; a damaged block stops LAMMPS with one line.
  void restart(char *) override;

 private:
  /// A number or an equal-style variable, which is evaluated in each step; `value` is the last one.
  struct Setting {
    std::string variable;
    double value = 0.0;
  };
  Setting velocity, pressure;
  std::string path;
  /// Steps in a row of the log, > 0; and a number that its head notes.
  bigint every, seed;

  PairMCA *pair;
  /// Open on rank 0 only, where `file` was given.
  mca::FrictionLogWriter log;
  /// Factors of the run's units to nm, ns, MPa; found in the constructor, which stops where a log
  /// is asked for and there are none.
  mca::Units units;
  /// A set-up was done: the start height is known, and the log has its head.
  bool begun;
  /// State came from a restart file.
  bool restarted;
  /// Sums of the layer and of the row in progress.
  mca::DriveSums sums;
  /// Rows of the log of the run that wrote the restart file; number -1: it had no log.
  mca::LogRows past;
  /// The step when the log was opened [time].
  double dt_of_log = 0.0;
  /// Bounds of the loading, of all materials: the fastest wave [velocity], the largest Young's
  /// modulus and the smallest strength [pressure].
  double largest_velocity, largest_pressure, least_strength;
  /// The smallest bulk modulus [pressure].
  double least_bulk_modulus;
  /// The smallest pressure that links two automata of a type [pressure], infinite where none does;
  /// the largest diameter [length].
  double least_link_pressure, largest_diameter;

  /// Its members are own automata since the last exchange of automata; its area is the box length
  /// in x times that in z, or the thickness.
  mca::DrivenLayer layer;
  /// The layer has automata on several ranks, which then add up its forces in each step.
  bool split;
  /// Velocity of the way to the present step: that of the step before [velocity].
  double moved_at;
  /// This rank's part of the stresses on the layer now [pressure].
  mca::DrivenLayer::Stress stress;
  /// Automata beyond the driven and the held layer that are known of, so that each is told of once.
  double above, below;
  /// Whether a layer that sank, and a term of the account that fell, have been told of.
  bool told_of_room, told_of_fall;
  /// What it slid, in rows of the log, since the fix was defined; whether a layer that was worn
  /// smooth has been told of.
  mcawr::layer_health::SmoothSliding sliding;
  bool told_of_smooth = false;
  double row_start = 0.0; ///< displacement where the row began that is being made [length]
  /// The most that flow, breaking and contacts had dissipated in a row so far [pressure length^3].
  std::array<double, 3> most_dissipated;

  /// Number of automata, of all ranks, that another fix acts on, too.
  bigint shared_with(const Fix *other) const;
  /// Stops LAMMPS where another drive, or a fix that moves or holds, has automata of the layer, or
  /// nothing moves them; warns of a fix that sets forces of them.
  void check_layer() const;
  void find_limits();
  /// Warns of a layer that slides and has too few junctions for its load.
  void check_junctions() const;
  /// Begins the log, continues it after a restart, or makes sure that a further run fits its head.
  void open_log();
  /// Stops all ranks when rank 0 has a problem.
  void stop_if(const std::string &problem);
  /// Both settings in this step; stops LAMMPS where they are out of bounds.
  void evaluate();
  void evaluate(Setting &) const;
  /// Number of an equal-style variable; stops LAMMPS where there is none of this name.
  int number_of(const std::string &variable) const;
  /// Setting that a word of the command names: v_name, or a finite number, of `pressure` >= 0; else
  /// LAMMPS stops.
  Setting parse_setting(const char *keyword, const char *word);
  /// y of an own automaton, not folded back into the box [length].
  double unwrapped_y(int i) const;
  /// Of the sample [length].
  double thickness() const;
  /// Mean height of the layer [length]; called by all ranks.
  double height() const;
  /// Where own automaton i belongs. Held are those at rest in y that forces do not move.
  mca::Part part_of(int i) const;
  /// Room between the rigid layers, and automata beyond them.
  struct Neighbourhood {
    double room = 0.0, above = 0.0, below = 0.0;
  };
  Neighbourhood look_around() const; ///< called by all ranks
  /// What compute mca/energy has, if the input script defines it [pressure length^3].
  std::array<double, 3> dissipated() const;
  /// Means of the row, events in it; warns of what is wrong with the layer. All ranks stop where
  /// the log cannot be written.
  void write_row();
  /// Warns of automata that left, of a layer that sank, of a term of the account that fell.
  /// \param work  of the drive so far, on all ranks [energy]
  void check_health(const mca::DriveSums::State &now, const Neighbourhood &around, double work);
  /// Sums over all ranks: links now, events since the pair style was created, and the parts of
  /// `sums`.
  mca::DriveSums::Totals totals() const;
  /// LAMMPS's arrays as they are now, for one call.
  mca::DrivenLayer::Arrays arrays() const;
  /// Over all ranks.
  double sum(double part) const;
};

} // namespace LAMMPS_NS

#endif
