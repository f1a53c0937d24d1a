// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/text_lines.h"
#include "contact/patch/formats/height_map_formats.h"
#include "contact/patch/formats/map_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {

namespace {

/// Record 1 of ISO 25178-71, as far as heights need it.
struct SdfHead {
  bool rowsUpwards = true; ///< of the standard; its forerunner BCR-1.0 runs downwards
  long points = -1, profiles = -1;
  double xScale = 0.0, yScale = 0.0, zScale = 0.0; // m
  int sizeLine = 0;
};

bool sameWord(std::string_view a, std::string_view b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char p, unsigned char q) {
    return std::tolower(p) == std::tolower(q);
  });
}

/// A line without its comment.
std::string_view contentOf(std::string_view line)
{
  return trimmedView(line.substr(0, line.find(';')));
}

double scaleOf(const std::string &path, int line, const std::string &name, std::string_view text)
{
  double value = 0.0;
  if (!readDecimal(text, value) || !(value > 0.0))
    throw badInput(path, line, name, fmt::format("'{}' must be a positive number of metres", text));
  return value;
}

/// Takes over one "name = value"; others than those needed are left alone.
void readEntry(const std::string &path, int line, std::string_view name, std::string_view value,
               SdfHead &head)
{
  const std::string text(value);
  const std::pair<const char *, bool> given[] = {{"NumPoints", head.points >= 0},
                                                 {"NumProfiles", head.profiles >= 0},
                                                 {"Xscale", head.xScale > 0.0},
                                                 {"Yscale", head.yScale > 0.0},
                                                 {"Zscale", head.zScale > 0.0}};
  for (const auto &[known, isGiven] : given)
    if (isGiven && sameWord(name, known))
      throw badInput(path, line, known, "appears twice in the head");
  if (sameWord(name, "NumPoints"))
    head.points = wholeNumber(path, line, "NumPoints", text);
  else if (sameWord(name, "NumProfiles"))
    head.profiles = wholeNumber(path, line, "NumProfiles", text);
  else if (sameWord(name, "Xscale"))
    head.xScale = scaleOf(path, line, "Xscale", value);
  else if (sameWord(name, "Yscale"))
    head.yScale = scaleOf(path, line, "Yscale", value);
  else if (sameWord(name, "Zscale"))
    head.zScale = scaleOf(path, line, "Zscale", value);
  else if ((sameWord(name, "Compression") || sameWord(name, "CheckType")) && text != "0")
    throw badInput(
        path, line, std::string(name),
        fmt::format("'{}': only files without compression and check sum (0) are read", text));
  if (sameWord(name, "NumPoints") || sameWord(name, "NumProfiles"))
    head.sizeLine = line;
}

SdfHead readHead(const std::string &path, LineReader &lines)
{
  SdfHead head;
  std::string_view line;
  lines.next(line);
  const std::string_view version = contentOf(line);
  if (version != "aISO-1.0" && version != "aISO-2.0" && version != "aBCR-1.0")
    throw badInput(path, 1, "",
                   fmt::format("version '{}'; aISO-1.0, aISO-2.0 and aBCR-1.0 are read", version));
  head.rowsUpwards = version != "aBCR-1.0";
  while (true) {
    if (!lines.next(line))
      throw badInput(path, 0, "", "ends within its head, before the line '*'");
    const std::string_view content = contentOf(line);
    if (content == "*")
      break;
    if (content.empty())
      continue;
    const auto sign = content.find('=');
    if (sign == std::string_view::npos)
      throw badInput(path, lines.number(), "", "a line of the head must be 'name = value'");
    readEntry(path, lines.number(), trimmedView(content.substr(0, sign)),
              trimmedView(content.substr(sign + 1)), head);
  }
  const std::array<std::pair<const char *, bool>, 5> needed = {{{"NumPoints", head.points >= 0},
                                                                {"NumProfiles", head.profiles >= 0},
                                                                {"Xscale", head.xScale > 0.0},
                                                                {"Yscale", head.yScale > 0.0},
                                                                {"Zscale", head.zScale > 0.0}}};
  for (const auto &[name, found] : needed)
    if (!found)
      throw badInput(path, 0, name, "is missing in the head");
  checkMapSize(path, head.sizeLine, "NumPoints, NumProfiles", head.points, head.profiles);
  return head;
}

/// Record 2: numbers and BAD, in as many lines as the writer liked.
Eigen::VectorXd readHeights(const std::string &path, LineReader &lines, long count)
{
  Eigen::VectorXd height(count);
  long next = 0;
  std::string_view line;
  while (lines.next(line)) {
    std::string_view rest = contentOf(line);
    while (!rest.empty()) {
      const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
      rest = trimmedView(rest.substr(word.size()));
      if (word == "*") {
        if (next != count)
          throw badInput(path, lines.number(), "",
                         fmt::format("the heights end after {} of {}", next, count));
        return height;
      }
      if (next == count)
        throw badInput(
            path, lines.number(), "",
            fmt::format("'{}' after the last of {} heights; '*' must follow", word, count));
      double value = std::numeric_limits<double>::quiet_NaN();
      if (!sameWord(word, "BAD") && !readDecimal(word, value))
        throw badInput(path, lines.number(), "",
                       fmt::format("'{}' is neither a number nor BAD", word));
      height[next++] = value;
    }
  }
  throw badInput(
      path, 0, "",
      fmt::format("ends within its heights, after {} of {}; the line '*' is missing", next, count));
}

} // namespace

HeightMap parseSdf(const std::string &path, const std::string &bytes, const HeightMapScale &)
{
  const std::string text = plainTextOf(path, bytes);
  LineReader lines(text);
  const SdfHead head = readHead(path, lines);
  const long count = head.points * head.profiles;
  if (count > static_cast<long>(bytes.size() / 2)) // a digit and a blank each
    throw badInput(path, head.sizeLine, "NumPoints, NumProfiles",
                   fmt::format("{} x {} heights do not fit into {} bytes", head.points,
                               head.profiles, bytes.size()));
  HeightMap map{static_cast<int>(head.points), static_cast<int>(head.profiles), head.xScale,
                head.yScale, readHeights(path, lines, count) * head.zScale};
  return head.rowsUpwards ? map : mirrored(map);
}

} // namespace wheelrail
