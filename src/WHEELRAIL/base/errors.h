// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_ERRORS_H
#define WHEELRAIL_BASE_ERRORS_H

#include <stdexcept>
#include <string>

namespace wheelrail {

/// Exit codes of our programs; the library throws an Error that carries one.
enum class ExitCode : int {
  Ok = 0,
  Internal = 1,     ///< a bug of ours
  Usage = 2,        ///< command line
  BadInput = 3,     ///< an input file is missing, unreadable or wrong
  NotConverged = 4, ///< not converged, or not identifiable from the data
  Io = 5,           ///< input/output, such as a folder that cannot be written
  Interrupted = 6   ///< interrupted; the same call goes on where it stopped
};

/// What a user can act on (bugs of ours are std::logic_error or an Error with code Internal): one
/// line that names file, line, keyword, the value given and what is allowed. Whatever the message
/// quotes of a file is made printable (`mcawr::printable`). The library never prints and never
/// exits; programs print what() and exit with code().
class Error : public std::runtime_error {
 public:
  /// A fault that belongs to no place in a file; for one that does, use `badInput`.
  /// \param message the whole line as the user reads it, without an end of line
  Error(ExitCode code, const std::string &message);

  ExitCode code() const { return code_; } ///< what the program exits with
  /// Path of the faulty file as it was given; empty: the fault is in no file.
  const std::string &file() const { return file_; }
  int line() const { return line_; } ///< 1-based; 0: no line
  /// "contact.radius"; empty: none. What these three hold stands in what() too.
  const std::string &keyword() const { return keyword_; }

 private:
  friend Error badInput(const std::string &, int, const std::string &, const std::string &);
  ExitCode code_;
  std::string file_, keyword_;
  int line_ = 0;
};

/// A fault in an input file (exit code 3): "FILE:LINE: keyword: problem".
/// \param file path as the user gave it
/// \param line 1-based, 0 when the fault belongs to the file as a whole
/// \param keyword may be empty
/// \param problem says the value given, what is allowed, and in which unit; of a long one the
///        middle is left out (`mcawr::shortened`)
/// \return the error, to be thrown by the caller
Error badInput(const std::string &file, int line, const std::string &keyword,
               const std::string &problem);

} // namespace wheelrail
#endif
