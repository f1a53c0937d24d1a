// SPDX-License-Identifier: GPL-2.0-or-later
/// \file fragments.h
/// Sets of rows that hang together: which rows pairs join, directly or through others.
#ifndef MCA_FRAGMENTS_H
#define MCA_FRAGMENTS_H

#include <numeric>
#include <utility>
#include <vector>

namespace mca {

/// Union-find over rows 0 to rows - 1, which begin alone. A set is known by its root, one of its
/// rows; roots change with join(). Rows are not checked.
class Fragments {
 public:
  explicit Fragments(int rows) : parent_(rows), size_(rows, 1)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The sets of both rows become one.
  void join(int i, int j)
  {
    i = root(i);
    j = root(j);
    if (i == j)
      return;
    if (size_[i] < size_[j])
      std::swap(i, j);
    parent_[j] = i;
    size_[i] += size_[j];
  }

  int root(int i)
  {
    for (; parent_[i] != i; i = parent_[i])
      parent_[i] = parent_[parent_[i]]; // halves the way
    return i;
  }

  /// Number of rows in the set of row i.
  int size(int i) { return size_[root(i)]; }

 private:
  std::vector<int> parent_, size_; // sizes of roots only
};

} // namespace mca

#endif
