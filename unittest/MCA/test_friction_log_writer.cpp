// SPDX-License-Identifier: GPL-2.0-or-later
#include "friction_log_writer.h"

#include "sample.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

namespace {

class FrictionLogWriterTest : public testing::Test {
 protected:
  void SetUp() override
  {
    folder =
        fs::temp_directory_path() / ("mca-log-" + std::to_string(getpid()) + "-" +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder);
    path = folder / "x.friction";
  }
  void TearDown() override { fs::remove_all(folder); }

  static mca::LogHeader header()
  {
    mca::LogHeader h;
    h.material = steel();
    h.pressure = 15;
    h.velocity = 5;
    h.width = 100;
    h.thickness = 1;
    h.packing = "hex";
    h.automata = 1280;
    h.laws = {"preset", "b", "link", "elastic_limit"};
    h.timestep = 5e-5;
    h.every = 1000;
    h.seed = 3;
    h.lammpsVersion = 20250204;
    return h;
  }

  static mca::LogRow row(long long step)
  {
    return {step, step * 5e-5, step * 2.5e-4, 7.5, 15, 0.5, 3000, 4, 5, -0.1};
  }

  std::string text() const
  {
    std::ifstream in(path);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }

  std::vector<std::string> rows() const
  {
    std::istringstream in(text());
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);)
      if (!line.empty() && std::isdigit(static_cast<unsigned char>(line[0])))
        all.push_back(line);
    return all;
  }

  fs::path folder, path;
  const mca::Units units = *mca::findUnits("nano");
};

} // namespace

TEST_F(FrictionLogWriterTest, HeaderThenColumnsThenRows)
{
  mca::FrictionLogWriter log;
  EXPECT_FALSE(log.isOpen());
  log.begin(path, header(), units);
  EXPECT_TRUE(log.isOpen());
  log.write(row(1000));
  log.write(row(2000));
  EXPECT_THAT(text(), StartsWith("# format: mca-friction 1\n"));
  EXPECT_THAT(text(), HasSubstr("youngs_modulus: 206000, "));
  EXPECT_THAT(text(), HasSubstr("density: 7800, "));
  EXPECT_THAT(text(), HasSubstr("viscosity: 0.41}"));
  EXPECT_THAT(text(), HasSubstr("# laws: {preset: b, link: elastic_limit}"));
  EXPECT_THAT(text(),
              HasSubstr("\nstep time displacement shear_stress normal_stress mu links broken "
                        "formed gap\n1000 0.05 0.25 7.5 15 0.5 3000 4 5 -0.1\n2000 "));
  EXPECT_EQ(rows().size(), 2u);
  EXPECT_FALSE(fs::exists(path.string() + ".tmp"));
}

TEST_F(FrictionLogWriterTest, TheHeadNamesThePackingOfTheRun)
{
  for (const char *packing : {"hex", "fcc", "hcp", "sc"}) {
    mca::LogHeader h = header();
    h.packing = packing;
    mca::FrictionLogWriter log;
    log.begin(path, h, units);
    EXPECT_THAT(text(), HasSubstr(std::string("diameter: 2.5, packing: ") + packing +
                                  ", automata: 1280}\n"));
  }
}

TEST_F(FrictionLogWriterTest, UnitsOfTheRunBecomeThoseOfTheLog)
{
  // the same steel in SI, cgs and metal
  const mca::Units si = *mca::findUnits("si"), metal = *mca::findUnits("metal");
  EXPECT_EQ(mca::findUnits("lj"), nullptr);
  EXPECT_EQ(mca::findUnits("electron"), nullptr);
  EXPECT_DOUBLE_EQ(206e9 * si.stress, 206000);
  EXPECT_DOUBLE_EQ(2.5e-9 * si.length, 2.5);
  EXPECT_DOUBLE_EQ(5 * si.velocity(), 5);
  EXPECT_DOUBLE_EQ(0.41 * si.viscosity(), 0.41);
  EXPECT_DOUBLE_EQ(7800 * si.density(), 7800);
  EXPECT_DOUBLE_EQ(25 * metal.length, 2.5);
  EXPECT_DOUBLE_EQ(0.05 * metal.velocity(), 5);              // Angstrom/ps
  EXPECT_DOUBLE_EQ(2060000 * metal.stress, 206000);          // bar
  EXPECT_DOUBLE_EQ(4.1e-6 * 1e12 * metal.viscosity(), 0.41); // 0.41 Pa s = 4.1e-6 bar s
  EXPECT_DOUBLE_EQ(410 * units.viscosity(), 0.41);
}

TEST_F(FrictionLogWriterTest, ResumeDropsLaterRowsAndACutLastLine)
{
  {
    mca::FrictionLogWriter log;
    log.begin(path, header(), units);
    for (long long step = 1000; step <= 5000; step += 1000)
      log.write(row(step));
  }
  const std::string head = text().substr(0, text().find("\n1000 ") + 1);
  std::ofstream(path, std::ios::app) << "6000 0.3 1.5"; // the machine stopped here
  {
    mca::FrictionLogWriter log;
    log.resume(path, 3000);
    log.write(row(4000));
  }
  ASSERT_EQ(rows().size(), 4u);
  EXPECT_THAT(rows().back(), StartsWith("4000 "));
  EXPECT_THAT(text(), StartsWith(head));
  EXPECT_EQ(text().back(), '\n');

  std::ofstream(path, std::ios::app) << "4500 0.2"; // cut short, but not later than the step
  mca::FrictionLogWriter again;
  again.resume(path, 9000);
  EXPECT_EQ(rows().size(), 4u);
}

TEST_F(FrictionLogWriterTest, ResumeRefusesAForeignFile)
{
  std::ofstream(path) << "something else\n1 2 3\n";
  const std::string before = text();
  mca::FrictionLogWriter log;
  try {
    log.resume(path, 100);
    FAIL() << "no error";
  } catch (const std::runtime_error &e) {
    EXPECT_THAT(e.what(), HasSubstr(path.string()));
    EXPECT_THAT(e.what(), HasSubstr("its first line is not '# format: mca-friction 1'"));
  }
  EXPECT_EQ(text(), before); // left as it was
  std::ofstream(path, std::ios::trunc).close();
  EXPECT_THROW(log.resume(path, 100), std::runtime_error) << "an empty file is no log";
}

TEST_F(FrictionLogWriterTest, UnwritableFolder)
{
  mca::FrictionLogWriter log;
  const std::string missing = folder / "no" / "x.friction";
  try {
    log.begin(missing, header(), units);
    FAIL() << "no error";
  } catch (const std::runtime_error &e) {
    EXPECT_EQ(std::string(e.what()),
              "cannot write friction log " + missing + ": No such file or directory");
  }
  EXPECT_THROW(log.resume(missing, 0), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder / "no"));
}

TEST_F(FrictionLogWriterTest, AFolderInTheWayLeavesNothingBehind)
{
  fs::create_directories(path);
  mca::FrictionLogWriter log;
  EXPECT_THROW(log.begin(path, header(), units), std::runtime_error);
  EXPECT_FALSE(fs::exists(path.string() + ".tmp"));
}

TEST_F(FrictionLogWriterTest, BeginReplacesAnOldLog)
{
  for (int k = 0; k < 2; k++) {
    mca::FrictionLogWriter log;
    log.begin(path, header(), units);
    log.write(row(1000));
  }
  EXPECT_EQ(rows().size(), 1u);
}
