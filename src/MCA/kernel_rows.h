/// \file kernel_rows.h
/// Rows of the per-automaton arrays as vectors of the compiler: one load, one addition, one store.
/// For the kernels' sources only, which are compiled once for each instruction set.
#ifndef MCA_KERNEL_ROWS_H
#define MCA_KERNEL_ROWS_H

#include "kernel.h"

namespace mca {
namespace MCA_ISA {
namespace {

inline int lesser(int a, int b)
{
  return a < b ? a : b;
}

typedef double Row2 __attribute__((vector_size(16), may_alias));
typedef double Row4 __attribute__((vector_size(32), may_alias));
typedef double Row8 __attribute__((vector_size(64), may_alias));

template<class Row>
inline Row *rowOf(double *array, int i)
{
  return reinterpret_cast<Row *>(array) + i;
}

template<class Row>
inline const Row *rowOf(const double *array, int i)
{
  return reinterpret_cast<const Row *>(array) + i;
}

// Adds each pair's row to both of its automata, with the given signs for the second one. Pairs
// come sorted by i, so that its sum stays in a register.
template<class Row>
inline void addToBoth(const int *pi, const int *pj, int n, const double *rows, const Row &signs,
                      double *sums)
{
  for (int k = 0; k < n;) {
    const int i = pi[k];
    Row sum = *rowOf<Row>(rows, k);
    *rowOf<Row>(sums, pj[k]) += sum * signs;
    for (k++; k < n && pi[k] == i; k++) {
      const Row row = *rowOf<Row>(rows, k);
      *rowOf<Row>(sums, pj[k]) += row * signs;
      sum += row;
    }
    *rowOf<Row>(sums, i) += sum;
  }
}

// Responses of both automata of a block's pairs side by side: those of i, those of j.
inline void gatherResponses(const int *pi, const int *pj, int n, const double *response,
                            double *both)
{
  for (int k = 0; k < n; k++) {
    *rowOf<Row2>(both, 2 * k) = *rowOf<Row2>(response, pi[k]);
    *rowOf<Row2>(both, 2 * k + 1) = *rowOf<Row2>(response, pj[k]);
  }
}

} // namespace
} // namespace MCA_ISA
} // namespace mca

#endif
