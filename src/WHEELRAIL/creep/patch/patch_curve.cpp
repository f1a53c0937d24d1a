// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_curve.h"

#include "base/errors.h"
#include "creep/patch/patch_journal.h"
#include "creep/patch/patch_piece.h"
#include "creep/sweep/plausibility.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t creepsInPiece = 8; ///< solved one after the other, warm

/// Steady rolling goes from creep to creep, so neighbours share a piece; the points of the other
/// modes begin anew, and each is a piece. The cut depends on the case only, never on the threads.
std::vector<PatchPiece> cutIntoPieces(const PatchSpecification &specification,
                                      const std::vector<PatchTask> &tasks)
{
  const std::size_t row = specification.mode == PatchMode::Frozen
                              ? std::max(specification.creep.size(), specification.forceX.size())
                              : 1;
  std::vector<PatchPiece> pieces;
  for (std::size_t first = 0; first < tasks.size(); first += row)
    for (std::size_t k = 0; k < row; k += creepsInPiece)
      pieces.push_back({first + k, std::min(creepsInPiece, row - k)});
  return pieces;
}

/// Longest way of any point with this load, m: all of them share the surfaces.
double longestWay(const PatchSpecification &asked, double load)
{
  if (asked.mode != PatchMode::Moving)
    return 0.0;
  constexpr double mostLengths = 1e5; // a sequence with s for ms has more; days of computing
  const HertzEllipse hertz = asked.contact.hertz(load);
  double way = 0.0, fastest = 0.0;
  for (double speed : asked.speed)
    way = std::max(way, rolledDistance(asked.moving, asked.sequence, hertz, speed));
  const double lengths = way / (2.0 * hertz.a);
  if (lengths > mostLengths)
    throw Error(ExitCode::BadInput,
                fmt::format("sequence.time: '{:g} s' lets the wheel roll {:.4g} m, {:.3g} lengths "
                            "of the contact; at most {:g} are allowed",
                            asked.sequence.time.back(), way, lengths, mostLengths));
  for (const auto *creeps : {&asked.creep, &asked.sequence.creep})
    for (double creep : *creeps)
      fastest = std::max(fastest, std::abs(creep));
  return way * (1.0 + 0.5 * fastest); // of the faster surface, which has half of the creep
}

PatchContactSummary contactSummary(const PatchSpecification &asked, const PatchContact &contact)
{
  PatchContactSummary summary;
  if (!asked.sensitivities || asked.mode == PatchMode::Static)
    return summary;
  TangentialSolver solver(contact.grid, contact.pair);
  summary.sensitivity = creepSensitivity(solver, contact.normal.pressure);
  summary.kalker = kalkerCoefficients(*summary.sensitivity, contact.pair.G, contact.nominalArea());
  return summary;
}

void prepare(const PatchSpecification &asked, const FrictionLaw &law, const SweepOptions &options,
             PatchCurves &curves)
{
  const std::vector<double> &loads = asked.contact.load;
  curves.contacts.resize(asked.roughness.surfaces() * loads.size());
  curves.summaries.resize(curves.contacts.size());
  prepareAll(curves.contacts.size(), options, [&](std::size_t k) {
    const double load = loads[k % loads.size()];
    curves.contacts[k] =
        preparePatch(asked.contact, asked.roughness, load, k / loads.size(),
                     asked.physics.pressureLimit(law, 0.0), longestWay(asked, load));
    curves.summaries[k] = contactSummary(asked, curves.contacts[k]);
  });
}

/// What can be computed with but hardly be meant, of contacts and creepages (`plausibility.h`).
void addDoubts(const PatchSpecification &asked, double strength, PatchCurves &curves)
{
  const auto &bodies = asked.contact.bodies;
  const double youngs = std::min(bodies[0].youngsModulus, bodies[1].youngsModulus);
  std::vector<double> atEdge = asked.spin;
  atEdge.insert(atEdge.end(), asked.sequence.spin.begin(), asked.sequence.spin.end());
  double largest = 0.0;
  for (const PatchContact &contact : curves.contacts) {
    for (const std::string &remark : contact.surface.remarks)
      addDoubt(curves.warnings, remark);
    for (const HeightMapStatistics &step : contact.surface.statistics)
      if (step.step.find("on the cells") != std::string::npos || step.step == "generated")
        addDoubt(curves.warnings, slopeDoubt(step.step, std::max(step.rmsSlopeX, step.rmsSlopeY)));
    addDoubt(curves.warnings, pressureDoubt(contact.normal.peakPressure(), strength, youngs));
    largest = std::max({largest, contact.hertz.a, contact.hertz.b});
    addDoubt(curves.warnings, sizeDoubt(std::max(contact.hertz.a, contact.hertz.b),
                                        0.5 / contact.hertz.curvatures.A));
  }
  if (asked.contact.curvatures) // not where the semi-axes decide on the radii
    addDoubt(curves.warnings, radiusDoubt(0.5 / asked.contact.curvatures->A));
  if (asked.mode == PatchMode::Static)
    return;
  for (double &spin : atEdge)
    spin *= largest;
  addDoubt(curves.warnings, speedDoubt("speed", asked.speed));
  addDoubt(curves.warnings, speedDoubt("sequence.speed", asked.sequence.speed));
  const double along = curves.contacts.front().hertz.a;
  const ThermalSpecification &thermal = asked.physics.thermal;
  addDoubt(curves.warnings, pecletDoubt("speed", asked.speed, along, thermal));
  addDoubt(curves.warnings, pecletDoubt("sequence.speed", asked.sequence.speed, along, thermal));
  addDoubt(curves.warnings, creepDoubt("creep", asked.creep));
  addDoubt(curves.warnings, creepDoubt("sequence.creep", asked.sequence.creep));
  addDoubt(curves.warnings, creepDoubt("lateral", asked.lateral));
  addDoubt(curves.warnings, creepDoubt("sequence.lateral", asked.sequence.lateral));
  addDoubt(curves.warnings, creepDoubt("spin at the contact's edge", atEdge));
}

/// The fields of a piece go into files beside the journal: their checksums, by number of the point.
nlohmann::json attachFields(const PatchPieceResult &result, const Journal &journal)
{
  nlohmann::json checksums = nlohmann::json::object();
  for (const auto &[number, fields] : result.fields)
    checksums[std::to_string(number)] = journal.attach(number, patchFieldsBytes(fields));
  return checksums;
}

/// \return whether all fields of the piece are there
bool takeFields(const nlohmann::json &checksums, const Journal &journal, int cells,
                PatchPieceResult &result)
{
  for (const auto &[key, checksum] : checksums.items()) {
    const int number = std::stoi(key);
    const std::optional<std::string> bytes = journal.attached(number, checksum);
    std::optional<PatchFields> fields;
    if (bytes)
      fields = patchFieldsFrom(*bytes, cells);
    if (!fields)
      return false;
    result.fields[number] = std::move(*fields);
  }
  return true;
}

} // namespace

PatchCurves solvePatchCurves(const PatchSpecification &asked, const LawPointer &law,
                             const SweepOptions &options)
{
  const auto begin = Clock::now();
  PatchCurves curves;
  prepare(asked, *law, options, curves);
  addDoubts(asked, asked.physics.strengthInUse(*law), curves);
  const std::vector<PatchTask> tasks = patchTasks(asked);
  const std::vector<PatchPiece> pieces = cutIntoPieces(asked, tasks);
  const auto contactOf = [&](std::size_t piece) -> const PatchContact & {
    return curves.contacts[tasks[pieces[piece].first].contact];
  };
  std::vector<PatchPieceResult> results(pieces.size());
  std::vector<nlohmann::json> checksums(pieces.size(), nlohmann::json::object());
  const LawSpread spread =
      asked.mode == PatchMode::Static ? LawSpread(law) : LawSpread(asked.spread, law);
  addDoubt(curves.warnings, spread.warning());
  Sweep sweep;
  for (const PatchPiece &piece : pieces)
    sweep.points.push_back(static_cast<int>(piece.count));
  sweep.leavesMore = [](std::size_t) { return false; };
  sweep.solve = [&](std::size_t k, const std::function<bool()> &goOn) {
    results[k] = solvePatchPiece(asked, spread, contactOf(k), tasks, pieces[k], goOn);
    if (results[k].points.empty())
      return false;
    if (options.journal)
      checksums[k] = attachFields(results[k], *options.journal);
    return true;
  };
  sweep.rows = [&](std::size_t k) -> nlohmann::json {
    for (const auto &[number, checksum] : checksums[k].items())
      if (checksum.get<std::string>().empty()) // no room for it: nothing of the piece is kept
        return nullptr;
    return {{"points", patchPointsJson(results[k].points)},
            {"series", patchSeriesJson(results[k].series)},
            {"fields", checksums[k]}};
  };
  sweep.takeRows = [&](std::size_t k, const nlohmann::json &rows) {
    results[k].points = patchPointsFrom(rows.at("points"));
    results[k].series = patchSeriesFrom(rows.at("series"));
    const bool complete =
        takeFields(rows.at("fields"), *options.journal, contactOf(k).grid.cells(), results[k]);
    return complete ? results[k].points.size() : 0;
  };
  curves.resumed = runSweep(sweep, options);

  for (PatchPieceResult &result : results) {
    curves.points.insert(curves.points.end(), result.points.begin(), result.points.end());
    curves.fields.merge(result.fields);
    curves.series.merge(result.series);
  }
  for (const PatchPoint &point : curves.points)
    curves.use.include(point.use);
  if (const std::string warning = law->warning(curves.use); !warning.empty())
    curves.warnings.push_back(warning);
  addDoubt(curves.warnings, memoryDoubt(asked.physics.memoryLength, law->dependsOnSpeed()));
  curves.hasBand = spread.any();
  curves.redrawn = spread.redrawn();
  if (curves.series.empty()) // else there is something to write
    requireAnyPoint(curves.points);
  curves.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return curves;
}

} // namespace wheelrail
