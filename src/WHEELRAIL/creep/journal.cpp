// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/journal.h"

#include "base/output_file.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Json = nlohmann::json;

constexpr auto pause = std::chrono::seconds(2);

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

} // namespace

Journal::Journal(std::string path, std::string identity)
    : path_(std::move(path)), identity_(std::move(identity)), lastWrite_(Clock::now())
{
}

const Journal::Pieces &Journal::load()
{
  if (path_.empty() || !std::filesystem::exists(path_))
    return pieces_;
  const Json journal = Json::parse(readInputFile(path_), nullptr, false);
  if (journal.is_discarded() || journal.value("case", "") != identity_)
    return pieces_;
  for (const auto &[key, rows] : journal["pieces"].items())
    for (const Json &row : rows)
      pieces_[std::stoul(key)].push_back(pointFrom(row));
  return pieces_;
}

void Journal::add(std::size_t piece, const std::vector<CurvePoint> &points)
{
  pieces_[piece] = points;
  if (Clock::now() - lastWrite_ >= pause)
    write();
}

void Journal::write()
{
  if (path_.empty())
    return;
  Json journal = {{"case", identity_}, {"pieces", Json::object()}};
  for (const auto &[number, points] : pieces_) {
    Json rows = Json::array();
    for (const CurvePoint &point : points)
      rows.push_back(toJson(point));
    journal["pieces"][std::to_string(number)] = rows;
  }
  writeOutputFile(path_, journal.dump());
  lastWrite_ = Clock::now();
}

void Journal::remove() const
{
  std::error_code ignored;
  if (!path_.empty())
    std::filesystem::remove(path_, ignored);
}

} // namespace wheelrail
