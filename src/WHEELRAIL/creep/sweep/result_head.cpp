// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/result_head.h"

#include <fmt/format.h>
#include <sstream>

namespace wheelrail {
namespace {

/// The keywords of a group in one line: "load: 100 kN, semi_axes: [3 mm, 4 mm]".
std::string groupOf(const std::string &caseText, const std::string &group)
{
  std::istringstream lines(caseText);
  std::string text;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    const bool isIndented = line.rfind("  ", 0) == 0;
    if (!isIndented)
      inside = line == group + ":";
    else if (inside)
      text += (text.empty() ? "" : ", ") + line.substr(2);
  }
  return text;
}

} // namespace

ResultHead resultHead(const std::string &axes, const std::string &caseText)
{
  // the version without the commit: results do not change with it
  ResultHead head = {{"program", fmt::format("wr_creep {}", WHEELRAIL_VERSION)}, {"axes", axes}};
  for (const char *group : {"contact", "layer", "friction"})
    if (const std::string keywords = groupOf(caseText, group); !keywords.empty())
      head.push_back({group, keywords});
  return head;
}

std::string tableHead(const ResultHead &head)
{
  std::string text;
  for (const HeadLine &line : head)
    text += fmt::format("# {}: {}\n", line.name, line.value);
  return text;
}

} // namespace wheelrail
