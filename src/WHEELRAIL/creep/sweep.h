// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_H
#define WHEELRAIL_CREEP_SWEEP_H

#include "contact/line/contact_setup.h"

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace wheelrail {

/// How a computation of many points is run; none of it changes a result.
/// Results depend on the case and the law only: pieces are started cold, so that neither their
/// order nor the number of threads matters.
struct SweepOptions {
  /// Upper limit of the threads that share the pieces.
  int threads = 0;     ///< 0: as many as OpenMP gives
  std::string journal; ///< file that keeps finished pieces; empty: not resumable
  /// What the journal belongs to, the whole configuration: one of another identity is not used.
  /// The journal adds the program version and the law: those of another run are not used either.
  std::string identity;
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

/// The first exception of a parallel loop, to be thrown after it: OpenMP lets none leave a loop.
/// Safe from all the loop's threads.
/// Which exception is the first depends on the threads; a loop asks `any()` and does no more work.
class FirstError {
 public:
  /// Keeps the exception that is being handled, unless there is one already.
  void take();
  /// Is one kept? Cheap enough to ask at every turn of a loop.
  bool any() const { return failed_; }
  /// Throws the exception that was kept, with its type; for the thread that ran the loop.
  void rethrow() const; ///< does nothing when there is none

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
  std::atomic<bool> failed_{false};
};

/// Surfaces and normal contacts of all profiles, in parallel: what every sweep begins with.
/// @param contact, surface SI units, as of `prepareContact`
/// @param pressureLimit Pa; infinite: elastic
/// @param travels the material will move through the contact
/// @return one for each of surface.profiles(), in their order
/// @throws Error (Interrupted) when asked to stop, and what `prepareContact` throws
/// The profiles do not influence each other: each thread prepares whole contacts.
std::vector<ContactSetup> prepareContacts(const LineContactSpecification &contact,
                                          const SurfaceSpecification &surface, double pressureLimit,
                                          bool travels, const SweepOptions &options);

} // namespace wheelrail
#endif
