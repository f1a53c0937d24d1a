// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_JOURNAL_H
#define WHEELRAIL_CREEP_JOURNAL_H

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace wheelrail {

/// Finished pieces of a sweep on disk, so that an interrupted run goes on where it stopped. The
/// file is written whole or not at all, at most every few seconds. JSON: `case`, the identity, and
/// `pieces`, rows of numbers in the order of the members of `CurvePoint`, exact to the last bit.
///
/// One object for a sweep; not safe from several threads at once.
class Journal {
 public:
  /// Results of a finished piece, by the piece's number from 0 on. What they hold is the sweep's
  /// business; numbers keep all their digits.
  using Pieces = std::map<std::size_t, nlohmann::json>;

  /// @param path empty: nothing is kept
  /// @param identity of what is computed; pieces of another one are not used
  /// No file is opened or written yet.
  Journal(std::string path, std::string identity);

  /// What the file holds, from now on kept with what is added; nothing where there is no file, or
  /// one of another identity.
  /// @throws Error (BadInput) when it cannot be read
  const Pieces &load();

  /// Keeps a finished piece; writes all of them if the last time is some seconds ago.
  /// @throws Error (Io)
  /// @param piece number from 0 on; an earlier result of the same piece is replaced
  /// @param results any JSON value
  void add(std::size_t piece, nlohmann::json results);

  /// Writes the pieces now. @throws Error (Io)
  void write();

  /// Takes the file away: the sweep is finished.
  /// A file that is not there, or cannot be removed, is no error.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::string path_, identity_;
  Pieces pieces_;
  Clock::time_point lastWrite_;
};

} // namespace wheelrail
#endif
