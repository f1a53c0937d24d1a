// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_SWEEP_H
#define WHEELRAIL_CREEP_SWEEP_SWEEP_H

#include "base/errors.h"
#include "creep/sweep/journal.h"

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace wheelrail {

/// How a computation of many points is run; none of it changes a result.
/// Results depend on the case and the law only: pieces are started cold, so that neither their
/// order nor the number of threads matters.
struct SweepOptions {
  /// Upper limit of the threads that share the pieces.
  int threads = 0; ///< 0: as many as OpenMP gives
  /// Keeps finished pieces, and gives back those of a run that ended early; null: not resumable. It
  /// is not removed: that is for who has put the results in place.
  Journal *journal = nullptr;
  /// Called after every piece with points done and points in all; from one thread at a time.
  /// Not called where it is empty.
  std::function<void(int, int)> progress;
  /// Asked often: true to stop as soon as possible. The journal then keeps what is done.
  std::function<bool()> interrupted;

  /// `threads`, or where that is 0 what OpenMP would take (OMP_NUM_THREADS, else the processors).
  int threadCount() const; ///< >= 1
  /// Whether `interrupted` is set and says so now.
  bool stopped() const { return interrupted && interrupted(); }
};

/// A sweep cut into pieces that share nothing. Results stay with the caller, who keeps them by the
/// piece's number; functions are called from several threads, for different pieces.
struct Sweep {
  std::vector<int> points; ///< of each piece
  /// Solves a piece. \return false when interrupted (goOn() is false)
  std::function<bool(std::size_t piece, const std::function<bool()> &goOn)> solve;
  /// All numbers of a solved piece; null where the journal is not to know it.
  std::function<nlohmann::json(std::size_t)> rows;
  /// The way back. \return number of operating points taken
  std::function<std::size_t(std::size_t, const nlohmann::json &)> takeRows;
  /// Does a piece leave more than its rows, so that it is solved whatever the journal has?
  std::function<bool(std::size_t)> leavesMore;
};

/// Solves all pieces in parallel, but for those that the journal has.
/// \return number of points that were taken over from the journal
/// \throws Error (Interrupted) when asked to stop; Error (NotConverged) for a result that is not
///         finite; what the pieces throw. The journal is written before
int runSweep(const Sweep &sweep, const SweepOptions &options);

/// A sweep whose points all failed has no result.
/// \param points with `converged()` and `failure`
/// \throws Error (NotConverged) with the first point's reason unless one of them converged
template<class Point>
void requireAnyPoint(const std::vector<Point> &points)
{
  for (const Point &point : points)
    if (point.converged())
      return;
  throw Error(ExitCode::NotConverged, points.front().failure);
}

/// action(0) to action(count - 1) in parallel: what every sweep begins with.
/// \throws Error (Interrupted) when asked to stop; the first that an action throws
void prepareAll(std::size_t count, const SweepOptions &options,
                const std::function<void(std::size_t)> &action);

} // namespace wheelrail
#endif
