// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/result_files.h"

#include "base/result_text.h"

namespace wheelrail {
namespace {

bool isTable(const std::string &name)
{
  const std::string ending = ".csv";
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

} // namespace

void ResultFiles::add(const std::string &name, const std::string &content)
{
  files_.add(pathOf(name), isTable(name) ? finiteTable(name, content) : content);
  names_ += (names_.empty() ? "" : ", ") + name;
}

void ResultFiles::addElsewhere(const std::string &path, const std::string &content)
{
  files_.add(path, content);
}

} // namespace wheelrail
