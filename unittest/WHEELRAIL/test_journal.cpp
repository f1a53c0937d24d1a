// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/checksum.h"
#include "base/program_files.h"
#include "base/version.h"
#include "creep/sweep/journal.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

using namespace wheelrail;
namespace fs = std::filesystem;

namespace {

class JournalFile : public testing::Test {
 protected:
  void SetUp() override
  {
    path = (fs::temp_directory_path() / ("wr-journal-test-" + std::to_string(::getpid()))).string();
  }
  void TearDown() override { fs::remove(path); }

  /// What a new journal of this case finds in the file.
  Journal::Pieces loaded(const std::string &identity = "case")
  {
    warnings.clear();
    return journal(identity).load();
  }
  Journal journal(const std::string &identity = "case")
  {
    return Journal(path, identity, [this](const std::string &line) { warnings += line + "\n"; });
  }
  void write(const std::string &content) const { std::ofstream(path, std::ios::binary) << content; }
  /// Two pieces in the file; its text.
  std::string twoPieces()
  {
    Journal two = journal();
    two.add(0, {1.0 / 3.0, 2});
    two.add(3, {{"points", {0.1}}});
    two.write();
    return readInputFile(path);
  }

  std::string path, warnings;
};

} // namespace

TEST(Checksum, isCrc32)
{
  EXPECT_EQ(checksum("123456789"), "cbf43926");
  EXPECT_EQ(checksum(""), "00000000");
}

TEST_F(JournalFile, givesBackWhatItGot)
{
  EXPECT_TRUE(loaded().empty());
  twoPieces();
  const Journal::Pieces pieces = loaded();
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces.at(0).at(0).get<double>(), 1.0 / 3.0);
  EXPECT_EQ(pieces.at(3).at("points").at(0), 0.1);
  EXPECT_EQ(warnings, "");
}

TEST_F(JournalFile, keepsWhatItLoaded)
{
  twoPieces();
  Journal again = journal();
  again.load();
  again.add(5, {1});
  again.write();
  EXPECT_EQ(loaded().size(), 3U);
}

TEST_F(JournalFile, growsByWhatIsNew)
{
  const std::string link = path + ".link"; // a file that is written anew leaves its other name
  Journal own = journal();
  own.add(4, {4});
  own.write();
  const std::string before = readInputFile(path);
  fs::create_hard_link(path, link);
  own.add(1, {1});
  own.write();
  own.write(); // nothing new
  EXPECT_TRUE(fs::equivalent(path, link));
  fs::remove(link);
  const std::string text = readInputFile(path);
  EXPECT_EQ(text.substr(0, before.size()), before);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_EQ(loaded().size(), 2U);
  EXPECT_EQ(warnings, "");
}

TEST_F(JournalFile, goesOnAfterALineThatWasCut)
{
  Journal own = journal();
  own.add(4, {4});
  own.write();
  const std::size_t whole = readInputFile(path).size();
  own.add(1, {1.0 / 3.0});
  own.write();
  const std::string text = readInputFile(path);
  for (std::size_t size = whole; size < text.size(); ++size) { // killed while it was added
    write(text.substr(0, size));
    Journal next = journal();
    const std::size_t kept = next.load().size();
    EXPECT_EQ(kept, size + 1 == text.size() ? 2U : 1U);
    next.add(1, {1.0 / 3.0});
    next.write();
    const Journal::Pieces pieces = loaded();
    EXPECT_EQ(warnings, "") << size;
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces.at(1).at(0).get<double>(), 1.0 / 3.0);
  }
}

TEST_F(JournalFile, isWrittenWholeWhereSomebodyHasChangedIt)
{
  Journal own = journal();
  own.add(0, {0});
  own.write();
  fs::remove(path);
  own.add(1, {1});
  own.write();
  EXPECT_EQ(loaded().size(), 2U);
  write("another file\n");
  own.add(2, {2});
  own.write();
  EXPECT_EQ(loaded().size(), 3U);
  EXPECT_EQ(warnings, "");
}

TEST_F(JournalFile, ofAnotherCaseIsNotUsedAndStays)
{
  const std::string text = twoPieces();
  EXPECT_TRUE(loaded("another case").empty());
  EXPECT_NE(warnings.find("is of another case"), std::string::npos) << warnings;
  Journal other = journal("another case");
  other.load();
  other.write(); // nothing to be kept
  other.remove();
  EXPECT_EQ(other.whatIsKept(), "");
  EXPECT_EQ(readInputFile(path), text);
}

TEST_F(JournalFile, ofAnotherCommitIsNotUsed)
{
  const std::string text = twoPieces();
  std::string head = text.substr(9, text.find('\n') - 9);
  const std::string version = nlohmann::json::parse(head)["version"];
  EXPECT_EQ(version, versionText);
  head.replace(head.find(version), version.size(), "0.0.9 (v0.0.9-5-gabcdef0)");
  write(checksum(head) + " " + head + text.substr(text.find('\n')));
  EXPECT_TRUE(loaded().empty());
  EXPECT_NE(warnings.find("was written by version \"0.0.9 (v0.0.9-5-gabcdef0)\" of this program, "
                          "which is \"" +
                          version + "\"; it is not used"),
            std::string::npos)
      << warnings;
  EXPECT_TRUE(loaded("another case").empty());
  EXPECT_NE(warnings.find("is of another case"), std::string::npos) << warnings;
}

TEST_F(JournalFile, isRemovedByWhomItBelongsTo)
{
  twoPieces();
  Journal own = journal();
  own.load();
  EXPECT_NE(own.whatIsKept().find(path), std::string::npos);
  own.remove();
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(JournalFile, everyFlippedBitIsFound)
{
  const std::string text = twoPieces();
  for (std::size_t k = 0; k < text.size(); ++k)
    for (int bit = 0; bit < 8; ++bit) {
      std::string flipped = text;
      flipped[k] = static_cast<char>(flipped[k] ^ (1 << bit));
      write(flipped);
      const Journal::Pieces pieces = loaded();
      EXPECT_NE(warnings, "") << "byte " << k << ", bit " << bit;
      if (pieces.count(0) > 0) {
        EXPECT_EQ(pieces.at(0).dump(), "[0.3333333333333333,2]") << k;
      }
      if (pieces.count(3) > 0) {
        EXPECT_EQ(pieces.at(3).dump(), "{\"points\":[0.1]}") << k;
      }
      EXPECT_LE(pieces.size(), 2U);
    }
}

TEST_F(JournalFile, everyCutIsFoundOrLeavesWholePieces)
{
  const std::string text = twoPieces();
  for (std::size_t size = 0; size < text.size(); ++size) {
    write(text.substr(0, size));
    const std::size_t pieces = loaded().size();
    const bool endsWithALine = size > 0 && (text[size - 1] == '\n' || text[size] == '\n');
    EXPECT_EQ(warnings.empty(), endsWithALine) << size << warnings;
    EXPECT_LE(pieces, size + 1 >= text.size() ? 2U : 1U);
  }
}

TEST_F(JournalFile, aPieceOfAnotherJournalIsFound)
{
  const std::string text = twoPieces();
  Journal other = journal("another case");
  other.add(1, {7});
  other.write();
  const std::string foreign = readInputFile(path);
  write(text + foreign.substr(foreign.find('\n') + 1));
  EXPECT_EQ(loaded().size(), 2U);
  EXPECT_NE(warnings.find("damaged, and computed again: line 4"), std::string::npos) << warnings;
}

TEST_F(JournalFile, whatIsNoneIsNotUsed)
{
  for (const char *text : {"{}", "{\"case\": \"case\"}", "[1]", "null", "\n\n", "12345678 {}\n"}) {
    write(text);
    EXPECT_TRUE(loaded().empty()) << text;
    EXPECT_NE(warnings.find("it is not a journal"), std::string::npos) << warnings;
  }
  write("");
  EXPECT_TRUE(loaded().empty());
  EXPECT_NE(warnings.find("is empty; it is not used"), std::string::npos) << warnings;
}
