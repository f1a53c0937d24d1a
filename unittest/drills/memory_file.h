// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef DRILLS_MEMORY_FILE_H
#define DRILLS_MEMORY_FILE_H

#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

/// A file in memory: thousands of them are written in a second.
class MemoryFile {
 public:
  explicit MemoryFile(const char *name)
      : descriptor_(memfd_create(name, 0)), path("/proc/self/fd/" + std::to_string(descriptor_))
  {
    if (descriptor_ < 0)
      throw std::runtime_error("no file in memory");
  }
  /// \return its path, when it holds these bytes
  const std::string &holding(const std::string &bytes) const
  {
    if (ftruncate(descriptor_, 0) != 0 ||
        pwrite(descriptor_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("no space for a file in memory");
    return path;
  }

 private:
  int descriptor_;

 public:
  const std::string path;
};

#endif
