// SPDX-License-Identifier: GPL-2.0-or-later
/// \file row_array.h
/// Memory of the rows of a step: plain doubles on a cache-line boundary that know their number.
/// The arrays are made once for the largest number of automata so far and used again in each step,
/// so that a step asks for no memory. They can be moved but not copied.
#ifndef MCA_ROW_ARRAY_H
#define MCA_ROW_ARRAY_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>

namespace mca {

/// Uninitialised doubles on a cache-line boundary; grows only, and growing loses what is there. A
/// vector would fill them and give no promise of their place.
class AlignedArray {
 public:
  /// First value, 64-byte aligned; nullptr before the first reserve() of more than 0.
  double *get() const { return data_.get(); }
  /// Makes room for n doubles, with an eighth more and in whole cache lines where it has to grow,
  /// so that a sample that grows slowly does so rarely.
  /// \throw std::bad_alloc  there is not so much memory; the array is of no use then
  void reserve(size_t n);
  /// Memory held [bytes].
  double bytes() const { return static_cast<double>(size_ * sizeof(double)); }

 private:
  /// std::aligned_alloc wants std::free, not delete[].
  struct Free {
    void operator()(double *p) const { std::free(p); }
  };
  /// Owns the memory; moved, not copied.
  std::unique_ptr<double, Free> data_;
  /// Number of doubles there is room for.
  size_t size_ = 0;
};

/// Rows of `length` values, one row an automaton. What a row holds stands in rows.h. The kernel
/// reads rows as vectors of two or four doubles, which is why the first value stands on a cache
/// line.
class RowArray {
 public:
  /// \param length  values of a row; 1 for one quantity an automaton
  explicit RowArray(int length = 1) : length_(length) {}

  /// Makes it n rows, whose values are not set: those of before are lost where the array has to
  /// grow, and may be kept where it has not. Callers that add up begin with clear().
  /// \param n  number of automata, >= 0
  /// \throw std::bad_alloc  there is not so much memory
  void resize(int n)
  {
    rows_ = n;
    values_.reserve(size());
  }

  /// Sets all values of all rows to 0, those of padding, too: before a pass that adds up.
  void clear() { std::fill_n(values_.get(), size(), 0.0); }

  /// Number of rows, as given to resize().
  int rows() const { return rows_; }
  /// Number of values of a row.
  int length() const { return length_; }
  /// Number of values of all rows together.
  size_t size() const { return static_cast<size_t>(rows_) * static_cast<size_t>(length_); }

  /// All values, for loops whose bounds are rows(). The same until resize() has to grow. Values may
  /// be changed through a const array, as through a pointer.
  double *data() const { return values_.get(); }

  /// First of the length() values of row i, for loops whose bounds are rows(); not checked.
  double *row(int i) const
  {
    return values_.get() + static_cast<size_t>(i) * static_cast<size_t>(length_);
  }

  /// Number i, for questions from outside, where it may be wrong; loops do not ask.
  /// \param i  number of an automaton's row, from 0
  /// \throw std::out_of_range  there is no such row; says which and how many there are
  int checked(int i) const;

  /// Memory held [bytes], for the account of memory that LAMMPS prints.
  double bytes() const { return values_.bytes(); }

 private:
  int length_, rows_ = 0;
  AlignedArray values_;
};

} // namespace mca

#endif
