// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/half_space.h"

namespace wheelrail {
namespace {

/// Calls visit(fine index, coarse index) for all fine cells.
template<class Visit>
void eachCell(const CellGrid &fine, const CellGrid &coarse, Visit visit)
{
  const int columns = fine.nx / coarse.nx, rows = fine.ny / coarse.ny;
  for (int iy = 0; iy < fine.ny; ++iy)
    for (int ix = 0; ix < fine.nx; ++ix)
      visit(fine.index(ix, iy), coarse.index(ix / columns, iy / rows));
}

} // namespace

Eigen::VectorXd coarseMean(const CellGrid &fine, const CellGrid &coarse,
                           const Eigen::VectorXd &values)
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(coarse.cells());
  eachCell(fine, coarse, [&](int i, int k) { sum[k] += values[i]; });
  return sum * (double(coarse.cells()) / fine.cells());
}

Eigen::VectorXd refinedField(const CellGrid &fine, const CellGrid &coarse,
                             const Eigen::VectorXd &values)
{
  Eigen::VectorXd refined(fine.cells());
  eachCell(fine, coarse, [&](int i, int k) { refined[i] = values[k]; });
  return refined;
}

} // namespace wheelrail
