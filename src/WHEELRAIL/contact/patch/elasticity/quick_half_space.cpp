// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/quick_half_space.h"

namespace wheelrail {
namespace {

PlaneTransformOf<float> singleTransform(const CellGrid &grid, int times, int fields)
{
  const PlaneSize size = fastSinglePlaneSize(times * grid.nx, times * grid.ny);
  return {grid.nx, grid.ny, size.x, size.y, fields};
}

std::vector<float> inSinglePrecision(const Quarter &values)
{
  return {values.begin(), values.end()};
}

SymmetricSymbolOf<float> inSinglePrecision(const SymmetricSymbol &symbol)
{
  return {inSinglePrecision(symbol.xx), inSinglePrecision(symbol.yy), inSinglePrecision(symbol.xy)};
}

} // namespace

QuickHalfSpace::QuickHalfSpace(const CellGrid &grid, const ElasticPair &pair,
                               const InfluenceTable &table)
    : padded_(singleTransform(grid, 2, 1)), wrapping_(singleTransform(grid, 1, 1)),
      compliance_(
          inSinglePrecision(normalSpectrum(table, grid, pair, padded_.sizeX(), padded_.sizeY()))),
      stiffness_(
          inSinglePrecision(normalStiffness(grid, pair, wrapping_.sizeX(), wrapping_.sizeY())))
{
}

void QuickHalfSpace::product(const Field &field, Transform &transform, const Spectrum &spectrum,
                             Field &result)
{
  const float *from = field.data();
  float *to = result.data();
  const int sizeY = transform.sizeY(), countY = sizeY / 2 + 1;
  transform.multiply(&from, &to, [&](int kx, Transform::Complex *const *column) {
    const float *s = &spectrum[std::size_t(kx) * countY];
    Transform::Complex *values = column[0];
    forFrequencies(sizeY, [&](int ky, int bin, double) { values[ky] *= s[bin]; });
  });
}

void QuickHalfSpace::displacement(const Field &pressure, Field &result)
{
  product(pressure, padded_, compliance_, result);
}

void QuickHalfSpace::tractionEstimate(const Field &displacement, Field &result)
{
  product(displacement, wrapping_, stiffness_, result);
}

QuickTractions::QuickTractions(const CellGrid &grid, const ElasticPair &pair,
                               const InfluenceTable &table)
    : padded_(singleTransform(grid, 2, 2)), wrapping_(singleTransform(grid, 1, 2)),
      compliance_(inSinglePrecision(
          tangentialSpectrum(table, grid, pair, padded_.sizeX(), padded_.sizeY()))),
      stiffness_(
          inSinglePrecision(tangentialStiffness(grid, pair, wrapping_.sizeX(), wrapping_.sizeY())))
{
}

TangentialField QuickTractions::product(const TangentialField &field, Transform &transform,
                                        const Symbol &symbol)
{
  TangentialField result{Eigen::VectorXd(field.x.size()), Eigen::VectorXd(field.y.size())};
  const double *from[] = {field.x.data(), field.y.data()};
  double *to[] = {result.x.data(), result.y.data()};
  multiplyBySymmetric(transform, from, to, symbol);
  return result;
}

TangentialField QuickTractions::displacement(const TangentialField &traction)
{
  return product(traction, padded_, compliance_);
}

TangentialField QuickTractions::tractionEstimate(const TangentialField &displacement)
{
  return product(displacement, wrapping_, stiffness_);
}

} // namespace wheelrail
