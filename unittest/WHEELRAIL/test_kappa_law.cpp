// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "law/kappa_law.h"
#include "law/law_checksum.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace wheelrail;

namespace {

/// Rows of a CSV file after its header.
std::vector<std::vector<double>> readCsv(const std::string &name)
{
  std::ifstream file(std::string(TEST_DATA) + "/" + name);
  EXPECT_TRUE(file) << name;
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
      rows.back().push_back(std::stod(cell));
  }
  return rows;
}

/// Eq. 7 by Simpson's rule in the logarithm of 1 + c kappa2, in long double: no closed form in it.
double averageByQuadrature(const KappaLaw &law, double k1, double modulus, double strength)
{
  using Real = long double;
  const Real x = 3.0L * law.c * modulus / strength;
  const Real top = std::log1p(x);
  constexpr int n = 20000;
  Real sum = 0.0L;
  Real weights = 0.0L;
  for (int i = 0; i <= n; ++i) {
    const Real u = top * i / n;
    const Real simpson = i == 0 || i == n ? 1.0L : (i % 2 ? 4.0L : 2.0L);
    const Real load = std::expm1(u) * std::exp(u); // p dp
    sum += simpson * load / std::exp(u);           // times 1/(1 + c kappa2)
    weights += simpson * load;
  }
  return static_cast<double>(law.mu0 + law.mu1 * k1 / (1.0 + law.b * k1) + law.mu2 * sum / weights);
}

std::string write(const std::string &content)
{
  const auto *test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = testing::TempDir() + "law_" + test->name() + ".json";
  std::ofstream(path) << content;
  return path;
}

/// The error's text when a law file with this content is read.
std::string problemOf(const std::string &content)
{
  try {
    readKappaLaw(write(content));
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

std::string lawWith(const std::string &key, const nlohmann::ordered_json &value)
{
  auto json = toJson(bucher2006());
  json[key] = value;
  return json.dump(1);
}

void expectContains(const std::string &text, const std::string &part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

} // namespace

TEST(KappaLaw, referenceTable)
{
  const auto law = bucher2006();
  for (const auto &row : readCsv("law.csv")) {
    const double k2 = kappa2(row[0], 206e3, 1000);
    EXPECT_NEAR(k2, row[1], 5e-4); // digits of the table
    EXPECT_NEAR(law.staticPart(k2), row[2], 5e-9);
    EXPECT_EQ(law(0.0, k2), law.staticPart(k2));
  }
}

TEST(KappaLaw, averageTableAndQuadrature)
{
  const auto law = bucher2006();
  for (const auto &row : readCsv("average.csv")) {
    EXPECT_NEAR(law.averaged(0.0, 206e3, row[0]), row[1], 5e-9); // digits of the table
    EXPECT_NEAR(law.averaged(0.0, 206e3, row[0]), averageByQuadrature(law, 0.0, 206e3, row[0]),
                1e-10);
  }
  EXPECT_NEAR(law.averaged(0.0, 206e3, 1000), 0.328667, 5e-7); // the paper's steel
  EXPECT_NEAR(law.averaged(0.2, 206e3, 1000), averageByQuadrature(law, 0.2, 206e3, 1000), 1e-10);
}

TEST(KappaLaw, averageOfSmallAndLargeX)
{
  auto law = bucher2006();
  for (double x : {1e-12, 1e-6, 1e-3, 0.05, 0.0999999, 0.1000001, 0.2, 3.0, 1e3}) {
    law.c = x / 3.0; // modulus = strength
    EXPECT_NEAR(law.averaged(0.0, 1.0, 1.0), averageByQuadrature(law, 0.0, 1.0, 1.0), 1e-11) << x;
  }
  law.c = 0.0;
  EXPECT_DOUBLE_EQ(law.averaged(0.0, 1.0, 1.0), law.mu0 + law.mu2);
  law.c = 1e12;
  EXPECT_NEAR(law.averaged(0.0, 1.0, 1.0), law.mu0, 1e-11);
  // continuous where series and closed form meet
  law.c = (0.1 - 1e-13) / 3.0;
  const double below = law.averaged(0.0, 1.0, 1.0);
  law.c = (0.1 + 1e-13) / 3.0;
  EXPECT_NEAR(law.averaged(0.0, 1.0, 1.0), below, 1e-13);
}

TEST(KappaLaw, kappasAreDimensionless)
{
  EXPECT_NEAR(kappa1(7800, 206e9, 5, 92e6), 4.745983, 1e-6);
  EXPECT_NEAR(kappa2(15e6, 206e9, 92e6), 365.0756, 1e-4);
  EXPECT_DOUBLE_EQ(kappa2(15, 206e3, 92), kappa2(15e6, 206e9, 92e6));
  EXPECT_DOUBLE_EQ(kappa1(4 * 7800, 206e9, 2.5, 92e6), kappa1(7800, 206e9, 5, 92e6));
}

TEST(KappaLaw, equationTwo)
{
  const auto law = bucher2006();
  EXPECT_NEAR(law(4.745983, 365.0756), 0.441758, 1e-6);
  EXPECT_NEAR(law(1e9, 0) - law(0, 0), law.mu1 / law.b, 1e-6);
}

TEST(LawFile, readsBackWhatItWrote)
{
  auto law = bucher2006();
  law.mu0 = 0.1 + 1.0 / 3.0;
  law.covariance = LawCovariance::Identity() * 1e-3;
  (*law.covariance)(0, 2) = (*law.covariance)(2, 0) = -1e-4 / 7.0;
  auto json = toJson(law);
  json["report"] = {{"anything", {1, 2, 3}}};
  const auto back = readKappaLaw(write(json.dump(2)));
  EXPECT_EQ(back.mu0, law.mu0);
  EXPECT_EQ(back.c, law.c);
  EXPECT_EQ(*back.covariance, *law.covariance);
  EXPECT_EQ(back.n, 34);
  EXPECT_EQ(back.kappa2Range, law.kappa2Range);
  EXPECT_EQ(back.kappa3Range, law.kappa3Range);
  EXPECT_EQ(back.fittedOn, law.fittedOn);
  EXPECT_FALSE(back.kappa3);
  EXPECT_EQ(back.source, law.source);
  EXPECT_EQ(bucher2006().mu1, 0.0442);
  EXPECT_FALSE(readKappaLaw(write(toJson(bucher2006()).dump())).covariance);
}

TEST(LawFile, whereItComesFromMayBeMissing)
{
  const std::string bare = R"({"format": "mca-friction-law 1",
    "mu0": 0.15, "mu1": 0.0442, "mu2": 0.3243, "b": 0.195, "c": 0.00212})";
  const std::string path = write(bare);
  const KappaLaw law = readKappaLaw(path);
  EXPECT_EQ(law(1.0, 100.0), bucher2006()(1.0, 100.0));
  EXPECT_EQ(law.source, path);
  EXPECT_EQ(law.n, 0);
  EXPECT_FALSE(law.covariance || law.kappa1Range || law.kappa2Range || law.kappa3Range);
  EXPECT_TRUE(law.fittedOn.empty());
  EXPECT_EQ(readKappaLaw(write(toJson(law).dump())).mu2, law.mu2);
}

TEST(LawFile, saysWhatItWasFittedOn)
{
  const KappaLaw paper = bucher2006();
  EXPECT_NEAR((*paper.kappa3Range)[0], 373.2, 0.1); // Table 1: 206 GPa, 92 to 552 MPa
  EXPECT_NEAR((*paper.kappa3Range)[1], 2239.1, 0.1);
  EXPECT_EQ(toJson(paper)["fitted_on"]["pressure"], (nlohmann::ordered_json{0.5, 26.0}));
  KappaLaw law = paper;
  law.kappa3 = 229.0;
  EXPECT_EQ(*readKappaLaw(write(toJson(law).dump())).kappa3, 229.0);
  expectContains(problemOf(lawWith("kappa3", 0)), "kappa3: 0 is not allowed, must be > 0");
  law.kappa3.reset();
  law.ductility = 90.0;
  EXPECT_EQ(*readKappaLaw(write(toJson(law).dump())).ductility, 90.0);
  expectContains(problemOf(lawWith("ductility", -1)), "ductility: -1 is not allowed, must be > 0");
  expectContains(problemOf(lawWith("kappa3_range", {5, 4})), "kappa3_range: [5, 4] is not a range");
  expectContains(problemOf(lawWith("fitted_on", {{"presure", {1, 2}}})),
                 "fitted_on: unknown key 'presure'; the nearest known one is 'pressure'");
  expectContains(problemOf(lawWith("fitted_on", 7)), "fitted_on: ranges");
}

TEST(LawFile, badContentIsOneClearLine)
{
  expectContains(problemOf(""), "empty");
  expectContains(problemOf("mu0 = 3"), ":1: not JSON");
  const auto whole = toJson(bucher2006()).dump(1);
  expectContains(problemOf(whole.substr(0, whole.size() / 2)), "not JSON, or cut short");
  expectContains(problemOf(lawWith("format", "mca-friction-law 2")), "'mca-friction-law 2'");
  expectContains(problemOf(lawWith("mu1", "0.0442")), ":4: mu1: a number is expected");
  expectContains(problemOf(lawWith("c", -1)), "c: -1 is not allowed, must be >= 0");
  expectContains(problemOf(lawWith("mu0", nullptr)), "mu0: a number is expected, not null");
  expectContains(problemOf(lawWith("mu_2", 1)),
                 "unknown key 'mu_2'; the nearest known one is 'mu2'");
  auto hexadecimal = whole;
  hexadecimal.replace(hexadecimal.find("0.195"), 5, "0x10");
  expectContains(problemOf(hexadecimal), "not JSON");
  expectContains(problemOf(lawWith("b", "0x10")), "b: a number is expected");
  expectContains(problemOf(lawWith("n", -3)), "n: a whole number");
  expectContains(problemOf(lawWith("kappa1_range", {3, 1})), "[3, 1] is not a range");
  expectContains(problemOf(lawWith("covariance", {1, 2})), "5 x 5");
  auto json = toJson(bucher2006());
  json.erase("b");
  expectContains(problemOf(json.dump()), "b: is missing");
  json["b"] = 1;
  json["covariance"] = std::vector<std::vector<double>>(5, {1, 2, 3, 4, 5});
  expectContains(problemOf(json.dump()), "not symmetric");
  auto text = toJson(bucher2006()).dump(1);
  text.replace(text.find("0.15"), 4, "1e999");
  expectContains(problemOf(text), "range of double precision");
  EXPECT_THROW(readKappaLaw("/nonexistent/law.json"), Error);
}

TEST(LawFile, keysThatStandTwiceAreRefused)
{
  const auto whole = toJson(bucher2006()).dump(1);
  auto twice = whole;
  twice.insert(twice.find("\"mu1\""), "\"mu0\": 0.3,\n ");
  expectContains(problemOf(twice), "mu0: appears twice");
  auto below = whole; // in what is skipped, too
  below.replace(below.rfind('}'), 1, ", \"report\": {\"a\": {\"x\": 1, \"x\": 2}}}");
  expectContains(problemOf(below), "x: appears twice");
  auto apart = whole; // the same key of two objects is none
  apart.replace(apart.rfind('}'), 1, ", \"report\": [{\"x\": 1}, {\"x\": 2, \"mu0\": 1}]}");
  EXPECT_EQ(problemOf(apart), "");
}

TEST(LawFile, numbersHaveARange)
{
  for (const char *n :
       {"18446744073709551615", "2147483648", "1e3", "-1", "18446744073709551616"}) {
    auto text = toJson(bucher2006()).dump(1);
    text.replace(text.find("34"), 2, n);
    expectContains(problemOf(text), "n: a whole number from 0 to 2147483647 is expected, not ");
  }
  for (const char *key : {"mu0", "mu1", "mu2", "b", "c", "rms_relative"})
    for (double x : {1e308, 1e101, -1e308})
      expectContains(problemOf(lawWith(key, x)), std::string(key) + ": ");
  expectContains(problemOf(lawWith("kappa1_range", {0, 1e308})), "must be within +-1e+100");
}

TEST(LawFile, covarianceIsPositiveSemiDefinite)
{
  const auto problemWith = [](const LawCovariance &covariance) {
    auto law = bucher2006();
    law.covariance = covariance;
    return problemOf(toJson(law).dump());
  };
  LawCovariance covariance = LawCovariance::Zero();
  covariance.diagonal() << 1e-4, 1e-6, 1e-4, 1e-2, 1e-12; // as different as parameters are
  covariance(0, 4) = covariance(4, 0) = 0.999 * 1e-8;
  EXPECT_EQ(problemWith(covariance), "");
  EXPECT_EQ(problemWith(LawCovariance::Zero()), "");
  covariance(0, 4) = covariance(4, 0) = 1.01e-8;
  expectContains(problemWith(covariance), "is not positive semi-definite");
  covariance(0, 4) = 1e-8;
  covariance(4, 0) = 0.99e-8;
  expectContains(problemWith(covariance), "is not symmetric");
  covariance(4, 0) = covariance(0, 4) = 0.0;
  covariance(4, 4) = -1e-12;
  expectContains(problemWith(covariance), "negative variance");
  covariance(4, 4) = 0.0;
  covariance(4, 0) = covariance(0, 4) = 1e-20;
  expectContains(problemWith(covariance), "whose variance is 0");
  // pairs that agree one by one, but not all three
  covariance = LawCovariance::Identity();
  covariance(0, 1) = covariance(1, 0) = covariance(1, 2) = covariance(2, 1) = 0.9;
  covariance(0, 2) = covariance(2, 0) = -0.9;
  expectContains(problemWith(covariance), "is not positive semi-definite");
}

TEST(LawFile, deepNestingIsRefused)
{
  for (const char *bracket : {"[", "{\"a\":"}) {
    std::string deep = toJson(bucher2006()).dump();
    deep.back() = ',';
    deep += "\"report\": ";
    for (int k = 0; k < 200000; ++k)
      deep += bracket;
    expectContains(problemOf(deep), "is nested deeper than 32 levels");
  }
}

TEST(LawFile, whatItSaysIsShownNotObeyed)
{
  const auto problem = problemOf(lawWith("\x1b[31m\nmu", 1));
  expectContains(problem, "unknown key '\\x1b[31m\\nmu'");
  EXPECT_EQ(problem.find('\x1b'), std::string::npos);
  expectContains(problemOf(lawWith("mu0", std::string(5000, 'x'))), "xxx ...");
}

TEST(LawFile, reportWithoutLawSaysSo)
{
  nlohmann::ordered_json report;
  report["format"] = "mca-friction-report 1";
  report["reason"] = "1 point";
  report["report"] = {};
  expectContains(problemOf(report.dump(1)), "no law was fitted: 1 point");
}

TEST(LawFile, checksumFindsEveryFlippedBit)
{
  auto law = bucher2006();
  law.covariance = LawCovariance::Identity() * 1e-3;
  auto json = toJson(law);
  json["report"] = {{"points", {{{"mu", 0.4}}}}};
  const std::string text = withChecksum(json.dump(2) + "\n");
  EXPECT_EQ(readKappaLaw(write(text)).note, "");
  EXPECT_TRUE(fitsChecksum(text));
  for (size_t k = 0; k < text.size(); ++k)
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = text;
      flipped[k] = static_cast<char>(flipped[k] ^ (1 << bit));
      EXPECT_FALSE(fitsChecksum(flipped)) << "byte " << k << ", bit " << bit;
      if (k < 64 || bit == static_cast<int>(k % 8)) { // a file is read for each byte
        EXPECT_NE(problemOf(flipped), "") << "byte " << k << ", bit " << bit;
      }
    }
}

// A checksum is of what is said, not of how other machines end their lines.
TEST(LawFile, itsChecksumSurvivesOtherLineEnds)
{
  const std::string text = withChecksum(toJson(bucher2006()).dump(2) + "\n");
  std::string windows, oldMac;
  for (const char c : text) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    oldMac += c == '\n' ? '\r' : c;
  }
  for (const std::string &changed : {windows, oldMac, "\xef\xbb\xbf" + text})
    EXPECT_EQ(readKappaLaw(write(changed)).note, "");
}

TEST(LawFile, anEditedLawIsReadWithoutItsChecksum)
{
  std::string text = withChecksum(toJson(bucher2006()).dump(2) + "\n");
  text.replace(text.find("0.15"), 4, "0.16");
  const std::string problem = problemOf(text);
  expectContains(problem, ".json:3: checksum: ");
  expectContains(problem, "does not fit: the file was changed since wr_fit wrote it; to use a law "
                          "that was edited, remove this line");
  const auto begin = text.find("  \"checksum\"");
  text.erase(begin, text.find('\n', begin) + 1 - begin);
  const auto law = readKappaLaw(write(text));
  EXPECT_EQ(law.mu0, 0.16);
  expectContains(law.note, ".json: no checksum");
  EXPECT_EQ(bucher2006().note, "");
}

TEST(LawFile, aChecksumThatIsNoneIsRefused)
{
  for (const char *value : {"\"\"", "5", "null", "\"00000000\"", "[]"})
    expectContains(problemOf(lawWith("checksum", nlohmann::ordered_json::parse(value))),
                   "does not fit");
}
