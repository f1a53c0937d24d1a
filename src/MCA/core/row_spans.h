// SPDX-License-Identifier: GPL-2.0-or-later
/// \file row_spans.h
/// Rows of automata in spans of a fixed length, and which of them each block of pairs touches. What
/// happens to few automata in a step (flow, breaking) is noted for their spans, and whole spans and
/// blocks without it are passed over. It never changes a result, only the time that it takes.
#ifndef MCA_ROW_SPANS_H
#define MCA_ROW_SPANS_H

#include "pairs.h"

#include <algorithm>
#include <vector>

namespace mca {

/// The spans of a list of pairs. Those of own automata are numbered from 0 to own() - 1, in the
/// order of their rows; all other rows, if pairs meet at them, are one more: the guests.
class RowSpans {
 public:
  /// Rows of a span, but of the last one of own automata and of the guests. A short one tells
  /// places apart better, a long one is looked at less often.
  static constexpr int length = 64;

  /// A list was made anew.
  /// \param pairs  all of it; its rows are read
  /// \param own    rows of own automata
  /// \param rows   of all automata that are in pairs
  void begin(const Pairs &pairs, int own, int rows);

  /// Number of spans of own automata.
  int own() const { return (ownRows_ + length - 1) / length; }
  /// Number of all spans.
  int size() const { return own() + (rows_ > ownRows_ ? 1 : 0); }

  /// First row of a span, and the one behind its last.
  int first(int span) const { return std::min(span * length, ownRows_); }
  int last(int span) const
  {
    return span < own() ? std::min((span + 1) * length, ownRows_) : rows_;
  }

  /// Numbers of the spans that a block's automata are in, each once; for loops.
  struct Range {
    const int *first, *last;
    const int *begin() const { return first; }
    const int *end() const { return last; }
  };
  Range of(int block) const
  {
    return {numbers_.data() + begins_[block], numbers_.data() + begins_[block + 1]};
  }

  /// Memory held [bytes].
  double bytes() const
  {
    return static_cast<double>((begins_.capacity() + numbers_.capacity()) * sizeof(int));
  }

 private:
  int ownRows_ = 0, rows_ = 0;
  std::vector<int> begins_, numbers_; // of block b: numbers_ from begins_[b] to begins_[b + 1]
};

} // namespace mca

#endif
