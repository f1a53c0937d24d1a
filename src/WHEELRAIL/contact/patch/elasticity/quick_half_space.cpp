// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/quick_half_space.h"

namespace wheelrail {
namespace {

PlaneTransformOf<float> singleTransform(const CellGrid &grid, int times)
{
  const PlaneSize size = fastSinglePlaneSize(times * grid.nx, times * grid.ny);
  return {grid.nx, grid.ny, size.x, size.y, 1};
}

std::vector<float> inSinglePrecision(const Quarter &values)
{
  return {values.begin(), values.end()};
}

} // namespace

QuickHalfSpace::QuickHalfSpace(const CellGrid &grid, const ElasticPair &pair,
                               const InfluenceTable &table)
    : padded_(singleTransform(grid, 2)), wrapping_(singleTransform(grid, 1)),
      compliance_(
          inSinglePrecision(normalSpectrum(table, grid, pair, padded_.sizeX(), padded_.sizeY()))),
      stiffness_(
          inSinglePrecision(normalStiffness(grid, pair, wrapping_.sizeX(), wrapping_.sizeY())))
{
}

void QuickHalfSpace::product(const Eigen::VectorXd &field, Transform &transform,
                             const Spectrum &spectrum, Eigen::VectorXd &result)
{
  const double *from = field.data();
  double *to = result.data();
  const int sizeY = transform.sizeY(), countY = sizeY / 2 + 1;
  transform.multiply(&from, &to, [&](int kx, Transform::Complex *const *column) {
    const float *s = &spectrum[std::size_t(kx) * countY];
    Transform::Complex *values = column[0];
    forFrequencies(sizeY, [&](int ky, int bin, double) { values[ky] *= s[bin]; });
  });
}

void QuickHalfSpace::displacement(const Eigen::VectorXd &pressure, Eigen::VectorXd &result)
{
  product(pressure, padded_, compliance_, result);
}

void QuickHalfSpace::tractionEstimate(const Eigen::VectorXd &displacement, Eigen::VectorXd &result)
{
  product(displacement, wrapping_, stiffness_, result);
}

} // namespace wheelrail
