// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/creep_curve.h"

#include "base/errors.h"
#include "creep/journal.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <mutex>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

/// Neighbouring creeps at one speed on one profile.
struct Piece {
  std::size_t profile;
  double speed;
  std::vector<double> creeps;
  int firstPoint;
};

/// Creeps that are solved one after the other. Rolling creeps of mode moving share the pressures,
/// unless each has its own because temperature acts back on them.
std::size_t creepsInPiece(const CreepSpecification &specification)
{
  if (specification.mode != RollingMode::Moving)
    return 8;
  const CreepPhysics &physics = specification.physics;
  return physics.hardnessLimit && physics.hasFeedback() ? 1 : 4;
}

std::vector<Piece> cutIntoPieces(const CreepSpecification &specification)
{
  const std::size_t length = creepsInPiece(specification);
  const std::vector<double> &creeps = specification.creep;
  std::vector<Piece> pieces;
  int point = 0;
  for (std::size_t profile = 0; profile < specification.surface.profiles(); ++profile)
    for (double speed : specification.speed)
      for (std::size_t k = 0; k < creeps.size(); k += length) {
        const auto end = std::min(k + length, creeps.size());
        pieces.push_back({profile,
                          speed,
                          {creeps.begin() + static_cast<std::ptrdiff_t>(k),
                           creeps.begin() + static_cast<std::ptrdiff_t>(end)},
                          point});
        point += static_cast<int>(end - k);
      }
  return pieces;
}

/// What a finished piece leaves.
struct PieceResult {
  bool done = false;
  std::vector<CurvePoint> points;
  ContactFields fields;
};

CurvePoint curvePoint(const CreepPoint &point, const ContactSetup &setup, const LawSpread &spread,
                      const std::vector<double> &ratios)
{
  CurvePoint result;
  static_cast<CreepPoint &>(result) = point;
  result.profile = setup.surface.profile;
  result.band = spread.band(ratios);
  return result;
}

/// A point in the journal, and back.
Json rowOf(const CurvePoint &p)
{
  return {p.speed,         p.creep,           p.tractionRatio,      p.traction,
          p.muMean,        p.temperatureRise, p.temperatureMaximum, p.iterations,
          p.stickFraction, p.profile,         p.band.standardError, p.band.low,
          p.band.high};
}

CurvePoint pointFrom(const Json &j)
{
  CurvePoint p;
  p.speed = j.at(0);
  p.creep = j.at(1);
  p.tractionRatio = j.at(2);
  p.traction = j.at(3);
  p.muMean = j.at(4);
  p.temperatureRise = j.at(5);
  p.temperatureMaximum = j.at(6);
  p.iterations = j.at(7);
  p.stickFraction = j.at(8);
  p.profile = j.at(9);
  p.band = {j.at(10), j.at(11), j.at(12)};
  return p;
}

Json rowsOf(const std::vector<CurvePoint> &points)
{
  Json rows = Json::array();
  for (const CurvePoint &point : points)
    rows.push_back(rowOf(point));
  return rows;
}

/// Empty when interrupted.
PieceResult solveMoving(const CreepPhysics &physics, const MovingSpecification &specification,
                        const LawSpread &spread, const ContactSetup &setup, const Piece &piece,
                        const std::function<bool()> &goOn)
{
  PieceResult result;
  std::vector<std::vector<CreepPoint>> perLaw;
  for (const FrictionLaw &law : spread.laws()) {
    MovingCreep moving(physics, specification, law, setup);
    perLaw.push_back(moving.solve(piece.speed, piece.creeps, goOn));
    if (perLaw.back().empty())
      return {};
    if (perLaw.size() == 1)
      result.fields = moving.fields();
  }
  for (std::size_t k = 0; k < piece.creeps.size(); ++k) {
    std::vector<double> ratios;
    for (const auto &points : perLaw)
      ratios.push_back(points[k].tractionRatio);
    result.points.push_back(curvePoint(perLaw[0][k], setup, spread, ratios));
  }
  result.done = true;
  return result;
}

/// The law itself warm from creep to creep, the others from its solution. Empty when interrupted.
PieceResult solveFrozen(const CreepPhysics &physics, const LawSpread &spread,
                        const ContactSetup &setup, const Piece &piece,
                        const std::function<bool()> &goOn)
{
  PieceResult result;
  FrozenCreep frozen(physics, setup);
  for (double creep : piece.creeps) {
    std::vector<double> ratios;
    CreepPoint point;
    for (const FrictionLaw &law : spread.laws()) {
      if (!goOn())
        return {};
      const CreepPoint solved = frozen.solve(law, piece.speed, creep);
      if (ratios.empty()) {
        point = solved;
        result.fields = frozen.fields();
      } else {
        frozen.startFrom(result.fields);
      }
      ratios.push_back(solved.tractionRatio);
    }
    result.points.push_back(curvePoint(point, setup, spread, ratios));
  }
  result.done = true;
  return result;
}

} // namespace

CreepCurves solveCreepCurves(const CreepSpecification &specification, const FrictionLaw &law,
                             const SweepOptions &options)
{
  const auto begin = Clock::now();
  const CreepPhysics &physics = specification.physics;
  const bool moving = specification.mode == RollingMode::Moving;

  CreepCurves curves;
  curves.contacts = prepareContacts(specification.contact, specification.surface,
                                    physics.pressureLimit(0.0), moving, options);
  const LawSpread spread(specification.spread, law);
  const std::vector<Piece> pieces = cutIntoPieces(specification);
  const int total = pieces.back().firstPoint + static_cast<int>(pieces.back().creeps.size());
  std::vector<PieceResult> results(pieces.size());
  Journal journal(options.journal, fmt::format("journal 2\n{}\n{}\n{}", WHEELRAIL_VERSION,
                                               options.identity, toJson(law).dump()));
  int done = 0;
  for (const auto &[number, rows] : journal.load()) {
    // The last piece is always computed: its fields are not in the journal.
    if (number + 1 >= pieces.size() || rows.size() != pieces[number].creeps.size())
      continue;
    for (const Json &row : rows)
      results[number].points.push_back(pointFrom(row));
    done += static_cast<int>(rows.size());
    results[number].done = true;
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
      const ContactSetup &setup = curves.contacts[pieces[k].profile];
      PieceResult result =
          moving ? solveMoving(physics, specification.moving, spread, setup, pieces[k], goOn)
                 : solveFrozen(physics, spread, setup, pieces[k], goOn);
      if (!result.done)
        continue; // interrupted: the journal must not know the piece
      if (k + 1 < pieces.size())
        result.fields = {};
      const std::lock_guard<std::mutex> lock(bookkeeping);
      results[k] = std::move(result);
      done += static_cast<int>(results[k].points.size());
      journal.add(k, rowsOf(results[k].points));
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

  for (const PieceResult &result : results)
    curves.points.insert(curves.points.end(), result.points.begin(), result.points.end());
  curves.last = std::move(results.back().fields);
  curves.hasBand = spread.any();
  curves.redrawn = spread.redrawn();
  curves.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return curves;
}

} // namespace wheelrail
