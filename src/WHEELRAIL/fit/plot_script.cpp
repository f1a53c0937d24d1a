// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/plot_script.h"

#include "shared/output_file.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

// NOLINTNEXTLINE(readability-redundant-declaration): POSIX declares it in no header
extern char **environ;

namespace wheelrail {

namespace {

constexpr const char *defaultPython = "/usr/bin/python3";

/// A file in memory, which a child inherits under the same name.
class MemoryFile {
 public:
  /// \param what a name for those who look at the open files
  explicit MemoryFile(const char *what) : descriptor_(::memfd_create(what, 0)) {}
  MemoryFile(const MemoryFile &) = delete;
  MemoryFile &operator=(const MemoryFile &) = delete;
  ~MemoryFile() { ::close(descriptor_); }
  std::string name() const { return fmt::format("/proc/self/fd/{}", descriptor_); }
  std::string content() const
  {
    std::string bytes;
    std::array<char, 1 << 16> part = {};
    ssize_t n = 0;
    while ((n = ::pread(descriptor_, part.data(), part.size(), static_cast<off_t>(bytes.size()))) >
           0)
      bytes.append(part.data(), static_cast<std::size_t>(n));
    return bytes;
  }

 private:
  int descriptor_;
};

std::filesystem::path findScript(const std::string &name)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const auto folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const auto &place :
       {folder / name, folder.parent_path() / "share/mca-wheelrail/tools" / name})
    if (fs::exists(place, error))
      return place;
  return {};
}

/// Runs a program to its end. \return what went wrong; empty: nothing
std::string run(std::vector<std::string> words, const std::string &name)
{
  std::vector<char *> argv;
  for (auto &word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ);
  if (error != 0)
    return fmt::format("cannot run {}: {}", words[0], std::strerror(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      return fmt::format("{}: {}", name, std::strerror(errno));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    return "";
  return WIFEXITED(status) ? fmt::format("{} ended with exit code {}", name, WEXITSTATUS(status))
                           : fmt::format("{} was killed by signal {}", name, WTERMSIG(status));
}

} // namespace

Picture makePicture(const std::string &name, const std::string &json, const std::string &ending)
{
  const auto script = findScript(name);
  if (script.empty())
    return {"", name + " is not installed beside this program"};
  const char *given = std::getenv("MCAWR_PYTHON");
  const MemoryFile data("data"), picture("picture");
  try {
    mcawr::writeOutputFile(data.name(), json);
  } catch (const mcawr::OutputError &error) {
    return {"", error.what()};
  }
  std::vector<std::string> words = {given && *given ? given : defaultPython, script.string(),
                                    data.name(), "-o", picture.name()};
  if (ending.size() > 1)
    words.insert(words.end(), {"--format", ending.substr(1)});
  const std::string problem = run(words, name);
  return {problem.empty() ? picture.content() : "", problem};
}

} // namespace wheelrail
