// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/formats/gsf_file.h"

#include "base/errors.h"
#include "base/text_lines.h"
#include "contact/patch/formats/height_map_formats.h"
#include "contact/patch/formats/map_text.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <map>

namespace wheelrail {

namespace {

constexpr std::string_view magic = "Gwyddion Simple Field 1.0\n";

// Entries of the head, in the order in which they are written.
constexpr const char *columnsName = "XRes", *rowsName = "YRes";
constexpr const char *xyUnitName = "XYUnits", *zUnitName = "ZUnits";

struct NumberEntry {
  const char *name;
  double SimpleField::*value;
  double standard; ///< the format's own, where the entry is missing
  bool isLength;   ///< > 0, and asked for in a map of heights, since it must not be guessed
};
constexpr NumberEntry numberEntries[] = {
    {"XReal", &SimpleField::width, 1.0, true},
    {"YReal", &SimpleField::height, 1.0, true},
    {"XOffset", &SimpleField::xOffset, 0.0, false},
    {"YOffset", &SimpleField::yOffset, 0.0, false},
};

struct TextEntry {
  const char *name;
  std::string SimpleField::*value; ///< empty: the entry is missing
};
constexpr TextEntry textEntries[] = {
    {xyUnitName, &SimpleField::xyUnit},
    {zUnitName, &SimpleField::zUnit},
    {"Title", &SimpleField::title},
};

struct Entry {
  std::string value;
  int line = 0;
};
using Head = std::map<std::string, Entry>;

/// "name = value" lines after the magic one.
Head parseHead(const std::string &path, std::string_view text)
{
  LineReader lines(text);
  Head head;
  std::string_view line;
  lines.next(line); // the magic line
  while (lines.next(line)) {
    if (trimmedView(line).empty())
      continue;
    const auto sign = line.find('=');
    const std::string name(trimmedView(line.substr(0, sign)));
    if (sign == std::string_view::npos || name.empty())
      throw badInput(path, lines.number(), "", "a line of the head must be 'name = value'");
    const Entry entry{std::string(trimmedView(line.substr(sign + 1))), lines.number()};
    if (!head.emplace(name, entry).second)
      throw badInput(path, lines.number(), name, "appears twice in the head");
  }
  return head;
}

const Entry &needed(const std::string &path, const Head &head, const std::string &name)
{
  const auto found = head.find(name);
  if (found == head.end())
    throw badInput(path, 0, name, "is missing in the head");
  return found->second;
}

std::string textOf(const Head &head, const std::string &name)
{
  const auto found = head.find(name);
  return found == head.end() ? std::string() : found->second.value;
}

double numberOf(const std::string &path, const Head &head, const NumberEntry &entry)
{
  const auto found = head.find(entry.name);
  if (found == head.end())
    return entry.standard;
  double value = 0.0;
  if (!readDecimal(found->second.value, value) || (entry.isLength && !(value > 0.0)))
    throw badInput(path, found->second.line, entry.name,
                   fmt::format("'{}' is not a {}number", found->second.value,
                               entry.isLength ? "positive " : ""));
  return value;
}

float littleEndianFloat(const char *bytes)
{
  std::uint32_t bits = 0;
  for (int k = 3; k >= 0; --k)
    bits = bits << 8 | static_cast<unsigned char>(bytes[k]);
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void appendLittleEndian(std::string &bytes, float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  for (int k = 0; k < 4; ++k)
    bytes += static_cast<char>(bits >> 8 * k & 0xff);
}

} // namespace

std::string gsfBytes(const SimpleField &field)
{
  std::string bytes(magic);
  bytes += fmt::format("{} = {}\n{} = {}\n", columnsName, field.nx, rowsName, field.ny);
  for (const NumberEntry &entry : numberEntries)
    bytes += fmt::format("{} = {:.17g}\n", entry.name, field.*entry.value);
  for (const TextEntry &entry : textEntries)
    if (const std::string &text = field.*entry.value; !text.empty())
      bytes += fmt::format("{} = {}\n", entry.name, text);
  for (const auto &[name, value] : field.notes)
    bytes += fmt::format("{} = {}\n", name, value);
  // One to four NUL bytes: the head ends with at least one, the data begin at a multiple of four.
  bytes.append(4 - bytes.size() % 4, '\0');
  bytes.reserve(bytes.size() + 4 * static_cast<std::size_t>(field.value.size()));
  for (int iy = field.ny - 1; iy >= 0; --iy)
    for (int ix = 0; ix < field.nx; ++ix)
      appendLittleEndian(bytes, static_cast<float>(field.value[ix + field.nx * iy]));
  return bytes;
}

SimpleField parseGsf(const std::string &path, const std::string &bytes)
{
  if (bytes.compare(0, magic.size(), magic) != 0)
    throw badInput(path, 1, "", "must be 'Gwyddion Simple Field 1.0'");
  const auto end = bytes.find('\0');
  if (end == std::string::npos)
    throw badInput(path, 0, "", "no NUL byte after the head");
  const Head head = parseHead(path, std::string_view(bytes).substr(0, end));
  SimpleField field;
  const Entry &columns = needed(path, head, columnsName), &rows = needed(path, head, rowsName);
  const long nx = wholeNumber(path, columns.line, columnsName, columns.value);
  const long ny = wholeNumber(path, rows.line, rowsName, rows.value);
  if (nx < 1 || ny < 1 || nx > mostMapPoints || ny > mostMapPoints || nx * ny > mostMapPoints)
    throw badInput(path, columns.line, columnsName,
                   fmt::format("{} x {} values; 1 to {} are allowed", nx, ny, mostMapPoints));

  const std::size_t data = (end / 4 + 1) * 4; // one to four NUL bytes
  for (std::size_t k = end; k < std::min(data, bytes.size()); ++k)
    if (bytes[k] != '\0')
      throw badInput(path, 0, fmt::format("byte {}", k),
                     fmt::format("must be NUL: the data begin at byte {}", data));
  const std::size_t expected = data + 4 * static_cast<std::size_t>(nx * ny);
  if (bytes.size() != expected)
    throw badInput(path, 0, "",
                   fmt::format("{} bytes; {} x {} values after the head make {}", bytes.size(), nx,
                               ny, expected));

  field.nx = static_cast<int>(nx);
  field.ny = static_cast<int>(ny);
  for (const NumberEntry &entry : numberEntries)
    field.*entry.value = numberOf(path, head, entry);
  for (const TextEntry &entry : textEntries)
    field.*entry.value = textOf(head, entry.name);
  field.value.resize(nx * ny);
  const char *next = bytes.data() + data;
  for (long iy = ny - 1; iy >= 0; --iy)
    for (long ix = 0; ix < nx; ++ix, next += 4)
      field.value[ix + nx * iy] = littleEndianFloat(next);
  return field;
}

HeightMap parseGsfMap(const std::string &path, const std::string &bytes, const HeightMapScale &)
{
  const SimpleField field = parseGsf(path, bytes);
  checkMapSize(path, 0, fmt::format("{}, {}", columnsName, rowsName), field.nx, field.ny);
  const Head head = parseHead(path, std::string_view(bytes).substr(0, bytes.find('\0')));
  for (const NumberEntry &entry : numberEntries)
    if (entry.isLength)
      needed(path, head, entry.name);
  const auto unitOf = [&](const char *name) {
    const Entry &entry = needed(path, head, name);
    return positiveLength(path, entry.line, name, "1 " + entry.value);
  };
  const double length = unitOf(xyUnitName), heightUnit = unitOf(zUnitName);
  HeightMap map{field.nx, field.ny, field.width * length / field.nx,
                field.height * length / field.ny, field.value * heightUnit};
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      if (std::isinf(map.height[map.index(ix, iy)]))
        throw badInput(path, 0, "",
                       fmt::format("row {}, column {}: infinite", map.ny - 1 - iy, ix));
  return map;
}

} // namespace wheelrail
