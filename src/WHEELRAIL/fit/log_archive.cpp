// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/log_archive.h"

#include "base/errors.h"
#include "base/program_files.h"
#include "shared/friction_log_format.h"

#include <algorithm>
#include <archive.h>
#include <archive_entry.h>
#include <cerrno>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <new>
#include <set>
#include <string_view>
#include <vector>

namespace wheelrail {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t mebibyte = std::size_t(1) << 20;
constexpr std::size_t largest = 256;  // MiB; tools/mcawr/archive.py has the same
constexpr std::size_t endMark = 1024; // zero bytes at the end of every tar file

struct Free {
  void operator()(archive *reader) const { archive_read_free(reader); }
};
using Reader = std::unique_ptr<archive, Free>;

Reader newReader()
{
  Reader reader(archive_read_new());
  if (!reader)
    throw std::bad_alloc();
  return reader;
}

Error cannotUnpack(const std::string &path, const std::string &why)
{
  return badInput(path, 0, "", "cannot be unpacked: " + why);
}

/// What the last call of libarchive failed at.
/// \throws std::bad_alloc where it was not the archive's fault
Error damaged(const std::string &path, archive *reader)
{
  if (archive_errno(reader) == ENOMEM)
    throw std::bad_alloc();
  const char *reason = archive_error_string(reader);
  return cannotUnpack(
      path, fmt::format("is damaged or cut{}{}", reason ? ": " : "", reason ? reason : ""));
}

/// The tar file, unpacked to its end, where xz has its checksums.
std::string unpackXz(const std::string &path)
{
  constexpr std::string_view magic = "\xFD\x37zXZ";
  const std::string packed = readInputFile(path);
  if (packed.compare(0, magic.size(), magic) != 0)
    throw cannotUnpack(path, "is not compressed by xz");
  const Reader reader = newReader();
  archive_read_support_filter_xz(reader.get());
  archive_read_support_format_raw(reader.get()); // one member: all bytes
  archive_entry *entry = nullptr;
  if (archive_read_open_memory(reader.get(), packed.data(), packed.size()) != ARCHIVE_OK ||
      archive_read_next_header(reader.get(), &entry) != ARCHIVE_OK)
    throw damaged(path, reader.get());
  std::string tar;
  std::vector<char> block(mebibyte);
  la_ssize_t got = 0;
  while ((got = archive_read_data(reader.get(), block.data(), block.size())) > 0) {
    tar.append(block.data(), static_cast<std::size_t>(got));
    if (tar.size() > largest * mebibyte)
      throw cannotUnpack(path, fmt::format("holds more than {} MiB: pack fewer runs into one, or "
                                           "more rows into one (--rows)",
                                           largest));
  }
  if (got < 0)
    throw damaged(path, reader.get());
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

  const Reader reader = newReader();
  archive_read_support_format_tar(reader.get());
  if (archive_read_open_memory(reader.get(), tar.data(), tar.size()) != ARCHIVE_OK)
    throw damaged(path, reader.get());
  std::map<std::string, std::string> logs;
  std::set<std::string> names;
  std::size_t total = 0;
  archive_entry *entry = nullptr;
  int code = ARCHIVE_OK;
  while ((code = archive_read_next_header(reader.get(), &entry)) == ARCHIVE_OK) {
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
    text.resize(size);
    if (archive_read_data(reader.get(), text.data(), size) != static_cast<la_ssize_t>(size))
      throw damaged(path, reader.get());
  }
  if (code != ARCHIVE_EOF)
    throw damaged(path, reader.get());
  if (logs.empty())
    throw badInput(path, 0, "", "this archive holds no *.friction file");
  return logs;
}

} // namespace wheelrail
