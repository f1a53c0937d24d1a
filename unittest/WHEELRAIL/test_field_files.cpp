// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/program_files.h"
#include "contact/patch/formats/gsf_file.h"
#include "creep/patch/field_files.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace wheelrail;
namespace fs = std::filesystem;

namespace {

PatchGrid theGrid()
{
  PatchGrid grid = centredGrid(3, 2, 1.5, 0.8);
  grid.left = -0.25;
  return grid;
}

PatchFields theFields()
{
  const PatchGrid grid = theGrid();
  PatchFields fields;
  fields.state.assign(6, PatchState::Apart);
  fields.state[1] = PatchState::Stick;
  fields.state[5] = PatchState::Slip;
  fields.pressure = sampled(grid, [](double x, double y) { return 100.0 + 10.0 * x + y; });
  fields.gap = Eigen::VectorXd::Constant(6, 1e-3);
  fields.traction = {0.3 * fields.pressure, -0.1 * fields.pressure};
  fields.slip = {Eigen::VectorXd::Constant(6, 1e-3), Eigen::VectorXd::Zero(6)};
  fields.mu = Eigen::VectorXd::Constant(6, 0.3);
  return fields; // without a temperature
}

ResultHead theHead()
{
  return {{"program", "wr_creep 1"}, {"contact", "radii.wheel_profile: -0.5 m"}};
}

/// The offset that a .vti states for an array.
std::size_t offsetOf(const std::string &bytes, const std::string &name)
{
  const auto at = bytes.find("Name=\"" + name + "\"");
  EXPECT_NE(at, std::string::npos) << name;
  const auto number = bytes.find("offset=\"", at) + 8;
  return std::stoul(bytes.substr(number, 20));
}

template<class Number>
Number numberAt(const std::string &bytes, std::size_t place)
{
  Number number{};
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

} // namespace

TEST(FieldFiles, VtiHoldsTheNumbersToTheLastBit)
{
  const PatchFields fields = theFields();
  const std::string bytes = vtiBytes(theGrid(), fields, "creep 1e-3", theHead());
  EXPECT_NE(bytes.find("WholeExtent=\"0 3 0 2 0 0\""), std::string::npos);
  EXPECT_NE(bytes.find("Origin=\"-0.25 -0.40000000000000002 0\""), std::string::npos);
  EXPECT_EQ(bytes.find("temperature\" "), std::string::npos);
  const std::size_t data = bytes.find("encoding=\"raw\">\n_") + 17;
  const std::size_t pressure = data + offsetOf(bytes, "pressure");
  EXPECT_EQ(numberAt<std::uint64_t>(bytes, pressure), 48U);
  for (int k = 0; k < 6; ++k)
    EXPECT_EQ(numberAt<double>(bytes, pressure + 8 + 8 * k), fields.pressure[k]);
  const std::size_t traction = data + offsetOf(bytes, "traction");
  EXPECT_EQ(numberAt<std::uint64_t>(bytes, traction), 144U);
  EXPECT_EQ(numberAt<double>(bytes, traction + 8 + 24 * 4), fields.traction.x[4]);
  EXPECT_EQ(numberAt<double>(bytes, traction + 8 + 24 * 4 + 8), fields.traction.y[4]);
  EXPECT_EQ(numberAt<double>(bytes, traction + 8 + 24 * 4 + 16), 0.0);
  const std::size_t state = data + offsetOf(bytes, "state");
  EXPECT_EQ(numberAt<std::uint64_t>(bytes, state), 6U);
  EXPECT_EQ(bytes.substr(state + 8, 6), std::string("\0\1\0\0\0\2", 6));
  EXPECT_EQ(bytes.substr(bytes.size() - 11), "</VTKFile>\n");
}

TEST(FieldFiles, ATitleCannotBreakTheFiles)
{
  const std::string title = "a --> b\n<!-- c\0";
  const std::string bytes = vtiBytes(theGrid(), theFields(), title, theHead());
  EXPECT_NE(bytes.find("<!-- a -_> b <!-_ c -->\n"), std::string::npos);
  for (const NamedBytes &file : gsfFields(theGrid(), theFields(), title, theHead()))
    EXPECT_NO_THROW(parseGsf(file.name, file.bytes)) << file.name;
}

TEST(FieldFiles, HaveTheHead)
{
  const std::string vti = vtiBytes(theGrid(), theFields(), "creep -0.001", theHead());
  EXPECT_EQ(vti.find("<!-- creep -0.001 -->\n"), vti.find("<!--")) << "the title leads";
  EXPECT_NE(vti.find("<!-- contact: radii.wheel_profile: -0.5 m -->\n"), std::string::npos);
  for (const NamedBytes &file : gsfFields(theGrid(), theFields(), "", theHead()))
    EXPECT_NE(file.bytes.find("\ncontact = radii.wheel_profile: -0.5 m\n"), std::string::npos);
}

TEST(FieldFiles, SlipOfAStaticContactIsALength)
{
  PatchFields fields = theFields();
  fields.slip.x = fields.slip.y = Eigen::VectorXd::LinSpaced(6, 0.0, 5e-3);
  for (const bool isShift : {false, true}) {
    fields.slipIsShift = isShift;
    const std::string vti = vtiBytes(theGrid(), fields, "", {});
    EXPECT_EQ(vti.find("slip: shift in mm;") != std::string::npos, isShift);
    EXPECT_EQ(vti.find("slip: sliding/rolling speed;") != std::string::npos, !isShift);
    for (const NamedBytes &file : gsfFields(theGrid(), fields, "", {}))
      if (file.name == "slip_y") {
        const SimpleField field = parseGsf(file.name, file.bytes);
        EXPECT_EQ(field.zUnit, isShift ? "m" : "");
        EXPECT_EQ(field.value[5], static_cast<float>(isShift ? 5e-6 : 5e-3));
      }
  }
}

TEST(FieldFiles, GsfFieldsAreInSi)
{
  const PatchFields fields = theFields();
  const auto files = gsfFields(theGrid(), fields, "", {});
  std::vector<std::string> names;
  for (const NamedBytes &file : files) {
    names.push_back(file.name);
    const SimpleField field = parseGsf(file.name, file.bytes);
    EXPECT_DOUBLE_EQ(field.width, 1.5e-3);
    EXPECT_DOUBLE_EQ(field.height, 0.8e-3);
    EXPECT_DOUBLE_EQ(field.xOffset, -0.25e-3);
    EXPECT_DOUBLE_EQ(field.yOffset, -0.4e-3);
    EXPECT_EQ(field.title, file.name);
    if (file.name == "pressure") {
      EXPECT_EQ(field.zUnit, "Pa");
      for (int k = 0; k < 6; ++k)
        EXPECT_EQ(field.value[k], static_cast<float>(1e6 * fields.pressure[k]));
    }
    if (file.name == "state") {
      EXPECT_EQ(field.value[5], 2.0);
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"state", "gap", "pressure", "traction_x", "traction_y",
                                             "slip_x", "slip_y", "mu"}));
}

TEST(FieldFiles, AppearWithTheOtherResults)
{
  const fs::path folder = fs::temp_directory_path() / fmt::format("wr-fields-{}", ::getpid());
  fs::create_directories(folder);
  const std::string stem = (folder / "point").string();
  mcawr::OutputFiles files;
  addFieldFiles(files, stem, theGrid(), theFields(), theHead(), "t");
  EXPECT_FALSE(fs::exists(stem + ".vti"));
  files.commit();
  EXPECT_EQ(readInputFile(stem + ".vti"), vtiBytes(theGrid(), theFields(), "t", theHead()));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 9);
  EXPECT_THROW(addFieldFiles(files, (folder / "absent" / "point").string(), theGrid(), theFields(),
                             theHead(), "t"),
               mcawr::OutputError);
  fs::remove_all(folder);
}

TEST(FieldFiles, OfWhatIsNotFiniteAreRefused)
{
  PatchFields fields = theFields();
  fields.traction.y[3] = NAN;
  mcawr::OutputFiles files;
  try {
    addFieldFiles(files, "point", theGrid(), fields, theHead(), "t");
    FAIL() << "nan was accepted";
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::NotConverged);
    EXPECT_STREQ(error.what(), "point: traction is not finite everywhere");
  }
}
