// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/result_files.h"

#include "base/result_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

bool isTable(const std::string &name)
{
  const std::string ending = ".csv";
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

/// What a summary says to stand beside it; nothing where it is none of ours, or says nothing.
std::vector<std::string> formerSet(const std::string &path)
{
  std::ifstream in(path);
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object() || json.value("format", nlohmann::json()) != "wr_creep-summary 1")
    return {};
  std::vector<std::string> names;
  for (const auto &name : json.value("files", nlohmann::json::array()))
    if (name.is_string())
      names.push_back(name.get<std::string>());
  return names;
}

} // namespace

void ResultFiles::add(const std::string &name, const std::string &content)
{
  files_.add(pathOf(name), isTable(name) ? tableHead(head_) + finiteTable(name, content) : content);
  names_ += (names_.empty() ? "" : ", ") + name;
  set_.push_back(name);
}

void ResultFiles::note(const std::vector<std::string> &names)
{
  set_.insert(set_.end(), names.begin(), names.end());
}

void ResultFiles::addSummary(
    const std::function<std::string(const std::vector<std::string> &)> &text)
{
  std::vector<std::string> names = set_;
  names.emplace_back(summaryName);
  add(summaryName, text(names));
}

void ResultFiles::commit(const std::vector<std::string> &inputs)
{
  const std::vector<std::string> former = formerSet(pathOf(summaryName));
  files_.commit();
  for (const std::string &name : former) {
    const std::string path = pathOf(name);
    const bool isPlain = !name.empty() && std::filesystem::path(name).filename() == name;
    const bool isInput = std::any_of(inputs.begin(), inputs.end(), [&](const std::string &input) {
      return mcawr::isSameFile(path, input);
    });
    std::error_code ignored; // what cannot be removed is no reason to lose the results
    if (isPlain && !isInput && std::find(set_.begin(), set_.end(), name) == set_.end() &&
        std::filesystem::is_regular_file(path, ignored))
      std::filesystem::remove(path, ignored);
  }
}

void ResultFiles::addElsewhere(const std::string &path, const std::string &content)
{
  files_.add(path, content);
}

} // namespace wheelrail
