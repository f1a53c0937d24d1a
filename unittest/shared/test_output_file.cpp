// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/output_file.h"

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <csignal>

using namespace mcawr;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {
class SharedOutputFile : public testing::Test {
 protected:
  void SetUp() override
  {
    folder =
        fs::temp_directory_path() / ("mcawr-output-" + std::to_string(::getpid()) + "-" +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string path(const std::string &name) const { return (folder / name).string(); }
  static std::string text(const std::string &path)
  {
    std::ifstream in(path);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  long entries() const
  {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }
  fs::path folder;
};

template<class Action>
std::string problemOf(Action &&action)
{
  try {
    action();
  } catch (const OutputError &error) {
    return error.what();
  }
  return "";
}
} // namespace

TEST_F(SharedOutputFile, ReplacesRegularFilesOnly)
{
  writeOutputFile(path("a"), "first");
  writeOutputFile(path("a"), "second");
  EXPECT_EQ(text(path("a")), "second");
  fs::create_symlink(path("a"), path("link"));
  writeOutputFile(path("link"), "third");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(text(path("a")), "third");
  EXPECT_EQ(problemOf([&] { writeOutputFile(path("no/a"), "x"); }),
            path("no/a") + ": cannot write: No such file or directory");
  EXPECT_NE(problemOf([&] { writeOutputFile(folder, "x"); }), "");
  EXPECT_EQ(entries(), 2);
}

TEST_F(SharedOutputFile, ALinkThatCannotBeWrittenKeepsItsFile)
{
  writeOutputFile(path("a"), "whole");
  fs::create_symlink("a", path("link"));
  struct rlimit limit = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const struct rlimit small = {8, limit.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string problem = problemOf([&] { writeOutputFile(path("link"), "more than fits"); });
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(problem, path("link") + ": cannot write: File too large");
  EXPECT_EQ(text(path("a")), "whole");
  EXPECT_EQ(entries(), 2);
}

TEST_F(SharedOutputFile, SeveralFilesAppearTogether)
{
  writeOutputFile(path("old"), "old");
  {
    OutputFiles files;
    files.add(path("old"), "new");
    files.add(path("new"), "new");
    EXPECT_EQ(text(path("old")), "old");
    EXPECT_FALSE(fs::exists(path("new")));
    files.commit();
  }
  EXPECT_EQ(text(path("old")), "new");
  EXPECT_EQ(text(path("new")), "new");
  EXPECT_EQ(entries(), 2);
  {
    OutputFiles files; // added and not committed
    files.add(path("old"), "newer");
  }
  EXPECT_EQ(text(path("old")), "new");
  EXPECT_EQ(entries(), 2);
}

TEST_F(SharedOutputFile, SeveralFilesAppearNotAtAll)
{
  writeOutputFile(path("old"), "old");
  const auto isAsBefore = [&] {
    EXPECT_EQ(text(path("old")), "old");
    EXPECT_FALSE(fs::exists(path("new")));
  };
  {
    OutputFiles files;
    files.add(path("new"), "new");
    EXPECT_NE(problemOf([&] { files.add(path("missing/b"), "new"); }), "");
  }
  isAsBefore();
  {
    OutputFiles files; // a rename that fails after two have gone through
    for (const char *name : {"old", "new", "taken"})
      files.add(path(name), "new");
    fs::create_directories(folder / "taken");
    EXPECT_EQ(problemOf([&] { files.commit(); }), path("taken") + ": cannot write: Is a directory");
  }
  isAsBefore();
  {
    OutputFiles files; // a device that takes nothing
    files.add(path("old"), "new");
    files.add("/dev/full", "new");
    EXPECT_EQ(problemOf([&] { files.commit(); }),
              "/dev/full: cannot write: No space left on device");
  }
  isAsBefore();
  EXPECT_EQ(entries(), 2); // old, taken
}

TEST_F(SharedOutputFile, GrowsWhereItIs)
{
  GrowingFile file;
  EXPECT_FALSE(file.isOpen());
  EXPECT_EQ(problemOf([&] { file.begin(path("no/a"), "x"); }),
            path("no/a") + ": cannot write: No such file or directory");
  writeOutputFile(path("a"), "old and long");
  file.begin(path("a"), "head\n");
  EXPECT_EQ(text(path("a")), "head\n");
  file.append("row\n");
  EXPECT_EQ(text(path("a")), "head\nrow\n");
  fs::create_symlink(path("a"), path("link"));
  file.close();
  file.begin(path("link"), "new\n");
  file.append("row\n");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(text(path("a")), "new\nrow\n");
  EXPECT_EQ(entries(), 2);
}

TEST_F(SharedOutputFile, GrowsThroughAPipeThatStaysOne)
{
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  GrowingFile file;
  file.begin(path("pipe"), "head\n");
  file.append("row\n");
  char got[20] = "";
  EXPECT_EQ(::read(reader, got, sizeof got), 9);
  EXPECT_STREQ(got, "head\nrow\n");
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(SharedOutputFile, ADeviceStaysADeviceAndHasManyWriters)
{
  const std::string node = path("null");
  if (::mknod(node.c_str(), S_IFCHR | 0600, makedev(1, 3)) != 0 || !std::ofstream(node)) {
    fs::remove(node); // only root makes devices, and not everywhere: the system's own, by a link
    fs::create_symlink("/dev/null", node);
  }
  GrowingFile one, other;
  one.begin(node, "head\n");
  other.begin(node, "head\n");
  one.append("row\n");
  writeOutputFile(node, "whole");
  EXPECT_TRUE(fs::is_character_file(node));
  EXPECT_EQ(entries(), 1);
}

TEST_F(SharedOutputFile, HasOneWriterByWhateverName)
{
  GrowingFile one, other;
  one.begin(path("a"), "one\n");
  fs::create_symlink(path("a"), path("link"));
  fs::create_hard_link(path("a"), path("hard"));
  for (const char *name : {"a", "link", "hard"})
    for (const bool grows : {true, false})
      EXPECT_THAT(problemOf([&] {
                    grows ? other.begin(path(name), "other\n") : writeOutputFile(path(name), "x");
                  }),
                  HasSubstr("another fix or program writes this file"));
  EXPECT_FALSE(other.isOpen());
  one.append("row\n");
  EXPECT_EQ(text(path("a")), "one\nrow\n");
  one.close();
  other.begin(path("a"), "other\n");
  EXPECT_EQ(text(path("a")), "other\n");
}

TEST_F(SharedOutputFile, DoesNotGrowBehindAnotherFileOfItsName)
{
  GrowingFile file;
  file.begin(path("a"), "head\n");
  std::ofstream(path("b")) << "somebody else's\n";
  fs::rename(path("b"), path("a"));
  EXPECT_THAT(problemOf([&] { file.append("row\n"); }), HasSubstr("another fix or program"));
  EXPECT_EQ(text(path("a")), "somebody else's\n");
  file.close();
  file.begin(path("a"), "head\n");
  fs::resize_file(path("a"), 0); // what a dump of that name does
  EXPECT_THAT(problemOf([&] { file.append("row\n"); }), HasSubstr("another fix or program"));
}

TEST_F(SharedOutputFile, AFullDiskLeavesNoCutLine)
{
  GrowingFile file;
  file.begin(path("a"), "head\n");
  struct rlimit limit = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const struct rlimit small = {8, limit.rlim_max};
  std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string problem = problemOf([&] { file.append("a row\n"); });
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(problem, path("a") + ": cannot write: File too large");
  EXPECT_EQ(text(path("a")), "head\n");
}
