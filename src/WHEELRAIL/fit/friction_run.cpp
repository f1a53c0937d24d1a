// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/friction_run.h"

#include "base/errors.h"
#include "fit/stationarity.h"
#include "law/kappa_law.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace wheelrail {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double longestGrindingIn = 100.0; // ns, Fig. 4
constexpr std::size_t firstRows = 1000;

/// First row whose interval begins at or after `time`.
std::size_t firstRowAfter(const FrictionLog &log, double time)
{
  const double slack = 1e-6 * log.interval();
  const auto row = std::find_if(log.time.begin(), log.time.end(),
                                [&](double end) { return end - log.interval() >= time - slack; });
  return row - log.time.begin();
}

/// The time that `start` and `startDistance` ask for, ns; absent: neither was given.
std::optional<double> startAskedFor(const FrictionLog &log, const AveragingOptions &options)
{
  if (!options.startDistance)
    return options.start;
  const double distance = *options.startDistance;
  const double time =
      distance > 0.0 ? distance / std::abs(log.head.velocity) : 0.0; // nm/(m/s) = ns
  return std::max(options.start.value_or(0.0), log.origin() + time);
}

/// That no row begins at the start or after it, in the unit in which the start was given.
Error beyondTheEnd(const FrictionLog &log, const AveragingOptions &options, double time)
{
  const bool isDistance = options.startDistance && time > options.start.value_or(0.0);
  const double perTime = isDistance ? std::abs(log.head.velocity) : 1.0;
  const double zero = isDistance ? log.origin() : 0.0;
  const char *unit = isDistance ? "nm" : "ns";
  const double end = log.time.back();
  const bool isWithinLastRow = time < end;
  const double last = isWithinLastRow ? end - log.interval() : end;
  return badInput(
      log.file, 0, "",
      fmt::format("the {} at {:.6g} {}, before the start of {:.6g} {} that was asked for",
                  isWithinLastRow ? "last row begins" : "log ends", (last - zero) * perTime, unit,
                  isDistance ? *options.startDistance : time, unit));
}

double meanBefore(const FrictionLog &log, double time)
{
  const double slack = 1e-6 * log.interval();
  const auto end = std::upper_bound(log.time.begin(), log.time.end(), time + slack);
  const auto rows = end - log.time.begin();
  if (rows == 0)
    return nan;
  return std::accumulate(log.mu.begin(), log.mu.begin() + rows, 0.0) / static_cast<double>(rows);
}

/// Mean of mu over some rows, and of its absolute value.
class RowMean {
 public:
  void add(double mu)
  {
    sum_ += mu;
    absolute_ += std::abs(mu);
    ++rows_;
  }
  double mean() const { return sum_ / rows_; }
  double size() const { return absolute_ / rows_; }

 private:
  double sum_ = 0.0, absolute_ = 0.0;
  int rows_ = 0;
};

void addNote(std::string &notes, const std::string &note)
{
  notes += (notes.empty() ? "" : "; ") + note;
}

} // namespace

double FrictionRun::ductility() const
{
  return head.breakingStrain > 0.0 ? head.breakingStrain * kappa3
                                   : std::numeric_limits<double>::quiet_NaN();
}

FrictionRun frictionRun(const FrictionLog &log, const AveragingOptions &options)
{
  FrictionRun run;
  run.file = log.file;
  run.kappa1 = log.kappa1();
  run.kappa2 = log.kappa2();
  run.kappa3 = log.kappa3();
  run.temperature = log.temperature;
  run.muEq2 = bucher2006()(run.kappa1, run.kappa2);
  run.head = log.head;
  run.muPeak = *std::max_element(log.mu.begin(), log.mu.end());
  run.madeBy = log.madeBy;
  run.packing = log.packing;
  run.condition = log.condition;
  const auto rows = std::min(firstRows, log.mu.size());
  run.firstStep.assign(log.step.begin(), log.step.begin() + rows);
  run.firstMu.assign(log.mu.begin(), log.mu.begin() + rows);
  run.note = log.note;
  run.duration = log.time.back() - log.origin();

  SeriesMean mean;
  double start = 0.0;
  std::size_t begin = 0;
  if (const auto asked = startAskedFor(log, options)) {
    const auto first = firstRowAfter(log, *asked);
    if (first == log.time.size())
      throw beyondTheEnd(log, options, *asked);
    mean = seriesMean(log.mu, first, log.mu.size());
    start = *asked;
    begin = first;
    run.tStart = start;
  } else {
    const auto part = stationaryPart(log.mu);
    mean = part.mean;
    begin = part.start;
    start = part.start == 0 ? log.origin() : log.time[part.start - 1];
    run.tStart = part.found ? start : nan;
    if (!part.found) {
      addNote(run.note, fmt::format("no stationary part: {}", part.reason));
    }
  }
  run.health = runHealth(log, begin);
  run.mu = mean.mean;
  run.muSe = run.muOwn = widenedError(mean);
  run.freedom = mean.freedom;
  if (mean.n > 0 && mean.freedom < leastEffective && std::isfinite(run.muOwn))
    addNote(run.note, fmt::format("too short for its slow times: its error is known from {:.1f} "
                                  "stretches, and widened {:.1f} times",
                                  mean.freedom, run.muOwn / mean.standardError));
  run.nEff = mean.effectiveN;
  run.correlationTime = mean.correlationTime * log.interval();
  run.muGrindingIn =
      meanBefore(log, options.grindingIn.value_or(std::min(start, longestGrindingIn)));
  return run;
}

bool sameRun(const FrictionRun &a, const FrictionRun &b)
{
  if (a.kappa1 != b.kappa1 || a.kappa2 != b.kappa2 || a.kappa3 != b.kappa3 || a.madeBy != b.madeBy)
    return false;
  // Rows of the one log may be means over several rows of the other. Both are added up until they
  // reach a step that both have; there the means must agree, and the sums begin anew.
  constexpr double rounding = 1e-6; // logs have seven digits
  RowMean ofA, ofB;
  bool compared = false;
  for (std::size_t i = 0, j = 0; i < a.firstStep.size() && j < b.firstStep.size();) {
    const long stepA = a.firstStep[i], stepB = b.firstStep[j];
    if (stepA <= stepB)
      ofA.add(a.firstMu[i++]);
    if (stepB <= stepA)
      ofB.add(b.firstMu[j++]);
    if (stepA != stepB)
      continue;
    if (std::abs(ofA.mean() - ofB.mean()) > rounding * ofA.size())
      return false;
    compared = true;
    ofA = ofB = {};
  }
  return compared;
}

} // namespace wheelrail
