// SPDX-License-Identifier: GPL-2.0-or-later
/// \file friction_log_writer.h
/// Writes the friction log (format `mca-friction 1`, doc/friction_log.md). No LAMMPS type in here.
/// Errors are a std::runtime_error with one line that names the file; a file that exists is left as
/// it was then.
#ifndef MCA_FRICTION_LOG_WRITER_H
#define MCA_FRICTION_LOG_WRITER_H

#include "files/friction_log_head.h"
#include "shared/friction_log_format.h"
#include "shared/output_file.h"
#include "shared/running_checksum.h"

#include <string>

namespace mca {

/// One row, in units of the log; its columns stand in shared/friction_log_format.h. Rows are sorted
/// by their step, which resume() looks at.
using LogRow = mcawr::friction_log::Row;

/// Which rows a log has: how many, and the step of the last one.
struct LogRows {
  long long number = 0, last = 0;
};

/// The file of one log, on the rank that writes. After begin() or resume() it is open until the
/// end.
class FrictionLogWriter {
 public:
  /// Begins a new log: its whole head at once.
  /// \param units      from those of the header to those of the log
  /// \param step       of the run; a log with rows until there is not replaced, they would be lost
  /// \param isRestart  the run goes on from a restart file: no file is replaced at all
  /// \throw std::runtime_error  also for a number that no reader takes, for a file with other
  ///                            contents, and for one that another writer has open
  void begin(const std::string &path, const LogHeader &, const Units &, long long step,
             bool isRestart);

  /// Goes on with a log; rows after `step`, and a last row that was cut, are dropped. The head
  /// stays as it is.
  /// \param rows  which are there up to `step`
  /// \return empty, or a line that tells of what differs and does not matter
  /// \throw std::runtime_error  also where head or rows are not those of this run
  std::string resume(const std::string &path, const LogHeader &, const Units &, long long step,
                     LogRows rows);

  /// In a further run of the same input script.
  /// \throw std::runtime_error  this run has another head
  void check(const LogHeader &, const Units &) const;

  /// Appends a row.
  /// \throw std::runtime_error  also for a number that is not finite; nothing is appended then
  void write(const LogRow &);

  /// Whether write() has a file.
  bool isOpen() const { return file_.isOpen(); }
  /// Rows that the file has.
  LogRows rows() const { return rows_; }

 private:
  void open(const std::string &text);

  mcawr::GrowingFile file_;
  std::string path_, head_;
  LogRows rows_;
  mcawr::RunningChecksum sum_; ///< of what is in the file
};

} // namespace mca

#endif
