// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_HEIGHT_MAP_FORMATS_H
#define WHEELRAIL_PATCH_HEIGHT_MAP_FORMATS_H

#include "contact/patch/height_map_file.h"

#include <string>
#include <string_view>

namespace wheelrail {

/// The formats behind readHeightMap, each from the bytes of a whole file (`path` for messages).

HeightMap parseGsfMap(const std::string &path, const std::string &bytes);
HeightMap parseSdf(const std::string &path, const std::string &bytes);
HeightMap parseMatrix(const std::string &path, const std::string &bytes);
HeightMap parseNpy(const std::string &path, const std::string &bytes, const HeightMapScale &scale);

/// What the readers share.

/// Fewest points along each side, most points of a map.
constexpr long fewestMapPoints = 4;
constexpr long mostMapPoints = 1L << 27;

/// @throws Error (BadInput) unless fewestMapPoints x fewestMapPoints .. mostMapPoints
void checkMapSize(const std::string &path, int line, const std::string &keyword, long nx, long ny);

/// A whole number >= 0 that a head states. @throws Error (BadInput)
long wholeNumber(const std::string &path, int line, const std::string &keyword,
                 const std::string &text);

/// A positive length with its unit, in m. @throws Error (BadInput)
double positiveLength(const std::string &path, int line, const std::string &keyword,
                      const std::string &text);

/// A decimal number that fills the whole text; finite. @return whether it is one
bool readDecimal(std::string_view text, double &value);

std::string_view trimmedView(std::string_view text);

/// Lines of a text, without their ends ("\n" or "\r\n"), counted from 1.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  /// @return false at the end
  bool next(std::string_view &line);
  int number() const { return number_; } ///< of the line last given

 private:
  std::string_view rest_;
  int number_ = 0;
};

} // namespace wheelrail
#endif
