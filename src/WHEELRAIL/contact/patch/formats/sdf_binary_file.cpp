// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "contact/patch/formats/height_map_formats.h"
#include "contact/patch/formats/map_bytes.h"
#include "contact/patch/formats/map_text.h"

#include <fmt/format.h>
#include <string_view>

namespace wheelrail {

namespace {

/// Places in record 1 of ISO 25178-71, in bytes.
constexpr std::size_t versionLength = 8, pointsAt = 42, profilesAt = 44, scaleAt = 46,
                      compressionAt = 78, heightTypeAt = 79, checkAt = 80, recordEnd = 81;

/// By number, from 0 on; floating-point numbers are IEEE's.
constexpr HeightType heightTypes[] = {heightType<std::uint8_t>,  heightType<std::uint16_t>,
                                      heightType<std::uint32_t>, heightType<float>,
                                      heightType<std::int8_t>,   heightType<std::int16_t>,
                                      heightType<std::int32_t>,  heightType<double>};

} // namespace

HeightMap parseBinarySdf(const std::string &path, const std::string &bytes, const HeightMapScale &)
{
  if (bytes.size() < recordEnd)
    throw badInput(path, 0, "",
                   fmt::format("{} bytes; the head alone has {}", bytes.size(), recordEnd));
  const std::string_view version(bytes.data(), versionLength);
  if (version != "bISO-1.0" && version != "bISO-2.0" && version != "bBCR-1.0")
    throw badInput(path, 1, "",
                   fmt::format("version '{}'; bISO-1.0, bISO-2.0 and bBCR-1.0 are read", version));
  const auto at = [&](std::size_t place) { return fmt::format("byte {}", place); };
  for (const auto &[place, what] :
       {std::pair{compressionAt, "compression"}, {checkAt, "check sum"}})
    if (bytes[place] != 0 && bytes[place] != '0')
      throw badInput(path, 0, at(place), fmt::format("only files without {} (0) are read", what));
  const auto type = static_cast<std::size_t>(static_cast<unsigned char>(bytes[heightTypeAt]));
  if (type >= std::size(heightTypes))
    throw badInput(path, 0, at(heightTypeAt),
                   fmt::format("data type {}; 0 to {} are read", type, std::size(heightTypes) - 1));
  const long nx = littleEndian<std::uint16_t>(bytes.data() + pointsAt);
  const long ny = littleEndian<std::uint16_t>(bytes.data() + profilesAt);
  checkMapSize(path, 0, at(pointsAt), nx, ny);
  double scale[3]; // m, along x, y, z
  for (int k = 0; k < 3; ++k) {
    const std::size_t place = scaleAt + sizeof(double) * k;
    scale[k] = littleEndian<double>(bytes.data() + place);
    if (!(scale[k] > 0.0) || !std::isfinite(scale[k]))
      throw badInput(path, 0, at(place),
                     fmt::format("a scale of {} m is not allowed, must be positive", scale[k]));
  }
  const HeightType &number = heightTypes[type];
  const std::size_t end = recordEnd + number.bytes * static_cast<std::size_t>(nx * ny);
  if (bytes.size() < end) // record 3, free text, may follow
    throw badInput(path, 0, "",
                   fmt::format("{} bytes; {} x {} heights of {} bytes after the head make {}",
                               bytes.size(), nx, ny, number.bytes, end));
  HeightMap map{static_cast<int>(nx), static_cast<int>(ny), scale[0], scale[1],
                Eigen::VectorXd(nx * ny)};
  const char *from = bytes.data() + recordEnd;
  for (long i = 0; i < nx * ny; ++i, from += number.bytes)
    map.height[i] = number.height(from) * scale[2];
  return version == "bBCR-1.0" ? mirrored(map) : map; // as in ASCII
}

} // namespace wheelrail
