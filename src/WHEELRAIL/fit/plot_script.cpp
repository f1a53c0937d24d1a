// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/plot_script.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

// NOLINTNEXTLINE(readability-redundant-declaration): POSIX declares it in no header
extern char **environ;

namespace wheelrail {

namespace {

constexpr const char *defaultPython = "/usr/bin/python3";

std::filesystem::path findScript(const std::string &name)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const auto folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const auto &place : {folder / name, folder.parent_path() / "share/mca-wheelrail" / name})
    if (fs::exists(place, error))
      return place;
  return {};
}

} // namespace

std::string runPlotScript(const std::string &name, const std::vector<std::string> &arguments)
{
  const auto script = findScript(name);
  if (script.empty())
    return name + " is not installed beside this program";
  const char *given = std::getenv("MCAWR_PYTHON");
  std::vector<std::string> words = {given && *given ? given : defaultPython, script.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
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

} // namespace wheelrail
