// SPDX-License-Identifier: GPL-2.0-or-later
/// \file row_array.h
/// Memory of the rows of a step: plain doubles on a cache-line boundary that know their number.
#ifndef MCA_ROW_ARRAY_H
#define MCA_ROW_ARRAY_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace mca {

/// Uninitialised doubles on a cache-line boundary; grows only, and growing loses what is there.
class AlignedArray {
 public:
  double *get() const { return data_.get(); }
  void reserve(size_t n)
  {
    if (n <= size_)
      return;
    size_ = (n + n / 8 + 7) / 8 * 8;
    data_.reset(static_cast<double *>(std::aligned_alloc(64, size_ * sizeof(double))));
    if (!data_)
      throw std::bad_alloc();
  }
  double bytes() const { return static_cast<double>(size_ * sizeof(double)); }

 private:
  struct Free {
    void operator()(double *p) const { std::free(p); }
  };
  std::unique_ptr<double, Free> data_;
  size_t size_ = 0;
};

/// Rows of `length` values, one row an automaton. What a row holds stands in rows.h.
class RowArray {
 public:
  /// \param length  values of a row; 1 for one quantity an automaton
  explicit RowArray(int length = 1) : length_(length) {}

  /// Makes it n rows, whose values are not set.
  void resize(int n)
  {
    rows_ = n;
    values_.reserve(size());
  }

  void clear() { std::fill_n(values_.get(), size(), 0.0); }

  int rows() const { return rows_; }
  int length() const { return length_; }
  size_t size() const { return static_cast<size_t>(rows_) * static_cast<size_t>(length_); }

  /// All values, for loops whose bounds are rows().
  double *data() const { return values_.get(); }

  /// Row i, for loops whose bounds are rows().
  double *row(int i) const
  {
    return values_.get() + static_cast<size_t>(i) * static_cast<size_t>(length_);
  }

  /// Row i, for questions from outside.
  /// \throw std::out_of_range  there is no such row
  const double *at(int i) const
  {
    if (i < 0 || i >= rows_)
      throw std::out_of_range("row " + std::to_string(i) + " of " + std::to_string(rows_));
    return row(i);
  }

  double bytes() const { return values_.bytes(); }

 private:
  int length_, rows_ = 0;
  AlignedArray values_;
};

} // namespace mca

#endif
