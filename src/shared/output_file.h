// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_OUTPUT_FILE_H
#define MCAWR_SHARED_OUTPUT_FILE_H

#include <stdexcept>
#include <string>
#include <vector>

/// The one way in which C++ of this project writes files. A regular file, or the one that a link
/// leads to, appears whole or not at all: a temporary file beside it, fsync, rename. A device, a
/// pipe or an open file by its name (/dev/stdout) is written into instead: a file renamed over it
/// would take its place.
namespace mcawr {

/// "PATH: cannot write: REASON", REASON by the system.
class OutputError : public std::runtime_error {
 public:
  /// \param reason  an errno
  OutputError(const std::string &path, int reason);
  /// \param reason  in words
  OutputError(const std::string &path, const std::string &reason);
};

/// Writes a file whole. Whatever stood under `path` before stays untouched until the new content is
/// safely on disk.
/// \throw OutputError  also where a GrowingFile is open there; the temporary file is removed
void writeOutputFile(const std::string &path, const std::string &content);

/// Adds to the end of a regular file that this process has written, all of it or, on a full disk,
/// nothing. A program that is killed may leave a part of it.
/// \param size  that the file has
/// \return false where the file has another size, is gone or cannot be opened: nothing is added
/// \throw OutputError
bool appendToFile(const std::string &path, std::size_t size, const std::string &text);

/// Several files that appear together or not at all: `add` them, then `commit`. What was added and
/// not committed leaves no trace.
/// A device or a pipe is written into by `commit`, before any file is in its place. What a reader
/// has got from it cannot be taken back.
class OutputFiles {
 public:
  OutputFiles() = default;
  OutputFiles(const OutputFiles &) = delete;
  OutputFiles &operator=(const OutputFiles &) = delete;
  ~OutputFiles();

  /// Writes the content to the disk, beside `path`; nothing of it is kept in memory.
  /// \throw OutputError
  void add(const std::string &path, const std::string &content);

  /// Puts all of them in place, in the order in which they were added.
  /// \throw OutputError  every file is what it was before, a new one is not there
  void commit();

 private:
  /// `place` is where `path` leads. `beside` holds the new content until it is renamed, `before` is
  /// another name of the old one.
  struct File {
    std::string path, place, beside, before;
    bool isNew;
  };
  struct Direct {
    std::string path, content;
  };
  void putInPlace(File &file);
  void undo(std::size_t placed);

  std::vector<File> files_;
  std::vector<Direct> direct_; ///< written into
};

/// To be called before a long computation; changes nothing.
/// \throw OutputError  `path` cannot be written
void checkWritable(const std::string &path);

/// Checks that files can be made in a folder that is there.
/// \throw OutputError
void checkFolder(const std::string &path);

/// Whether both names lead to the same file on the disk, or would.
bool isSameFile(const std::string &a, const std::string &b);

/// Whether a file may be renamed over `path`, or to it: a regular file, or nothing yet.
bool isReplaced(const std::string &path);

/// A file that begins whole and then grows, by one writer at a time: a regular file is locked
/// (flock) as long as it is open.
class GrowingFile {
 public:
  GrowingFile() = default;
  GrowingFile(const GrowingFile &) = delete;
  GrowingFile &operator=(const GrowingFile &) = delete;
  ~GrowingFile();

  /// Writes `content` as writeOutputFile() does, and stays open; closes what was open before.
  /// \throw OutputError  also where another GrowingFile, here or in another program, has the file
  ///                     open; nothing changes then
  void begin(const std::string &path, const std::string &content);

  /// Adds to the end, all of it or, on a full disk, nothing.
  /// \throw OutputError  also where somebody else has changed or replaced the file
  void append(const std::string &text);

  bool isOpen() const { return descriptor_ >= 0; }
  void close();

 private:
  std::string path_;
  int descriptor_ = -1;
};

} // namespace mcawr
#endif
