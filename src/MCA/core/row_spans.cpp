// SPDX-License-Identifier: GPL-2.0-or-later
#include "row_spans.h"

namespace mca {

void RowSpans::begin(const Pairs &pairs, int own, int rows)
{
  ownRows_ = own;
  rows_ = rows;
  begins_.assign(1, 0);
  numbers_.clear();
  std::vector<int> latest(size(), -1); // block that has named a span last
  for (int first = 0, block = 0; first < pairs.n; first += blockLength, block++) {
    const int behind = std::min(first + blockLength, pairs.n);
    for (int k = first; k < behind; k++)
      for (const int row : {pairs.i[k], pairs.j[k]}) {
        const int span = row < own ? row / length : this->own();
        if (latest[span] != block)
          numbers_.push_back(span);
        latest[span] = block;
      }
    begins_.push_back(static_cast<int>(numbers_.size()));
  }
}

} // namespace mca
