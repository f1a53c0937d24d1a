// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/output_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mcawr {
namespace {

namespace fs = std::filesystem;

constexpr mode_t readableByAll = 0666; // less the user's umask

bool writeAll(int descriptor, const std::string &content)
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
  return true;
}

bool isRegular(int descriptor)
{
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/// Adds to the end of a file of `size` bytes, all of it or nothing.
/// \return why not; empty: it is there
std::string whyNotAdded(int descriptor, off_t size, const std::string &text)
{
  if (writeAll(descriptor, text))
    return "";
  const int reason = errno;
  const bool isCut = isRegular(descriptor) && ::ftruncate(descriptor, size) != 0;
  ::lseek(descriptor, size, SEEK_SET);
  return std::strerror(reason) + std::string(isCut ? "; its last line is cut short" : "");
}

/// A file that is open for writing; a temporary one is removed unless it is renamed.
class OpenFile {
 public:
  OpenFile(const std::string &path, bool isTemporary)
      : name_(path),
        descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readableByAll)),
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
  bool write(const std::string &content) const { return writeAll(descriptor_, content); }
  /// Keeps a regular file from other writers; where the file system knows no locks, it does not.
  void lock() const
  {
    if (isRegular(descriptor_))
      ::flock(descriptor_, LOCK_EX | LOCK_NB);
  }
  /// On the disk, or refused by it.
  bool sync() const { return !temporary_ || ::fsync(descriptor_) == 0; } // a pipe cannot be synced
  bool close()
  {
    const bool synced = sync();
    return ::close(std::exchange(descriptor_, -1)) == 0 && synced;
  }
  bool renameTo(const std::string &target)
  {
    if (::rename(name_.c_str(), target.c_str()) != 0)
      return false;
    temporary_ = false;
    return true;
  }
  int release() { return std::exchange(descriptor_, -1); }
  void keep() { temporary_ = false; } ///< the temporary file stays

 private:
  std::string name_;
  int descriptor_;
  bool temporary_;
};

/// Where the content of `path` is written first.
std::string besideOf(const std::string &path)
{
  return path + ".part" + std::to_string(::getpid());
}

/// Where the links of `path` lead; `path` itself where it is none, or an open file by its name,
/// which a rename would not reach.
std::string followed(const std::string &path)
{
  constexpr int mostLinks = 40; // as the system's own
  std::error_code error;
  fs::path place = path;
  for (int k = 0; k < mostLinks && fs::is_symlink(place, error); ++k) {
    if (fs::absolute(place, error).string().rfind("/proc/", 0) == 0)
      return path;
    place = place.parent_path() / fs::read_symlink(place, error);
  }
  return place.string();
}

fs::path placeOf(const std::string &path)
{
  std::error_code error;
  const auto place = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::absolute(path) : place;
}

constexpr const char *otherWriter = "another fix or program writes this file";

/// Whether a GrowingFile has this file open.
bool isLocked(const std::string &path)
{
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored))
    return false;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    return false;
  const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

} // namespace

OutputError::OutputError(const std::string &path, const std::string &reason)
    : std::runtime_error(path + ": cannot write: " + reason)
{
}

OutputError::OutputError(const std::string &path, int reason)
    : OutputError(path, std::string(std::strerror(reason)))
{
}

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
    throw OutputError(path, EISDIR);
  // a pipe without a reader must not be opened: that would wait for one
  const std::string place = followed(path);
  const bool writable = isReplaced(place) ? OpenFile(besideOf(place), true).isOpen()
                                          : ::access(path.c_str(), W_OK) == 0 || errno == ENOENT;
  if (!writable)
    throw OutputError(path, errno);
}

void checkFolder(const std::string &path)
{
  if (!OpenFile(besideOf(path + "/.write-test"), true).isOpen())
    throw OutputError(path, errno);
}

bool isSameFile(const std::string &a, const std::string &b)
{
  std::error_code ignored;
  return placeOf(a) == placeOf(b) || fs::equivalent(a, b, ignored);
}

void writeOutputFile(const std::string &path, const std::string &content)
{
  if (isLocked(path))
    throw OutputError(path, otherWriter);
  const std::string place = followed(path);
  const bool replaced = isReplaced(place);
  OpenFile file(replaced ? besideOf(place) : path, replaced);
  if (!file.isOpen() || !file.write(content) || !file.close() ||
      (replaced && !file.renameTo(place)))
    throw OutputError(path, errno);
}

bool appendToFile(const std::string &path, std::size_t size, const std::string &text)
{
  std::error_code error;
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) != size)
    return false;
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0)
    return false;
  const std::string problem = whyNotAdded(descriptor, static_cast<off_t>(size), text);
  ::close(descriptor);
  if (!problem.empty())
    throw OutputError(path, problem);
  return true;
}

OutputFiles::~OutputFiles()
{
  for (const File &file : files_)
    for (const std::string &name : {file.beside, file.before})
      if (!name.empty())
        ::unlink(name.c_str());
}

void OutputFiles::add(const std::string &path, const std::string &content)
{
  if (isLocked(path))
    throw OutputError(path, otherWriter);
  const std::string place = followed(path);
  if (!isReplaced(place)) {
    direct_.push_back({path, content});
    return;
  }
  std::error_code ignored;
  File file{path, place, besideOf(place), "", !fs::exists(place, ignored)};
  OpenFile beside(file.beside, true);
  if (!beside.isOpen() || !beside.write(content) || !beside.close())
    throw OutputError(path, errno);
  beside.keep();
  files_.push_back(std::move(file));
}

void OutputFiles::commit()
{
  for (const Direct &direct : direct_)
    writeOutputFile(direct.path, direct.content);
  direct_.clear();
  for (std::size_t k = 0; k < files_.size(); ++k)
    try {
      putInPlace(files_[k]);
    } catch (...) {
      undo(k);
      throw;
    }
  for (const File &file : files_)
    if (!file.before.empty())
      ::unlink(file.before.c_str());
  files_.clear();
}

void OutputFiles::putInPlace(File &file)
{
  // a second name keeps the old content; where the file system has none, a rename that fails after
  // others have gone through cannot be taken back
  const std::string before = file.beside + ".before";
  if (!file.isNew && ::link(file.place.c_str(), before.c_str()) == 0)
    file.before = before;
  if (::rename(file.beside.c_str(), file.place.c_str()) != 0)
    throw OutputError(file.path, errno);
  file.beside.clear();
}

void OutputFiles::undo(std::size_t placed)
{
  for (std::size_t k = 0; k < placed; ++k) {
    File &file = files_[k];
    if (file.isNew)
      ::unlink(file.place.c_str());
    else if (!file.before.empty())
      ::rename(std::exchange(file.before, "").c_str(), file.place.c_str());
  }
}

GrowingFile::~GrowingFile()
{
  close();
}

void GrowingFile::close()
{
  if (isOpen())
    ::close(std::exchange(descriptor_, -1));
}

void GrowingFile::begin(const std::string &path, const std::string &content)
{
  close();
  if (isLocked(path))
    throw OutputError(path, otherWriter);
  const std::string place = followed(path);
  const bool replaced = isReplaced(place);
  OpenFile file(replaced ? besideOf(place) : path, replaced);
  if (file.isOpen())
    file.lock(); // before it has its name
  if (!file.isOpen() || !file.write(content) || !file.sync() || (replaced && !file.renameTo(place)))
    throw OutputError(path, errno);
  path_ = path;
  descriptor_ = file.release();
}

void GrowingFile::append(const std::string &text)
{
  struct stat ours = {}, there = {};
  ::fstat(descriptor_, &ours);
  const bool isMoved = ::stat(path_.c_str(), &there) == 0 &&
                       (there.st_ino != ours.st_ino || there.st_dev != ours.st_dev);
  const bool isChanged = ours.st_size != ::lseek(descriptor_, 0, SEEK_CUR);
  if (S_ISREG(ours.st_mode) && (isMoved || isChanged))
    throw OutputError(path_, otherWriter);
  const std::string problem = whyNotAdded(descriptor_, ours.st_size, text);
  if (!problem.empty())
    throw OutputError(path_, problem);
}

} // namespace mcawr
