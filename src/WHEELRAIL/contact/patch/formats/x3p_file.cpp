// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/archive_reader.h"
#include "base/errors.h"
#include "base/text_lines.h"
#include "contact/patch/formats/height_map_formats.h"
#include "contact/patch/formats/map_bytes.h"
#include "contact/patch/formats/map_text.h"

#include <archive_entry.h>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace wheelrail {

namespace {

constexpr std::size_t most = std::size_t(1) << 30; ///< bytes of all members that are read

/// The members of a zip file by name, those of the data and main.xml only: others are not unpacked.
std::map<std::string, std::string> membersOf(const std::string &path, const std::string &bytes)
{
  ArchiveReader reader(path, bytes, ArchiveReader::Kind::Zip);
  std::map<std::string, std::string> members;
  std::size_t left = most;
  while (archive_entry *entry = reader.next()) {
    const char *given = archive_entry_pathname(entry);
    const std::string name = given ? given : "";
    if (name != "main.xml" && name.find(".bin") == std::string::npos)
      continue;
    std::string &content = members[name];
    const std::size_t before = content.size();
    if (!reader.append(content, before + left))
      throw badInput(path, 0, name, fmt::format("unpacks to more than {} bytes", most));
    left -= content.size() - before;
  }
  return members;
}

/// What stands between <tag> and </tag>, the first time after another tag; blank where neither is.
/// The standard's schema has no attributes there, and no tag of one name within another.
class Xml {
 public:
  Xml(const std::string &path, std::string_view text) : path_(path), text_(text) {}

  /// An element of this name, with or without the prefix of a name space.
  std::string_view inside(std::string_view within, const std::string &tag) const
  {
    for (auto at = within.find(tag + ">"); at != std::string_view::npos;
         at = within.find(tag + ">", at + 1)) {
      if (at == 0 || (within[at - 1] != '<' && within[at - 1] != ':'))
        continue;
      const std::string_view rest = within.substr(at + tag.size() + 1);
      for (const char *mark : {"</", ":"})
        if (const auto end = rest.find(mark + tag + ">"); end != std::string_view::npos)
          return rest.substr(0, rest.rfind('<', end));
      break;
    }
    return {};
  }
  /// Text of the element that the path of tags leads to. \throws Error (BadInput)
  std::string needed(const std::vector<const char *> &tags) const
  {
    std::string text = given(tags);
    if (text.empty())
      throw badInput(path_, 0, std::string("main.xml, ") + tags.back(), "is missing");
    return text;
  }
  std::string given(const std::vector<const char *> &tags) const
  {
    std::string_view part = text_;
    for (const char *tag : tags)
      part = inside(part, tag);
    return std::string(trimmedView(part));
  }
  double positive(const std::vector<const char *> &tags) const
  {
    const std::string text = needed(tags);
    double value = 0.0;
    if (!readDecimal(text, value) || !(value > 0.0))
      throw badInput(path_, 0, fmt::format("main.xml, {} {}", tags[tags.size() - 2], tags.back()),
                     fmt::format("'{}' must be a positive number of metres", text));
    return value;
  }

 private:
  const std::string &path_;
  std::string_view text_;
};

HeightType typeOf(const std::string &path, const std::string &word)
{
  const std::pair<const char *, HeightType> types[] = {{"I", heightType<std::int16_t>},
                                                       {"L", heightType<std::int32_t>},
                                                       {"F", heightType<float>},
                                                       {"D", heightType<double>}};
  for (const auto &[name, type] : types)
    if (word == name)
      return type;
  throw badInput(path, 0, "main.xml, CZ DataType",
                 fmt::format("'{}'; I, L, F and D are read", word));
}

} // namespace

HeightMap parseX3p(const std::string &path, const std::string &bytes, const HeightMapScale &)
{
  const std::map<std::string, std::string> members = membersOf(path, bytes);
  const auto main = members.find("main.xml");
  if (main == members.end())
    throw badInput(path, 0, "", "a zip file without main.xml is no x3p file");
  const Xml xml(path, main->second);
  const long nx = wholeNumber(path, 0, "main.xml, SizeX", xml.needed({"MatrixDimension", "SizeX"}));
  const long ny = wholeNumber(path, 0, "main.xml, SizeY", xml.needed({"MatrixDimension", "SizeY"}));
  checkMapSize(path, 0, "main.xml, SizeX, SizeY", nx, ny);
  if (const std::string layers = xml.given({"MatrixDimension", "SizeZ"});
      !layers.empty() && layers != "1")
    throw badInput(path, 0, "main.xml, SizeZ", fmt::format("{} layers; 1 is read", layers));
  for (const char *axis : {"CX", "CY"})
    if (const std::string type = xml.needed({axis, "AxisType"}); type != "I")
      throw badInput(path, 0, fmt::format("main.xml, {} AxisType", axis),
                     fmt::format("'{}'; I, points at equal distances, is read", type));
  const HeightType number = typeOf(path, xml.needed({"CZ", "DataType"}));
  const double unit =
      xml.given({"CZ", "Increment"}).empty() ? 1.0 : xml.positive({"CZ", "Increment"});
  const std::string link = xml.needed({"DataLink", "PointDataLink"});
  const auto data = members.find(link);
  if (data == members.end())
    throw badInput(path, 0, "main.xml, PointDataLink",
                   fmt::format("'{}' is not in the zip file", link));
  const std::size_t expected = number.bytes * static_cast<std::size_t>(nx * ny);
  if (data->second.size() != expected)
    throw badInput(path, 0, link,
                   fmt::format("{} bytes; {} x {} heights of {} bytes make {}", data->second.size(),
                               nx, ny, number.bytes, expected));
  HeightMap map{static_cast<int>(nx), static_cast<int>(ny), xml.positive({"CX", "Increment"}),
                xml.positive({"CY", "Increment"}), Eigen::VectorXd(nx * ny)};
  const char *from = data->second.data();
  for (long i = 0; i < nx * ny; ++i, from += number.bytes)
    map.height[i] = number.height(from) * unit;
  // points that were not measured may stand in a file of bits, the least one of a byte first
  if (const std::string valid = xml.given({"DataLink", "ValidPointsLink"}); !valid.empty()) {
    const auto bits = members.find(valid);
    if (bits == members.end() || bits->second.size() < static_cast<std::size_t>(nx * ny + 7) / 8)
      throw badInput(path, 0, "main.xml, ValidPointsLink",
                     fmt::format("'{}' does not have a bit for each point", valid));
    for (long i = 0; i < nx * ny; ++i)
      if (!(static_cast<unsigned char>(bits->second[i / 8]) >> i % 8 & 1))
        map.height[i] = std::numeric_limits<double>::quiet_NaN();
  }
  return map; // y runs upwards, as the standard's axes do
}

} // namespace wheelrail
