#include "base/nearest_word.h"

#include <algorithm>

namespace wheelrail {

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

std::string nearestWord(const std::string &word, const std::vector<std::string> &candidates)
{
  const auto nearest = std::min_element(candidates.begin(), candidates.end(),
                                        [&](const std::string &a, const std::string &b) {
                                          return editDistance(word, a) < editDistance(word, b);
                                        });
  return nearest == candidates.end() ? std::string() : *nearest;
}

} // namespace wheelrail
