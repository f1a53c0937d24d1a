// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/archive_reader.h"

#include <archive.h>
#include <archive_entry.h>
#include <cerrno>
#include <fmt/format.h>
#include <new>
#include <vector>

namespace wheelrail {

Error cannotUnpack(const std::string &path, const std::string &why)
{
  return badInput(path, 0, "", "cannot be unpacked: " + why);
}

void ArchiveReader::Free::operator()(archive *reader) const
{
  archive_read_free(reader);
}

ArchiveReader::ArchiveReader(std::string path, const std::string &bytes, Kind kind)
    : path_(std::move(path)), reader_(archive_read_new())
{
  if (!reader_)
    throw std::bad_alloc();
  if (kind == Kind::Xz) {
    archive_read_support_filter_xz(reader_.get());
    archive_read_support_format_raw(reader_.get());
  } else if (kind == Kind::Tar) {
    archive_read_support_format_tar(reader_.get());
  } else {
    archive_read_support_format_zip(reader_.get());
  }
  if (archive_read_open_memory(reader_.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    throw damaged();
}

archive_entry *ArchiveReader::next()
{
  archive_entry *entry = nullptr;
  const int code = archive_read_next_header(reader_.get(), &entry);
  if (code == ARCHIVE_EOF)
    return nullptr;
  if (code != ARCHIVE_OK)
    throw damaged();
  return entry;
}

bool ArchiveReader::append(std::string &text, std::size_t most)
{
  std::vector<char> block(std::size_t(1) << 20);
  la_ssize_t got = 0;
  while ((got = archive_read_data(reader_.get(), block.data(), block.size())) > 0) {
    text.append(block.data(), static_cast<std::size_t>(got));
    if (text.size() > most)
      return false;
  }
  if (got < 0)
    throw damaged();
  return true;
}

Error ArchiveReader::damaged() const
{
  if (archive_errno(reader_.get()) == ENOMEM)
    throw std::bad_alloc();
  const char *reason = archive_error_string(reader_.get());
  return cannotUnpack(
      path_, fmt::format("is damaged or cut{}{}", reason ? ": " : "", reason ? reason : ""));
}

} // namespace wheelrail
