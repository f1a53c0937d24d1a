// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/formats/height_map_formats.h"

#include "base/errors.h"
#include "shared/plain_text.h"

#include <algorithm>

namespace wheelrail {

namespace {

bool begins(std::string_view bytes, const HeightMapFormat &format)
{
  return std::any_of(format.beginnings.begin(), format.beginnings.end(),
                     [&](std::string_view head) { return bytes.substr(0, head.size()) == head; });
}

HeightMap refusePackedSur(const std::string &path, const std::string &, const HeightMapScale &)
{
  throw badInput(path, 1, "", "a compressed SUR file; save it without compression");
}

HeightMap refuseGwy(const std::string &path, const std::string &, const HeightMapScale &)
{
  throw badInput(path, 1, "",
                 "Gwyddion's own format; save it as GSF (gwyddion: File, Save As, .gsf)");
}

/// What no other format knows is text, or no map at all.
HeightMap parseText(const std::string &path, const std::string &bytes, const HeightMapScale &scale)
{
  if (const std::string problem = mcawr::plainText(bytes).problem; !problem.empty())
    throw badInput(path, 0, "", problem + " (GSF, SDF, x3p, SUR, npy and text are read)");
  return parseMatrix(path, bytes, scale);
}

} // namespace

const std::vector<HeightMapFormat> &heightMapFormats()
{
  static const std::vector<HeightMapFormat> formats = {
      {"npy", {"\x93NUMPY"}, false, parseNpy},
      {"GSF", {"Gwyddion Simple Field"}, true, parseGsfMap},
      {"SDF", {"aISO-", "aBCR-"}, true, parseSdf},
      {"binary SDF", {"bISO-", "bBCR-"}, true, parseBinarySdf},
      {"x3p", {"PK\x03\x04"}, true, parseX3p},
      {"SUR", {"DIGITAL SURF"}, true, parseSur},
      {"compressed SUR", {"DSCOMPRESSED"}, true, refusePackedSur},
      {"gwy", {"GWYP", "GWYO"}, true, refuseGwy},
      {"text", {""}, true, parseText},
  };
  return formats;
}

const HeightMapFormat &heightMapFormatOf(std::string_view bytes)
{
  const auto &formats = heightMapFormats();
  return *std::find_if(formats.begin(), formats.end(),
                       [&](const HeightMapFormat &format) { return begins(bytes, format); });
}

std::size_t longestBeginning()
{
  std::size_t longest = 0;
  for (const HeightMapFormat &format : heightMapFormats())
    for (const std::string_view head : format.beginnings)
      longest = std::max(longest, head.size());
  return longest;
}

} // namespace wheelrail
