// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/text_lines.h"
#include "contact/patch/formats/height_map_formats.h"
#include "contact/patch/formats/map_bytes.h"
#include "contact/patch/formats/map_text.h"

#include <fmt/format.h>

namespace wheelrail {

namespace {

/// Places in the head of 512 bytes.
constexpr std::size_t typeAt = 18, specialAt = 86, bitsAt = 98, smallestAt = 100, columnsAt = 108,
                      rowsAt = 112, spacingAt = 120, unitAt = 180, commentAt = 334, privateAt = 336,
                      headEnd = 512, unitLength = 16;
constexpr int surfaceType = 2;
constexpr int belowSmallest = 2; ///< a point that was not measured is the smallest height less 2

class SurHead {
 public:
  SurHead(const std::string &path, const std::string &bytes) : path_(path), bytes_(bytes)
  {
    if (bytes.size() < headEnd)
      throw badInput(path, 0, "",
                     fmt::format("{} bytes; the head alone has {}", bytes.size(), headEnd));
  }
  template<class Number>
  Number at(std::size_t place) const
  {
    return littleEndian<Number>(bytes_.data() + place);
  }
  /// Spacing of axis 0, 1, 2 (x, y, z) in m.
  double spacing(int axis) const
  {
    const std::size_t from = unitAt + unitLength * axis;
    std::string_view unit(bytes_.data() + from, unitLength);
    unit = trimmedView(unit.substr(0, unit.find('\0')));
    const double length = positiveLength(path_, 0, fmt::format("byte {}", from),
                                         "1 " + plainTextOf(path_, unit)); // "\xb5m" in Latin-1
    const double value = at<float>(spacingAt + sizeof(float) * axis);
    if (!(value > 0.0) || !std::isfinite(value))
      throw badInput(path_, 0, fmt::format("byte {}", spacingAt + sizeof(float) * axis),
                     fmt::format("a spacing of {} is not allowed, must be positive", value));
    return value * length;
  }

 private:
  const std::string &path_;
  const std::string &bytes_;
};

} // namespace

// The head's layout is that of Digital Surf's description of its format 1 ("The Surface Data File
// Format"); numbers are little endian.
HeightMap parseSur(const std::string &path, const std::string &bytes, const HeightMapScale &)
{
  const SurHead head(path, bytes);
  if (const int type = head.at<std::int16_t>(typeAt); type != surfaceType)
    throw badInput(path, 0, fmt::format("byte {}", typeAt),
                   fmt::format("a study of type {}; {}, a surface, is read", type, surfaceType));
  const int bits = head.at<std::int16_t>(bitsAt);
  if (bits != 16 && bits != 32)
    throw badInput(path, 0, fmt::format("byte {}", bitsAt),
                   fmt::format("{} bits a height; 16 and 32 are read", bits));
  const long nx = head.at<std::int32_t>(columnsAt), ny = head.at<std::int32_t>(rowsAt);
  checkMapSize(path, 0, fmt::format("byte {}", columnsAt), nx, ny);
  const int comment = head.at<std::int16_t>(commentAt), own = head.at<std::int16_t>(privateAt);
  if (comment < 0 || own < 0)
    throw badInput(path, 0, fmt::format("byte {}", commentAt), "a length below 0");
  const std::size_t data = headEnd + comment + own, width = bits / 8;
  const std::size_t expected = data + width * static_cast<std::size_t>(nx * ny);
  if (bytes.size() != expected)
    throw badInput(path, 0, "",
                   fmt::format("{} bytes; {} x {} heights of {} bytes after the head make {}",
                               bytes.size(), nx, ny, width, expected));
  HeightMap map{static_cast<int>(nx), static_cast<int>(ny), head.spacing(0), head.spacing(1),
                Eigen::VectorXd(nx * ny)};
  const double unit = head.spacing(2);
  const bool special = head.at<std::int16_t>(specialAt) != 0;
  const double none = double(head.at<std::int32_t>(smallestAt)) - belowSmallest;
  const char *from = bytes.data() + data;
  for (long i = 0; i < nx * ny; ++i, from += width) {
    const double value = bits == 16 ? double(littleEndian<std::int16_t>(from))
                                    : double(littleEndian<std::int32_t>(from));
    map.height[i] =
        special && value == none ? std::numeric_limits<double>::quiet_NaN() : value * unit;
  }
  return mirrored(map); // its first row is the top one
}

} // namespace wheelrail
