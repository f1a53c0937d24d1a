// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/program.h"

#include "base/errors.h"
#include "base/program_files.h"
#include "shared/nearest_word.h"
#include "shared/output_file.h"
#include "shared/printable.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <new>
#include <unistd.h>

namespace wheelrail {
namespace {

/// A file that is opened gets the lowest free number: one of a closed stream would take what is
/// printed. Reading from the stand-in of stdin ends at once, writing into that of stdout fails.
void openClosedStreams()
{
  const int modes[] = {O_RDONLY, O_RDONLY, O_WRONLY};
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1)
      ::open("/dev/null", modes[stream]);
}

const char *programOfAbort = "";

/// A library that ends the program itself, as FFTW does where a transform gets no memory, has said
/// why; this is the line and the exit code of ours. Only calls that a signal allows.
void endOfAbort(int)
{
  const char *const parts[] = {programOfAbort,
                               ": not enough memory, or a fault of a library: ended by abort()\n"};
  for (const char *part : parts)
    if (::write(STDERR_FILENO, part, std::strlen(part)) < 0)
      break;
  ::_exit(static_cast<int>(ExitCode::Internal));
}

/// What to say of arguments that are left over: the nearest option there is.
std::string unknownOption(const CLI::App &app, const char *extra)
{
  std::vector<std::string> known;
  for (const auto *option : app.get_options())
    for (const auto &name : option->get_lnames())
      known.push_back("--" + name);
  for (const auto &given : app.remaining())
    if (given.substr(0, 1) == "-")
      return mcawr::unknownWord("option", given, known);
  return extra;
}

int usageError(const CLI::App &app, const std::string &problem)
{
  complain(app.get_name().c_str(), fmt::format("{}; see {} --help", problem, app.get_name()));
  return static_cast<int>(ExitCode::Usage);
}

} // namespace

void complain(const char *name, const std::string &text) noexcept
{
  try {
    const std::string line = fmt::format("{}: {}\n", name, mcawr::printable(text));
    std::fwrite(line.data(), 1, line.size(), stderr);
  } catch (...) { // no memory for the line
    std::fputs(name, stderr);
    std::fputs(": not enough memory\n", stderr);
  }
  std::fflush(stderr);
}

int runProgram(const char *name, int (*body)(int, char **), int argc, char **argv) noexcept
{
  openClosedStreams();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  programOfAbort = name;
  std::signal(SIGABRT, endOfAbort);
  ExitCode code = ExitCode::Internal;
  try {
    return body(argc, argv);
  } catch (const Error &error) {
    complain(name, error.what());
    code = error.code();
  } catch (const mcawr::OutputError &error) {
    complain(name, error.what());
    code = ExitCode::Io;
  } catch (const std::bad_alloc &) {
    complain(name, "not enough memory");
  } catch (const std::exception &error) {
    complain(name, std::string("internal error: ") + error.what());
  } catch (...) {
    complain(name, "internal error of an unknown kind");
  }
  return static_cast<int>(code);
}

std::optional<int> parseCommandLine(CLI::App &app, int argc, char **argv, const char *extra)
{
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::CallForHelp &) {
    writeStandardOutput(app.help());
    return static_cast<int>(ExitCode::Ok);
  } catch (const CLI::CallForVersion &) {
    writeStandardOutput(app.version() + "\n");
    return static_cast<int>(ExitCode::Ok);
  } catch (const CLI::ExtrasError &) {
    return usageError(app, unknownOption(app, extra));
  } catch (const CLI::ParseError &error) {
    return usageError(app, error.what());
  }
}

CLI::Validator wholeNumberOption(int low, int high)
{
  const std::string range = fmt::format("from {} to {}", low, high);
  const auto check = [=](const std::string &given) -> std::string {
    constexpr std::size_t mostDigits = 9; // of any int
    const bool isWhole = !given.empty() && given.size() <= mostDigits && given[0] != '0' &&
                         given.find_first_not_of("0123456789") == std::string::npos;
    if (isWhole && std::stoi(given) >= low && std::stoi(given) <= high)
      return "";
    return fmt::format("'{}' is not allowed, must be a whole number {}", given, range);
  };
  return CLI::Validator(check, range);
}

CLI::Validator nameOption()
{
  const auto check = [](const std::string &given) -> std::string {
    return given.empty() ? "'' is not allowed, must be a name" : "";
  };
  return CLI::Validator(check, "");
}

} // namespace wheelrail
