#include "creep_curve.h"

#include "errors.h"
#include "moving_creep.h"
#include "output_file.h"

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

constexpr int creepsInPiece = 8;
constexpr auto journalPause = std::chrono::seconds(2);
constexpr double differencePart = 0.1; ///< of a parameter's standard error

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

std::vector<Piece> cutIntoPieces(const Case &input, int profiles)
{
  std::vector<Piece> pieces;
  int point = 0;
  for (int profile = 0; profile < profiles; ++profile)
    for (double speed : input.speed)
      for (std::size_t k = 0; k < input.creep.size(); k += creepsInPiece) {
        const auto end = std::min(k + creepsInPiece, input.creep.size());
        pieces.push_back({profile,
                          speed,
                          {input.creep.begin() + static_cast<std::ptrdiff_t>(k),
                           input.creep.begin() + static_cast<std::ptrdiff_t>(end)},
                          point});
        point += static_cast<int>(end - k);
      }
  return pieces;
}

/// The law and its neighbours for derivatives: (parameter, +-) in pairs after the law itself.
std::vector<FrictionLaw> lawAndNeighbours(const FrictionLaw &law)
{
  std::vector<FrictionLaw> laws{law};
  if (!law.covariance)
    return laws;
  for (int k = 0; k < lawParameters; ++k)
    for (double sign : {1.0, -1.0}) {
      FrictionLaw neighbour = law;
      double *parameter[] = {&neighbour.mu0, &neighbour.mu1, &neighbour.mu2, &neighbour.b,
                             &neighbour.c};
      *parameter[k] += sign * differencePart * std::sqrt((*law.covariance)(k, k));
      laws.push_back(neighbour);
    }
  return laws;
}

double errorOf(const std::vector<double> &ratios, const FrictionLaw &law)
{
  Eigen::Matrix<double, lawParameters, 1> derivative;
  for (int k = 0; k < lawParameters; ++k) {
    const double step = 2.0 * differencePart * std::sqrt((*law.covariance)(k, k));
    derivative[k] = step > 0.0 ? (ratios[1 + 2 * k] - ratios[2 + 2 * k]) / step : 0.0;
  }
  return std::sqrt(std::max(0.0, derivative.dot(*law.covariance * derivative)));
}

/// What a finished piece leaves.
struct PieceResult {
  bool done = false;
  std::vector<CurvePoint> points;
  ContactFields fields;
};

Json toJson(const CurvePoint &p)
{
  return {p.speed,
          p.creep,
          p.tractionRatio,
          p.traction,
          p.muMean,
          p.temperatureRise,
          p.temperatureMaximum,
          p.iterations,
          p.stickFraction,
          p.seed,
          p.tractionRatioError};
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
  p.seed = j.at(9);
  p.tractionRatioError = j.at(10);
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

/// Points of one piece for one law; empty when interrupted.
std::vector<CreepPoint> solvePiece(const Case &input, const FrictionLaw &law,
                                   const ContactSetup &setup, const Piece &piece,
                                   const std::function<bool()> &goOn, ContactFields &fields)
{
  if (input.mode == RollingMode::Moving) {
    MovingCreep moving(input, law, setup);
    std::vector<CreepPoint> points = moving.solve(piece.speed, piece.creeps, goOn);
    fields = moving.fields();
    return points;
  }
  FrozenCreep frozen(input, law, setup);
  std::vector<CreepPoint> points;
  for (double creep : piece.creeps) {
    if (!goOn())
      return {};
    points.push_back(frozen.solve(piece.speed, creep));
  }
  fields = frozen.fields();
  return points;
}

PieceResult solveWithErrors(const Case &input, const std::vector<FrictionLaw> &laws,
                            const ContactSetup &setup, const Piece &piece,
                            const std::function<bool()> &goOn)
{
  PieceResult result;
  std::vector<std::vector<CreepPoint>> perLaw;
  for (const FrictionLaw &law : laws) {
    ContactFields fields;
    perLaw.push_back(solvePiece(input, law, setup, piece, goOn, fields));
    if (perLaw.back().empty())
      return result;
    if (perLaw.size() == 1)
      result.fields = fields;
  }
  for (std::size_t k = 0; k < piece.creeps.size(); ++k) {
    CurvePoint point;
    static_cast<CreepPoint &>(point) = perLaw[0][k];
    point.seed = setup.seed;
    if (laws.size() > 1) {
      std::vector<double> ratios;
      for (const auto &points : perLaw)
        ratios.push_back(points[k].tractionRatio);
      point.tractionRatioError = errorOf(ratios, laws[0]);
    }
    result.points.push_back(point);
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

CreepCurves solveCreepCurves(const Case &input, const FrictionLaw &law, const SweepOptions &options)
{
  const auto begin = Clock::now();
  const int threads = options.threads > 0 ? options.threads : omp_get_max_threads();
  const std::vector<std::uint64_t> seeds =
      input.seeds.empty() ? std::vector<std::uint64_t>{0} : input.seeds;
  const auto stopped = [&] { return options.interrupted && options.interrupted(); };

  CreepCurves curves;
  FirstError error;
  curves.contacts.resize(seeds.size());
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    if (error.any() || stopped())
      continue;
    try {
      curves.contacts[k] = prepareContact(input, seeds[k]);
    } catch (...) {
      error.take();
    }
  }
  error.rethrow();

  const std::vector<FrictionLaw> laws = lawAndNeighbours(law);
  const std::vector<Piece> pieces = cutIntoPieces(input, static_cast<int>(seeds.size()));
  const int total = pieces.back().firstPoint + static_cast<int>(pieces.back().creeps.size());
  std::vector<PieceResult> results(pieces.size());
  Journal journal(options.journal,
                  fmt::format("{}\n{}\n{}", WHEELRAIL_VERSION, input.text, toJson(law).dump()));
  journal.load(results);
  int done = 0;
  for (const PieceResult &result : results)
    done += static_cast<int>(result.points.size());
  curves.resumed = done;

  std::mutex bookkeeping;
  const auto goOn = [&] { return !stopped() && !error.any(); };
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (results[k].done || !goOn())
      continue;
    try {
      PieceResult result =
          solveWithErrors(input, laws, curves.contacts[pieces[k].profile], pieces[k], goOn);
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
  curves.hasErrors = laws.size() > 1;
  curves.seconds = secondsSince(begin);
  return curves;
}

} // namespace wheelrail
