// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/progress.h"

#include <cstdio>
#include <unistd.h>

namespace wheelrail {

Progress::Progress(std::string program)
    : program_(std::move(program)), onTerminal_(::isatty(STDERR_FILENO) != 0),
      pause_(onTerminal_ ? 200 : 2000)
{
}

void Progress::operator()(int done, int total)
{
  const auto now = std::chrono::steady_clock::now();
  if (done < total && now - last_ < pause_)
    return;
  last_ = now;
  std::fprintf(stderr, "%s%s: %d of %d operating points%s", onTerminal_ ? "\r" : "",
               program_.c_str(), done, total, onTerminal_ && done < total ? "" : "\n");
  std::fflush(stderr);
}

} // namespace wheelrail
