// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/log_archive.h"

#include "base/archive_reader.h"
#include "base/errors.h"
#include "base/program_files.h"
#include "shared/friction_log_format.h"

#include <algorithm>
#include <archive_entry.h>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <set>
#include <string_view>

namespace wheelrail {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t mebibyte = std::size_t(1) << 20;
constexpr std::size_t largest = 256;  // MiB; tools/mcawr/archive.py has the same
constexpr std::size_t endMark = 1024; // zero bytes at the end of every tar file

/// The tar file, unpacked to its end, where xz has its checksums.
std::string unpackXz(const std::string &path)
{
  constexpr std::string_view magic = "\xFD\x37zXZ";
  const std::string packed = readInputFile(path);
  if (packed.compare(0, magic.size(), magic) != 0)
    throw cannotUnpack(path, "is not compressed by xz");
  ArchiveReader reader(path, packed, ArchiveReader::Kind::Xz);
  reader.next();
  std::string tar;
  if (!reader.append(tar, largest * mebibyte))
    throw cannotUnpack(path, fmt::format("holds more than {} MiB: pack fewer runs into one, or "
                                         "more rows into one (--rows)",
                                         largest));
  return tar;
}

/// Whether a member is a regular file with a plain name: whatever else one may call itself or
/// point to, it is nothing of ours.
bool isPlain(archive_entry *entry)
{
  const char *name = archive_entry_pathname(entry);
  if (!name || archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry))
    return false;
  const std::string text = name;
  return !text.empty() && text != "." && text != ".." && text.find('/') == std::string::npos;
}

/// Whether nothing but zeros stands behind the mark that ends a tar file: a second archive that was
/// joined to it would be passed over.
bool endsOnce(const std::string &tar)
{
  constexpr std::size_t block = 512, sizeAt = 124, sizeLength = 12; // of ustar's heads
  std::size_t at = 0;
  while (at + block <= tar.size() && tar[at] != '\0') {
    const std::size_t size = std::strtoull(tar.substr(at + sizeAt, sizeLength).c_str(), nullptr, 8);
    if (size > tar.size())
      return false;
    at += block * (1 + (size + block - 1) / block);
  }
  return at <= tar.size() && std::all_of(tar.begin() + static_cast<std::ptrdiff_t>(at), tar.end(),
                                         [](char c) { return c == '\0'; });
}

} // namespace

bool isLogArchive(const std::string &path)
{
  const std::string ending = archiveEnding;
  std::error_code ignored;
  return path.size() >= ending.size() &&
         path.compare(path.size() - ending.size(), ending.size(), ending) == 0 &&
         !fs::is_directory(path, ignored);
}

std::optional<ArchivedFile> archivedFile(const std::string &path)
{
  const auto slash = path.rfind('/');
  if (slash == std::string::npos || !isLogArchive(path.substr(0, slash)))
    return std::nullopt;
  return ArchivedFile{path.substr(0, slash), path.substr(slash + 1)};
}

std::map<std::string, std::string> readLogArchive(const std::string &path)
{
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw badInput(path, 0, "", "no such file or folder");
  if (!fs::is_regular_file(path, ignored))
    throw badInput(path, 0, "", "is not a regular file"); // reading a pipe might never end
  return logsOfTar(path, unpackXz(path));
}

std::map<std::string, std::string> logsOfTar(const std::string &path, const std::string &tar)
{
  if (tar.size() < endMark ||
      !std::all_of(tar.end() - endMark, tar.end(), [](char c) { return c == '\0'; }))
    throw cannotUnpack(path, "is not a whole tar file: its end is missing");

  ArchiveReader reader(path, tar, ArchiveReader::Kind::Tar);
  std::map<std::string, std::string> logs;
  std::set<std::string> names;
  std::size_t total = 0;
  while (archive_entry *entry = reader.next()) {
    const char *given = archive_entry_pathname(entry);
    const std::string name = given ? given : "";
    if (!isPlain(entry))
      throw cannotUnpack(
          path, fmt::format("member '{}' is not allowed, must be a file with a plain name", name));
    if (!names.insert(name).second)
      throw cannotUnpack(path, fmt::format("member '{}' is there twice", name));
    const auto size = static_cast<std::size_t>(archive_entry_size(entry));
    if (size > tar.size() - total) // of a sparse file, or of a damaged head
      throw cannotUnpack(path, fmt::format("member '{}' is larger than the archive", name));
    total += size;
    if (fs::path(name).extension() != mcawr::friction_log::extension)
      continue;
    std::string &text = logs[name];
    if (!reader.append(text, size) || text.size() != size)
      throw reader.damaged();
  }
  if (!endsOnce(tar))
    throw reader.damaged();
  if (logs.empty())
    throw badInput(path, 0, "", "this archive holds no *.friction file");
  return logs;
}

} // namespace wheelrail
