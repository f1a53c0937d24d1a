// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_LOG_ARCHIVE_H
#define WHEELRAIL_FIT_LOG_ARCHIVE_H

#include <map>
#include <optional>
#include <string>

namespace wheelrail {

/// Ending of the archives of friction logs that `tools/campaign pack` writes.
constexpr const char *archiveEnding = ".tar.xz";

/// Whether a path is that of an archive: it ends in `archiveEnding` and is no folder. There need
/// not be a file of that name.
bool isLogArchive(const std::string &path);

/// A path that leads into an archive, like `paper36.tar.xz/r01.friction`.
struct ArchivedFile {
  std::string archive; ///< paper36.tar.xz
  std::string name;    ///< r01.friction
};

/// \return nothing for a path that does not lead into an archive
std::optional<ArchivedFile> archivedFile(const std::string &path);

/// The texts of all friction logs of an archive by their names, which are in alphabetical order.
/// Nothing is written to the disk; what is no log is checked and left out.
///
/// An archive is a tar file that is compressed by xz. Its members are regular files side by side:
/// names are plain ones without a slash, each is there once. All together unpack to 256 MiB at
/// most, so that no small file fills the memory.
/// \throws Error (BadInput) for one that is missing, no regular file, no such archive, damaged, cut
///         or larger, and for one without a log
std::map<std::string, std::string> readLogArchive(const std::string &path);

/// Logs of the tar file that stands in an archive behind the checksums of xz.
/// \param path what the archive is called in messages
/// \param tar all bytes of the tar file
/// \throws Error (BadInput)
std::map<std::string, std::string> logsOfTar(const std::string &path, const std::string &tar);

} // namespace wheelrail
#endif
