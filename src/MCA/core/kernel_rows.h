// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_rows.h
/// Rows of the per-automaton arrays as vectors of the compiler: one load, one addition, one store.
/// For the kernel's source only, which is compiled once for each instruction set; everything here
/// is inlined into it.
/// A block's pairs are gathered from rows, one an automaton, to columns, one a quantity, and what
/// is found is scattered back. Arrays of row numbers have three more entries than pairs (Pairs), so
/// that loops over whole twos and fours may read on; what these give is not added to any automaton.
/// Rows are 64-byte aligned arrays of doubles (row_array.h), and offsets in them stand in rows.h.
///
///     rows of automata in memory                   columns of a block on the stack
///     row pi[k], pj[k]:  a b c d    gather() ->    a of pair 0, 1, 2 ... 127
///                                                  b of pair 0, 1, 2 ... 127, and so on
///                                                  the pass's loop over k: laws/
///     row pi[k], pj[k] += a b c d   <- scatter()   results of pair 0, 1, 2 ... 127
#ifndef MCA_KERNEL_ROWS_H
#define MCA_KERNEL_ROWS_H

#include "pairs.h"

// What a block does that knows nothing of its way: a function that is called, once a block. As a
// copy in each loop that calls it, it would be most of the plugin's code.
#define MCA_CALLED __attribute__((noinline))

namespace mca::MCA_ISA {
namespace {

// NOLINTNEXTLINE(modernize-use-using): the attributes belong to the declared name
typedef double Row2 __attribute__((vector_size(16), may_alias));
// NOLINTNEXTLINE(modernize-use-using): likewise
typedef double Row4 __attribute__((vector_size(32), may_alias));

// One value of each pair of a block, on a cache-line boundary: loops over k are plain vector loads.
// On the stack, 1 KiB each.
struct alignas(64) Column {
  double value[blockLength];
  double &operator[](int k) { return value[k]; }
  double operator[](int k) const { return value[k]; }
};

// Row i of an array whose rows have the length of Row. The array is 64-byte aligned (RowArray), so
// that each row is aligned, too. may_alias lets the compiler see the doubles and the vector as the
// same memory.
template<class Row>
inline Row *rowOf(double *array, int i)
{
  return reinterpret_cast<Row *>(array) + i;
}

// A row of an array that is only read.
template<class Row>
inline const Row *rowOf(const double *array, int i)
{
  return reinterpret_cast<const Row *>(array) + i;
}

// Four rows of four become four columns of four and back. Shuffles are much cheaper than the
// element-wise loads and stores that strided loops would make. Eight of them: two rows at a time,
// then halves.
inline void transpose(Row4 &a, Row4 &b, Row4 &c, Row4 &d)
{
  const Row4 ab0 = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Row4 ab1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Row4 cd0 = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Row4 cd1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7);
}

// The lesser of two numbers. Of its own, since std::min compiled here for a new processor could be
// the copy that the linker keeps for all, also for code that runs on an old one.
inline int lesser(int a, int b)
{
  return a < b ? a : b;
}

// Rows of two values of one automaton of each pair, as columns; works on whole twos.
// \param index  row of that automaton for each of n pairs; one more is read where n is odd
// \param rows   two values an automaton
// \param c0,c1  first and second values; entry k is of pair k, the rest up to a whole two of the
//               last pair
inline void gather(const int *index, int n, const double *rows, Column &c0, Column &c1)
{
  for (int k = 0; k < n; k += 2) {
    const Row2 a = *rowOf<Row2>(rows, index[k]), b = *rowOf<Row2>(rows, index[k + 1]);
    *rowOf<Row2>(c0.value + k, 0) = __builtin_shufflevector(a, b, 0, 2);
    *rowOf<Row2>(c1.value + k, 0) = __builtin_shufflevector(a, b, 1, 3);
  }
}

// The first three of rows of four values; works on whole fours, by transposing them.
inline void gather(const int *index, int n, const double *rows, Column &c0, Column &c1, Column &c2)
{
  for (int k = 0; k < n; k += 4) {
    Row4 r[4];
    for (int m = 0; m < 4; m++)
      r[m] = *rowOf<Row4>(rows, index[k + m]);
    transpose(r[0], r[1], r[2], r[3]);
    *rowOf<Row4>(c0.value + k, 0) = r[0];
    *rowOf<Row4>(c1.value + k, 0) = r[1];
    *rowOf<Row4>(c2.value + k, 0) = r[2];
  }
}

// Four rows of four, one of each of four pairs, as four columns.
// \param r   the rows, which are transposed in place
// \param k   first of the four pairs in the block, a multiple of 4
// \param c0  the first value of each row, and so on
inline void store(Row4 *r, int k, Column &c0, Column &c1, Column &c2, Column &c3)
{
  transpose(r[0], r[1], r[2], r[3]);
  *rowOf<Row4>(c0.value + k, 0) = r[0];
  *rowOf<Row4>(c1.value + k, 0) = r[1];
  *rowOf<Row4>(c2.value + k, 0) = r[2];
  *rowOf<Row4>(c3.value + k, 0) = r[3];
}

// All four values of rows of four; works on whole fours.
inline void gather(const int *index, int n, const double *rows, Column &c0, Column &c1, Column &c2,
                   Column &c3)
{
  for (int k = 0; k < n; k += 4) {
    Row4 r[4];
    for (int m = 0; m < 4; m++)
      r[m] = *rowOf<Row4>(rows, index[k + m]);
    store(r, k, c0, c1, c2, c3);
  }
}

// One value of the row of one automaton of each pair; works on whole fours. A loop over pairs would
// compile to take row numbers out of vectors again, which takes longer than the loads.
// \tparam LENGTH  values of a row
// \param from    of the first automaton
template<int LENGTH>
inline void gatherOne(const int *index, int n, const double *from, Column &c)
{
  for (int k = 0; k < n; k += 4)
    *rowOf<Row4>(c.value + k, 0) = Row4{from[LENGTH * index[k]], from[LENGTH * index[k + 1]],
                                        from[LENGTH * index[k + 2]], from[LENGTH * index[k + 3]]};
}

// Means of a row of both automata of each pair, for criteria that see both sides.
// \tparam LENGTH  values of a row, a multiple of 4: rows.local.length
// \param rows     LENGTH values an automaton, of guests, too
// \param means    LENGTH values for each of the n pairs, written; 32-byte aligned
template<int LENGTH>
MCA_CALLED void gatherMeans(const int *pi, const int *pj, int n, const double *rows, double *means)
{
  static_assert(LENGTH % 4 == 0);
  constexpr int parts = LENGTH / 4;
  for (int k = 0; k < n; k++)
    for (int m = 0; m < parts; m++)
      *rowOf<Row4>(means, parts * k + m) =
          0.5 * (*rowOf<Row4>(rows, parts * pi[k] + m) + *rowOf<Row4>(rows, parts * pj[k] + m));
}

// Whether no automaton of these n pairs flows: all factors M are exactly 1. M is at most 1, so the
// sum of what is missing is 0 only if nothing is. A sum, since a loop that may end early does not
// vectorise.
inline bool allOne(int n, const Column &a, const Column &b)
{
  double below = 0.0;
#pragma omp simd reduction(+ : below)
  for (int k = 0; k < n; k++)
    below += (1.0 - a[k]) + (1.0 - b[k]);
  return below == 0.0;
}

// Adds rows to both automata of n successive pairs. The order is that of the pairs: an automaton
// may be in several of them, so this is no vector loop over pairs, and sums come out the same on
// any processor.
// \param rows   one of each pair
// \param signs  factors of +1 or -1 for what the second automaton gets
// \param sums   a Row an automaton, added to
template<class Row>
inline void addRows(const int *pi, const int *pj, int n, const Row *rows, const Row &signs,
                    double *sums)
{
  for (int m = 0; m < n; m++) {
    *rowOf<Row>(sums, pi[m]) += rows[m];
    *rowOf<Row>(sums, pj[m]) += rows[m] * signs;
  }
}

// Adds the four columns of each pair as a row to both of its automata: one load and one store of
// each automaton for four quantities, instead of four.
// \param n      number of pairs; the rest of a last four is not added
// \param c0     what goes to the first value of a row, and so on; read up to a whole four
// \param signs  factors of +1 or -1 for what the second automaton gets: -1 of what has a direction
//               seen from i
// \param sums   four values an automaton, added to
inline void scatter(const int *pi, const int *pj, int n, const Column &c0, const Column &c1,
                    const Column &c2, const Column &c3, const Row4 &signs, double *sums)
{
  for (int k = 0; k < n; k += 4) {
    Row4 r[4] = {*rowOf<Row4>(c0.value + k, 0), *rowOf<Row4>(c1.value + k, 0),
                 *rowOf<Row4>(c2.value + k, 0), *rowOf<Row4>(c3.value + k, 0)};
    transpose(r[0], r[1], r[2], r[3]);
    if (k + 4 <= n)
      addRows(pi + k, pj + k, 4, r, signs, sums);
    else
      addRows(pi + k, pj + k, n - k, r, signs, sums);
  }
}

// Adds two columns, with equal sign for both automata: strains do not depend on the side.
// \param sums  two values an automaton, added to
inline void scatter(const int *pi, const int *pj, int n, const Column &c0, const Column &c1,
                    double *sums)
{
  const Row2 same = {1.0, 1.0};
  for (int k = 0; k < n; k += 2) {
    const Row2 a = *rowOf<Row2>(c0.value + k, 0), b = *rowOf<Row2>(c1.value + k, 0);
    const Row2 r[2] = {__builtin_shufflevector(a, b, 0, 2), __builtin_shufflevector(a, b, 1, 3)};
    if (k + 2 <= n)
      addRows(pi + k, pj + k, 2, r, same, sums);
    else
      addRows(pi + k, pj + k, 1, r, same, sums);
  }
}

// Adds rows of PARTS times four values to both automata of each of n pairs. A run of pairs with the
// same i is summed in registers and written once; the order of additions is that of the pairs.
// \tparam STRIDE  fours from one automaton to the next, >= PARTS
// \param pi,pj    rows of both automata; n > 0
// \param signs    factors of +1 or -1 for what the second automaton gets
// \param rowsOf   rowsOf(k, rows) sets rows[part][m] to that part of the row of pair k + m, m < 4
// \param sums     4 STRIDE values an automaton, the first 4 PARTS of which are added to
template<int PARTS, int STRIDE, class RowsOf>
inline void scatterRuns(const int *pi, const int *pj, int n, const Row4 (&signs)[PARTS],
                        const RowsOf &rowsOf, double *sums)
{
  // pairs come sorted by i, so that its sum stays in registers
  int last = pi[0];
  Row4 sum[PARTS] = {};
  auto flush = [&]() {
    for (int part = 0; part < PARTS; part++)
      *rowOf<Row4>(sums, STRIDE * last + part) += sum[part];
  };
  auto add = [&](int k, const Row4(*rows)[4], int m) {
    if (pi[k + m] != last) {
      flush();
      last = pi[k + m];
      for (Row4 &part : sum)
        part = Row4{};
    }
    for (int part = 0; part < PARTS; part++) {
      sum[part] += rows[part][m];
      *rowOf<Row4>(sums, STRIDE * pj[k + m] + part) += signs[part] * rows[part][m];
    }
  };
  Row4 rows[PARTS][4];
  int k = 0;
  for (; k + 4 <= n; k += 4) { // whole fours have a loop of their own, which is unrolled
    rowsOf(k, rows);
    for (int m = 0; m < 4; m++)
      add(k, rows, m);
  }
  if (k < n) {
    rowsOf(k, rows);
    for (int m = 0; m < n - k; m++)
      add(k, rows, m);
  }
  flush();
}

// Signs of what the second automaton gets: the first TURNED of PARTS times four values are turned.
template<int TURNED>
constexpr double signOf(int value)
{
  return value < TURNED ? -1.0 : 1.0;
}

// Values of each pair, PARTS times four, which go as a row to both of its automata.
template<int PARTS>
struct Columns {
  Column c[4 * PARTS];

  // Sets the values from this one on to 0 for all pairs: those of a row that are not used.
  void clearFrom(int value)
  {
    for (int m = value; m < 4 * PARTS; m++)
      c[m] = Column{};
  }

  // Rows of the pairs from k on.
  void rows(int k, Row4 (*rows)[4]) const
  {
    for (int part = 0; part < PARTS; part++) {
      for (int m = 0; m < 4; m++)
        rows[part][m] = *rowOf<Row4>(c[4 * part + m].value + k, 0);
      transpose(rows[part][0], rows[part][1], rows[part][2], rows[part][3]);
    }
  }

  // Adds the rows to both automata of each of n pairs.
  // \tparam TURNED  so many first values go to the second automaton with the opposite sign
  // \tparam STRIDE  fours from one automaton to the next
  // \param sums     of the first automaton, from where this row is added on
  template<int TURNED, int STRIDE = PARTS>
  void scatter(const int *pi, const int *pj, int n, double *sums) const
  {
    Row4 signs[PARTS];
    for (int m = 0; m < 4 * PARTS; m++)
      signs[m / 4][m % 4] = signOf<TURNED>(m);
    scatterRuns<PARTS, STRIDE>(
        pi, pj, n, signs, [this](int k, Row4(*to)[4]) { rows(k, to); }, sums);
  }
};

// Adds two sets of columns, one behind the other in a row.
// \tparam TURNED  so many first values of the second set go to the second automaton with the
//                 opposite sign
template<int TURNED, int A, int B>
inline void scatterBoth(const int *pi, const int *pj, int n, const Columns<A> &a,
                        const Columns<B> &b, double *sums)
{
  Row4 signs[A + B];
  for (int m = 0; m < 4 * (A + B); m++)
    signs[m / 4][m % 4] = m < 4 * A ? 1.0 : signOf<TURNED>(m - 4 * A);
  scatterRuns<A + B, A + B>(
      pi, pj, n, signs,
      [&a, &b](int k, Row4(*to)[4]) {
        a.rows(k, to);
        b.rows(k, to + A);
      },
      sums);
}

} // namespace
} // namespace mca::MCA_ISA

#endif
