// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/creep_curve.h"

#include "base/errors.h"
#include "creep/line/creep_under_force.h"
#include "creep/line/curve_journal.h"
#include "creep/line/line_contacts.h"
#include "creep/sweep/plausibility.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Clock = std::chrono::steady_clock;

/// Neighbouring creeps, or forces, at one speed on one profile.
struct Piece {
  std::size_t first; ///< place of its first point among all
  std::size_t profile;
  double speed;
  std::vector<double> drives;
};

/// Creeps that are solved one after the other. Rolling creeps of mode moving share the pressures,
/// unless each has its own because temperature, or the traction of unlike bodies, acts back on
/// them.
std::size_t creepsInPiece(const CreepSpecification &specification)
{
  if (specification.mode != RollingMode::Moving)
    return 8;
  const bool couples = couplingOf(specification.contact.bodies) != 0.0;
  return specification.physics.heatLimitsPressure() || couples ? 1 : 4;
}

std::vector<Piece> cutIntoPieces(const CreepSpecification &specification)
{
  const std::size_t length = creepsInPiece(specification);
  const std::vector<double> &drives = specification.drives();
  std::vector<Piece> pieces;
  std::size_t points = 0;
  for (std::size_t profile = 0; profile < specification.surface.profiles(); ++profile)
    for (double speed : specification.speed) {
      for (std::size_t k = 0; k < drives.size(); k += length) {
        const auto end = std::min(k + length, drives.size());
        pieces.push_back({points + k,
                          profile,
                          speed,
                          {drives.begin() + static_cast<std::ptrdiff_t>(k),
                           drives.begin() + static_cast<std::ptrdiff_t>(end)}});
      }
      points += drives.size();
    }
  return pieces;
}

/// What a finished piece leaves.
struct PieceResult {
  std::vector<CurvePoint> points;
  std::map<int, ContactFields> fields;
};

/// What belongs to all pieces.
struct Work {
  const CreepSpecification &asked;
  const LawSpread &spread;
  std::size_t total; ///< number of points

  bool keeps(std::size_t point) const
  {
    return asked.fields.holds(static_cast<int>(point) + 1, static_cast<int>(total));
  }
};

/// The mirror image of a solution for the creep's size, where the creep is negative.
void turnToSign(double creep, CreepPoint &point)
{
  if (!(creep < 0.0))
    return;
  point.creep = creep;
  point.tractionRatio = -point.tractionRatio;
  point.traction = -point.traction;
}
ContactFields turnedToSign(double creep, ContactFields fields)
{
  if (creep < 0.0) {
    fields.traction = -fields.traction;
    fields.slip = -fields.slip;
  }
  return fields;
}

CurvePoint failedPoint(const ContactSetup &setup, double speed, double creep, const Error &error)
{
  CurvePoint point;
  point.speed = speed;
  point.creep = creep;
  point.profile = setup.surface.profile;
  point.failure = error.what();
  return point;
}

/// \param creep as asked for; `point` and `ratios` are of its size
CurvePoint curvePoint(double creep, const CreepPoint &point, const ContactSetup &setup,
                      const LawSpread &spread, std::vector<double> ratios)
{
  CurvePoint result;
  static_cast<CreepPoint &>(result) = point;
  turnToSign(creep, result);
  if (creep < 0.0)
    for (double &ratio : ratios)
      ratio = -ratio;
  result.profile = setup.surface.profile;
  result.band = spread.band(ratios);
  return result;
}

/// Creeps of one call share the pressures. Empty when interrupted.
/// \param creeps some of the piece's, from place `first` among all points on
PieceResult rollTogether(const Work &work, const ContactSetup &setup, double speed,
                         const std::vector<double> &creeps, std::size_t first,
                         const std::function<bool()> &goOn)
{
  PieceResult result;
  std::vector<std::vector<CreepPoint>> perLaw;
  for (const LawPointer &law : work.spread.laws()) {
    if (!perLaw.empty() && law == work.spread.laws().front()) {
      perLaw.push_back(perLaw.front());
      continue;
    }
    MovingCreep moving(work.asked.physics, work.asked.moving, *law, setup);
    perLaw.push_back(moving.solve(speed, creeps, goOn));
    if (perLaw.back().empty())
      return {};
    if (perLaw.size() > 1)
      continue;
    for (std::size_t k = 0; k < creeps.size(); ++k)
      if (work.keeps(first + k))
        result.fields[static_cast<int>(first + k) + 1] = turnedToSign(creeps[k], moving.fields(k));
  }
  for (std::size_t k = 0; k < creeps.size(); ++k) {
    std::vector<double> ratios;
    for (const auto &points : perLaw)
      ratios.push_back(points[k].tractionRatio);
    result.points.push_back(curvePoint(creeps[k], perLaw[0][k], setup, work.spread, ratios));
  }
  return result;
}

/// Where the creeps of a piece do not all converge, each rolls alone, which changes none of its
/// numbers. Empty when interrupted.
PieceResult solveMoving(const Work &work, const ContactSetup &setup, const Piece &piece,
                        const std::function<bool()> &goOn)
{
  try {
    return rollTogether(work, setup, piece.speed, piece.drives, piece.first, goOn);
  } catch (const Error &error) {
    if (error.code() != ExitCode::NotConverged)
      throw;
  }
  PieceResult result;
  for (std::size_t k = 0; k < piece.drives.size(); ++k)
    try {
      PieceResult one =
          rollTogether(work, setup, piece.speed, {piece.drives[k]}, piece.first + k, goOn);
      if (one.points.empty())
        return {};
      result.points.push_back(one.points.front());
      result.fields.merge(one.fields);
    } catch (const Error &error) {
      if (error.code() != ExitCode::NotConverged)
        throw;
      result.points.push_back(failedPoint(setup, piece.speed, piece.drives[k], error));
    }
  return result;
}

/// The creep at which a contact carries a force.
double creepOf(const Work &work, FrozenCreep &frozen, double speed, double force)
{
  const FrictionLaw &law = *work.spread.laws().front();
  return creepUnder(force, [&](double creep) {
    const double size = frozen.solve(law, speed, creep).traction;
    return creep < 0.0 ? -size : size;
  });
}

/// One creep with the law and with those near it, which start from the law's solution: neighbours
/// differ little from it. Its fields are what the next creep starts from.
/// \return nothing when interrupted
std::optional<CurvePoint> solveCreep(const Work &work, const ContactSetup &setup,
                                     FrozenCreep &frozen, double speed, double creep,
                                     const std::function<bool()> &goOn)
{
  std::vector<double> ratios;
  CreepPoint point;
  ContactFields fields;
  for (const LawPointer &law : work.spread.laws()) {
    if (!goOn())
      return std::nullopt;
    if (!work.spread.counts(ratios.size())) {
      ratios.push_back(ratios.front());
      continue;
    }
    const CreepPoint solved = frozen.solve(*law, speed, creep);
    if (ratios.empty()) {
      point = solved;
      point.use = frozen.use(*law, speed, std::abs(creep));
      fields = frozen.fields();
    } else {
      frozen.startFrom(fields);
    }
    ratios.push_back(solved.tractionRatio);
  }
  return curvePoint(creep, point, setup, work.spread, ratios);
}

/// Warm from creep to creep. Empty when interrupted.
PieceResult solveFrozen(const Work &work, const ContactSetup &setup, const Piece &piece,
                        const std::function<bool()> &goOn)
{
  PieceResult result;
  std::optional<FrozenCreep> frozen;
  for (std::size_t k = 0; k < piece.drives.size(); ++k) {
    const double drive = piece.drives[k];
    const bool found = !work.asked.force.empty();
    if (!frozen)
      frozen.emplace(work.asked.physics, setup);
    try {
      const double creep = found ? creepOf(work, *frozen, piece.speed, drive) : drive;
      const auto point = solveCreep(work, setup, *frozen, piece.speed, creep, goOn);
      if (!point)
        return {};
      result.points.push_back(*point);
      if (work.keeps(piece.first + k))
        result.fields[static_cast<int>(piece.first + k) + 1] =
            turnedToSign(creep, frozen->fields());
    } catch (const Error &error) {
      if (error.code() != ExitCode::NotConverged)
        throw;
      result.points.push_back(failedPoint(setup, piece.speed, found ? 0.0 : drive, error));
      frozen.reset();
    }
  }
  return result;
}

} // namespace

CreepCurves solveCreepCurves(const CreepSpecification &specification, const LawPointer &law,
                             const SweepOptions &options)
{
  const auto begin = Clock::now();
  const CreepPhysics &physics = specification.physics;
  const bool moving = specification.mode == RollingMode::Moving;

  CreepCurves curves;
  curves.contacts = prepareContacts(specification.contact, specification.surface,
                                    physics.pressureLimit(*law, 0.0), moving, options);
  curves.warnings =
      contactDoubts(curves.contacts, specification.contact, physics.strengthInUse(*law));
  addDoubt(curves.warnings, speedDoubt("speed", specification.speed));
  addDoubt(curves.warnings, pecletDoubt("speed", specification.speed,
                                        curves.contacts.front().hertz.halfWidth, physics.thermal));
  addDoubt(curves.warnings, creepDoubt("creep", specification.creep));
  const LawSpread spread(specification.spread, law);
  addDoubt(curves.warnings, spread.warning());
  const std::vector<Piece> pieces = cutIntoPieces(specification);
  std::vector<PieceResult> results(pieces.size());
  Sweep sweep;
  for (const Piece &piece : pieces)
    sweep.points.push_back(static_cast<int>(piece.drives.size()));
  const Work work{specification, spread, pieces.back().first + pieces.back().drives.size()};
  // fields are not in the journal
  sweep.leavesMore = [&](std::size_t k) {
    for (std::size_t i = 0; i < pieces[k].drives.size(); ++i)
      if (work.keeps(pieces[k].first + i))
        return true;
    return false;
  };
  sweep.solve = [&](std::size_t k, const std::function<bool()> &goOn) {
    const ContactSetup &setup = curves.contacts[pieces[k].profile];
    results[k] = moving ? solveMoving(work, setup, pieces[k], goOn)
                        : solveFrozen(work, setup, pieces[k], goOn);
    return !results[k].points.empty();
  };
  sweep.rows = [&](std::size_t k) { return curvePointsJson(results[k].points); };
  sweep.takeRows = [&](std::size_t k, const nlohmann::json &rows) {
    results[k].points = curvePointsFrom(rows);
    return results[k].points.size();
  };
  curves.resumed = runSweep(sweep, options);

  for (PieceResult &result : results) {
    curves.points.insert(curves.points.end(), result.points.begin(), result.points.end());
    curves.fields.merge(result.fields);
  }
  requireAnyPoint(curves.points);
  for (const CurvePoint &point : curves.points)
    curves.use.include(point.use);
  if (const std::string warning = law->warning(curves.use); !warning.empty())
    curves.warnings.push_back(warning);
  addDoubt(curves.warnings, memoryDoubt(specification.physics.memoryLength, law->dependsOnSpeed()));
  curves.hasBand = spread.any();
  curves.redrawn = spread.redrawn();
  curves.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return curves;
}

} // namespace wheelrail
