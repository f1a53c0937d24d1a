// SPDX-License-Identifier: GPL-2.0-or-later
#include "shared/nearest_word.h"

#include <algorithm>

namespace mcawr {
namespace {

/// "contact." of "contact.load"; empty without a dot.
std::string groupOf(const std::string &word)
{
  return word.substr(0, word.rfind('.') + 1);
}

/// Both words without the group that they share.
std::pair<std::string, std::string> withoutGroup(const std::string &a, const std::string &b)
{
  const std::size_t group = groupOf(a) == groupOf(b) ? groupOf(a).size() : 0;
  return {a.substr(group), b.substr(group)};
}

} // namespace

int editDistance(const std::string &a, const std::string &b)
{
  const std::size_t rows = a.size() + 1, columns = b.size() + 1;
  std::vector<std::vector<int>> d(rows, std::vector<int>(columns));
  for (std::size_t i = 0; i < rows; ++i)
    d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j < columns; ++j)
    d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i < rows; ++i)
    for (std::size_t j = 1; j < columns; ++j) {
      const int replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped)
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d.back().back();
}

std::string nearestWord(const std::string &word, const std::vector<std::string> &known)
{
  constexpr std::size_t lettersForAnEdit = 3;
  std::string nearest, beginning;
  int least = -1;
  for (const std::string &candidate : known) {
    const auto [given, other] = withoutGroup(word, candidate);
    const int distance = editDistance(given, other);
    const auto allowed = static_cast<int>(std::max(given.size(), other.size()) / lettersForAnEdit);
    if (distance <= allowed && (least < 0 || distance < least)) {
      least = distance;
      nearest = candidate;
    }
    const bool begins = !given.empty() && other.compare(0, given.size(), given) == 0;
    if (begins && (beginning.empty() || candidate.size() < beginning.size()))
      beginning = candidate;
  }
  return least >= 0 ? nearest : beginning;
}

std::string knownWords(const std::string &word, const std::vector<std::string> &known)
{
  const std::string nearest = nearestWord(word, known);
  if (!nearest.empty())
    return "; the nearest known one is '" + nearest + "'";
  const auto inGroup = [&](const std::string &candidate) {
    return groupOf(candidate) == groupOf(word);
  };
  const bool groupIsKnown = std::any_of(known.begin(), known.end(), inGroup);
  std::string list;
  for (const std::string &candidate : known)
    if (groupIsKnown ? inGroup(candidate) : groupOf(candidate).empty())
      list += (list.empty() ? "" : ", ") + candidate;
  return list.empty() ? "" : "; known: " + list;
}

std::string unknownWord(const std::string &what, const std::string &word,
                        const std::vector<std::string> &known)
{
  return "unknown " + what + " '" + word + "'" + knownWords(word, known);
}

} // namespace mcawr
