// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_HEIGHT_MAP_FORMATS_H
#define WHEELRAIL_PATCH_HEIGHT_MAP_FORMATS_H

#include "contact/patch/formats/height_map.h"

#include <string>
#include <string_view>
#include <vector>

namespace wheelrail {

/// A format of height maps: how its files are told from others, and who reads them.
struct HeightMapFormat {
  const char *name; ///< as messages say it: "GSF"
  /// A file that begins with one of these is of this format; "" fits every file.
  std::vector<std::string_view> beginnings;
  /// Spacing and unit of height stand in the file; false: the case gives them.
  bool statesLengths;
  /// \param path for messages only
  /// \param bytes of the whole file
  /// \param scale read by formats that do not state their lengths; both are given then
  /// \throws Error (BadInput) with the line of the head or the byte of the data
  HeightMap (*parse)(const std::string &path, const std::string &bytes,
                     const HeightMapScale &scale);
};

/// Gwyddion Simple Field; heights by ZUnits, rows turned so that y runs upwards.
HeightMap parseGsfMap(const std::string &path, const std::string &bytes,
                      const HeightMapScale &scale);
/// ISO 25178-71 SDF in ASCII, "aISO-", and its forerunner "aBCR-1.0".
HeightMap parseSdf(const std::string &path, const std::string &bytes, const HeightMapScale &scale);
/// ISO 25178-71 SDF in binary, "bISO-", and its forerunner "bBCR-1.0".
HeightMap parseBinarySdf(const std::string &path, const std::string &bytes,
                         const HeightMapScale &scale);
/// x3p of ISO 25178-72: a zip file of main.xml and the heights. The MD5 sums that main.xml may hold
/// are not compared, those of the zip file are.
HeightMap parseX3p(const std::string &path, const std::string &bytes, const HeightMapScale &scale);
/// SUR of Digital Surf, not compressed.
HeightMap parseSur(const std::string &path, const std::string &bytes, const HeightMapScale &scale);
/// Text matrix with head lines that begin with '#'; see `readHeightMap`.
HeightMap parseMatrix(const std::string &path, const std::string &bytes,
                      const HeightMapScale &scale);
/// numpy's array.
HeightMap parseNpy(const std::string &path, const std::string &bytes, const HeightMapScale &scale);

/// All of them, in the order in which a file is compared with them.
const std::vector<HeightMapFormat> &heightMapFormats();

/// The format that a file has by what it begins with; its name plays no part.
/// \param bytes of the file, as many as there are or `longestBeginning`
const HeightMapFormat &heightMapFormatOf(std::string_view bytes);

/// Bytes that tell a format.
std::size_t longestBeginning();

} // namespace wheelrail
#endif
