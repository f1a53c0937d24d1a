// SPDX-License-Identifier: GPL-2.0-or-later
// What restart files and files of mca_links hold behind their checksums: read back to the last bit,
// and refused where it is damaged though the checksum fits.
#include "../shared/comma_locale.h"
#include "../shared/other_machines.h"
#include "core/automaton_states.h"
#include "files/links_text.h"
#include "files/restart_format.h"
#include "sample.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

using namespace mca;

namespace {

template<class Read>
std::string problemOf(Read read)
{
  try {
    read();
  } catch (const std::runtime_error &error) {
    return error.what();
  }
  return "";
}

void expectContains(const std::string &text, const std::string &part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

double bitsOf(long long id)
{
  double bits;
  std::memcpy(&bits, &id, sizeof(bits));
  return bits;
}

/// A record with its length before and its checksum behind it.
std::vector<double> sealed(std::vector<double> values, int id)
{
  values.insert(values.begin(), static_cast<double>(values.size() + 2));
  values.push_back(recordChecksum(values.data(), values.size(), id));
  return values;
}

/// As a fix's memory.
std::string fixBlock(const std::string &text)
{
  FILE *fp = tmpfile();
  writeFixBlock(fp, text);
  std::string bytes(ftell(fp), ' ');
  rewind(fp);
  EXPECT_EQ(fread(bytes.data(), 1, bytes.size(), fp), bytes.size());
  fclose(fp);
  return bytes.substr(sizeof(int));
}

} // namespace

TEST(RestartFormat, settingsReadBack)
{
  PairSettings settings;
  settings.thickness = 1.0 / 3.0;
  settings.packing = findPacking("hex");
  ASSERT_EQ(settings.laws.parse({"preset", "a", "steps", "plain"}), "");
  const std::string text = textOf(settings);
  const PairSettings again = settingsIn(text);
  EXPECT_EQ(again.thickness, 1.0 / 3.0);
  EXPECT_EQ(again.packing, settings.packing);
  EXPECT_EQ(again.laws.words(), settings.laws.words());
  for (const char *bad : {"", "nan 0 hex ", "0 -1 hex ", "0x10 0 hex ", "0 0 oct ", "0 0"})
    expectContains(problemOf([&] { settingsIn(bad); }), "is damaged: pair_style mca: thickness");
  expectContains(problemOf([&] { settingsIn(text + "\x1b[31m 5"); }), "Restart file: pair_style");
}

TEST(RestartFormat, materialsReadBack)
{
  const std::string text = textOf({steel(), steel()});
  EXPECT_TRUE(materialsIn(text, 2).at(1) == steel());
  expectContains(problemOf([&] { materialsIn(text, 3); }), "the block of pair_coeff of mca has 20");
  std::string bad = text;
  bad.replace(bad.find(' '), 1, "e400 ");
  expectContains(problemOf([&] { materialsIn(bad, 2); }), "for a finite number");
  bad = "-" + text;
  expectContains(problemOf([&] { materialsIn(bad, 2); }), "material of type 1: youngs_modulus");
}

TEST(RestartFormat, countsOfADriveAreCounts)
{
  DriveState state;
  state.sums.startHeight = 1;
  state.sums.displacement = 1.0 / 3.0;
  state.sums.samples = 6;
  state.sums.brokenBefore = -7.5;
  state.rows = {9, 900};
  const std::string text = textOf(state);
  EXPECT_EQ(textOf(driveStateIn(text)), text);
  const DriveState read = driveStateIn("1 2 3 4 5 6 -7.5 8 9 10 ");
  EXPECT_EQ(read.sums.startHeight, 1);
  EXPECT_EQ(read.sums.displacement, 2);
  EXPECT_EQ(read.sums.work, 3);
  EXPECT_EQ(read.sums.shearSum, 4);
  EXPECT_EQ(read.sums.normalSum, 5);
  EXPECT_EQ(read.sums.samples, 6);
  EXPECT_EQ(read.sums.brokenBefore, -7.5);
  EXPECT_EQ(read.sums.formedBefore, 8);
  EXPECT_EQ(read.rows.number, 9);
  EXPECT_EQ(read.rows.last, 10);
  for (const char *bad :
       {"1 2 3 4 5 6.5 7 8 9 10", "1 2 3 4 5 -6 7 8 9 10", "1 2 3 4 5 6 7 8 -2 10",
        "1 2 3 4 5 6 7 8 1e300 10", "1 2 3 4 5 6 7 8 9 -1e19", "1 2 3 4 5 6 7 8 9 0.1"})
    expectContains(problemOf([&] { driveStateIn(bad); }), "for numbers of steps, rows and a step");
}

TEST(RestartFormat, aBlockEndsWhereItsMemoryEnds)
{
  const std::string bytes = fixBlock("1 2 3 ");
  EXPECT_EQ(fixBlockIn(bytes.data(), bytes.size()), "1 2 3 ");
  for (std::size_t size = 0; size < bytes.size(); size++)
    EXPECT_FALSE(fixBlockIn(std::vector<char>(bytes.begin(), bytes.begin() + size).data(), size));
  for (const unsigned long long length : {7ULL, 1ULL << 40, ~0ULL, ~0ULL - 15}) {
    std::string longer = bytes;
    std::memcpy(longer.data(), &length, sizeof(length));
    EXPECT_FALSE(fixBlockIn(longer.data(), longer.size())) << length;
  }
}

TEST(RestartFormat, recordsAreAskedForTheirContent)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> good = sealed({0.25, -1, 0}, 7);
  ASSERT_TRUE(checkedRecord(good.data(), good.size(), 0, 7));
  EXPECT_FALSE(checkedRecord(good.data(), good.size(), 0, 8)); // of another automaton
  EXPECT_FALSE(checkedRecord(good.data(), good.size(), 1, 7));
  EXPECT_FALSE(checkedRecord(good.data(), good.size() - 1, 0, 7));
  EXPECT_TRUE(isStateRecord(*checkedRecord(good.data(), good.size(), 0, 7), 3));
  EXPECT_FALSE(isStateRecord(*checkedRecord(good.data(), good.size(), 0, 7), 4));
  const std::vector<double> none = sealed({0.25, nan, 0}, 7);
  EXPECT_FALSE(isStateRecord(*checkedRecord(none.data(), none.size(), 0, 7), 3));

  const auto isPartners = [](const std::vector<double> &values) {
    const std::vector<double> record = sealed(values, 7);
    return isPartnerRecord(*checkedRecord(record.data(), record.size(), 0, 7), 2);
  };
  EXPECT_TRUE(isPartners({2, bitsOf(7), 0, 0, bitsOf(9), 1, 0.5}));
  EXPECT_TRUE(isPartners({0}));
  EXPECT_FALSE(isPartners({3, bitsOf(7), 0, 0, bitsOf(9), 1, 0.5})); // read beyond its end
  EXPECT_FALSE(isPartners({-1}));
  EXPECT_FALSE(isPartners({2, bitsOf(7), 0, 0, bitsOf(9), 1}));
  EXPECT_FALSE(isPartners({1, bitsOf(0), 0, 0}));
  EXPECT_FALSE(isPartners({1, bitsOf(7), 4, 0}));
  EXPECT_FALSE(isPartners({1, bitsOf(7), 1, nan}));
}

TEST(LinksText, readBack)
{
  const double state[] = {2, 1.0 / 3.0, -1e-300, 4};
  const std::string comments =
      pairLine(12, 5, state, 4, true) + automatonLine(5, stateNumber("kappa"), 0.1);
  const std::string text = sealedLinks(linksHead("5 atoms\n", comments));
  const Links links = linksIn(text, 4, 100);
  ASSERT_EQ(links.pairs.size(), 1U);
  const auto &[ids, pair] = *links.pairs.begin();
  EXPECT_EQ(ids, (std::pair<std::int64_t, std::int64_t>{5, 12}));
  EXPECT_EQ(pair.state, std::vector<double>(state, state + 4));
  EXPECT_TRUE(pair.original);
  EXPECT_EQ(links.automata.at(5).at(0).value, 0.1);
  const auto before = text.begin() + static_cast<std::ptrdiff_t>(text.find("# pair"));
  const auto line = 1 + std::count(text.begin(), before, '\n');
  expectContains(problemOf([&] { linksIn(text, 4, 11); }),
                 "line " + std::to_string(line) + ": # pair 12 5");
  std::string flipped = text;
  flipped[text.find("5 atoms")] ^= 1;
  expectContains(problemOf([&] { linksIn(flipped, 4, 100); }), "does not match its checksum");
}

TEST(LinksText, noLocaleOfTheHostMatters)
{
  const double state[] = {2, 1.0 / 3.0, -1e-300, 1234.5};
  const auto written = [&] {
    return sealedLinks(linksHead("5 atoms\n", pairLine(12000, 5, state, 4, true) +
                                                  automatonLine(5, stateNumber("kappa"), 0.1)));
  };
  const auto blocks = [&] { return exactText({0.1, 123456.0, -1e-300}) + textOf({steel()}); };
  const std::string plain = written(), plainBlocks = blocks();
  const CommaLocale comma;
  EXPECT_EQ(written(), plain);
  EXPECT_EQ(linksIn(plain, 4, 100000).pairs.begin()->second.state,
            std::vector<double>(state, state + 4));
  EXPECT_EQ(blocks(), plainBlocks);
  EXPECT_EQ(materialsIn(textOf({steel()}), 1).at(0), steel());
}

TEST(LinksText, whatOtherMachinesSaveKeepsItsChecksum)
{
  const double state[] = {2, 1.0 / 3.0, -1e-300, 4};
  const std::string text = sealedLinks(linksHead(
      "5 atoms\n", pairLine(12, 5, state, 4, true) + automatonLine(5, stateNumber("kappa"), 0.1)));
  const Links plain = linksIn(text, 4, 100);
  for (const auto &[what, bytes] : asOtherMachinesSave(text)) {
    const Links links = linksIn(bytes, 4, 100);
    EXPECT_EQ(links.pairs, plain.pairs) << what;
    EXPECT_EQ(links.automata, plain.automata) << what;
  }
  expectContains(problemOf([&] { linksIn(withoutMark(text), 4, 100); }),
                 "is UTF-16 without a byte order mark");
  const std::string repeats =
      sealedLinks(linksHead("", "# pair " + std::string(58000, '7') + "\n"));
  EXPECT_LT(problemOf([&] { linksIn(repeats, 4, 100); }).size(), 500U);
}

TEST(LinksText, whatFitsItsChecksumIsReadAllTheSame)
{
  for (const char *bad : {"# pair 1 1 1 0 0 0 0", "# pair 1 2 4 0 0 0 0", "# pair 1 2 1 2 0 0 0",
                          "# pair 1 2 1 0 nan 0 0", "# pair 1 2 1 0 0 0", "# pair 1 2 1 0 0 0 0 0",
                          "# pair 1.5 2 1 0 0 0 0", "# pair 0 2 1 0 0 0 0", "# automaton 1 kappa",
                          "# automaton 1 kappa 1e400"})
    expectContains(
        problemOf([&] { linksIn(sealedLinks(linksHead("", std::string(bad) + "\n")), 4, 100); }),
        ", allowed: # pair");
  const std::string unknown = sealedLinks(linksHead("", "# automaton 1 kappb 1\n"));
  expectContains(problemOf([&] { linksIn(unknown, 4, 100); }), "automata have no value kappb");
}
