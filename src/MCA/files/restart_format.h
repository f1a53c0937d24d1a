// SPDX-License-Identifier: GPL-2.0-or-later
/// \file restart_format.h
/// What our parts of a restart file look like: the checksum of the whole file (FileSeal), blocks of
/// text with length and checksum (global state), records of automata with a checksum (state of a
/// fix), and what a block or record may hold. A damaged one is refused, not read. No LAMMPS type in
/// here; restart_block.h hands it to LAMMPS.
#ifndef MCA_RESTART_FORMAT_H
#define MCA_RESTART_FORMAT_H

#include "files/drive_sums.h"
#include "files/friction_log_writer.h"
#include "laws/law_set.h"
#include "laws/material.h"
#include "laws/packing.h"

#include <cstddef>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mca {

/// One line that says which part of a restart file is damaged, and how.
/// What it quotes of the file is made printable.
class RestartError : public std::runtime_error {
 public:
  explicit RestartError(const std::string &line);
};

/// FNV-1a checksum of 64 bits (Fowler, Noll, Vo; RFC draft-eastlake-fnv). It finds damage, not
/// intent.
/// \param n  number of bytes; those of doubles are taken as they lie in memory, so that a file
///           belongs to one byte order, as LAMMPS's own restart files
unsigned long long checksum(const void *bytes, std::size_t n);

// ---- the whole file

/// The checksum of a whole restart file, LAMMPS's own parts included, in a place that is kept free
/// where the pair style writes. Of a file in several parts (name with %) that of its base; the rest
/// has the checksums of our records.
class FileSeal {
 public:
  /// Keeps the place.
  /// \param fp  open for writing, at the place
  void keepPlace(FILE *fp);
  /// Puts the checksum there, when the file is whole and closed.
  /// \return whether that went well; else errno says why
  bool close(const std::string &path) const;
  /// Reads the whole file, and goes on behind the place.
  /// \param fp  open, at the place
  /// \return empty, or one line: the file is damaged or of another version
  static std::string problem(FILE *fp);

 private:
  long place_ = 0;
};

// ---- blocks of text

/// Far beyond any block of ours [bytes].
constexpr std::size_t longestBlock = 1 << 28;

/// What stands before the text of a block.
struct BlockHead {
  unsigned long long length, sum;
};

/// Length, checksum, text.
/// \param text  less than longestBlock, else reading refuses it
void writeBlock(FILE *fp, const std::string &text);
/// \param fp  at the block's beginning; afterwards behind its end
/// \return nothing where the block is cut, longer than a block of ours, or does not match its
///         checksum
std::optional<std::string> readBlock(FILE *fp);

/// The global state of a fix: its length as LAMMPS wants it, then as writeBlock().
void writeFixBlock(FILE *fp, const std::string &text);
/// The block of a fix from memory.
/// \param bytes      the block begins there
/// \param available  number of bytes that may be read
std::optional<std::string> fixBlockIn(const char *bytes, std::size_t available);

/// Numbers as text that reads back to the same bits: 17 digits, a blank after each.
std::string exactText(const std::vector<double> &values);
/// The finite numbers of a block's text as exactText() wrote it.
/// \param n     so many; nothing: any number
/// \param what  names the block in the message
/// \throw RestartError  where there are others, or one is not finite
std::vector<double> numbersIn(const std::string &text, std::optional<std::size_t> n,
                              const char *what);

// ---- what blocks hold

/// Settings of the command pair_style mca.
struct PairSettings {
  double thickness = 0.0, cutoff = 0.0; ///< [length], >= 0; 0: not given
  const Packing *packing = nullptr;
  LawSet laws;
};
std::string textOf(const PairSettings &);
/// \throw RestartError
PairSettings settingsIn(const std::string &text);

std::string textOf(const std::vector<Material> &);
/// \param count  number of materials, one for each type
/// \return materials that checkMaterial() accepts
/// \throw RestartError
std::vector<Material> materialsIn(const std::string &text, std::size_t count);

/// Settings of pair_coeff interface.
std::string textOfInterfaces(const Interfaces &);
/// \param types  number of types
/// \param laws   that they have to fit
/// \throw RestartError
Interfaces interfacesIn(const std::string &text, int types, const LawSet &laws);

/// State of fix mca/drive, with the parts of all ranks.
struct DriveState {
  DriveSums sums;
  LogRows rows = {-1, 0}; ///< of the log; number < 0: no log
};
std::string textOf(const DriveState &);
/// \throw RestartError
DriveState driveStateIn(const std::string &text);

// ---- records of automata

/// Checksum of a record and of its automaton's ID, as a double that is a whole number below 2^53.
/// \param values  the record without its checksum
/// \param n       its length in doubles
template<class Id>
double recordChecksum(const double *values, std::size_t n, Id id)
{
  // the 53 bits that a double holds exactly
  const unsigned long long sum = checksum(values, n * sizeof(double)) + checksum(&id, sizeof(id));
  return static_cast<double>(sum >> 11);
}

/// A record without its checksum; the first value is its length with it.
struct Record {
  const double *values;
  std::size_t size;
};

/// The place of a record among those of an automaton, each of which begins with its length.
/// \param values  of all records
/// \param size    their length in doubles
/// \param number  from 0
/// \return nothing where a length does not fit
std::optional<Record> recordNumber(const double *values, std::size_t size, int number);

/// The record of a number; nothing where it is missing or its checksum is another.
template<class Id>
std::optional<Record> checkedRecord(const double *values, std::size_t size, int number, Id id)
{
  const std::optional<Record> record = recordNumber(values, size, number);
  if (!record || record->values[record->size] != recordChecksum(record->values, record->size, id))
    return std::nullopt;
  return record;
}

/// Whether a record holds so many finite states and nothing else.
bool isStateRecord(const Record &, std::size_t states);
/// Whether a record is a list of partners as fix neigh/history packs it: their number, then for
/// each the bits of its ID and its values, which are finite and begin with a kind of link; the
/// first is the automaton itself.
/// \param values  number of values of a partner
bool isPartnerRecord(const Record &, std::size_t values);

} // namespace mca

#endif
