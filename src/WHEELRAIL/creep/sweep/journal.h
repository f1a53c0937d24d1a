// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_JOURNAL_H
#define WHEELRAIL_CREEP_SWEEP_JOURNAL_H

#include <chrono>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace wheelrail {

/// Name of the journal in the folder for the results.
constexpr const char *journalName = "wr_creep.journal";

/// Finished pieces of a sweep on disk, so that a run that ended early goes on where it stopped. The
/// file begins whole and grows by what is new, at most every few seconds. Where somebody else has
/// changed it, it is written whole again. It stays until `remove`: the results must be in place
/// before.
///
/// Lines of text, each "CHECKSUM JSON". The first says what is computed: format, version and commit
/// of the program (base/version.h), identity. The others are pieces: {"piece": number, "results":
/// ...}, numbers exact to the last bit. A checksum is that of the first line's checksum and the
/// line's own JSON, so that a piece of another journal is found out like a damaged one, or one that
/// was cut as the program was killed. Of two lines of a piece the later one counts. What is
/// damaged, of another identity or of another version, is not used, and a warning says so.
///
/// One object for a sweep; not safe from several threads at once.
class Journal {
 public:
  /// Results of a finished piece, by the piece's number from 0 on. What they hold is the sweep's
  /// business; numbers keep all their digits.
  using Pieces = std::map<std::size_t, nlohmann::json>;
  /// Takes a line for the user.
  using Warn = std::function<void(const std::string &)>;

  /// \param path of the file; none is opened or written yet
  /// \param identity all that decides the results: a case with the content of its files
  /// \param warn may be empty: for who does not want to know
  Journal(std::string path, const std::string &identity, Warn warn = {});

  /// What the file holds, from now on kept with what is added; nothing where there is no file, or
  /// none of this identity and version.
  Pieces load();

  /// Keeps a finished piece; writes what is new if the last time is some seconds ago.
  /// \throws Error (Io)
  /// \param piece number from 0 on; an earlier result of the same piece is replaced
  /// \param results any JSON value
  void add(std::size_t piece, const nlohmann::json &results);

  /// A piece that was loaded and makes no sense: dropped with a warning.
  void refuse(std::size_t piece);

  /// Writes what is new now, the first time all pieces, if there are any. \throws Error (Io)
  void write();

  /// Keeps bytes that are too many for a line, in a file of their own beside the journal,
  /// PATH.NUMBER. May be called from several threads, for different numbers.
  /// \return a checksum, for the results of the piece that they belong to; empty where the file
  ///         cannot be written: the piece will then be computed again
  std::string attach(int number, const std::string &bytes) const;
  /// \return the bytes; nothing where they are missing, or not those of the checksum
  std::optional<std::string> attached(int number, const std::string &expected) const;

  /// Half a sentence for the message of a run that fails: "; what is kept in PATH ...". Empty where
  /// the file holds nothing of this sweep.
  std::string whatIsKept() const;

  /// Takes the file away if it is this sweep's, and what is attached: the results are in place.
  /// A file that cannot be removed is no error.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::string lineOf(const std::string &json) const;
  std::string attachment(int number) const; ///< path
  void say(const std::string &problem) const;

  std::string path_, head_, headChecksum_;
  Warn warn_;
  std::map<std::size_t, std::string> lines_; ///< of the pieces
  std::string unwritten_;                    ///< lines since the last time
  std::size_t size_ = 0;                     ///< of the file as it was written; 0: it was not
  bool isOnDisk_ = false;                    ///< some of the lines
  Clock::time_point lastWrite_;
};

} // namespace wheelrail
#endif
