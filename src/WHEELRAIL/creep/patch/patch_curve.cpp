// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_curve.h"

#include "base/errors.h"
#include "creep/journal.h"
#include "creep/patch/patch_journal.h"
#include "creep/patch/static_patch.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <mutex>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t creepsInPiece = 8; ///< solved one after the other, warm

/// Neighbouring points of one contact at one speed.
struct Piece {
  std::size_t first, count;
};

std::vector<Piece> cutIntoPieces(const PatchSpecification &specification,
                                 const std::vector<PatchTask> &tasks)
{
  const std::size_t row = specification.mode == PatchMode::Frozen
                              ? std::max(specification.creep.size(), specification.forceX.size())
                              : 1;
  std::vector<Piece> pieces;
  for (std::size_t first = 0; first < tasks.size(); first += row)
    for (std::size_t k = 0; k < row; k += creepsInPiece)
      pieces.push_back({first + k, std::min(creepsInPiece, row - k)});
  return pieces;
}

struct PieceResult {
  bool done = false;
  std::vector<PatchPoint> points;
  std::map<int, PatchFields> fields;
  std::map<int, std::vector<PatchStep>> series;
};

/// Empty when interrupted.
PieceResult solvePiece(const PatchSpecification &asked, const FrictionLaw &law,
                       const PatchContact &contact, const std::vector<PatchTask> &tasks,
                       const Piece &piece, const std::function<bool()> &goOn)
{
  PieceResult result;
  const double spinPoint = asked.contact.spinPoint;
  std::optional<FrozenPatch> frozen;
  std::optional<MovingPatch> moving;
  for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) {
    if (!goOn())
      return {};
    const PatchTask &task = tasks[k];
    const int number = static_cast<int>(k) + 1;
    const bool keeps = asked.fields.holds(number, static_cast<int>(tasks.size()));
    if (asked.mode == PatchMode::Static) {
      const StaticPatch still = solveStaticPatch(asked.physics, law, contact, task);
      result.points.push_back(still.point);
      if (keeps)
        result.fields[number] = still.fields;
    } else if (asked.mode == PatchMode::Moving) {
      moving.emplace(asked.physics, asked.moving, asked.sequence, law, contact, spinPoint);
      const std::optional<PatchPoint> point = moving->solve(task.speed, task.drive, goOn);
      if (!point)
        return {};
      result.points.push_back(*point);
      result.series[number] = moving->series();
      if (keeps)
        result.fields[number] = moving->fields();
    } else {
      if (!frozen)
        frozen.emplace(asked.physics, contact, spinPoint);
      result.points.push_back(frozen->solve(law, task.speed, task.drive));
      if (keeps)
        result.fields[number] = frozen->fields();
    }
  }
  result.done = true;
  return result;
}

/// Longest way of any point with this load, m: all of them share the surfaces.
double longestWay(const PatchSpecification &asked, double load)
{
  if (asked.mode != PatchMode::Moving)
    return 0.0;
  double way = 0.0, fastest = 0.0;
  for (double speed : asked.speed)
    way = std::max(way,
                   rolledDistance(asked.moving, asked.sequence, asked.contact.hertz(load), speed));
  for (const auto *creeps : {&asked.creep, &asked.sequence.creep})
    for (double creep : *creeps)
      fastest = std::max(fastest, std::abs(creep));
  return way * (1.0 + 0.5 * fastest);
}

PatchContactSummary summaryOf(const PatchSpecification &asked, const PatchContact &contact)
{
  PatchContactSummary summary;
  if (!asked.sensitivities || asked.mode == PatchMode::Static)
    return summary;
  TangentialSolver solver(contact.grid, contact.pair);
  summary.sensitivity = creepSensitivity(solver, contact.normal.pressure);
  summary.kalker = kalkerCoefficients(*summary.sensitivity, contact.pair.G, contact.nominalArea());
  return summary;
}

void prepare(const PatchSpecification &asked, const SweepOptions &options, PatchCurves &curves)
{
  const std::vector<double> &loads = asked.contact.load;
  curves.contacts.resize(asked.roughness.surfaces() * loads.size());
  curves.summaries.resize(curves.contacts.size());
  FirstError error;
#pragma omp parallel for schedule(dynamic) num_threads(options.threadCount())
  for (std::size_t k = 0; k < curves.contacts.size(); ++k) {
    if (error.any() || options.stopped())
      continue;
    try {
      const double load = loads[k % loads.size()];
      curves.contacts[k] = preparePatch(asked.contact, asked.roughness, load, k / loads.size(),
                                        asked.physics.pressureLimit(0.0), longestWay(asked, load));
      curves.summaries[k] = summaryOf(asked, curves.contacts[k]);
    } catch (...) {
      error.take();
    }
  }
  error.rethrow();
  if (options.stopped())
    throw Error(ExitCode::Interrupted,
                "interrupted before the first point; the same command goes on");
  for (const PatchContact &contact : curves.contacts)
    for (const std::string &remark : contact.surface.remarks)
      if (std::find(curves.warnings.begin(), curves.warnings.end(), remark) ==
          curves.warnings.end())
        curves.warnings.push_back(remark);
}

/// Does a piece leave more than its rows, so that it is computed even if the journal has them?
bool leavesFields(const PatchSpecification &asked, const Piece &piece, std::size_t total)
{
  for (std::size_t k = piece.first; k < piece.first + piece.count; ++k)
    if (asked.fields.holds(static_cast<int>(k) + 1, static_cast<int>(total)))
      return true;
  return false;
}

} // namespace

bool FieldSelection::holds(int number, int total) const
{
  switch (kind) {
  case Kind::None:
    return false;
  case Kind::Last:
    return number == total;
  case Kind::All:
    return true;
  default:
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
  }
}

namespace {

/// Drives in the order of the results: spin, lateral, longitudinal.
std::vector<PatchDrive> drivesOf(const PatchSpecification &asked)
{
  const bool givesX = !asked.forceX.empty(), givesY = !asked.forceY.empty();
  std::vector<PatchDrive> drives;
  for (double spin : asked.spin)
    for (double y : givesY ? asked.forceY : asked.lateral)
      for (double x : givesX ? asked.forceX : asked.creep) {
        PatchDrive drive;
        drive.creepage.phi = spin;
        (givesX ? drive.forceX.emplace(0.0) : drive.creepage.xi) = x;
        (givesY ? drive.forceY.emplace(0.0) : drive.creepage.eta) = y;
        drives.push_back(drive);
      }
  return drives;
}

std::vector<PatchTask> staticTasks(const PatchSpecification &asked)
{
  std::vector<PatchTask> tasks;
  for (double ratio : asked.forceRatio) {
    PatchTask task{};
    task.forceRatio = ratio;
    tasks.push_back(task);
  }
  for (const auto &shift : asked.shift) {
    PatchTask task{};
    task.drive.creepage = {shift[0], shift[1], 0.0};
    tasks.push_back(task);
  }
  if (!tasks.empty())
    return tasks;
  for (const PatchDrive &drive : drivesOf(asked)) {
    PatchTask task{};
    task.drive = drive;
    tasks.push_back(task);
  }
  return tasks;
}

} // namespace

std::vector<PatchTask> patchTasks(const PatchSpecification &asked)
{
  const std::size_t contacts = asked.roughness.surfaces() * asked.contact.load.size();
  std::vector<PatchTask> tasks;
  for (std::size_t contact = 0; contact < contacts; ++contact)
    if (asked.mode == PatchMode::Static) {
      for (PatchTask task : staticTasks(asked)) {
        task.contact = contact;
        tasks.push_back(task);
      }
    } else {
      for (double speed : asked.speed)
        for (const PatchDrive &drive : drivesOf(asked))
          tasks.push_back({contact, speed, drive, 0.0});
    }
  return tasks;
}

PatchCurves solvePatchCurves(const PatchSpecification &asked, const FrictionLaw &law,
                             const SweepOptions &options)
{
  const auto begin = Clock::now();
  PatchCurves curves;
  prepare(asked, options, curves);
  const std::vector<PatchTask> tasks = patchTasks(asked);
  const std::vector<Piece> pieces = cutIntoPieces(asked, tasks);
  const int total = static_cast<int>(tasks.size());
  std::vector<PieceResult> results(pieces.size());
  Journal journal(options.journal, fmt::format("patch journal 1\n{}\n{}\n{}", WHEELRAIL_VERSION,
                                               options.identity, toJson(law).dump()));
  int done = 0;
  for (const auto &[number, rows] : journal.load()) {
    if (number >= pieces.size() || leavesFields(asked, pieces[number], tasks.size()))
      continue; // fields are not in the journal
    results[number].points = patchPointsFrom(rows.at("points"));
    results[number].series = patchSeriesFrom(rows.at("series"));
    results[number].done = true;
    done += static_cast<int>(results[number].points.size());
  }
  curves.resumed = done;

  FirstError error;
  std::mutex bookkeeping;
  const auto goOn = [&] { return !options.stopped() && !error.any(); };
#pragma omp parallel for schedule(dynamic) num_threads(options.threadCount())
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (results[k].done || !goOn())
      continue;
    try {
      const PatchContact &contact = curves.contacts[tasks[pieces[k].first].contact];
      PieceResult result = solvePiece(asked, law, contact, tasks, pieces[k], goOn);
      if (!result.done)
        continue;
      const std::lock_guard<std::mutex> lock(bookkeeping);
      results[k] = std::move(result);
      done += static_cast<int>(results[k].points.size());
      journal.add(k, {{"points", patchPointsJson(results[k].points)},
                      {"series", patchSeriesJson(results[k].series)}});
      if (options.progress)
        options.progress(done, total);
    } catch (...) {
      error.take();
    }
  }
  if (options.stopped() || error.any())
    journal.write();
  error.rethrow();
  if (options.stopped() && done < total)
    throw Error(
        ExitCode::Interrupted,
        fmt::format("interrupted after {} of {} points; the same command goes on from there", done,
                    total));
  journal.remove();

  for (PieceResult &result : results) {
    curves.points.insert(curves.points.end(), result.points.begin(), result.points.end());
    curves.fields.merge(result.fields);
    curves.series.merge(result.series);
  }
  curves.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return curves;
}

} // namespace wheelrail
