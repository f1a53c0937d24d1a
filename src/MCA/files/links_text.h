// SPDX-License-Identifier: GPL-2.0-or-later
/// \file links_text.h
/// The text of a file of mca_links write: a LAMMPS data file with links as bonds. What a bond
/// cannot hold stands in comments of the file's header, which read_data and viewers skip. No LAMMPS
/// type in here.
#ifndef MCA_LINKS_TEXT_H
#define MCA_LINKS_TEXT_H

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace mca {

/// One line that says what is wrong with a file of links; what it quotes is made printable.
class LinksError : public std::runtime_error {
 public:
  explicit LinksError(const std::string &line);
};

/// Links of a file.
struct Links {
  /// A pair that has more than nothing with each other.
  struct Pair {
    /// As LinkList::getState() gives it: a kind of link (laws/linking.h) first, all finite.
    std::vector<double> state;
    bool original; ///< a link of the sample as it was made
    bool operator==(const Pair &) const;
  };
  /// A value of an automaton.
  struct Value {
    int state; ///< number in mca::automatonStates
    double value;
    bool operator==(const Value &) const;
  };
  /// By the IDs of both, the lower one first.
  std::map<std::pair<std::int64_t, std::int64_t>, Pair> pairs;
  std::unordered_map<std::int64_t, std::vector<Value>> automata; ///< by ID
  bool hasStates = false; ///< of mca_links write: what it leaves out is zero
};

/// The comment that keeps a pair, a line.
/// \param i,j    IDs
/// \param state  size values, the kind first
std::string pairLine(std::int64_t i, std::int64_t j, const double *state, int size, bool original);
/// The comment that keeps a state of an automaton, a line.
/// \param state  number in mca::automatonStates
std::string automatonLine(std::int64_t id, int state, double value);

/// The head of a file: what was counted, then the comments.
/// \param counts    lines of a data file's header: atoms, types, bonds, box
/// \param comments  lines of pairs and automata
std::string linksHead(const std::string &counts, const std::string &comments);
/// A whole file with its checksum, for what linksHead() begins.
std::string sealedLinks(std::string text);

/// Reads a file of mca_links write, or the section Bonds of any data file as original links without
/// shear and plastic offset.
/// \param bytes      of the whole file, as any editor saves it (`mcawr::plainText`); the checksum
///                   is that of the plain text
/// \param stateSize  number of values of a pair's state, LinkList::stateSize()
/// \param largestId  of an automaton
/// \throw LinksError  with the number of the line where there is one; also where a file of ours
///                     does not match its checksum
Links linksIn(const std::string &bytes, int stateSize, std::int64_t largestId);

} // namespace mca

#endif
