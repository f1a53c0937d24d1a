// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_PROGRESS_H
#define WHEELRAIL_BASE_PROGRESS_H

#include <chrono>
#include <string>

namespace wheelrail {

/// Progress on stderr: one line that is written over on a terminal, a line now and then elsewhere.
class Progress {
 public:
  /// \param program its name begins the line
  explicit Progress(std::string program);

  /// "wr_creep: 3 of 21 operating points". The last call is never passed over.
  void operator()(int done, int total);

 private:
  std::string program_;
  const bool onTerminal_;
  const std::chrono::milliseconds pause_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace wheelrail
#endif
