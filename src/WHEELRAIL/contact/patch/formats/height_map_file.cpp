// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/formats/height_map_file.h"

#include "base/errors.h"
#include "base/program_files.h"
#include "base/text_lines.h"
#include "contact/patch/formats/height_map_formats.h"
#include "shared/plain_text.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace wheelrail {

namespace {

constexpr std::uintmax_t mostBytes = 4UL << 30;

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

} // namespace

bool statesLengths(const std::string &path)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    return true;
  std::string head(longestBeginning(), '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return heightMapFormatOf(head).statesLengths;
}

HeightMap readHeightMap(const std::string &path, const HeightMapScale &scale)
{
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored && size > mostBytes)
    throw badInput(path, 0, "", fmt::format("{} bytes; at most {} are allowed", size, mostBytes));
  std::string bytes = readInputFile(path);
  if (mcawr::hasTextMark(bytes)) // it would hide what the text begins with
    bytes = plainTextOf(path, bytes);
  const HeightMapFormat &format = heightMapFormatOf(bytes);
  if (!format.statesLengths &&
      !(scale.spacingX > 0.0 && scale.spacingY > 0.0 && scale.heightUnit > 0.0))
    throw badInput(path, 0, "",
                   fmt::format("an {} file knows no lengths; the case must give the spacing of its "
                               "points and the unit of its heights",
                               format.name));
  HeightMap map = format.parse(path, bytes, scale);
  checkRange(path, map);
  return map;
}

} // namespace wheelrail
