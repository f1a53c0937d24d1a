// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/program_files.h"
#include "contact/patch/formats/gsf_file.h"
#include "contact/patch/formats/height_map_formats.h"
#include "contact/patch/surfaces/height_map_preparation.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <unistd.h>

using namespace wheelrail;

namespace {

const std::string maps = TEST_DATA "/maps/";
const HeightMapScale micrometres{2e-6, 3e-6, 1e-6};

/// A file of its own that goes with the object.
class MapFile {
 public:
  explicit MapFile(const std::string &bytes)
      : path((std::filesystem::temp_directory_path() / fmt::format("wr-map-{}.dat", ::getpid()))
                 .string())
  {
    std::ofstream(path, std::ios::binary) << bytes; // without a sync: there are thousands
  }
  ~MapFile() { std::filesystem::remove(path); }
  std::string path;
};

HeightMap mapOfBytes(const std::string &bytes, const HeightMapScale &scale = {})
{
  return readHeightMap(MapFile(bytes).path, scale);
}

/// The one line that a file is refused with; "" if it is read.
std::string refusal(const std::string &bytes, const HeightMapScale &scale = {})
{
  try {
    mapOfBytes(bytes, scale);
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

void expectRefused(const std::string &bytes, const std::vector<std::string> &parts,
                   const HeightMapScale &scale = {})
{
  const std::string line = refusal(bytes, scale);
  for (const auto &part : parts)
    EXPECT_NE(line.find(part), std::string::npos) << part << " in: " << line;
}

std::string replaced(std::string text, const std::string &old, const std::string &fresh)
{
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), fresh);
}

/// A GSF file with another head, filled up to four bytes again.
std::string withHead(const std::string &gsf, const std::string &old, const std::string &fresh)
{
  const auto end = gsf.find('\0');
  std::string head = replaced(gsf.substr(0, end), old, fresh);
  head.append(4 - head.size() % 4, '\0');
  return head + gsf.substr((end / 4 + 1) * 4);
}

/// 10 iy + ix in micrometres, [2, 3] not measured, as in the files that NumPy wrote.
void expectTheMap(const HeightMap &map, const std::string &what)
{
  ASSERT_EQ(map.nx, 5) << what;
  ASSERT_EQ(map.ny, 4) << what;
  EXPECT_EQ(map.unmeasured(), 1) << what;
  for (int iy = 0; iy < 4; ++iy)
    for (int ix = 0; ix < 5; ++ix) {
      const double z = map.height[map.index(ix, iy)];
      if (iy == 2 && ix == 3)
        EXPECT_TRUE(std::isnan(z)) << what;
      else
        EXPECT_NEAR(z, (10.0 * iy + ix) * 1e-6, 1e-20) << what;
    }
}

SimpleField theField()
{
  SimpleField field;
  field.nx = 5;
  field.ny = 4;
  field.width = 10e-6;
  field.height = 12e-6;
  field.xyUnit = field.zUnit = "m";
  field.title = "test";
  field.value.resize(20);
  for (int k = 0; k < 20; ++k)
    field.value[k] = (10.0 * (k / 5) + k % 5) * 1e-6;
  field.value[13] = std::numeric_limits<double>::quiet_NaN();
  return field;
}

/// After the example in ISO 25178-71: profiles upwards.
const std::string sdf = "aISO-1.0\r\nManufacID = ISOTC213\r\nCreateDate = 040120220853\r\n"
                        "ModDate = 050320231353\r\nNumPoints = 5\r\nNumProfiles = 4\r\n"
                        "Xscale = 2.00000000000000e-006\r\nYscale = 3.0e-006\r\n"
                        "Zscale = 1.0e-006\r\nZresolution = 1.0e-009\r\nCompression = 0\r\n"
                        "DataType = 7\r\nCheckType = 0\r\n*\r\n"
                        " 0.0 1.0 2.0 3.0 4.0\r\n1e1 11 12 13 14\r\n20 21 22 BAD\r\n 24 +30 31\r\n"
                        "32 33 34 ; the last ones\r\n*\r\nOperator = nobody\r\n*\r\n";

const std::string matrix = "# measured on a rail\n# height: um\n# spacing: 2 um, 3 um\n"
                           "# points: 5, 4\n0;1;2;3;4\n10; 11; 12; 13; 14\n20 ;21 ;22 ;nan ;24\n"
                           "30;31;32;33;34\n";

std::string fileBytes(const std::string &name)
{
  return readInputFile(maps + name);
}

} // namespace

TEST(HeightMapFile, NpyFilesOfNumPy)
{
  for (const char *name : {"c64", "c32", "fortran64", "big32", "version2", "version3"}) {
    const HeightMap map = readHeightMap(maps + name + ".npy", micrometres);
    expectTheMap(mirrored(map), name); // its first row is the top one
    EXPECT_EQ(map.dx, 2e-6);
    EXPECT_EQ(map.dy, 3e-6);
  }
}

TEST(HeightMapFile, NpyFilesThatCannotBeHeights)
{
  const auto npy = fileBytes("c64.npy");
  expectRefused(npy, {"the case must give the spacing"});
  expectRefused(npy, {"must give"}, {2e-6, 0.0, 1e-6});
  expectRefused(fileBytes("int.npy"), {"descr", "<i8", "float64"}, micrometres);
  expectRefused(fileBytes("cube.npy"), {"shape", "3 dimensions"}, micrometres);
  expectRefused(replaced(npy, "(4, 5)", "(5, 5)"), {"288 bytes", "328"}, micrometres);
  expectRefused(replaced(npy, "(4, 5)", "(4, -5)"), {"shape", "-5"}, micrometres);
  expectRefused(replaced(npy, "'shape': (4, 5), }      ", "'shape': (9999999, 9999999)}"),
                {"shape", "points in all"}, micrometres);
  expectRefused(replaced(npy, "False", "Maybe"), {"Maybe"}, micrometres);
  expectRefused(replaced(npy, "descr", "dtype"), {"unknown entry 'dtype'"}, micrometres);
  std::string bytes = npy;
  bytes[8] = bytes[9] = '\xff'; // length of the head
  expectRefused(bytes, {"byte 8", "65535"}, micrometres);
  bytes = npy;
  bytes[6] = 9;
  expectRefused(bytes, {"byte 6", "version 9"}, micrometres);
  bytes = npy; // the exponent of the third number
  bytes.replace(128 + 2 * 8, 8, std::string("\0\0\0\0\0\0\xf0\x7f", 8));
  expectRefused(bytes, {"[0, 2]", "infinite"}, micrometres);
}

TEST(HeightMapFile, GsfRowsRunDownwards)
{
  const std::string bytes = gsfBytes(theField());
  const HeightMap map = mapOfBytes(bytes);
  EXPECT_NEAR(map.dx, 2e-6, 1e-20);
  EXPECT_NEAR(map.dy, 3e-6, 1e-20);
  EXPECT_EQ(map.unmeasured(), 1);
  EXPECT_TRUE(std::isnan(map.height[13]));
  for (const int k : {0, 1, 7, 19})
    EXPECT_EQ(map.height[k], static_cast<float>(theField().value[k]));
  // the file's first number is that of the top row
  const auto data = bytes.size() - 80;
  float first = 0.0F;
  std::memcpy(&first, bytes.data() + data, 4); // on machines of either kind: see the next line
  const std::uint32_t one = 1;
  if (*reinterpret_cast<const char *>(&one) == 1) {
    EXPECT_EQ(first, 30e-6F);
  }
}

TEST(HeightMapFile, GsfIsAlignedToFourBytes)
{
  for (const char *title : {"", "a", "ab", "abc", "abcd"}) {
    SimpleField field = theField();
    field.title = title;
    const std::string bytes = gsfBytes(field);
    const auto end = bytes.find('\0');
    EXPECT_EQ((bytes.size() - 80) % 4, 0U);
    EXPECT_GE(bytes.size() - 80 - end, 1U);
    EXPECT_LE(bytes.size() - 80 - end, 4U);
    EXPECT_EQ(parseGsf("x.gsf", bytes).title, title);
  }
}

TEST(HeightMapFile, GsfFaults)
{
  const std::string bytes = gsfBytes(theField());
  expectRefused(withHead(bytes, "XRes = 5", "XRes = 6"), {"bytes", "6 x 4"});
  expectRefused(withHead(bytes, "XRes = 5", "XRes = -5"), {":2:", "XRes", "-5"});
  expectRefused(withHead(bytes, "XRes = 5", "XRes = 99999999999999999999"), {"XRes"});
  expectRefused(withHead(bytes, "XRes = 5", "XRes = 100000000"), {"XRes", "allowed"});
  expectRefused(withHead(bytes, "XRes = 5", "YRes = 5"), {"YRes", "twice"});
  expectRefused(withHead(bytes, "XRes = 5", "XSize = 5"), {"XRes", "missing"});
  expectRefused(withHead(bytes, "XReal = ", "XReal = -"), {"XReal", "positive"});
  expectRefused(withHead(bytes, "XYUnits = m", "XYUnits = s"), {"XYUnits", "'s'"});
  expectRefused(withHead(bytes, "ZUnits = m", "Zunits = m"), {"ZUnits", "missing"});
  expectRefused(withHead(bytes, "Title = test", "Title . test"), {"name = value"});
  expectRefused(withHead(bytes, "Field 1.0", "Field 2.0"), {":1:", "1.0"});
  EXPECT_EQ(mapOfBytes(bytes, micrometres).dx, mapOfBytes(bytes).dx); // states its own
  EXPECT_EQ(refusal(withHead(bytes, "XYUnits = m", "XYUnits = um")), "");
  EXPECT_NEAR(mapOfBytes(withHead(bytes, "XYUnits = m", "XYUnits = um")).dx, 2e-12, 1e-24);
}

TEST(HeightMapFile, FormatsAreToldByTheirFirstBytes)
{
  std::set<std::string> names;
  for (const HeightMapFormat &format : heightMapFormats())
    for (const std::string_view head : format.beginnings) {
      EXPECT_EQ(&heightMapFormatOf(head), &format) << format.name;
      EXPECT_EQ(&heightMapFormatOf(std::string(head) + " more"), &format) << format.name;
      names.insert(format.name);
    }
  EXPECT_EQ(names.size(), heightMapFormats().size());
  const std::string array = std::string(TEST_DATA) + "/maps/c64.npy";
  EXPECT_FALSE(statesLengths(array));
  const MapFile renamed(readInputFile(array)); // whatever its name
  EXPECT_FALSE(statesLengths(renamed.path));
  EXPECT_TRUE(statesLengths(MapFile(gsfBytes(theField())).path));
  EXPECT_TRUE(statesLengths("not there.npy"));
}

TEST(HeightMapFile, SdfProfilesRunUpwards)
{
  const HeightMap map = mapOfBytes(sdf);
  expectTheMap(map, "SDF");
  EXPECT_EQ(map.dx, 2e-6);
  EXPECT_EQ(map.dy, 3e-6);
  expectTheMap(mapOfBytes(replaced(sdf, "aISO-1.0", "aISO-2.0")), "SDF 2.0");
  const HeightMap old = mapOfBytes(replaced(sdf, "aISO-1.0", "aBCR-1.0"));
  EXPECT_EQ(old.height[0], map.height[map.index(0, 3)]); // its first profile is the top one
}

TEST(HeightMapFile, SdfFaults)
{
  expectRefused(replaced(sdf, "aISO-1.0", "aISO-3.0"), {":1:", "aISO-3.0"});
  expectRefused(replaced(sdf, "Compression = 0", "Compression = 1"), {":11:", "Compression"});
  expectRefused(replaced(sdf, "CheckType = 0", "CheckType = 1"), {":13:", "CheckType"});
  expectRefused(replaced(sdf, "NumPoints = 5", "NumPoints = 6"), {":20:", "20 of 24"});
  expectRefused(replaced(sdf, "NumPoints = 5", "NumPoints = 4"),
                {":18:", "'31' after the last of 16"});
  expectRefused(replaced(sdf, "NumPoints = 5", "NumPoints = five"), {":5:", "'five'"});
  expectRefused(replaced(sdf, "NumPoints = 5", "NumPoints = 20000000"), {"do not fit"});
  expectRefused(replaced(sdf, "NumPoints = 5", "NumPoint = 5"), {"NumPoints", "missing"});
  expectRefused(replaced(sdf, "Xscale = 2", "Xscale = -2"), {":7:", "Xscale", "positive"});
  expectRefused(replaced(sdf, "Zscale = 1.0e-006", "Zscale = um"), {":9:", "'um'"});
  expectRefused(replaced(sdf, "21 22", "2x1 22"), {":17:", "'2x1'", "BAD"});
  expectRefused(replaced(sdf, "21 22", "inf 22"), {"'inf'"});
  expectRefused(replaced(sdf, "ModDate = ", "ModDate "), {":4:", "name = value"});
}

TEST(HeightMapFile, LengthsBeyondAnySurfaceAreRefused)
{
  const std::string allowed = "must be within +-1000 m";
  expectRefused(replaced(matrix, "height: um", "height: Gm"), {"height", allowed});
  expectRefused(replaced(sdf, "Zscale = 1.0e-006", "Zscale = 1e308"), {"height", allowed});
  expectRefused(withHead(gsfBytes(theField()), "ZUnits = m", "ZUnits = Gm"), {"height", allowed});
  expectRefused(replaced(matrix, "2 um, 3 um", "2 um, 1e-300 m"), {"spacing", "[1e-12, 1000] m"});
  expectRefused(replaced(sdf, "Xscale = 2", "Xscale = 1e300 ; 2"), {"spacing", "[1e-12, 1000] m"});
}

TEST(HeightMapFile, KeysThatStandTwiceAreRefused)
{
  for (const char *line : {"# height: mm", "# spacing: 2 um", "# points: 5, 4"}) {
    const std::string twice = std::string(line) + "\n" + line + "\n# spacing: 1 um\n# height: um\n";
    expectRefused(twice + matrix.substr(matrix.rfind("um\n") + 3), {"appears twice"});
  }
  for (const char *name : {"NumPoints", "NUMPROFILES", "Xscale", "yscale", "Zscale"})
    expectRefused(replaced(sdf, "Compression = 0", fmt::format("{} = 4\r\nCompression = 0", name)),
                  {"appears twice"});
}

TEST(HeightMapFile, TextMatrix)
{
  const HeightMap map = mapOfBytes(matrix);
  expectTheMap(mirrored(map), "text"); // its first row is the top one
  EXPECT_EQ(map.dx, 2e-6);
  EXPECT_EQ(map.dy, 3e-6);
  EXPECT_EQ(mapOfBytes(replaced(matrix, "2 um, 3 um", "2 um")).dy, 2e-6);
  expectTheMap(mapOfBytes(replaced(matrix, "# height", "# rows: upwards\n# height")), "upwards");
  expectTheMap(mirrored(mapOfBytes(replaced(matrix, "# height", "# rows: downwards\n# height"))),
               "downwards");
  expectRefused(replaced(matrix, "# height: um\n", ""), {":4:", "height"});
  expectRefused(replaced(matrix, "# spacing: 2 um, 3 um\n", ""), {"spacing"});
  expectRefused(replaced(matrix, "2 um, 3 um", "0 um"), {":3:", "spacing", "positive"});
  expectRefused(replaced(matrix, "2 um, 3 um", "2, 3 um"), {":3:", "spacing", "unit"});
  expectRefused(replaced(matrix, "2 um, 3 um", "0,2 um"), {":3:", "spacing", "a decimal comma"});
  expectRefused(replaced(matrix, "height: um", "height: K"), {":2:", "height"});
  expectRefused(replaced(matrix, "13; 14", "13"), {":6:", "4 columns"});
  expectRefused(replaced(matrix, "13; 14", "13;x14"), {":6:", "column 5", "'x14'"});
  expectRefused(replaced(matrix, "13; 14", "13;inf"), {"'inf'"});
  expectRefused(replaced(matrix, "points: 5, 4", "points: 5, 5"), {"points", "5 x 4", "5 x 5"});
  expectRefused(replaced(matrix, "# height", "# rows: up\n# height"), {"rows", "'up'"});
  expectRefused(matrix.substr(0, matrix.find("20 ;")) + "# end\n", {"head", "before"});
  expectRefused("# height: um\n# spacing: 1 um\n1 2 3\n4 5 6\n7 8 9\n", {"3 x 3", "4 x 4"});
  expectRefused(std::string("a\0b", 3), {"byte 1", "binary", "GSF, SDF, x3p, SUR"});
}

/// One array, written in each format as its standard or its programs write it, is one surface: the
/// first row lies at the largest y, as it does in a picture, but in SDF, which begins at the
/// smallest.
TEST(HeightMapFile, RowOrderIsThatOfTheFormat)
{
  const auto topOf = [](const HeightMap &map) {
    return map.height.segment(map.index(0, map.ny - 1), map.nx).eval();
  };
  SimpleField field = theField(); // 10 iy + ix, upwards
  const Eigen::VectorXd last = field.value.segment(15, 5);
  EXPECT_LT((topOf(mapOfBytes(gsfBytes(field))) - last).norm(), 1e-11); // of float32
  // the file's first values are those of the top
  const HeightMap npy = readHeightMap(maps + "c64.npy", micrometres), text = mapOfBytes(matrix);
  for (int ix = 0; ix < 5; ++ix) {
    EXPECT_NEAR(topOf(npy)[ix], ix * 1e-6, 1e-20);
    EXPECT_NEAR(topOf(text)[ix], ix * 1e-6, 1e-20);
    EXPECT_NEAR(mapOfBytes(sdf).height[ix], ix * 1e-6, 1e-20);
  }
}

/// A row that is read loosely is a map of other heights.
TEST(HeightMapFile, TextIsReadStrictly)
{
  const std::string head = "# height: um\n# spacing: 1 mm\n";
  const auto rows = [&](const std::string &first, const std::string &others = "") {
    std::string text = head + first + "\n";
    for (int k = 0; k < 4; ++k)
      text += (others.empty() ? first : others) + "\n";
    return text;
  };
  const Eigen::VectorXd expected = mapOfBytes(rows("0.2;-0.1;0.5;3")).height;
  for (const char *row : {"0,2;-0,1;0,5;3", "0,2\t-0,1\t0,5\t3", "0.2\t-0.1\t0.5\t3",
                          "0.2,-0.1,0.5,3", "0.2, -0.1 , 0.5, 3", " 0.2 -0.1  0.5 3 "})
    EXPECT_EQ(mapOfBytes(rows(row)).height, expected) << row;
  expectRefused(rows("1;2;;4"), {":3: column 3: is empty"});
  expectRefused(rows("1;2;3;4", "1;2;3;;4"), {":4: column 4: is empty"});
  expectRefused(rows("1\t2\t\t4"), {":3: column 3: is empty"});
  expectRefused(rows("1,2,3,4", "1,2,,4"), {":4: column 3: is empty"});
  expectRefused(rows("\t1\t2\t3\t4"), {":3: column 1: is empty"});
  expectRefused(rows("1;2;3;4;"), {":3: column 5: is empty"});
  expectRefused(rows("1;2;3;4", "1,2,3,4"), {":4: column 1: '1,2,3,4'"});
  expectRefused(rows("1 2 3 4", "1;2;3;4"), {":4: column 1: '1;2;3;4'"});
  expectRefused(rows("1.5;2;3;4", "1,5;2;3;4"), {":4: column 1: '1,5'", "line 3", "point"});
  expectRefused(rows("1,5;2;3;4", "1.5;2;3;4"), {":4: column 1: '1.5'", "line 3", "comma"});
  expectRefused(rows("1.234,5;2;3;4"), {"'1.234,5'", "decimal comma"});
  // decimal commas that cannot be told from separators are named
  for (const char *row :
       {"0,2 0,4 0,5 0,3", "0,2, 0,4, 0,5, 0,3", "-0,2,0,4,0,5,0,3", "0,2,0,05,0,5,0,3"})
    expectRefused(rows(row), {":3: ", "decimal comma", "semicolons"});
  expectRefused(replaced(rows("0,2,0,4,0,5,0,3"), "# height", "# points: 4, 5\n# height"),
                {"8 x 5", "4 x 5", "decimal comma"});
}

TEST(HeightMapFile, TransverseProfilesAreNamed)
{
  for (const char *name : {"a.prr", "a.PRW", "a.whl", "a.ban", "a.slcs"}) {
    const std::string path = (std::filesystem::temp_directory_path() / name).string();
    std::ofstream(path) << "1 2\n3 4\n";
    try {
      prepareHeightMap(path, {}, "rail");
      ADD_FAILURE() << name;
    } catch (const Error &error) {
      EXPECT_NE(std::string(error.what()).find("transverse profile"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("contact.radii"), std::string::npos);
    }
    std::filesystem::remove(path);
  }
}

TEST(HeightMapFile, HeightsThatStandForNoneAreNamed)
{
  const auto remarks = [](const std::string &last) {
    std::string text = "# height: um\n# spacing: 1 mm\n";
    for (int k = 0; k < 5; ++k)
      text += fmt::format("{} 0.4 -0.1 0.3 {}\n", 0.1 * k, k == 2 ? last : "0.2 0.15");
    const MapFile file(text);
    return prepareHeightMap(file.path, {}, "rail").remarks;
  };
  EXPECT_TRUE(remarks("0.45 0.4").empty());
  EXPECT_TRUE(remarks("0.8 0.4").empty()); // a peak
  ASSERT_EQ(remarks("-9999 -9999").size(), 1U);
  EXPECT_NE(remarks("-9999 -9999").front().find("2 of the heights are -9999 um"),
            std::string::npos);
  ASSERT_EQ(remarks("32767 0.2").size(), 1U); // a single one, far away
  EXPECT_NE(remarks("32767 0.2").front().find("nan"), std::string::npos);
}

TEST(HeightMapFile, TextOfOtherMachines)
{
  const auto changed = [](std::string text, const std::string &from, const std::string &to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  };
  for (const std::string &whole :
       {changed(sdf, "\r\n", "\n"), changed(matrix, "um", "\xc2\xb5m")}) {
    const bool downwards = whole.find('*') == std::string::npos; // text
    const auto expectIt = [&](const std::string &bytes, const char *what) {
      const HeightMap map = mapOfBytes(bytes);
      expectTheMap(downwards ? mirrored(map) : map, what);
    };
    expectIt(changed(whole, "\n", "\r\n"), "CRLF");
    expectIt(changed(whole, "\n", "\r"), "CR");
    expectIt("\xef\xbb\xbf" + whole, "UTF-8 with a mark");
    expectIt(changed(whole, "\xc2\xb5", "\xb5"), "Latin-1");
    std::string wide = "\xff\xfe";
    for (const char c : changed(whole, "\xc2\xb5", "\xb5"))
      wide += {c, '\0'};
    expectIt(wide, "UTF-16");
    expectRefused(wide.substr(2), {"is UTF-16 without a byte order mark"});
  }
  // one line without an end is not repeated
  EXPECT_LT(refusal(std::string(60000, 'x')).size(), 600U);
}

/// Numbers that are good alone, but not times their unit.
TEST(HeightMapFile, BeyondDoublePrecision)
{
  expectRefused(replaced(sdf, "Zscale = 1.0e-006", "Zscale = 1e308"), {"height", "must be within"});
  expectRefused(withHead(gsfBytes(theField()), "XReal = ", "XReal = 5e-324\nComment = "),
                {"spacing", "0 m is not in the allowed range"});
}

/// Wherever a file is cut off, it is refused: nothing is read beyond the end.
TEST(HeightMapFile, TruncatedFilesAreRefused)
{
  const auto whole = [](const std::string &bytes, std::size_t needed, const HeightMapScale &scale) {
    EXPECT_EQ(refusal(bytes.substr(0, needed), scale), "");
    for (std::size_t k = 1; k < needed; ++k)
      EXPECT_NE(refusal(bytes.substr(0, k), scale), "") << k << " of " << needed;
  };
  const std::string gsf = gsfBytes(theField()), npy = fileBytes("c32.npy");
  whole(gsf, gsf.size(), {});
  whole(npy, npy.size(), micrometres);
  whole(fileBytes("version2.npy"), 288, micrometres);
  whole(sdf, sdf.find("*\r\nOperator") + 1, {}); // what follows is not needed
  // a text matrix that states its points: up to the last number, of which a part is a number
  whole(matrix, matrix.size() - 2, {});
  EXPECT_NE(refusal(gsf + "x"), "");
  EXPECT_NE(refusal(npy + "x", micrometres), "");
}

/// Whatever byte is falsified: a map of sane size, or one line. (Run under AddressSanitizer.)
TEST(HeightMapFile, FalsifiedBytesNeverEscape)
{
  const std::vector<std::pair<std::string, HeightMapScale>> files = {
      {gsfBytes(theField()), {}},
      {fileBytes("c32.npy"), micrometres},
      {fileBytes("version3.npy"), micrometres},
      {sdf, {}},
      {matrix, {}}};
  for (const auto &[bytes, scale] : files)
    for (std::size_t k = 0; k < bytes.size(); ++k)
      for (const char flip : {'\x01', '\x10', '\x80', '\xff'}) {
        std::string bad = bytes;
        bad[k] = static_cast<char>(bad[k] ^ flip);
        try {
          const HeightMap map = mapOfBytes(bad, scale);
          EXPECT_EQ(map.height.size(), map.nx * map.ny);
          EXPECT_FALSE(map.height.array().isInf().any());
          EXPECT_LE(map.height.size(), 40);
        } catch (const Error &error) {
          EXPECT_EQ(error.code(), ExitCode::BadInput) << error.what();
        }
      }
}

TEST(HeightMapFile, PreparationSaysEveryStep)
{
  const MapFile file(replaced(matrix, "# height", "# rows: upwards\n# height"));
  HeightMapPreparation preparation;
  EXPECT_THROW(prepareHeightMap(file.path, preparation, "rail"), Error); // a point is missing
  preparation.fill = true;
  preparation.cutoff = 7e-6;
  const PreparedHeightMap rail = prepareHeightMap(file.path, preparation, "rail");
  std::vector<std::string> steps;
  for (const auto &s : rail.statistics)
    steps.push_back(s.step);
  EXPECT_EQ(steps, (std::vector<std::string>{"rail: as read", "rail: form removed",
                                             "rail: 1 points filled", "rail: low-passed"}));
  EXPECT_EQ(rail.statistics[0].unmeasured, 1);
  EXPECT_EQ(rail.statistics[2].unmeasured, 0);
  EXPECT_LT(rail.map.height.cwiseAbs().maxCoeff(), 1e-15); // the map is a plane
  preparation.form = Form::None;
  preparation.cutoff = 0.0;
  preparation.turn = preparation.mirror = true;
  const PreparedHeightMap turnedRail = prepareHeightMap(file.path, preparation, "rail");
  EXPECT_EQ(turnedRail.map.nx, 4);
  EXPECT_NEAR(turnedRail.map.height[0], 34e-6, 1e-15); // the plane fills its hole
}
