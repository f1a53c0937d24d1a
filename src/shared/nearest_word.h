// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_NEAREST_WORD_H
#define MCAWR_SHARED_NEAREST_WORD_H

#include <string>
#include <vector>

namespace mcawr {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn a into b
/// (optimal string alignment: no part of the text is changed twice). Letters count by bytes, upper
/// and lower case differ.
int editDistance(const std::string &a, const std::string &b);

/// What a misspelt word may have meant: of the known words that are near, the one at the smallest
/// edit distance (the first of equals); empty when none is near.
///
/// Near is a word at no more edits than a third of the longer one's letters. Failing that, one that
/// the given word is the beginning of ("youngs" of "youngs_modulus"), the shortest of them. A group
/// that both share ("contact." of contact.load and contact.domain) says nothing about likeness:
/// only what follows it counts.
std::string nearestWord(const std::string &word, const std::vector<std::string> &known);

/// One line for messages: "unknown WHAT 'WORD'; the nearest known one is 'K'", or, when nothing is
/// near, "unknown WHAT 'WORD'; known: A, B, C". Of words in groups ("contact.radius") only those of
/// the given word's group are listed; a word without a known group gets the words outside of
/// groups.
/// \param what "keyword", "option", "key"
std::string unknownWord(const std::string &what, const std::string &word,
                        const std::vector<std::string> &known);

/// The end of such a line alone, beginning with "; ", for messages of another wording.
std::string knownWords(const std::string &word, const std::vector<std::string> &known);

} // namespace mcawr
#endif
