// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/run_health.h"

#include "fit/stationarity.h"
#include "shared/layer_health.h"
#include "shared/plain_number.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numeric>
#include <optional>
#include <sstream>

namespace wheelrail {

namespace {

namespace health = mcawr::layer_health;
using Row = mcawr::friction_log::Row;

/// Value of an input script's variable in the command of a packed log.
std::optional<double> variableIn(const std::string &command, const std::string &name)
{
  std::istringstream words(command);
  std::string before, word;
  while (words >> word) {
    if (before == "-var" && word == name && words >> word)
      return mcawr::plainNumber(word);
    before = word;
  }
  return std::nullopt;
}

/// Volume of an automaton in the solid, nm3; nan of a packing that is not known.
double cellVolume(const FrictionLog &log)
{
  const double d = log.head.diameter;
  if (log.packing == "hex")
    return 0.5 * std::sqrt(3.0) * d * d * log.head.thickness;
  if (log.packing == "fcc" || log.packing == "hcp")
    return d * d * d / std::sqrt(2.0);
  return log.packing == "sc" ? d * d * d : std::numeric_limits<double>::quiet_NaN();
}

/// Room at a gap, of a log without that column: the blocks are cut out of one lattice, of whose
/// rows the command says how many there are and how many are held and driven. nan: it does not.
double roomAt(const FrictionLog &log, double gap)
{
  const auto rows = variableIn(log.command, "rows"), held = variableIn(log.command, "held");
  if (!rows || !held || !(2.0 * *held < *rows))
    return std::numeric_limits<double>::quiet_NaN();
  const double betweenRows = log.head.automata * (1.0 - (2.0 * *held - 1.0) / *rows);
  return 1.0 + gap * log.head.width * log.head.thickness / (betweenRows * cellVolume(log));
}

/// Share of the part from a row on that was worn smooth.
double smoothShare(const FrictionLog &log, std::size_t first)
{
  const double perRow = std::abs(log.head.velocity) * log.interval(); // nm
  health::SmoothSliding sliding;
  for (std::size_t i = first; i < log.rows.size(); ++i)
    sliding.add(perRow, log.rows[i].broken, log.head.diameter);
  return sliding.share();
}

/// RunHealth::junctions.
double junctionsOf(const FrictionLog &log)
{
  const auto law = log.madeBy.find("laws.link");
  const double d = log.head.diameter;
  if (law == log.madeBy.end() || !(d > 0.0))
    return std::numeric_limits<double>::quiet_NaN();
  const auto factor = mcawr::plainNumber(law->second);
  const double linkPressure = factor                           ? *factor * log.head.strength
                              : law->second == "elastic_limit" ? log.head.elasticLimit
                                                               : 0.0;
  if (!(linkPressure > 0.0))
    return std::numeric_limits<double>::quiet_NaN();
  const double across = log.head.width / d;
  const double places = log.packing == "hex" ? across : across * log.head.thickness / d;
  return health::junctions(log.head.pressure, linkPressure, places);
}

/// RunHealth::fall.
double fallOf(const FrictionLog &log)
{
  double most[3] = {}, fall = 0.0, work = 0.0, before = 0.0;
  for (const Row &row : log.rows) {
    work += row.shearStress * log.head.width * log.head.thickness * (row.displacement - before);
    before = row.displacement;
    const double terms[3] = {row.flowEnergy, row.breakingEnergy, row.contactEnergy};
    for (int k = 0; k < 3; ++k) {
      fall = std::max(fall, most[k] - terms[k]);
      most[k] = std::max(most[k], terms[k]);
    }
  }
  const Row &last = log.rows.back();
  const bool isKept =
      last.flowEnergy != 0.0 || last.breakingEnergy != 0.0 || last.contactEnergy != 0.0;
  return isKept && work != 0.0 ? fall / std::abs(work) : std::numeric_limits<double>::quiet_NaN();
}

/// Something that a run may have, and what it means.
struct Doubt {
  std::function<bool(const RunHealth &)> applies;
  std::function<std::string(const RunHealth &)> number;
  const char *meaning;
};

const std::vector<Doubt> &doubts()
{
  static const std::vector<Doubt> all = {
      {[](const RunHealth &h) { return h.room < h.leastRoom; },
       [](const RunHealth &h) {
         return fmt::format("{:.3f} of the solid's area, at least {:.3f} is expected", h.room,
                            h.leastRoom);
       },
       "automata sank into each other: the layer is no solid any more"},
      {[](const RunHealth &h) { return h.fall > health::fallAllowance; },
       [](const RunHealth &h) { return fmt::format("by {:.2g} of the work done", h.fall); },
       "what flow, breaking or contacts dissipate fell: energy came from nothing"},
      {[](const RunHealth &h) { return h.lost > 0.0; },
       [](const RunHealth &h) { return fmt::format("{:g}", h.lost); },
       "automata left through the held or the driven rows"},
      {[](const RunHealth &h) { return h.slides && h.distance < grindingDistance; },
       [](const RunHealth &h) { return fmt::format("{:.4g} nm", h.distance); },
       "slid less than 250 nm in all: surfaces grind in over that distance, mu may still change"},
      {[](const RunHealth &h) {
         return h.slides && h.distance >= grindingDistance &&
                h.startDistance < (1.0 - 1e-6) * grindingDistance;
       },
       [](const RunHealth &h) { return fmt::format("from {:.4g} nm on", h.startDistance); },
       "are averaged from less than 250 nm of sliding on, over which surfaces grind in: "
       "--start-distance 250"},
      {[](const RunHealth &h) { return std::abs(h.drift) > largeDrift && h.driftP < certainDrift; },
       [](const RunHealth &h) { return fmt::format("by {:+.0f} %", 100.0 * h.drift); },
       "mu drifts over the part that is averaged: its mean may be that of no stationary state"},
      {[](const RunHealth &h) { return h.strengths.size() > 1; },
       [](const RunHealth &h) {
         return fmt::format("sigma_0 {} MPa", fmt::join(h.strengths, " and "));
       },
       "of several materials: kappas are those of the weakest, and the law is one of a single "
       "material"},
      {[](const RunHealth &h) { return h.smooth > health::smoothLimit; },
       [](const RunHealth &h) {
         return fmt::format("worn smooth for {:.0f} % of the time", 100.0 * h.smooth);
       },
       "slide without a link broken: no dry friction of rough surfaces; a wider fragment has more "
       "junctions"},
      {[](const RunHealth &h) { return h.slides && h.junctions < health::leastJunctions; },
       [](const RunHealth &h) { return fmt::format("{:.2g} junctions at once", h.junctions); },
       "mu scatters with less than 10, and a fragment of less than 160 automata in a layer may rub "
       "half as much as a wide one, or a quarter more"},
  };
  return all;
}

} // namespace

RunHealth runHealth(const FrictionLog &log, std::size_t first)
{
  RunHealth result;
  result.slides = log.head.velocity != 0.0;
  result.strengths = {log.head.strength};
  result.strengths.insert(result.strengths.end(), log.otherStrengths.begin(),
                          log.otherStrengths.end());
  const double speed = std::abs(log.head.velocity); // m/s = nm/ns
  result.distance = speed * (log.time.back() - log.origin());
  result.startDistance = speed * (log.time[first] - log.interval() - log.origin());
  const auto rows = static_cast<double>(log.rows.size() - first);
  double room = 0.0;
  for (std::size_t i = first; i < log.rows.size(); ++i) {
    result.gap += log.rows[i].gap / rows;
    room += log.rows[i].room / rows;
  }
  const bool isMeasured = log.hasState && log.rows.back().room > 0.0;
  result.room = isMeasured ? room : roomAt(log, result.gap);
  const double bulkModulus = log.head.youngsModulus / (3.0 * (1.0 - 2.0 * log.head.poissonsRatio));
  result.leastRoom = health::leastRoom(log.head.pressure, bulkModulus);
  if (log.hasState)
    result.lost = log.rows.back().lost;
  result.smooth = smoothShare(log, first);
  result.junctions = junctionsOf(log);
  result.fall = fallOf(log);
  const double mean = std::accumulate(log.mu.begin() + first, log.mu.end(), 0.0) / rows;
  if (log.mu.size() >= first + leastTested && mean != 0.0) {
    result.drift = drift(log.mu, first) / mean;
    result.driftP = trendP(log.mu, first);
  }
  return result;
}

std::vector<std::string>
healthWarnings(const std::vector<std::pair<std::string, const RunHealth *>> &runs)
{
  std::vector<std::string> lines;
  for (const Doubt &doubt : doubts()) {
    std::size_t count = 0;
    std::string first;
    for (const auto &[name, run] : runs)
      if (doubt.applies(*run) && count++ == 0)
        first = fmt::format("{} ({})", name, doubt.number(*run));
    if (count > 0)
      lines.push_back(fmt::format("{} of {} run{}, {}{}: {}", count, runs.size(),
                                  runs.size() == 1 ? "" : "s", count == 1 ? "" : "such as ", first,
                                  doubt.meaning));
  }
  return lines;
}

} // namespace wheelrail
