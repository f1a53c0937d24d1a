// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/output_file.h"

#include "base/errors.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace wheelrail {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWriting(const std::string &path, int reason)
{
  throw Error(ExitCode::Io, fmt::format("{}: cannot write: {}", path, std::strerror(reason)));
}

/// A file that is open for writing; a temporary one is removed unless it is renamed.
class OpenFile {
 public:
  OpenFile(const std::string &path, bool isTemporary)
      : name_(path),
        descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)),
        temporary_(isTemporary && descriptor_ >= 0)
  {
  }
  OpenFile(const OpenFile &) = delete;
  OpenFile &operator=(const OpenFile &) = delete;
  ~OpenFile()
  {
    if (descriptor_ >= 0)
      ::close(descriptor_);
    if (temporary_)
      ::unlink(name_.c_str());
  }
  bool isOpen() const { return descriptor_ >= 0; }
  bool write(const std::string &content) const
  {
    std::size_t done = 0;
    while (done < content.size()) {
      const ssize_t n = ::write(descriptor_, content.data() + done, content.size() - done);
      if (n < 0 && errno == EINTR)
        continue;
      if (n <= 0)
        return false;
      done += static_cast<std::size_t>(n);
    }
    return true;
  }
  /// On the disk, or refused by it.
  bool close()
  {
    const bool synced = !temporary_ || ::fsync(descriptor_) == 0; // a pipe cannot be synced
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    return synced && closed == 0;
  }
  bool renameTo(const std::string &target)
  {
    if (::rename(name_.c_str(), target.c_str()) != 0)
      return false;
    temporary_ = false;
    return true;
  }

 private:
  std::string name_;
  int descriptor_;
  bool temporary_;
};

/// Where the content of `path` is written first.
std::string besideOf(const std::string &path)
{
  return fmt::format("{}.part{}", path, ::getpid());
}

/// Whether a file may be renamed over `path`, or to it.
bool isReplaced(const std::string &path)
{
  std::error_code ignored;
  const auto type = fs::symlink_status(path, ignored).type();
  return type == fs::file_type::regular || type == fs::file_type::not_found;
}

void checkWritable(const std::string &path)
{
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    failWriting(path, EISDIR);
  // a pipe without a reader must not be opened: that would wait for one
  const bool writable = isReplaced(path) ? OpenFile(besideOf(path), true).isOpen()
                                         : ::access(path.c_str(), W_OK) == 0 || errno == ENOENT;
  if (!writable)
    failWriting(path, errno);
}

fs::path placeOf(const std::string &path)
{
  std::error_code error;
  const auto place = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::absolute(path) : place;
}

bool sameFile(const std::string &a, const std::string &b)
{
  std::error_code ignored;
  return placeOf(a) == placeOf(b) || fs::equivalent(a, b, ignored);
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
  const bool replaced = isReplaced(path);
  OpenFile file(replaced ? besideOf(path) : path, replaced);
  if (!file.isOpen() || !file.write(content) || !file.close() || (replaced && !file.renameTo(path)))
    failWriting(path, errno);
}

void writeStandardOutput(const std::string &text)
{
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    failWriting("standard output", errno);
}

void checkOutputs(const std::vector<RequestedOutput> &outputs,
                  const std::vector<std::string> &inputs)
{
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    for (const auto &input : inputs)
      if (sameFile(output->path, input))
        throw Error(ExitCode::Usage, fmt::format("{}: {} is an input, it would be overwritten",
                                                 output->option, output->path));
    for (auto other = outputs.begin(); other != output; ++other)
      if (sameFile(output->path, other->path))
        throw Error(ExitCode::Usage, fmt::format("{}: {} is the file of {} too", output->option,
                                                 output->path, other->option));
  }
  for (const auto &output : outputs)
    checkWritable(output.path);
}

void prepareOutputFolder(const std::string &path)
{
  std::error_code reason;
  fs::create_directories(path, reason);
  if (reason)
    failWriting(path, reason.value());
  if (!OpenFile(fmt::format("{}/.write-test.{}", path, ::getpid()), true).isOpen())
    failWriting(path, errno);
}

} // namespace wheelrail
