#include "creep/creep_curve.h"

#include "base/errors.h"
#include "base/output_file.h"
#include "creep/moving_creep.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <mutex>
#include <nlohmann/json.hpp>
#include <omp.h>

namespace wheelrail {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

constexpr auto journalPause = std::chrono::seconds(2);

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Neighbouring creeps at one speed on one profile.
struct Piece {
  int profile;
  double speed;
  std::vector<double> creeps;
  int firstPoint;
};

/// Creeps that are solved one after the other. Rolling creeps of mode moving share the pressures,
/// unless each has its own because temperature acts back on them.
std::size_t creepsInPiece(const Case &input)
{
  if (input.mode != RollingMode::Moving)
    return 8;
  return input.hardnessLimit && hasFeedback(input) ? 1 : 4;
}

std::vector<Piece> cutIntoPieces(const Case &input, int profiles)
{
  const std::size_t length = creepsInPiece(input);
  std::vector<Piece> pieces;
  int point = 0;
  for (int profile = 0; profile < profiles; ++profile)
    for (double speed : input.speed)
      for (std::size_t k = 0; k < input.creep.size(); k += length) {
        const auto end = std::min(k + length, input.creep.size());
        pieces.push_back({profile,
                          speed,
                          {input.creep.begin() + static_cast<std::ptrdiff_t>(k),
                           input.creep.begin() + static_cast<std::ptrdiff_t>(end)},
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

Json toJson(const CurvePoint &p)
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

/// Finished pieces on disk. A journal of another case or version is not used.
class Journal {
 public:
  Journal(std::string file, std::string configuration)
      : path(std::move(file)), identity(std::move(configuration)), lastWrite(Clock::now())
  {
  }

  void load(std::vector<PieceResult> &pieces) const
  {
    if (path.empty() || !std::filesystem::exists(path))
      return;
    const Json journal = Json::parse(readInputFile(path), nullptr, false);
    if (journal.is_discarded() || journal.value("case", "") != identity)
      return;
    for (const auto &[key, rows] : journal["pieces"].items()) {
      const std::size_t index = std::stoul(key);
      // The last piece is always computed: its fields are not in the journal.
      if (index + 1 >= pieces.size())
        continue;
      for (const Json &row : rows)
        pieces[index].points.push_back(pointFrom(row));
      pieces[index].done = true;
    }
  }

  void save(const std::vector<PieceResult> &pieces, bool now)
  {
    if (path.empty() || (!now && Clock::now() - lastWrite < journalPause))
      return;
    Json journal = {{"case", identity}, {"pieces", Json::object()}};
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (!pieces[k].done)
        continue;
      Json rows = Json::array();
      for (const CurvePoint &point : pieces[k].points)
        rows.push_back(toJson(point));
      journal["pieces"][std::to_string(k)] = rows;
    }
    writeOutputFile(path, journal.dump());
    lastWrite = Clock::now();
  }

  void remove() const
  {
    std::error_code ignored;
    if (!path.empty())
      std::filesystem::remove(path, ignored);
  }

 private:
  std::string path, identity;
  Clock::time_point lastWrite;
};

CurvePoint curvePoint(const CreepPoint &point, const ContactSetup &setup, const LawSpread &spread,
                      const std::vector<double> &ratios)
{
  CurvePoint result;
  static_cast<CreepPoint &>(result) = point;
  result.profile = setup.profile;
  result.band = spread.band(ratios);
  return result;
}

/// Empty when interrupted.
PieceResult solveMoving(const Case &input, const LawSpread &spread, const ContactSetup &setup,
                        const Piece &piece, const std::function<bool()> &goOn)
{
  PieceResult result;
  std::vector<std::vector<CreepPoint>> perLaw;
  for (const FrictionLaw &law : spread.laws()) {
    MovingCreep moving(input, law, setup);
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
PieceResult solveFrozen(const Case &input, const LawSpread &spread, const ContactSetup &setup,
                        const Piece &piece, const std::function<bool()> &goOn)
{
  PieceResult result;
  FrozenCreep frozen(input, setup);
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

/// The first exception of a parallel loop, to be thrown after it.
class FirstError {
 public:
  void take()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!error)
      error = std::current_exception();
    failed = true;
  }
  bool any() const { return failed; }
  void rethrow() const
  {
    if (error)
      std::rethrow_exception(error);
  }

 private:
  std::mutex mutex;
  std::exception_ptr error;
  std::atomic<bool> failed{false};
};

} // namespace

FrictionLaw lawOf(const Case &input)
{
  if (input.law != "constant")
    return readFrictionLaw(input.law);
  FrictionLaw law;
  law.mu0 = input.mu;
  law.source = "constant";
  return law;
}

int sweepThreads(const SweepOptions &options)
{
  return options.threads > 0 ? options.threads : omp_get_max_threads();
}

std::vector<ContactSetup> prepareContacts(const Case &input, int threads,
                                          const std::function<bool()> &stopped)
{
  std::vector<ContactSetup> contacts(input.profiles());
  FirstError error;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (error.any() || stopped())
      continue;
    try {
      contacts[k] = prepareContact(input, k);
    } catch (...) {
      error.take();
    }
  }
  error.rethrow();
  if (stopped())
    throw Error(ExitCode::Interrupted,
                "interrupted before the first point; the same command goes on");
  return contacts;
}

CreepCurves solveCreepCurves(const Case &input, const FrictionLaw &law, const SweepOptions &options)
{
  const auto begin = Clock::now();
  const int threads = sweepThreads(options);
  const auto stopped = [&] { return options.interrupted && options.interrupted(); };

  CreepCurves curves;
  curves.contacts = prepareContacts(input, threads, stopped);
  const LawSpread spread(input, law);
  const std::vector<Piece> pieces = cutIntoPieces(input, static_cast<int>(curves.contacts.size()));
  const int total = pieces.back().firstPoint + static_cast<int>(pieces.back().creeps.size());
  std::vector<PieceResult> results(pieces.size());
  Journal journal(options.journal, fmt::format("journal 2\n{}\n{}\n{}", WHEELRAIL_VERSION,
                                               input.text, toJson(law).dump()));
  journal.load(results);
  int done = 0;
  for (const PieceResult &result : results)
    done += static_cast<int>(result.points.size());
  curves.resumed = done;

  FirstError error;
  std::mutex bookkeeping;
  const auto goOn = [&] { return !stopped() && !error.any(); };
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (results[k].done || !goOn())
      continue;
    try {
      const ContactSetup &setup = curves.contacts[pieces[k].profile];
      PieceResult result = input.mode == RollingMode::Moving
                               ? solveMoving(input, spread, setup, pieces[k], goOn)
                               : solveFrozen(input, spread, setup, pieces[k], goOn);
      if (k + 1 < pieces.size())
        result.fields = {};
      const std::lock_guard<std::mutex> lock(bookkeeping);
      results[k] = std::move(result);
      done += static_cast<int>(results[k].points.size());
      journal.save(results, false);
      if (options.progress)
        options.progress(done, total);
    } catch (...) {
      error.take();
    }
  }
  if (stopped() || error.any())
    journal.save(results, true);
  error.rethrow();
  if (stopped() && done < total)
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
  curves.seconds = secondsSince(begin);
  return curves;
}

} // namespace wheelrail
