// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_FOUND_LOGS_H
#define WHEELRAIL_FIT_FOUND_LOGS_H

#include "fit/friction_log.h"

#include <string>
#include <vector>

namespace wheelrail {

/// A friction log that a command line names.
struct FoundLog {
  std::string file;    ///< what it is called: run.friction, or paper36.tar.xz/r01.friction
  std::string archive; ///< that it is in, paper36.tar.xz; empty for a file of its own
  std::string text;    ///< of one in an archive, which is unpacked once; empty for a file

  /// The file on the disk that it comes from.
  const std::string &onDisk() const { return archive.empty() ? file : archive; }
  /// \throws Error (BadInput) as readFrictionLog
  FrictionLog read() const;
};

/// The logs named on a command line: files as they are, folders replaced by all *.friction below
/// them and archives by all *.friction in them, in alphabetical order; a log that is named twice
/// counts once. Each archive is read once.
/// \throws Error (BadInput) for a path that does not exist, a folder that cannot be read, an
///         archive that readLogArchive refuses, and a folder or archive without a log
std::vector<FoundLog> findFrictionLogs(const std::vector<std::string> &paths);

} // namespace wheelrail

#endif
