// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/sweep.h"

#include "base/errors.h"
#include "base/result_text.h"

#include <atomic>
#include <exception>
#include <fmt/format.h>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <omp.h>
#include <stdexcept>

namespace wheelrail {
namespace {

/// The first exception of a parallel loop, to be thrown after it: OpenMP lets none leave a loop.
/// Which one is the first depends on the threads; a loop asks `any()` and does no more work.
class FirstError {
 public:
  /// Keeps the exception that is being handled, unless there is one already.
  void take()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!error_)
      error_ = std::current_exception();
    failed_ = true;
  }
  bool any() const { return failed_; }
  void rethrow() const
  {
    if (error_)
      std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
  std::atomic<bool> failed_{false};
};

/// The pieces that the journal has.
std::vector<char> takeOver(const Sweep &sweep, Journal *journal)
{
  std::vector<char> done(sweep.points.size(), 0);
  if (!journal)
    return done;
  for (const auto &[piece, rows] : journal->load()) {
    if (piece >= done.size() || sweep.leavesMore(piece))
      continue;
    try {
      done[piece] = sweep.takeRows(piece, rows) == static_cast<std::size_t>(sweep.points[piece]);
    } catch (const nlohmann::json::exception &) { // of a program of this commit that was changed
    } catch (const std::logic_error &) {          // a number in a key that is none
    }
    if (!done[piece])
      journal->refuse(piece);
  }
  return done;
}

/// Where there is something else to be said, or results to be written, a journal that cannot be
/// written is passed over: `Journal::whatIsKept` knows.
void writeIfPossible(Journal *journal)
{
  try {
    if (journal)
      journal->write();
  } catch (const Error &) {
  }
}

void checkFinite(const nlohmann::json &rows, const Sweep &sweep, std::size_t piece)
{
  if (isFinite(rows))
    return;
  const auto begin = sweep.points.begin();
  const int before = std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(piece), 0);
  throw Error(ExitCode::NotConverged,
              fmt::format("points {} to {}: a result is not finite: the numbers of the case are "
                          "beyond what double precision can compute with",
                          before + 1, before + sweep.points[piece]));
}

} // namespace

int SweepOptions::threadCount() const
{
  return threads > 0 ? threads : omp_get_max_threads();
}

int runSweep(const Sweep &sweep, const SweepOptions &options)
{
  const std::size_t pieces = sweep.points.size();
  const int total = std::accumulate(sweep.points.begin(), sweep.points.end(), 0);
  const std::vector<char> done = takeOver(sweep, options.journal);
  int finished = 0;
  for (std::size_t k = 0; k < pieces; ++k)
    finished += done[k] ? sweep.points[k] : 0;
  const int resumed = finished;

  FirstError error;
  std::mutex bookkeeping;
  const std::function<bool()> goOn = [&] { return !options.stopped() && !error.any(); };
#pragma omp parallel for schedule(dynamic) num_threads(options.threadCount())
  for (std::size_t k = 0; k < pieces; ++k) {
    if (done[k] || !goOn())
      continue;
    try {
      if (!sweep.solve(k, goOn))
        continue; // interrupted: the journal must not know the piece
      const nlohmann::json rows = sweep.rows(k);
      checkFinite(rows, sweep, k);
      const std::lock_guard<std::mutex> lock(bookkeeping);
      finished += sweep.points[k];
      if (options.journal && !sweep.leavesMore(k) && !rows.is_null())
        options.journal->add(k, rows);
      if (options.progress)
        options.progress(finished, total);
    } catch (...) {
      error.take();
    }
  }
  if (!error.any() && options.stopped() && finished < total) {
    if (options.journal)
      options.journal->write();
    throw Error(
        ExitCode::Interrupted,
        fmt::format("interrupted after {} of {} operating points; run the same command again to "
                    "continue",
                    finished, total));
  }
  writeIfPossible(options.journal);
  error.rethrow();
  return resumed;
}

void prepareAll(std::size_t count, const SweepOptions &options,
                const std::function<void(std::size_t)> &action)
{
  FirstError error;
#pragma omp parallel for schedule(dynamic) num_threads(options.threadCount())
  for (std::size_t k = 0; k < count; ++k) {
    if (error.any() || options.stopped())
      continue;
    try {
      action(k);
    } catch (...) {
      error.take();
    }
  }
  error.rethrow();
  if (options.stopped())
    throw Error(ExitCode::Interrupted,
                "interrupted before the first point; run the same command again");
}

} // namespace wheelrail
