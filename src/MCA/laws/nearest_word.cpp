#include "nearest_word.h"

#include <algorithm>
#include <numeric>

namespace mca {

static int editDistance(const std::string &a, const std::string &b)
{
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (size_t i = 1; i <= a.size(); i++) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); j++) {
      const int substituted = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string nearestWord(const std::string &word, const std::vector<std::string> &known)
{
  const auto nearest =
      std::min_element(known.begin(), known.end(), [&](const auto &a, const auto &b) {
        return editDistance(word, a) < editDistance(word, b);
      });
  return nearest == known.end() ? "" : *nearest;
}

std::string unknownWord(const std::string &word, const std::vector<std::string> &known)
{
  std::string all;
  for (const auto &k : known)
    all += (all.empty() ? "" : ", ") + k;
  return "unknown keyword " + word + ", the nearest known one is " + nearestWord(word, known) +
         ", known: " + all;
}

} // namespace mca
