// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/found_logs.h"

#include "base/errors.h"
#include "fit/log_archive.h"
#include "shared/friction_log_format.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace wheelrail {

namespace {

namespace fs = std::filesystem;

/// One name for each file, whatever leads to it.
std::string placeOf(const std::string &path)
{
  std::error_code error;
  const auto place = fs::weakly_canonical(path, error);
  return error ? path : place.string();
}

/// All *.friction below a folder, whatever they are: one that cannot be read must not be missed.
void search(const fs::path &folder, std::vector<std::string> &found)
{
  std::error_code error, ignored;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->is_directory(ignored)) {
      if (!entry->is_symlink(ignored)) // it may lead back here
        search(entry->path(), found);
    } else if (entry->path().extension() == mcawr::friction_log::extension) {
      found.push_back(entry->path().string());
    }
  }
  if (error)
    throw badInput(folder.string(), 0, "", "cannot be searched: " + error.message());
}

/// What was found so far: each log once, each archive read once.
class Finder {
 public:
  void add(const std::string &path)
  {
    std::error_code error;
    if (isLogArchive(path)) {
      for (auto &[name, text] : textsOf(path))
        addArchived(path, name, text);
    } else if (const auto inside = archivedFile(path)) {
      auto &texts = textsOf(inside->archive);
      if (fs::path(inside->name).extension() != mcawr::friction_log::extension)
        throw badInput(path, 0, "", "is no *.friction: of an archive only those are read");
      const auto text = texts.find(inside->name);
      if (text == texts.end())
        throw badInput(path, 0, "", "no such file in the archive");
      addArchived(inside->archive, inside->name, text->second);
    } else if (fs::is_directory(path, error)) {
      addFolder(path);
    } else if (fs::exists(path, error)) {
      addFile(path);
    } else {
      throw badInput(path, 0, "", "no such file or folder");
    }
  }
  std::vector<FoundLog> takeLogs() { return std::move(logs_); }

 private:
  std::map<std::string, std::string> &textsOf(const std::string &archive)
  {
    const auto place = placeOf(archive);
    auto known = archives_.find(place);
    if (known == archives_.end())
      known = archives_.emplace(place, readLogArchive(archive)).first;
    return known->second;
  }
  /// \param text is moved from: a log is taken once
  void addArchived(const std::string &archive, const std::string &name, std::string &text)
  {
    if (seen_.insert(placeOf(archive) + "/" + name).second)
      logs_.push_back({archive + "/" + name, archive, std::move(text)});
  }
  void addFile(const std::string &path)
  {
    if (seen_.insert(placeOf(path)).second)
      logs_.push_back({path, "", ""});
  }
  void addFolder(const std::string &path)
  {
    std::vector<std::string> found;
    search(path, found);
    if (found.empty())
      throw badInput(path, 0, "",
                     std::string("this folder holds no *.friction file (archives, *") +
                         archiveEnding + ", have to be named themselves)");
    std::sort(found.begin(), found.end());
    for (const auto &file : found)
      addFile(file);
  }

  std::vector<FoundLog> logs_;
  std::set<std::string> seen_;
  std::map<std::string, std::map<std::string, std::string>> archives_; ///< by their places
};

} // namespace

FrictionLog FoundLog::read() const
{
  return archive.empty() ? readFrictionLog(file) : parseFrictionLog(file, text);
}

std::vector<FoundLog> findFrictionLogs(const std::vector<std::string> &paths)
{
  Finder finder;
  for (const auto &path : paths)
    finder.add(path);
  return finder.takeLogs();
}

} // namespace wheelrail
