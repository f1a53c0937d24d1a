// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/journal.h"

#include "base/checksum.h"
#include "base/errors.h"
#include "base/program_files.h"
#include "base/version.h"
#include "shared/output_file.h"

#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace wheelrail {
namespace {

using Json = nlohmann::json;

constexpr const char *format = "wr_creep-journal 5";
constexpr auto pause = std::chrono::seconds(2);
constexpr std::size_t checksumLength = 8;

std::string textOf(const Json &json)
{
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The JSON of a line "CHECKSUM JSON"; empty where the checksum is another.
std::string checkedJson(const std::string &line, const std::string &headChecksum)
{
  if (line.size() <= checksumLength + 1 || line[checksumLength] != ' ')
    return "";
  const std::string json = line.substr(checksumLength + 1);
  return line.compare(0, checksumLength, checksum(headChecksum + json)) == 0 ? json : "";
}

/// Why a first line is not the one that is expected.
std::string whyNot(const std::string &head, const std::string &expected)
{
  if (head.empty())
    return "its first line is damaged, or it is not a journal";
  Json found = Json::parse(head, nullptr, false);
  const std::string version = found.is_object() ? found.value("version", Json()).dump() : "";
  if (found.is_object())
    found["version"] = versionText;
  return textOf(found) == expected
             ? fmt::format("was written by version {} of this program, which is \"{}\"", version,
                           versionText)
             : "is of another case, or of files that have changed since";
}

} // namespace

Journal::Journal(std::string path, const std::string &identity, Warn warn)
    : path_(std::move(path)),
      head_(textOf({{"format", format}, {"version", versionText}, {"case", identity}})),
      headChecksum_(checksum(head_)), warn_(std::move(warn)), lastWrite_(Clock::now())
{
}

std::string Journal::lineOf(const std::string &json) const
{
  return fmt::format("{} {}\n", checksum(headChecksum_ + json), json);
}

void Journal::say(const std::string &problem) const
{
  if (warn_)
    warn_(problem);
}

Journal::Pieces Journal::load()
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path_, ignored))
    return {};
  std::string text;
  try {
    text = readInputFile(path_);
  } catch (const Error &error) { // empty, or not to be read
    say(fmt::format("{}; it is not used", error.what()));
    return {};
  }
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::string head = checkedJson(line, "");
  if (head != head_) {
    say(fmt::format("{}: {}; it is not used", path_, whyNot(head, head_)));
    return {};
  }
  Pieces pieces;
  std::vector<int> damaged;
  for (int number = 2; std::getline(lines, line); ++number) {
    const Json json = Json::parse(checkedJson(line, headChecksum_), nullptr, false);
    if (!json.contains("results") || !json["piece"].is_number_unsigned()) {
      damaged.push_back(number);
      continue;
    }
    const auto piece = json["piece"].get<std::size_t>();
    pieces[piece] = json["results"];
    lines_[piece] = line + "\n";
  }
  if (!damaged.empty())
    say(fmt::format("{}: damaged, and computed again: line{} {}", path_,
                    damaged.size() == 1 ? "" : "s", fmt::join(damaged, ", ")));
  isOnDisk_ = !lines_.empty();
  return pieces;
}

void Journal::add(std::size_t piece, const Json &results)
{
  const std::string line = lineOf(textOf({{"piece", piece}, {"results", results}}));
  lines_[piece] = line;
  unwritten_ += line;
  if (Clock::now() - lastWrite_ >= pause)
    write();
}

void Journal::refuse(std::size_t piece)
{
  lines_.erase(piece);
  say(fmt::format("{}: piece {} is not complete, or of another kind; it is computed again", path_,
                  piece));
}

void Journal::write()
{
  if (lines_.empty())
    return;
  try {
    if (size_ > 0 && mcawr::appendToFile(path_, size_, unwritten_)) {
      size_ += unwritten_.size();
    } else {
      std::string text = fmt::format("{} {}\n", headChecksum_, head_);
      for (const auto &[piece, line] : lines_)
        text += line;
      mcawr::writeOutputFile(path_, text);
      size_ = text.size();
    }
    unwritten_.clear();
  } catch (const mcawr::OutputError &error) {
    throw Error(ExitCode::Io, error.what() + whatIsKept());
  }
  isOnDisk_ = true;
  lastWrite_ = Clock::now();
}

std::string Journal::attachment(int number) const
{
  return fmt::format("{}.{}", path_, number);
}

std::string Journal::attach(int number, const std::string &bytes) const
{
  try {
    mcawr::writeOutputFile(attachment(number), bytes);
  } catch (const mcawr::OutputError &) { // the results will say so, if there is no room for them
    return "";
  }
  return checksum(bytes);
}

std::optional<std::string> Journal::attached(int number, const std::string &expected) const
{
  try {
    std::string bytes = readInputFile(attachment(number));
    if (checksum(bytes) == expected)
      return bytes;
  } catch (const Error &) { // missing, or not to be read: the piece is computed again
  }
  return std::nullopt;
}

std::string Journal::whatIsKept() const
{
  if (!isOnDisk_)
    return "";
  return fmt::format(
      "; the operating points in {} are kept, run the same command again to continue", path_);
}

void Journal::remove() const
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (isOnDisk_)
    fs::remove(path_, ignored);
  const fs::path path(path_);
  const std::string stem = path.filename().string() + ".";
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<fs::path> attachments;
  for (const auto &entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > stem.size() && name.compare(0, stem.size(), stem) == 0 &&
        name.find_first_not_of("0123456789", stem.size()) == std::string::npos)
      attachments.push_back(entry.path());
  }
  for (const fs::path &file : attachments)
    fs::remove(file, ignored);
}

} // namespace wheelrail
