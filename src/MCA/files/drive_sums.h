// SPDX-License-Identifier: GPL-2.0-or-later
/// \file drive_sums.h
/// What fix mca/drive adds up from step to step, and the row of the friction log that comes of it.
/// In units of the run. No LAMMPS type in here.
#ifndef MCA_DRIVE_SUMS_H
#define MCA_DRIVE_SUMS_H

#include "core/driven_layer.h"
#include "files/friction_log_writer.h"
#include "files/units.h"

#include <array>

namespace mca {

/// Sums since the first set-up of a driven layer, and of the row of the log that is being made.
/// Work and stresses are this rank's parts; all else is known to every rank alike.
struct DriveSums {
  double startHeight = 0.0;  ///< of the layer in its first set-up [length]
  double displacement = 0.0; ///< in x since then [length]
  double work = 0.0;         ///< of the drive since then [energy]
  /// Sums over the steps of the row [pressure].
  double shearSum = 0.0, normalSum = 0.0;
  double samples = 0.0; ///< number of steps of the row
  /// Events of the sample until the last row.
  double brokenBefore = 0.0, formedBefore = 0.0;

  /// A step with these stresses, or this rank's parts of them.
  void add(const DrivenLayer &, const DrivenLayer::Stress &, double velocity, double dt);

  /// What a row says of the sample as it is now, in units of the run.
  struct State {
    double height = 0.0;           ///< of the driven layer [length]
    double room = 0.0, lost = 0.0; ///< roomOf(); free automata beyond the rigid layers
    /// By plastic flow, breaking, unlinked contacts, of compute mca/energy; without it 0
    /// [pressure length^3].
    std::array<double, 3> dissipated = {};
  };
  /// What a row needs of all ranks.
  struct Totals {
    double links = 0.0, broken = 0.0, formed = 0.0; ///< now; since the counters began
    double work = 0.0, shearSum = 0.0, normalSum = 0.0;
  };
  /// The row of the log, in its units.
  /// \param step      of the run, the row's last one
  /// \param dt        [time]
  /// \param pressure  prescribed in that step [pressure]; at 0 mu is 0
  LogRow row(const Totals &, const State &, long long step, double dt, double pressure,
             const Units &) const;
  /// The next row begins, after that of these totals.
  void beginRow(const Totals &);

  /// The parts of all ranks become this one's, as the run that continues has them.
  /// \param first  this rank keeps them; the others have 0
  void gather(const Totals &, bool first);
};

} // namespace mca

#endif
