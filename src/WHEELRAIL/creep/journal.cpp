// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/journal.h"

#include "base/output_file.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Json = nlohmann::json;

constexpr auto pause = std::chrono::seconds(2);

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
  for (const auto &[key, results] : journal["pieces"].items())
    pieces_[std::stoul(key)] = results;
  return pieces_;
}

void Journal::add(std::size_t piece, Json results)
{
  pieces_[piece] = std::move(results);
  if (Clock::now() - lastWrite_ >= pause)
    write();
}

void Journal::write()
{
  if (path_.empty())
    return;
  Json journal = {{"case", identity_}, {"pieces", Json::object()}};
  for (const auto &[number, results] : pieces_)
    journal["pieces"][std::to_string(number)] = results;
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
