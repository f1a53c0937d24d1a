// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/formats/height_map_file.h"

#include "base/errors.h"
#include "base/program_files.h"
#include "base/quantity.h"
#include "contact/patch/formats/height_map_formats.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <stdexcept>

namespace wheelrail {

namespace {

constexpr std::uintmax_t mostBytes = 4UL << 30;

bool beginsWith(const std::string &bytes, std::string_view head)
{
  return std::string_view(bytes).substr(0, head.size()) == head;
}

} // namespace

bool LineReader::next(std::string_view &line)
{
  if (rest_.empty())
    return false;
  const auto end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
  if (!line.empty() && line.back() == '\r')
    line.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view trimmedView(std::string_view text)
{
  constexpr const char *blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool readDecimal(std::string_view text, double &value)
{
  if (text.size() > 1 && text.front() == '+' && text[1] != '-')
    text.remove_prefix(1);
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

long wholeNumber(const std::string &path, int line, const std::string &keyword,
                 const std::string &text)
{
  long value = -1;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || value < 0)
    throw badInput(path, line, keyword, fmt::format("'{}' is not a whole number >= 0", text));
  return value;
}

double positiveLength(const std::string &path, int line, const std::string &keyword,
                      const std::string &text)
{
  double value = 0.0;
  try {
    value = parseQuantity(text, "m");
  } catch (const std::invalid_argument &problem) {
    throw badInput(path, line, keyword, problem.what());
  }
  if (!(value > 0.0))
    throw badInput(path, line, keyword, fmt::format("'{}' must be positive", text));
  return value;
}

void checkMapSize(const std::string &path, int line, const std::string &keyword, long nx, long ny)
{
  if (nx < fewestMapPoints || ny < fewestMapPoints || nx > mostMapPoints || ny > mostMapPoints ||
      nx * ny > mostMapPoints)
    throw badInput(path, line, keyword,
                   fmt::format("{} x {} points; allowed are {} x {} to {} points in all", nx, ny,
                               fewestMapPoints, fewestMapPoints, mostMapPoints));
}

namespace {

/// Whatever the format: lengths beyond any surface would overflow in its statistics.
void checkRange(const std::string &path, const HeightMap &map)
{
  constexpr double smallestSpacing = 1e-12, largest = 1e3; // m
  for (const double spacing : {map.dx, map.dy})
    if (!(spacing >= smallestSpacing && spacing <= largest))
      throw badInput(path, 0, "spacing",
                     fmt::format("{} m is not in the allowed range [{}, {}] m", spacing,
                                 smallestSpacing, largest));
  for (const double height : map.height)
    if (std::abs(height) > largest) // nan: not measured
      throw badInput(path, 0, "height",
                     fmt::format("{} m is not allowed, must be within +-{} m", height, largest));
}

HeightMap parsedMap(const std::string &path, const HeightMapScale &scale)
{
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored && size > mostBytes)
    throw badInput(path, 0, "", fmt::format("{} bytes; at most {} are allowed", size, mostBytes));
  const std::string bytes = readInputFile(path);
  if (beginsWith(bytes, "\x93NUMPY"))
    return parseNpy(path, bytes, scale);
  if (scale.spacingX != 0.0 || scale.spacingY != 0.0 || scale.heightUnit != 0.0)
    throw badInput(path, 0, "",
                   "states its own spacing and unit; only an npy file takes them from the case");
  if (beginsWith(bytes, "Gwyddion Simple Field"))
    return parseGsfMap(path, bytes);
  if (beginsWith(bytes, "aISO-") || beginsWith(bytes, "aBCR-"))
    return parseSdf(path, bytes);
  if (beginsWith(bytes, "bISO-") || beginsWith(bytes, "bBCR-"))
    throw badInput(path, 1, "", "a binary SDF file; only those in ASCII (aISO-1.0) are read");
  if (bytes.find('\0') != std::string::npos)
    throw badInput(path, 0, fmt::format("byte {}", bytes.find('\0')),
                   "a binary file of unknown kind; GSF, SDF (ASCII), npy and text are read");
  return parseMatrix(path, bytes);
}

} // namespace

HeightMap readHeightMap(const std::string &path, const HeightMapScale &scale)
{
  HeightMap map = parsedMap(path, scale);
  checkRange(path, map);
  return map;
}

} // namespace wheelrail
