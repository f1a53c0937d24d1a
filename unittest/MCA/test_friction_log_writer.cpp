// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/friction_log_writer.h"

#include "../shared/comma_locale.h"
#include "../shared/other_machines.h"
#include "sample.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
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

  static mca::LogRow row(double step)
  {
    mca::LogRow row;
    row.step = step;
    row.time = step * 5e-5;
    row.displacement = step * 2.5e-4;
    row.shearStress = 7.5;
    row.normalStress = 15;
    row.mu = 0.5;
    row.links = 3000;
    row.broken = 4;
    row.formed = 5;
    row.gap = -0.1;
    row.room = 0.97;
    row.lost = 2;
    row.flowEnergy = 11;
    row.breakingEnergy = 12;
    row.contactEnergy = 13;
    return row;
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

TEST_F(FrictionLogWriterTest, HeadHasAllMaterialsTheWeakestFirst)
{
  mca::Material bronze = steel();
  bronze.strength = 350;
  bronze.youngsModulus = 110000;
  const mca::Units nano = *mca::findUnits("nano");
  for (const bool bronzeDrives : {false, true}) {
    mca::LogHeader h = header();
    h.use({bronze, steel(), bronze}, bronzeDrives ? bronze : steel());
    const std::string head = mca::headOf(h, nano);
    const auto first = head.find("# material: {youngs_modulus: 206000,");
    const auto second = head.find("# other_material: {youngs_modulus: 110000,");
    ASSERT_NE(first, std::string::npos) << head;
    ASSERT_NE(second, std::string::npos) << head;
    EXPECT_LT(first, second);
    EXPECT_LT(second, head.find("# loading"));
    EXPECT_NE(head.find(bronzeDrives ? "viscosity: 0.41, layer: other}"
                                     : "viscosity: 0.41, layer: driven}"),
              std::string::npos)
        << head;
    EXPECT_EQ(head.find("other_material_2"), std::string::npos);
    mca::LogHeader turned = header();
    turned.use({bronze, steel()}, bronzeDrives ? steel() : bronze);
    EXPECT_NE(mca::differenceFrom(head, turned, nano), "");
  }
  mca::LogHeader alone = header();
  alone.use({steel(), steel()}, steel());
  EXPECT_EQ(mca::headOf(alone, nano), mca::headOf(header(), nano));
}

TEST_F(FrictionLogWriterTest, HeadHasInterfacesInUnitsOfTheLog)
{
  const mca::Units si = *mca::findUnits("si");
  mca::LogHeader h = header();
  mca::Interface coating;
  coating.strength = 30e6;
  coating.viscosity = 0.2;
  coating.friction = 0.35;
  coating.links = {"link", "none"};
  h.interfaces[{1, 2}] = coating;
  h.interfaces[{2, 2}].friction = 0.0;
  const std::string head = mca::headOf(h, si);
  EXPECT_THAT(head, HasSubstr("\n# interface: {types: 1 2, strength: 30, viscosity: 0.2, friction: "
                              "0.35, link: none}\n# interface_2: {types: 2 2, friction: 0}\n"
                              "# loading"));
  EXPECT_EQ(mca::differenceFrom(head, h, si), "");
  h.interfaces[{1, 2}].friction = 0.4;
  EXPECT_EQ(mca::differenceFrom(head, h, si),
            "interface: friction is 0.35 in the log, 0.4 in this run");
}

TEST_F(FrictionLogWriterTest, HeaderThenColumnsThenRows)
{
  mca::FrictionLogWriter log;
  EXPECT_FALSE(log.isOpen());
  log.begin(path, header(), units, 0, false);
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
                        "formed gap room lost flow_energy breaking_energy contact_energy check\n"
                        "1000 0.05 0.25 7.5 15 0.5 3000 4 5 -0.1 0.97 2 11 12 13 "));
  EXPECT_EQ(rows().size(), 2u);
  EXPECT_FALSE(fs::exists(path.string() + ".tmp"));
}

TEST_F(FrictionLogWriterTest, NoLocaleOfTheHostMatters)
{
  mca::LogHeader head = header();
  head.material.poissonsRatio = 0.28;
  const auto written = [&] {
    mca::FrictionLogWriter log;
    log.begin(path, head, units, 0, false);
    log.write(row(1000));
    log.write(row(123456));
    return text();
  };
  const std::string plain = written();
  fs::remove(path);
  const CommaLocale comma;
  EXPECT_EQ(written(), plain);
  mca::FrictionLogWriter again;
  EXPECT_EQ(again.resume(path, head, units, 123456, {2, 123456}), "");
  EXPECT_EQ(text(), plain);
}

TEST_F(FrictionLogWriterTest, ALogThatAnotherMachineSavedGoesOn)
{
  {
    mca::FrictionLogWriter log;
    log.begin(path, header(), units, 0, false);
    log.write(row(1000));
    log.write(row(2000));
  }
  const std::string plain = text();
  const auto save = [&](const std::string &bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  };
  for (const auto &[what, bytes] : asOtherMachinesSave(plain)) {
    save(bytes);
    mca::FrictionLogWriter log;
    EXPECT_EQ(log.resume(path, header(), units, 2000, {2, 2000}), "") << what;
    EXPECT_EQ(text(), plain) << what;
  }
  save(withoutMark(plain));
  mca::FrictionLogWriter log;
  EXPECT_THAT(
      [&] {
        log.resume(path, header(), units, 2000, {2, 2000});
      },
      testing::ThrowsMessage<std::runtime_error>(HasSubstr("it is UTF-16 without a")));
}

TEST_F(FrictionLogWriterTest, TheHeadNamesThePackingOfTheRun)
{
  for (const char *packing : {"hex", "fcc", "hcp", "sc"}) {
    mca::LogHeader h = header();
    h.packing = packing;
    mca::FrictionLogWriter log;
    log.begin(path, h, units, 0, false);
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

// What a further run of the same loading finds after these steps.
class ContinuedLogTest : public FrictionLogWriterTest {
 protected:
  void SetUp() override
  {
    FrictionLogWriterTest::SetUp();
    write(5);
  }

  void write(int number) const
  {
    mca::FrictionLogWriter log;
    log.begin(path, header(), units, 0, false);
    for (long long k = 1; k <= number; k++)
      log.write(row(1000 * k));
  }

  std::string problemOf(const mca::LogHeader &h, long long step, mca::LogRows there) const
  {
    const std::string before = text();
    mca::FrictionLogWriter log;
    try {
      log.resume(path, h, units, step, there);
    } catch (const std::runtime_error &e) {
      EXPECT_EQ(text(), before) << "a log that is refused is left as it was";
      return e.what();
    }
    return "";
  }
};

TEST_F(ContinuedLogTest, DropsLaterRowsAndACutLastLine)
{
  const std::string head = text().substr(0, text().find("\n1000 ") + 1);
  std::ofstream(path, std::ios::app) << "6000 0.3 1.5"; // the machine stopped here
  {
    mca::FrictionLogWriter log;
    EXPECT_EQ(log.resume(path, header(), units, 3000, {3, 3000}), "");
    EXPECT_EQ(log.rows().number, 3);
    log.write(row(4000));
  }
  ASSERT_EQ(rows().size(), 4u);
  EXPECT_THAT(rows().back(), StartsWith("4000 "));
  EXPECT_THAT(text(), StartsWith(head));
  EXPECT_EQ(text().back(), '\n');

  std::ofstream(path, std::ios::app) << "4500 0.2"; // cut short, but not later than the step
  EXPECT_EQ(problemOf(header(), 4700, {4, 4000}), "");
  EXPECT_EQ(rows().size(), 4u);
}

TEST_F(ContinuedLogTest, RefusesRowsThatAreMissing)
{
  EXPECT_THAT(problemOf(header(), 7500, {7, 7000}),
              HasSubstr("it has 5 rows, the last one of step 5000 up to step 7500, the run that "
                        "wrote the restart file had 7 rows, the last one of step 7000"));
  EXPECT_THAT(problemOf(header(), 900, {4, 4000}), HasSubstr("it has no row up to step 900"));
  std::string cut = text();
  const size_t third = cut.find("\n3000 ");
  cut.erase(third, cut.find('\n', third + 1) - third);
  std::ofstream(path, std::ios::trunc) << cut;
  for (const mca::LogRows there : {mca::LogRows{5, 5000}, mca::LogRows{4, 5000}})
    EXPECT_THAT(problemOf(header(), 5000, there), HasSubstr("line 12: check: "));
}

TEST_F(ContinuedLogTest, RefusesABitThatWasFlipped)
{
  const std::string good = text();
  for (size_t at = 0; at < good.size(); at++) {
    std::string damaged = good;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    std::ofstream(path, std::ios::trunc) << damaged;
    EXPECT_NE(problemOf(header(), 5000, {5, 5000}), "") << "byte " << at;
  }
}

TEST_F(ContinuedLogTest, TheCheckIsThatOfAllBytesBefore)
{
  std::ofstream(path, std::ios::app) << "6000 0.3 1.5";
  {
    mca::FrictionLogWriter log;
    log.resume(path, header(), units, 3000, {3, 3000});
    log.write(row(4000));
  }
  const std::string all = text();
  size_t end = all.find("\n1000 ");
  for (int k = 0; k < 4; k++) {
    end = all.find('\n', end + 1);
    const size_t begin = all.rfind(' ', end) + 1;
    mcawr::RunningChecksum sum;
    sum.add(all.substr(0, begin));
    EXPECT_EQ(all.substr(begin, end - begin), std::to_string(sum.value())) << "row " << k;
  }
  EXPECT_EQ(end + 1, all.size());
}

TEST_F(ContinuedLogTest, RefusesRowsThatAreDamaged)
{
  const std::string good = text();
  for (const char *word : {"nan", "0x10", "1e999", "7.5.1", ""}) {
    std::string damaged = good;
    damaged.replace(damaged.find(" 7.5 "), 5, std::string(" ") + word + " ");
    std::ofstream(path, std::ios::trunc) << damaged;
    EXPECT_THAT(problemOf(header(), 5000, {5, 5000}), HasSubstr("line 10")) << word;
  }
}

TEST_F(ContinuedLogTest, RefusesAnotherHead)
{
  const auto differing = [](auto &&change) {
    mca::LogHeader h = header();
    change(h);
    return h;
  };
  const std::vector<std::pair<mca::LogHeader, std::string>> cases = {
      {differing([](auto &h) { h.material.strength = 552; }),
       "material: elastic_limit is"}, // a ratio of the strength, hence another one, too
      {differing([](auto &h) { h.material.youngsModulus = 70000; }),
       "material: youngs_modulus is 206000 in the log, 70000 in this run"},
      {differing([](auto &h) { h.pressure = 26; }), "loading: pressure is 15 in the log, 26"},
      {differing([](auto &h) { h.velocity = 6; }), "loading: velocity"},
      {differing([](auto &h) { h.width = 120; }), "geometry: width"},
      {differing([](auto &h) { h.packing = "sc"; }), "geometry: packing is hex in the log, sc"},
      {differing([](auto &h) { h.laws[3] = "2.35"; }), "laws: link is elastic_limit"},
      {differing([](auto &h) { h.laws.resize(2); }), "laws: link is elastic_limit in the log, not"},
      {differing([](auto &h) { h.timestep = 2e-5; }), "run: timestep"},
      {differing([](auto &h) { h.every = 500; }), "run: every is 1000 in the log, 500"},
      {differing([](auto &h) { h.seed = 4; }), "run: seed is 3 in the log, 4 in this run"},
  };
  for (const auto &[h, part] : cases)
    EXPECT_THAT(problemOf(h, 5000, {5, 5000}), HasSubstr("its head does not fit: " + part));
}

TEST_F(ContinuedLogTest, TakesWhatMayDiffer)
{
  mca::LogHeader h = header();
  h.automata += 1;
  h.width *= 1.0 + 1e-12;
  h.pressure = 26;
  h.varying = {"pressure"};
  EXPECT_EQ(problemOf(h, 5000, {5, 5000}), "");
  h.lammpsVersion = 20260704;
  mca::FrictionLogWriter log;
  EXPECT_THAT(log.resume(path, h, units, 5000, {5, 5000}), HasSubstr("lammps 20250204, this is"));
}

TEST_F(ContinuedLogTest, ALogThatIsNotThereBeginsAnewAndSaysSo)
{
  fs::remove(path);
  mca::FrictionLogWriter log;
  EXPECT_THAT(log.resume(path, header(), units, 5000, {5, 5000}), HasSubstr("a new one begins"));
  EXPECT_EQ(log.rows().number, 0);
}

TEST_F(ContinuedLogTest, ANewLogErasesNoRowsThatItsRunWillNotMake)
{
  const std::string before = text();
  const auto problemOfNew = [&](long long step, bool isRestart) {
    mca::FrictionLogWriter log;
    try {
      log.begin(path, header(), units, step, isRestart);
    } catch (const std::runtime_error &e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(problemOfNew(0, true), HasSubstr("the restart file holds no log of that name"));
  EXPECT_THAT(problemOfNew(1000, false), HasSubstr("it exists and has rows from step 1000 on"));
  EXPECT_EQ(text(), before);
  EXPECT_EQ(problemOfNew(999, false), "");
  EXPECT_EQ(rows().size(), 0u);
  std::ofstream(path, std::ios::trunc) << "units nano\n";
  EXPECT_THAT(problemOfNew(0, false), HasSubstr("its first line is not"));
  EXPECT_EQ(text(), "units nano\n");
}

TEST_F(ContinuedLogTest, HasOneWriter)
{
  mca::FrictionLogWriter one, other;
  one.resume(path, header(), units, 5000, {5, 5000});
  EXPECT_THROW(other.resume(path, header(), units, 5000, {5, 5000}), std::runtime_error);
  EXPECT_THROW(other.begin(path, header(), units, 0, false), std::runtime_error);
  one.write(row(6000));
  EXPECT_EQ(rows().size(), 6u);
}

TEST_F(ContinuedLogTest, AFurtherRunOfTheInputHasTheSameHead)
{
  mca::FrictionLogWriter log;
  log.begin(path, header(), units, 0, false);
  EXPECT_NO_THROW(log.check(header(), units));
  mca::LogHeader h = header();
  h.material.viscosity = 100;
  EXPECT_THROW(log.check(h, units), std::runtime_error);
}

TEST_F(FrictionLogWriterTest, ResumeRefusesAForeignFile)
{
  std::ofstream(path) << "something else\n1 2 3\n";
  const std::string before = text();
  mca::FrictionLogWriter log;
  try {
    log.resume(path, header(), units, 100, {});
    FAIL() << "no error";
  } catch (const std::runtime_error &e) {
    EXPECT_THAT(e.what(), HasSubstr(path.string()));
    EXPECT_THAT(e.what(), HasSubstr("its first line is not '# format: mca-friction 1'"));
  }
  EXPECT_EQ(text(), before); // left as it was
  std::ofstream(path, std::ios::trunc).close();
  EXPECT_THROW(log.resume(path, header(), units, 100, {}), std::runtime_error)
      << "an empty file is no log";
}

// friction_log_format.h has one range for this writer and for wr_fit.
TEST_F(FrictionLogWriterTest, WritesNoNumberThatNoReaderTakes)
{
  const std::vector<std::pair<void (*)(mca::LogHeader &), std::string>> cases = {
      {[](mca::LogHeader &h) { h.every = -1; },
       "every is -1, allowed in a friction log: >= 0, whole"},
      {[](mca::LogHeader &h) { h.velocity = -1e13; },
       "velocity is -1.0e+13, allowed in a friction"},
      {[](mca::LogHeader &h) { h.pressure = -1; },
       "pressure is -1, allowed in a friction log: >= 0"},
      {[](mca::LogHeader &h) { h.pressure = NAN; }, "pressure is nan"},
      {[](mca::LogHeader &h) { h.timestep = -1e-5; }, "timestep is -1.0e-05"},
      {[](mca::LogHeader &h) { h.material.youngsModulus = 1e13; }, "youngs_modulus is 1.0e+13"},
  };
  for (const auto &[change, part] : cases) {
    mca::LogHeader h = header();
    change(h);
    mca::FrictionLogWriter log;
    try {
      log.begin(path, h, units, 0, false);
      FAIL() << part;
    } catch (const std::runtime_error &e) {
      EXPECT_THAT(e.what(), HasSubstr(part));
    }
    EXPECT_FALSE(fs::exists(path));
  }
  mca::FrictionLogWriter log;
  log.begin(path, header(), units, 0, false);
  mca::LogRow bad = row(1000);
  bad.mu = NAN;
  EXPECT_THROW(log.write(bad), std::runtime_error);
  EXPECT_EQ(rows().size(), 0u);
}

TEST_F(FrictionLogWriterTest, LinksAndPipesStay)
{
  const fs::path real = folder / "real";
  fs::create_symlink(real, path);
  mca::FrictionLogWriter log;
  log.begin(path, header(), units, 0, false);
  log.write(row(1000));
  EXPECT_TRUE(fs::is_symlink(path));
  EXPECT_EQ(rows().size(), 1u);
  fs::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  log.begin(path, header(), units, 0, false);
  log.write(row(1000));
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(path));
}

TEST_F(FrictionLogWriterTest, UnwritableFolder)
{
  mca::FrictionLogWriter log;
  const std::string missing = folder / "no" / "x.friction";
  try {
    log.begin(missing, header(), units, 0, false);
    FAIL() << "no error";
  } catch (const std::runtime_error &e) {
    EXPECT_EQ(std::string(e.what()), missing + ": cannot write: No such file or directory");
  }
  EXPECT_THROW(log.resume(missing, header(), units, 0, {}), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder / "no"));
}

TEST_F(FrictionLogWriterTest, AFolderInTheWayLeavesNothingBehind)
{
  fs::create_directories(path);
  mca::FrictionLogWriter log;
  EXPECT_THROW(log.begin(path, header(), units, 0, false), std::runtime_error);
  EXPECT_FALSE(fs::exists(path.string() + ".tmp"));
}

TEST_F(FrictionLogWriterTest, BeginReplacesAnOldLog)
{
  for (int k = 0; k < 2; k++) {
    mca::FrictionLogWriter log;
    log.begin(path, header(), units, 0, false);
    log.write(row(1000));
  }
  EXPECT_EQ(rows().size(), 1u);
}
