#include "errors.h"
#include "output_file.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
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

TEST_F(OutputFile, RefusesAFolderThatIsAFile)
{
  writeOutputFile(path("file"), "x");
  EXPECT_EQ(codeOf([&] { prepareOutputFolder(path("file")); }), ExitCode::Io);
  EXPECT_EQ(codeOf([&] { prepareOutputFolder(path("file/below")); }), ExitCode::Io);
  EXPECT_NO_THROW(prepareOutputFolder(path("new/below")));
}

TEST_F(OutputFile, RefusesMissingEmptyAndFolderInput)
{
  std::ofstream(path("empty"));
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
