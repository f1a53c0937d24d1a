// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef DRILLS_MUTATOR_H
#define DRILLS_MUTATOR_H

#include <cstdint>
#include <random>
#include <string>
#include <vector>

/// Falsifies files: the same seed and number give the same bytes, on every machine.
class Mutator {
 public:
  /// \param corpus good files, at least one; the words in them are the dictionary
  Mutator(std::vector<std::string> corpus, std::uint64_t seed);

  /// One of the corpus with 1 to 8 changes: bits, bytes, numbers, words, lines, pieces of another
  /// file, deep nesting, a cut end, and what another machine makes of a whole text: line ends,
  /// marks, encodings, decimal signs, separators.
  /// \param number of the execution
  std::string operator()(std::uint64_t number);

 private:
  using Change = void (Mutator::*)(std::string &);
  std::size_t below(std::size_t n); ///< 0 .. n - 1; 0 for n = 0
  const std::string &anyOf(const std::vector<std::string> &list)
  {
    return list[below(list.size())];
  }
  void flipBit(std::string &);
  void setByte(std::string &);
  void insertBytes(std::string &);
  void eraseRange(std::string &);
  void repeatRange(std::string &);
  void replaceNumber(std::string &);
  void replaceWord(std::string &);
  void moveLine(std::string &);
  void splice(std::string &);
  void nest(std::string &);
  void cutEnd(std::string &);
  void otherMachine(std::string &);

  std::vector<std::string> corpus_, words_;
  std::uint64_t seed_;
  std::mt19937_64 random_;
};

#endif
