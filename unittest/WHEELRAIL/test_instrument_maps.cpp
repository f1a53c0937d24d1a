// SPDX-License-Identifier: GPL-2.0-or-later
// Height maps as instruments write them: x3p, SUR, binary SDF, Gwyddion's text, lists of points.
#include "base/errors.h"
#include "base/program_files.h"
#include "contact/patch/formats/height_map_formats.h"

#include <archive.h>
#include <archive_entry.h>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace wheelrail;

namespace {

HeightMap mapOf(const std::string &bytes)
{
  return heightMapFormatOf(bytes).parse("map", bytes, {});
}

std::string refusal(const std::string &bytes)
{
  try {
    mapOf(bytes);
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

void expectRefused(const std::string &bytes, const std::vector<std::string> &parts)
{
  const std::string line = refusal(bytes);
  for (const std::string &part : parts)
    EXPECT_NE(line.find(part), std::string::npos) << part << " in: " << line;
}

std::string replaced(std::string text, const std::string &old, const std::string &fresh)
{
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), fresh);
}

/// The least byte first.
template<class Number>
std::string bytesOf(Number value)
{
  std::string bytes(sizeof value, '\0');
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof value); // this test runs on machines of that kind
  for (std::size_t k = 0; k < sizeof value; ++k)
    bytes[k] = static_cast<char>(bits >> 8 * k & 0xff);
  return bytes;
}
template<class Number>
void put(std::string &bytes, std::size_t at, Number value)
{
  bytes.replace(at, sizeof value, bytesOf(value));
}

/// Heights 10 iy + ix, and one that was not measured, [2, 3].
template<class Number>
std::string heights(double unit, Number none)
{
  std::string bytes;
  for (int iy = 0; iy < 4; ++iy)
    for (int ix = 0; ix < 5; ++ix)
      bytes +=
          iy == 2 && ix == 3 ? bytesOf(none) : bytesOf(static_cast<Number>((10 * iy + ix) / unit));
  return bytes;
}

/// 5 x 4 points of 2 x 3 um, heights in um. \param downwards the file's first row is the top one
void expectTheMap(HeightMap map, bool downwards, const std::string &what)
{
  if (downwards)
    map = mirrored(map);
  ASSERT_EQ(map.nx, 5) << what;
  ASSERT_EQ(map.ny, 4) << what;
  EXPECT_NEAR(map.dx, 2e-6, 1e-12) << what; // float32 in SUR
  EXPECT_NEAR(map.dy, 3e-6, 1e-12) << what;
  EXPECT_EQ(map.unmeasured(), 1) << what;
  for (int iy = 0; iy < 4; ++iy)
    for (int ix = 0; ix < 5; ++ix) {
      const double z = map.height[map.index(ix, iy)];
      if (iy == 2 && ix == 3)
        EXPECT_TRUE(std::isnan(z)) << what;
      else
        EXPECT_NEAR(z, (10.0 * iy + ix) * 1e-6, 1e-12) << what;
    }
}

template<class Number>
std::string sdf(const std::string &version, int type, double zScale, Number none)
{
  std::string bytes = version + std::string("ISOTC213  040120220853050320231353");
  bytes += bytesOf(std::uint16_t{5}) + bytesOf(std::uint16_t{4});
  for (const double scale : {2e-6, 3e-6, zScale, 1e-9})
    bytes += bytesOf(scale);
  bytes += '\0';
  bytes += static_cast<char>(type);
  bytes += '\0';
  return bytes + heights<Number>(zScale / 1e-6, none);
}

template<class Number>
std::string sur()
{
  std::string bytes(512, '\0');
  bytes.replace(0, 12, "DIGITAL SURF");
  put(bytes, 18, std::int16_t{2});
  put(bytes, 86, std::int16_t{1}); // special points
  put(bytes, 98, static_cast<std::int16_t>(8 * sizeof(Number)));
  put(bytes, 100, std::int32_t{0}); // smallest height: one that is missing has -2
  put(bytes, 108, std::int32_t{5});
  put(bytes, 112, std::int32_t{4});
  put(bytes, 120, 2.0F);
  put(bytes, 124, 3e-3F);
  put(bytes, 128, 0.5F);
  for (const auto &[at, unit] : {std::pair{180, "\xb5m"}, {196, "mm"}, {212, "\xb5m"}})
    bytes.replace(at, std::strlen(unit), unit);
  put(bytes, 334, std::int16_t{7});
  return bytes + "comment" + heights<Number>(0.5, static_cast<Number>(-2));
}

std::string zipOf(const std::vector<std::pair<std::string, std::string>> &members)
{
  std::string packed(1 << 20, '\0');
  std::size_t used = 0;
  archive *zip = archive_write_new();
  archive_write_set_format_zip(zip);
  archive_write_open_memory(zip, packed.data(), packed.size(), &used);
  for (const auto &[name, content] : members) {
    archive_entry *entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    archive_write_header(zip, entry);
    archive_write_data(zip, content.data(), content.size());
    archive_entry_free(entry);
  }
  archive_write_close(zip);
  archive_write_free(zip);
  packed.resize(used);
  return packed;
}

const std::string mainXml =
    "<?xml version=\"1.0\"?>\n<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n"
    "<Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>\n"
    "<CX><AxisType>I</AxisType><DataType>D</DataType><Increment>2e-6</Increment></CX>\n"
    "<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>3e-6</Increment></CY>\n"
    "<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ></Axes></Record1>\n"
    "<Record3><MatrixDimension><SizeX>5</SizeX><SizeY>4</SizeY><SizeZ>1</SizeZ>"
    "</MatrixDimension>\n<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>"
    "</Record3></p:ISO5436_2>\n";

std::string x3p(const std::string &xml, const std::string &data)
{
  return zipOf({{"main.xml", xml}, {"md5checksum.hex", "0 *main.xml"}, {"bindata/data.bin", data}});
}

const std::string gwyddion = "# Channel: Topography\n# Width: 10.00 \xc2\xb5m\n"
                             "# Height: 12.00 \xc2\xb5m\n# Value units: m\n"
                             "0\t1e-6\t2e-6\t3e-6\t4e-6\n1e-5\t1.1e-5\t1.2e-5\t1.3e-5\t1.4e-5\n"
                             "2e-5\t2.1e-5\t2.2e-5\tnan\t2.4e-5\n"
                             "3e-5\t3.1e-5\t3.2e-5\t3.3e-5\t3.4e-5\n";

std::string pointsText()
{
  std::string text = "# height: um\n# position: mm\n";
  for (int ix = 4; ix >= 0; --ix) // columns first, from the last
    for (int iy = 0; iy < 4; ++iy)
      if (!(iy == 2 && ix == 3))
        text += fmt::format("{:.6f} {:.6f} {}\n", 1.0 + 2e-3 * ix, 3e-3 * iy - 7.0, 10 * iy + ix);
  return text;
}

} // namespace

TEST(InstrumentMaps, AreTheSameMap)
{
  const double nan = std::nan("");
  expectTheMap(mapOf(sdf<double>("bISO-1.0", 7, 1e-6, nan)), false, "double");
  expectTheMap(mapOf(sdf<double>("bISO-1.0", 7, 1e-6, 1.7976931348623157e308)), false, "largest");
  expectTheMap(mapOf(sdf<float>("bISO-2.0", 3, 1e-6, std::nanf(""))), false, "float");
  expectTheMap(mapOf(sdf<std::int16_t>("bISO-1.0", 5, 0.5e-6, -32768)), false, "16 bits");
  expectTheMap(mapOf(sdf<std::int32_t>("bBCR-1.0", 6, 1e-6, INT32_MIN)), true, "bBCR");
  expectTheMap(mapOf(sur<std::int16_t>()), true, "SUR 16");
  expectTheMap(mapOf(sur<std::int32_t>()), true, "SUR 32");
  expectTheMap(mapOf(x3p(mainXml, heights<double>(1e6, nan))), false, "x3p");
  const std::string whole = replaced(mainXml, "<AxisType>A</AxisType><DataType>D</DataType>",
                                     "<AxisType>A</AxisType><DataType>L</DataType>\n"
                                     "<Increment>5e-7</Increment>");
  expectTheMap(mapOf(x3p(whole, heights<std::int32_t>(0.5, INT32_MIN))), false, "x3p, integers");
  expectTheMap(mapOf(gwyddion), true, "Gwyddion's text");
  expectTheMap(mapOf(pointsText()), false, "points");
}

// Written by another program, after the formats' descriptions.
TEST(InstrumentMaps, FilesOfAnotherWriter)
{
  const auto read = [](const char *name) {
    return mapOf(readInputFile(std::string(TEST_DATA) + "/maps/" + name));
  };
  expectTheMap(read("deflated.x3p"), false, "x3p");
  expectTheMap(read("points.sur"), false, "SUR, turned by the reader");
  expectTheMap(read("points.sdf"), false, "SDF");
}

TEST(InstrumentMaps, X3pMayListTheValidPoints)
{
  const std::string xml =
      replaced(mainXml, "</PointDataLink>",
               "</PointDataLink><ValidPointsLink>bindata/valid.bin</ValidPointsLink>");
  std::string valid(3, '\xff');
  valid[1] = static_cast<char>(0xff ^ 1 << 5); // point 13
  const std::string data = heights<double>(1e6, 0.0);
  expectTheMap(
      mapOf(zipOf({{"bindata/data.bin", data}, {"bindata/valid.bin", valid}, {"main.xml", xml}})),
      false, "valid.bin");
  expectRefused(x3p(xml, data), {"ValidPointsLink", "valid.bin"});
}

TEST(InstrumentMaps, FaultsOfX3p)
{
  const std::string data = heights<double>(1e6, 0.0);
  const auto with = [&](const char *old, const char *fresh) {
    return x3p(replaced(mainXml, old, fresh), data);
  };
  expectRefused(zipOf({{"a.txt", "no"}}), {"main.xml", "no x3p"});
  expectRefused(with("<SizeX>5", "<SizeX>6"), {"data.bin", "160 bytes", "192"});
  expectRefused(with("<SizeX>5", "<SizeX>five"), {"SizeX", "'five'"});
  expectRefused(with("<SizeX>5", "<SizeX>999999999"), {"points in all"});
  expectRefused(with("<SizeZ>1", "<SizeZ>2"), {"SizeZ", "2 layers"});
  expectRefused(with("<Increment>2e-6", "<Increment>-2e-6"), {"CX Increment", "positive"});
  expectRefused(with("<DataType>D</DataType></CZ>", "<DataType>X</DataType></CZ>"),
                {"DataType", "'X'"});
  expectRefused(with("<CY><AxisType>I", "<CY><AxisType>A"), {"CY AxisType"});
  expectRefused(with("bindata/data.bin", "bindata/other.bin"), {"PointDataLink", "other.bin"});
  expectRefused(with("<SizeY>4</SizeY>", ""), {"SizeY", "missing"});
  const std::string good = x3p(mainXml, data);
  EXPECT_EQ(refusal(good), "");
  for (std::size_t k = 4; k < good.size() / 2; k += 7)
    EXPECT_NE(refusal(good.substr(0, k)), "") << k;
}

TEST(InstrumentMaps, FaultsOfBinaryFiles)
{
  const std::string good = sdf<double>("bISO-1.0", 7, 1e-6, 0.0), surface = sur<std::int32_t>();
  for (const std::string &whole : {good, surface}) {
    EXPECT_EQ(refusal(whole), "");
    for (std::size_t k = 12; k < whole.size(); ++k)
      EXPECT_NE(refusal(whole.substr(0, k)), "") << k;
  }
  const auto with = [](std::string bytes, std::size_t at, const std::string &fresh) {
    return bytes.replace(at, fresh.size(), fresh);
  };
  expectRefused(with(good, 6, "9"), {"version", "bISO-1.0"});
  expectRefused(with(good, 78, "\1"), {"byte 78", "compression"});
  expectRefused(with(good, 79, "\x9"), {"byte 79", "data type 9"});
  expectRefused(with(good, 80, "\1"), {"byte 80", "check sum"});
  expectRefused(with(good, 46, bytesOf(-1.0)), {"byte 46", "positive"});
  expectRefused(with(surface, 18, bytesOf(std::int16_t{1})), {"byte 18", "type 1"});
  expectRefused(with(surface, 98, bytesOf(std::int16_t{8})), {"byte 98", "8 bits"});
  expectRefused(with(surface, 180, "K "), {"byte 180", "'1 K'"});
  expectRefused(with(surface, 334, bytesOf(std::int16_t{-7})), {"byte 334"});
  expectRefused("DSCOMPRESSED" + std::string(600, '\0'), {"compressed SUR"});
  expectRefused("GWYP" + std::string(600, '\0'), {"GSF"});
}

TEST(InstrumentMaps, FaultsOfText)
{
  expectRefused(replaced(gwyddion, "# Value units: m\n", ""), {"height"});
  expectRefused(replaced(gwyddion, "# Width: 10.00 \xc2\xb5m\n", ""), {"spacing"});
  expectRefused(replaced(gwyddion, "10.00", "10.00 10"), {"Width"});
  const std::string points = pointsText();
  expectRefused(replaced(points, "1.008000 -7.000000 4", "1.0085 -7.000000 4"),
                {"not on a raster", "interpolate"});
  expectRefused(points + "1.000000 -7.000000 0\n", {"two points"});
  expectRefused("# height: um\n# position: mm\n1 2 3 4\n", {"4 columns"});
  expectRefused("# height: um\n# position: mm\n1 2 3\n1 3 3\n", {"one value"});
  expectRefused(replaced(points, "1.008000 -7.000000 4", "nan -7.000000 4"), {"no place"});
}
