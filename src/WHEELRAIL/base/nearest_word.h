#ifndef WHEELRAIL_BASE_NEAREST_WORD_H
#define WHEELRAIL_BASE_NEAREST_WORD_H

#include <string>
#include <vector>

namespace wheelrail {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn a into b.
int editDistance(const std::string &a, const std::string &b);

/// The candidate with the smallest edit distance to `word` (the first one of equals);
/// an empty string when there are no candidates.
std::string nearestWord(const std::string &word, const std::vector<std::string> &candidates);

} // namespace wheelrail
#endif
