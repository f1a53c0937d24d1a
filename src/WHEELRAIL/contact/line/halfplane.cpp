// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/line/halfplane.h"

#include "shared/pi.h"

#include <cmath>

namespace wheelrail {
namespace {

using mcawr::pi;

/// Sum over j >= 0 of (-1)^j / (x + j)^2, x > 0: twelve terms, then the mean of the remainder's
/// Euler-Maclaurin expansion f/2 - f'/4 + f'''/48 - f^(5)/480 at the next point.
double alternatingInverseSquares(double x)
{
  double sum = 0.0;
  for (int j = 0; j < 12; ++j)
    sum += (j % 2 ? -1.0 : 1.0) / ((x + j) * (x + j));
  const double y = 1.0 / (x + 12.0), y2 = y * y;
  return sum + y2 * (0.5 + y * (0.5 + y2 * (-0.5 + y2 * 1.5)));
}

/// Symbol of the cell kernel at the angle theta = k h in (0, pi]: the continuous 2/|k| times the
/// transform of a cell, summed over aliases.
double periodicSymbol(double theta)
{
  const double x = theta / (2.0 * pi);
  // Aliases k + 2 pi j: the cell's transform changes sign with j, k |k| changes it for j < 0.
  const double total = alternatingInverseSquares(x) + alternatingInverseSquares(1.0 - x);
  return 4.0 * std::sin(0.5 * theta) * total / (4.0 * pi * pi);
}

} // namespace

double cellInfluence(double m)
{
  const double x = std::abs(m);
  if (x < 0.5)
    return (2.0 / pi) * (1.0 + std::log(2.0)); // the loaded cell itself
  // ln x plus the difference that curvature makes, without cancellation of large terms
  const double s = 0.5 / x;
  const double integral =
      std::log(x) + (x + 0.5) * std::log1p(s) - (x - 0.5) * std::log1p(-s) - 1.0;
  return -(2.0 / pi) * integral;
}

// A line with free ends takes twice the cells: the cyclic convolution needs room for offsets
// -(n-1) .. n-1.
HalfPlane::HalfPlane(int cells, Boundary boundary, double cellSize)
    : boundary_(boundary), cellGrid_{cells, 1, cellSize, cellSize},
      line_(cells, boundary == Boundary::Free ? fastTransformSize(2 * cells) : cells)
{
  if (boundary_ == Boundary::Periodic)
    fillPeriodicSpectra();
}

void HalfPlane::fillPeriodicSpectra()
{
  const int size = line_.size(), bins = line_.bins();
  if (boundary_ == Boundary::Periodic)
    compliance_.assign(bins, 0.0);
  stiffness_.assign(bins, 0.0);
  // A line with free ends gets its preconditioner here as well: as if it repeated with the
  // padded length.
  for (int m = 1; m < bins; ++m) {
    const double symbol = periodicSymbol(2.0 * pi * m / size);
    if (boundary_ == Boundary::Periodic)
      compliance_[m] = symbol / size; // FFTW's transforms are not normalised
    stiffness_[m] = 1.0 / (symbol * size);
  }
  // The mean has no stiffness; half of the lowest wave's keeps the preconditioner definite.
  if (bins > 1)
    stiffness_[0] = 0.5 * stiffness_[1];
}

HalfPlane::Vector HalfPlane::multiply(const Vector &x, Spectrum &spectrum, double (*kernel)(int))
{
  if (spectrum.empty())
    spectrum = line_.spectrumOf(kernel);
  return line_.multiply(x, spectrum);
}

HalfPlane::Vector HalfPlane::displacement(const Vector &q)
{
  return cellGrid_.dx * multiply(q, compliance_, [](int m) { return cellInfluence(m); });
}
// Derivative of the logarithm for loads at the centres, half-way between them: 1/(m + 1/2).
HalfPlane::Vector HalfPlane::stretch(const Vector &q)
{
  return multiply(q, stretching_, [](int m) { return 2.0 / (pi * (m + 0.5)); });
}
HalfPlane::Vector HalfPlane::stretchTransposed(const Vector &q)
{
  return multiply(q, stretchingTransposed_, [](int m) { return 2.0 / (pi * (0.5 - m)); });
}
HalfPlane::Vector HalfPlane::edgeLogarithm(const Vector &charge)
{
  return multiply(charge, faces_, [](int m) { return std::log(std::abs(m + 0.5)); });
}
HalfPlane::Vector HalfPlane::tractionEstimate(const Vector &u)
{
  if (stiffness_.empty())
    fillPeriodicSpectra();
  return line_.multiply(u, stiffness_) / cellGrid_.dx;
}

HalfPlane::Vector HalfPlane::layeredEstimate(const Vector &u, double layer)
{
  if (layer == 0.0)
    return tractionEstimate(u);
  if (stiffness_.empty())
    fillPeriodicSpectra();
  if (layered_.empty() || layer_ != layer) {
    layered_ = stiffness_;
    for (auto &value : layered_)
      value /= cellGrid_.dx + layer * line_.size() * value;
    layer_ = layer;
  }
  return line_.multiply(u, layered_);
}

HalfSpace *HalfPlane::coarser()
{
  constexpr int coarsestGrid = 128;
  if (cells() < 2 * coarsestGrid || cells() % 2 != 0)
    return nullptr;
  if (!coarser_)
    coarser_ = std::make_unique<HalfPlane>(cells() / 2, boundary_, 2.0 * cellGrid_.dx);
  return coarser_.get();
}

} // namespace wheelrail
