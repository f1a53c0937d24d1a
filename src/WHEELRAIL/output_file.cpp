#include "output_file.h"

#include "errors.h"

#include <cerrno>
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

/// A file descriptor that removes its file unless told to keep it.
class TemporaryFile {
 public:
  TemporaryFile(const std::string &path) : name(path)
  {
    descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  }
  TemporaryFile(const TemporaryFile &) = delete;
  TemporaryFile &operator=(const TemporaryFile &) = delete;
  ~TemporaryFile()
  {
    if (descriptor >= 0)
      ::close(descriptor);
    if (!name.empty())
      ::unlink(name.c_str());
  }
  bool isOpen() const { return descriptor >= 0; }
  bool write(const std::string &content)
  {
    std::size_t done = 0;
    while (done < content.size()) {
      const ssize_t n = ::write(descriptor, content.data() + done, content.size() - done);
      if (n < 0 && errno == EINTR)
        continue;
      if (n <= 0)
        return false;
      done += static_cast<std::size_t>(n);
    }
    return ::fsync(descriptor) == 0;
  }
  bool renameTo(const std::string &target)
  {
    const int closed = ::close(descriptor);
    descriptor = -1;
    if (closed != 0 || ::rename(name.c_str(), target.c_str()) != 0)
      return false;
    name.clear();
    return true;
  }

 private:
  std::string name;
  int descriptor;
};

} // namespace

std::string readInputFile(const std::string &path)
{
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw badInput(path, 0, "", "no such file");
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
  TemporaryFile file(fmt::format("{}.part{}", path, ::getpid()));
  if (!file.isOpen())
    failWriting(path, errno);
  if (!file.write(content))
    failWriting(path, errno);
  if (!file.renameTo(path))
    failWriting(path, errno);
}

void prepareOutputFolder(const std::string &path)
{
  std::error_code reason;
  fs::create_directories(path, reason);
  if (reason)
    failWriting(path, reason.value());
  const std::string probe = fmt::format("{}/.write-test.{}", path, ::getpid());
  if (!TemporaryFile(probe).isOpen())
    failWriting(path, errno);
}

} // namespace wheelrail
