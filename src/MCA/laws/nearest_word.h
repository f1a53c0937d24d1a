/// \file nearest_word.h
/// What a misspelt keyword may have meant, for messages. No LAMMPS type in here.
#ifndef MCA_LAWS_NEAREST_WORD_H
#define MCA_LAWS_NEAREST_WORD_H

#include <string>
#include <vector>

namespace mca {

/// The known word at the smallest edit distance; empty when none is known.
std::string nearestWord(const std::string &word, const std::vector<std::string> &known);

/// "unknown keyword W, the nearest known one is K, known: ..."
std::string unknownWord(const std::string &word, const std::vector<std::string> &known);

} // namespace mca

#endif
