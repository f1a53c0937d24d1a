// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_FRICTION_RUN_H
#define WHEELRAIL_FIT_FRICTION_RUN_H

#include "base/statistics.h"
#include "fit/friction_log.h"
#include "fit/run_health.h"

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

/// What the friction log of one run says: mu of its stationary part at (kappa1, kappa2, kappa3).
/// mu and kappas are pure numbers; the run's own numbers stand beside them for the report.
struct FrictionRun {
  /// Path of the log, as given.
  std::string file;
  /// From the head: rho E v^2/sigma_0^2, p E/sigma_0^2 (Eq. 2, Bucher et al. 2006), E/sigma_0.
  double kappa1 = 0.0;
  double kappa2 = 0.0;
  double kappa3 = 0.0;
  double mu = 0.0; ///< mean of the stationary part; of the second half if there is none
  /// Its standard error: `muOwn`, and with it what seeds differ by (`SeedScatter`), where the
  /// runs it is read with tell.
  double muSe = 0.0;
  double muOwn = 0.0;        ///< what the run alone knows of its error, `widenedError`
  double freedom = 0.0;      ///< SeriesMean::freedom
  double t95 = normal95;     ///< standard errors (muSe) that 95 % reach; SeedScatter::t95
  double nEff = 0.0;         ///< independent samples it is worth
  double tStart = 0.0;       ///< ns; nan: no stationary part was found
  double muGrindingIn = 0.0; ///< mean over the grinding-in; nan if there was none
  double muEq2 = 0.0;        ///< Eq. 2 with the paper's numbers at (kappa1, kappa2)

  double correlationTime = 0.0;   ///< integrated autocorrelation time, ns
  double duration = 0.0;          ///< ns
  double muPeak = 0.0;            ///< largest row of the log: the static peak, if rows are short
  mcawr::friction_log::Head head; ///< FrictionLog::head
  std::map<std::string, std::string> madeBy; ///< FrictionLog::madeBy
  std::string packing;                       ///< FrictionLog::packing
  /// FrictionLog::condition
  std::map<std::string, std::string> condition;
  /// Steps and mu of the first rows, at most 1000: they tell one run from another.
  std::vector<long> firstStep;
  std::vector<double> firstMu;
  RunHealth health; ///< of the run, over the part that is averaged
  std::string note; ///< why there is no stationary part, or that a cut line was dropped
  /// K, FrictionLog::temperature; of a fit with a material that at which the run has its strength
  /// and modulus. nan where it is not known.
  double temperature = std::numeric_limits<double>::quiet_NaN();
  std::string leftOut; ///< why the run is not fitted; empty: it is

  /// Breaking strain over sigma_0/E, a pure number; nan where the log does not tell it.
  double ductility() const;
  double youngsModulus() const { return kappa3 * head.strength; } ///< MPa
  long seed() const { return static_cast<long>(head.seed); }
  /// Was a stationary part found?
  bool stationary() const { return tStart == tStart; }
};

/// Times are those of the log's column `time`, ns.
struct AveragingOptions {
  /// Start of the part that is averaged, ns; absent: found by stationaryPart.
  std::optional<double> start;
  /// Start as a distance of sliding, nm; with both starts, the later of them.
  std::optional<double> startDistance;
  /// End of the grinding-in, ns; absent: the start of the stationary part, at most 100 ns (the
  /// window of the paper's Fig. 4).
  std::optional<double> grindingIn;
};

/// Whether two logs are of one run, of which one may be longer, or have rows that are
/// means over several of the other's: the same kappas, laws and program, and the same mean of mu,
/// within the rounding of the logs, between all steps at which both have a row. Two seeds of a
/// roughness so small that it moves no automaton to the other block are one run, too.
/// For leaving out a log that would count twice.
bool sameRun(const FrictionRun &a, const FrictionRun &b);

/// The run of one log; its mu is the mean of the column over the stationary part (`seriesMean`).
/// \param log with at least one row
/// \throws Error (BadInput) if the start lies beyond the end of the log
FrictionRun frictionRun(const FrictionLog &log, const AveragingOptions &options);

} // namespace wheelrail

#endif
