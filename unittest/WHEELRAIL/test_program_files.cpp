// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/program_files.h"

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace wheelrail;
namespace fs = std::filesystem;

namespace {
class OutputFile : public testing::Test {
 protected:
  void SetUp() override
  {
    folder = fs::temp_directory_path() / ("wheelrail-output-" + std::to_string(::getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string path(const std::string &name) const { return (folder / name).string(); }
  fs::path folder;
};

ExitCode codeOf(const std::function<void()> &action)
{
  try {
    action();
  } catch (const Error &error) {
    return error.code();
  }
  return ExitCode::Ok;
}
} // namespace

TEST_F(OutputFile, WritesAndReplacesWithoutLeavingParts)
{
  writeOutputFile(path("a.csv"), "first\n");
  writeOutputFile(path("a.csv"), "second\n");
  EXPECT_EQ(readInputFile(path("a.csv")), "second\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(OutputFile, FailsWithIoErrorAndLeavesNothing)
{
  fs::create_directories(folder / "taken"); // renaming a file over a folder fails, even for root
  EXPECT_EQ(codeOf([&] { writeOutputFile(path("taken"), "x"); }), ExitCode::Io);
  EXPECT_EQ(codeOf([&] { writeOutputFile(path("missing/a.csv"), "x"); }), ExitCode::Io);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(OutputFile, WritesIntoPipesAndLinksInsteadOfReplacingThem)
{
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  writeOutputFile(path("pipe"), "through");
  char text[20] = "";
  EXPECT_EQ(::read(reader, text, sizeof text), 7);
  ::close(reader);
  EXPECT_STREQ(text, "through");
  EXPECT_TRUE(fs::is_fifo(path("pipe")));

  fs::create_symlink(path("real"), path("link"));
  writeOutputFile(path("link"), "first, and longer");
  writeOutputFile(path("link"), "second");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(readInputFile(path("real")), "second");
}

TEST_F(OutputFile, OutputsAreCheckedBeforeAnythingIsWritten)
{
  writeOutputFile(path("log"), "data");
  fs::create_hard_link(path("log"), path("other-name"));
  fs::create_directories(folder / "below");
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0); // has no reader: must not be waited for
  const auto check = [&](const std::vector<std::string> &names) {
    std::vector<RequestedOutput> outputs;
    for (const auto &name : names)
      outputs.push_back({"--option", path(name)});
    return codeOf([&] { checkOutputs(outputs, {path("log")}); });
  };
  EXPECT_EQ(check({"a", "b", "pipe"}), ExitCode::Ok);
  EXPECT_EQ(check({"log"}), ExitCode::Usage);
  EXPECT_EQ(check({"below/../log"}), ExitCode::Usage);
  EXPECT_EQ(check({"other-name"}), ExitCode::Usage);
  EXPECT_EQ(check({"a", "b", "below/../a"}), ExitCode::Usage);
  EXPECT_EQ(check({"a", "missing/b"}), ExitCode::Io);
  EXPECT_EQ(check({"below"}), ExitCode::Io);
  EXPECT_EQ(readInputFile(path("log")), "data");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 4);
}

TEST_F(OutputFile, RefusesAFolderThatIsAFile)
{
  writeOutputFile(path("file"), "x");
  EXPECT_EQ(codeOf([&] { prepareOutputFolder(path("file")); }), ExitCode::Io);
  EXPECT_EQ(codeOf([&] { prepareOutputFolder(path("file/below")); }), ExitCode::Io);
  EXPECT_NO_THROW(prepareOutputFolder(path("new/below")));
}

TEST_F(OutputFile, RefusesMissingEmptyAndFolderInput)
{
  std::ofstream{path("empty")}.close();
  EXPECT_EQ(codeOf([&] { readInputFile(path("none")); }), ExitCode::BadInput);
  EXPECT_EQ(codeOf([&] { readInputFile(path("empty")); }), ExitCode::BadInput);
  EXPECT_EQ(codeOf([&] { readInputFile(folder.string()); }), ExitCode::BadInput);
}

TEST(Errors, NamesFileLineAndKeyword)
{
  const Error error = badInput("case.yaml", 7, "points", "'x' is not a whole number");
  EXPECT_STREQ(error.what(), "case.yaml:7: points: 'x' is not a whole number");
  EXPECT_EQ(error.line(), 7);
  EXPECT_EQ(error.keyword(), "points");
}
