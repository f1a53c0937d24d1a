// SPDX-License-Identifier: GPL-2.0-or-later
// A full disk without privileges: preloaded into a program (LD_PRELOAD), it gives the folder
// FULL_DISK room for FULL_DISK_SIZE bytes in whole pages, as a tmpfs of that size has. What goes
// elsewhere, as the files of MPI do, does not meet it. Our programs and scripts write by write(2)
// only; the C library's own streams (fopen) would pass it by.
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <system_error>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t page = 4096;

std::size_t inPages(std::size_t bytes)
{
  return (bytes + page - 1) / page * page;
}

/// The file behind a descriptor; empty if there is none.
std::string fileOf(int descriptor)
{
  std::error_code none;
  return fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor), none).string();
}

/// Bytes that the files in a folder take.
std::size_t used(const std::string &folder)
{
  std::size_t sum = 0;
  std::error_code gone; // a file may be renamed or removed meanwhile
  for (auto at = fs::recursive_directory_iterator(folder, gone);
       at != fs::recursive_directory_iterator(); at.increment(gone)) {
    std::error_code none;
    const auto size = at->is_regular_file(none) ? at->file_size(none) : 0;
    sum += none ? 0 : inPages(size);
  }
  return sum;
}

/// How many bytes more can be put at the end of the file.
std::size_t roomOf(int descriptor, const std::string &folder, std::size_t size)
{
  struct stat status = {};
  if (::fstat(descriptor, &status) != 0)
    return 0;
  const auto length = static_cast<std::size_t>(status.st_size);
  const std::size_t taken = used(folder);
  return inPages(length) - length + (size > taken ? size - taken : 0);
}

} // namespace

extern "C" ssize_t write(int descriptor, const void *bytes, std::size_t count)
{
  const char *folder = std::getenv("FULL_DISK");
  const char *size = std::getenv("FULL_DISK_SIZE");
  if (folder && size && fileOf(descriptor).rfind(std::string(folder) + "/", 0) == 0) {
    const std::size_t room = roomOf(descriptor, folder, std::strtoull(size, nullptr, 10));
    if (count > 0 && room == 0) {
      errno = ENOSPC;
      return -1;
    }
    count = std::min(count, room);
  }
  return ::syscall(SYS_write, descriptor, bytes, count);
}
