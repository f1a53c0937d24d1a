// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   fix mca/drive: rigid driven layer and friction log; see doc/fix_mca_drive.md
------------------------------------------------------------------------- */

#ifndef LMP_FIX_MCA_DRIVE_H
#define LMP_FIX_MCA_DRIVE_H

#include "fix.h"

#include "friction_log_writer.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class PairMCA;

class FixMCADrive : public Fix {
 public:
  FixMCADrive(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup_post_neighbor() override;
  void post_neighbor() override;
  void setup(int) override;
  void post_force(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  struct Setting { // a number or an equal-style variable
    std::string variable;
    double value = 0.0;
  };
  Setting velocity, pressure;
  std::string path;
  bigint every, seed;

  PairMCA *pair;
  mca::FrictionLogWriter log;
  mca::Units units;
  bool begun;     // the log's first row, or the state of a restart file, is there
  bool restarted; // state came from a restart file

  std::vector<int> members; // own automata of the layer, since the last exchange of automata
  double area;              // nominal contact area: box length in x times that in z, or thickness
  bool split;               // the layer has automata on several ranks
  double mass;              // of the layer
  double shear, normal;     // this rank's part of the stresses on the layer now, pressure units
  double start_height;      // of the layer
  double displacement;
  double work, shear_sum, normal_sum;  // this rank's parts, the sums since the last row
  double samples;                      // since the last row
  double broken_before, formed_before; // events until the last row
  bigint above;                        // automata above the layer that are known of

  double evaluate(Setting &);
  Setting parse_setting(const char *keyword, const char *word);
  double unwrapped_y(int i) const;
  double height() const;
  bigint count_above() const;
  void write_row();
  struct Totals { // of all ranks
    double links, broken, formed, work, shear_sum, normal_sum;
  };
  Totals totals() const;
  double sum(double part) const;
  void keep_parts();
};

} // namespace LAMMPS_NS

#endif
