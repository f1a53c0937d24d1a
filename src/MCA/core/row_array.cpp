// SPDX-License-Identifier: GPL-2.0-or-later
#include "row_array.h"

#include <new>
#include <stdexcept>
#include <string>

namespace mca {

void AlignedArray::reserve(size_t n)
{
  if (n <= size_)
    return;
  size_ = (n + n / 8 + 7) / 8 * 8;
  data_.reset(static_cast<double *>(std::aligned_alloc(64, size_ * sizeof(double))));
  if (!data_)
    throw std::bad_alloc();
}

int RowArray::checked(int i) const
{
  if (i < 0 || i >= rows_)
    throw std::out_of_range("row " + std::to_string(i) + " of " + std::to_string(rows_));
  return i;
}

} // namespace mca
