// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_ARCHIVE_READER_H
#define WHEELRAIL_BASE_ARCHIVE_READER_H

#include "base/errors.h"

#include <memory>
#include <string>

struct archive;
struct archive_entry;

namespace wheelrail {

/// A message about an archive: "cannot be unpacked: why".
Error cannotUnpack(const std::string &path, const std::string &why);

/// The members of an archive in memory, one after the other, by libarchive.
class ArchiveReader {
 public:
  enum class Kind { Tar, Xz, Zip }; ///< Xz: one member without a name, all bytes

  /// \param path what the archive is called in messages
  /// \param bytes of the archive; must outlive this
  /// \throws Error (BadInput)
  ArchiveReader(std::string path, const std::string &bytes, Kind kind);

  /// The next member; null behind the last one. \throws Error (BadInput)
  archive_entry *next();

  /// Adds all bytes of the member to a text.
  /// \return false, and stops, where the text becomes longer than `most`
  /// \throws Error (BadInput) where it is damaged or cut, by its checksums, too
  bool append(std::string &text, std::size_t most);

  /// What the last call of libarchive failed at.
  /// \throws std::bad_alloc where it was not the archive's fault
  Error damaged() const;

 private:
  struct Free {
    void operator()(archive *reader) const;
  };
  std::string path_;
  std::unique_ptr<archive, Free> reader_;
};

} // namespace wheelrail
#endif
