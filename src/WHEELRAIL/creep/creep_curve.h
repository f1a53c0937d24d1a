#ifndef WHEELRAIL_CREEP_CREEP_CURVE_H
#define WHEELRAIL_CREEP_CREEP_CURVE_H

#include "creep/creep_point.h"
#include "creep/law_spread.h"

#include <functional>
#include <string>
#include <vector>

namespace wheelrail {

/// A point with the profile it belongs to and, if the law has a covariance, the band of its T/N.
struct CurvePoint : CreepPoint {
  std::uint64_t profile = 0; ///< seed, or number of the measured profile from 1 on
  Band band;
};

struct CreepCurves {
  std::vector<ContactSetup> contacts; ///< one per profile
  std::vector<CurvePoint> points;     ///< by profile, then speed, then creep
  bool hasBand = false;
  double redrawn = 0.0; ///< share of the sampled laws that had to be drawn again
  ContactFields last;   ///< along the contact, of the last point
  int resumed = 0;      ///< points taken over from an interrupted run
  double seconds = 0.0;
};

struct SweepOptions {
  int threads = 0;     ///< 0: as many as OpenMP gives
  std::string journal; ///< file that keeps finished pieces; empty: not resumable
  /// Called after every piece with points done and points in all; from one thread at a time.
  std::function<void(int, int)> progress;
  /// Asked often: true to stop as soon as possible. The journal then keeps what is done.
  std::function<bool()> interrupted;
};

/// All creeps at all speeds on all profiles. The work is cut into pieces of a few neighbouring
/// creeps, each started cold and solved in order, whatever the number of threads: so the result is
/// the same to the last bit on one thread or many, in one go or resumed.
/// The law's covariance, if it has one, is carried through (`LawSpread`).
/// @throws Error (Interrupted) when asked to stop, and what the points throw
CreepCurves solveCreepCurves(const Case &input, const FrictionLaw &law,
                             const SweepOptions &options = {});

int sweepThreads(const SweepOptions &options);

/// Surfaces and normal contacts of all profiles, in parallel.
std::vector<ContactSetup> prepareContacts(const Case &input, int threads,
                                          const std::function<bool()> &stopped);

/// The case's law; that of a constant mu for "constant".
FrictionLaw lawOf(const Case &input);

} // namespace wheelrail
#endif
