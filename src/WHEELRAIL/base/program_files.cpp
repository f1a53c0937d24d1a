// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/program_files.h"

#include "base/errors.h"
#include "shared/output_file.h"
#include "shared/printable.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace wheelrail {
namespace {

namespace fs = std::filesystem;

/// Does what may fail with the system's reason.
template<class Action>
void orIoError(Action &&action)
{
  try {
    action();
  } catch (const mcawr::OutputError &error) {
    throw Error(ExitCode::Io, error.what());
  }
}

} // namespace

std::string readInputFile(const std::string &path)
{
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw badInput(path, 0, "",
                   fs::is_symlink(path, ignored) ? "is a link that leads to no file"
                                                 : "no such file");
  if (fs::is_directory(path, ignored))
    throw badInput(path, 0, "", "is a folder, not a file");
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (in.bad() || (!in.is_open()))
    throw badInput(path, 0, "", "cannot be read");
  if (text.str().empty())
    throw badInput(path, 0, "", "is empty");
  return text.str();
}

void writeOutputFile(const std::string &path, const std::string &content)
{
  orIoError([&] { mcawr::writeOutputFile(path, content); });
}

void writeStandardOutput(const std::string &text)
{
  const std::string shown = mcawr::printableLines(text);
  if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size() ||
      std::fflush(stdout) != 0)
    orIoError([] { throw mcawr::OutputError("standard output", errno); });
}

void checkOutputs(const std::vector<RequestedOutput> &outputs,
                  const std::vector<std::string> &inputs)
{
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    for (const auto &input : inputs)
      if (mcawr::isSameFile(output->path, input))
        throw Error(ExitCode::Usage, fmt::format("{}: {} is an input, it would be overwritten",
                                                 output->option, output->path));
    for (auto other = outputs.begin(); other != output; ++other)
      if (mcawr::isSameFile(output->path, other->path))
        throw Error(ExitCode::Usage, fmt::format("{}: {} is also the file of {}", output->option,
                                                 output->path, other->option));
  }
  for (const auto &output : outputs)
    orIoError([&] { mcawr::checkWritable(output.path); });
}

void prepareOutputFolder(const std::string &path)
{
  std::error_code reason;
  fs::create_directories(path, reason);
  orIoError([&] {
    if (reason)
      throw mcawr::OutputError(path, reason.value());
    mcawr::checkFolder(path);
  });
}

} // namespace wheelrail
