// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/plane_transform.h"

#include "contact/convolution.h"
#include "contact/fftw_memory.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace wheelrail {
namespace {
constexpr int blockColumns = 8; ///< gathered together: two cache lines of a row
/// Values between rows and between columns: those of lengths 2^n would share their places in
/// caches.
constexpr int apart = 8;
constexpr int soon = 6; ///< rows ahead that are fetched in time
} // namespace

// Rows are real, and two of them make one complex row, x + i y, whose transform is half the work of
// theirs. Z[k] of it has both: X[k] = (Z[k] + conj Z[-k])/2, Y[k] = (Z[k] - conj Z[-k])/(2 i).
template<class Real>
struct PlaneTransformOf<Real>::Work {
  using Plan = FftwPlanOf<Real>;
  using Value = typename Fftw<Real>::Complex;

  Work(int cellsX, int cellsY, int lengthX, int lengthY, int fieldCount)
      : nx(cellsX), ny(cellsY), sizeX(lengthX), sizeY(lengthY), bins(lengthX / 2 + 1),
        pairs((cellsY + 1) / 2), fields(fieldCount), rows(fftwArray<Value>(sizeX)),
        plane(fftwArray<Value>(std::size_t(fields) * pairs * (sizeX + apart))),
        block(fftwArray<Value>(std::size_t(fields) * blockColumns * (sizeY + apart))),
        waves(fftwArray<Value>(std::size_t(fields) * (sizeY + apart))),
        rowForward(line(sizeX, rows.get(), plane.get(), FFTW_FORWARD)),
        rowBackward(line(sizeX, plane.get(), rows.get(), FFTW_BACKWARD)),
        columnForward(line(sizeY, block.get(), waves.get(), FFTW_FORWARD)),
        columnBackward(line(sizeY, waves.get(), block.get(), FFTW_BACKWARD))
  {
  }

  static Plan line(int size, Value *from, Value *to, int sign)
  {
    return fftwPlan<Real>(size,
                          [&] { return Fftw<Real>::plan(size, from, to, sign, FFTW_ESTIMATE); });
  }

  Value *spectrumRow(int field, int pair) const
  {
    return plane.get() + (std::size_t(field) * pairs + pair) * (sizeX + apart);
  }
  Complex *planeRow(int field, int pair) const
  {
    return reinterpret_cast<Complex *>(spectrumRow(field, pair));
  }
  Value *blockColumn(int field, int c) const
  {
    return block.get() + (std::size_t(field) * blockColumns + c) * (sizeY + apart);
  }
  Complex *column(int field, int c) const
  {
    return reinterpret_cast<Complex *>(blockColumn(field, c));
  }
  Value *wavesOf(int field) const { return waves.get() + std::size_t(field) * (sizeY + apart); }
  template<class Field>
  void rowsForward(int field, const Field *values);
  template<class Field>
  void rowsBackward(int field, Field *values);
  /// Moves columns firstBin .. between the plane and the block.
  void gather(int firstBin, int count);
  void scatter(int firstBin, int count);

  int nx, ny, sizeX, sizeY, bins, pairs, fields;
  FftwArray<Value> rows, plane, block, waves;
  Plan rowForward, rowBackward, columnForward, columnBackward;
};

// Plans of one pair serve all: an even number of complex numbers keeps rows aligned as FFTW's
// arrays are.
template<class Real>
template<class Field>
void PlaneTransformOf<Real>::Work::rowsForward(int field, const Field *values)
{
  std::fill(&rows[0][0], &rows[0][0] + 2 * sizeX, Real(0));
  for (int pair = 0; pair < pairs; ++pair) {
    const Field *x = values + std::size_t(2 * pair) * nx;
    const bool two = 2 * pair + 1 < ny;
    for (int i = 0; i < nx; ++i) {
      rows[i][0] = static_cast<Real>(x[i]);
      rows[i][1] = two ? static_cast<Real>(x[nx + i]) : Real(0);
    }
    Fftw<Real>::executeOn(rowForward.get(), rows.get(), spectrumRow(field, pair));
  }
}

template<class Real>
template<class Field>
void PlaneTransformOf<Real>::Work::rowsBackward(int field, Field *values)
{
  for (int pair = 0; pair < pairs; ++pair) {
    Fftw<Real>::executeOn(rowBackward.get(), spectrumRow(field, pair), rows.get());
    Field *x = values + std::size_t(2 * pair) * nx;
    for (int i = 0; i < nx; ++i)
      x[i] = rows[i][0];
    if (2 * pair + 1 < ny)
      for (int i = 0; i < nx; ++i)
        x[nx + i] = rows[i][1];
  }
}

// sizeY is even, so that there is a place for both rows of a pair.
template<class Real>
void PlaneTransformOf<Real>::Work::gather(int firstBin, int count)
{
  constexpr Real half(0.5);
  const std::ptrdiff_t stride = sizeY + apart;
  for (int f = 0; f < fields; ++f) {
    for (int pair = 0; pair < pairs; ++pair) {
      const Complex *ahead = planeRow(f, pair) + firstBin;
      const Complex *back = planeRow(f, pair) + sizeX - firstBin;
      const Complex first = firstBin == 0 ? ahead[0] : back[0];
      if (pair + soon < pairs) { // the processor does not foresee lines of rows so far apart
        const std::ptrdiff_t way = std::ptrdiff_t(soon) * (sizeX + apart);
        __builtin_prefetch(ahead + way);
        __builtin_prefetch(back + way - (count - 1));
        __builtin_prefetch(back + way);
      }
      Complex *to = column(f, 0) + std::ptrdiff_t(2) * pair;
      for (int c = 0; c < count; ++c, to += stride) {
        const Complex u = ahead[c], v = c == 0 ? first : back[-c];
        to[0] = {half * (u.real() + v.real()), half * (u.imag() - v.imag())};
        to[1] = {half * (u.imag() + v.imag()), half * (v.real() - u.real())};
      }
    }
    for (int c = 0; c < count; ++c)
      std::fill(column(f, c) + ny, column(f, c) + sizeY, Complex(0));
  }
}

template<class Real>
void PlaneTransformOf<Real>::Work::scatter(int firstBin, int count)
{
  const std::ptrdiff_t stride = sizeY + apart;
  for (int f = 0; f < fields; ++f)
    for (int pair = 0; pair < pairs; ++pair) {
      Complex *ahead = planeRow(f, pair) + firstBin;
      Complex *back = planeRow(f, pair) + sizeX - firstBin;
      const Complex *from = column(f, 0) + std::ptrdiff_t(2) * pair;
      for (int c = 0; c < count; ++c, from += stride) {
        const Complex x = from[0], y = from[1];
        if (firstBin + c > 0)
          back[-c] = {x.real() + y.imag(), y.real() - x.imag()};
        ahead[c] = {x.real() - y.imag(), x.imag() + y.real()};
      }
    }
}

template<class Real>
PlaneTransformOf<Real>::PlaneTransformOf(int nx, int ny, int sizeX, int sizeY, int fields)
    : work_(std::make_unique<Work>(nx, ny, sizeX, sizeY, fields))
{
}
template<class Real>
PlaneTransformOf<Real>::~PlaneTransformOf() = default;
template<class Real>
PlaneTransformOf<Real>::PlaneTransformOf(PlaneTransformOf &&) noexcept = default;
template<class Real>
PlaneTransformOf<Real> &PlaneTransformOf<Real>::operator=(PlaneTransformOf &&) noexcept = default;

template<class Real>
int PlaneTransformOf<Real>::sizeX() const
{
  return work_->sizeX;
}
template<class Real>
int PlaneTransformOf<Real>::sizeY() const
{
  return work_->sizeY;
}

// Rows first: only the ny rows that hold something, not the sizeY of the padded plane. Then the
// columns, a few at a time: gathered from the rows, transformed, multiplied, transformed back and
// scattered while they are in the cache. Last the same ny rows back; nobody asks for the others.
// Transforms lead from one place to another: in place FFTW's are slower by a quarter.
template<class Real>
template<class Field>
void PlaneTransformOf<Real>::multiply(const Field *const *from, Field *const *to,
                                      const Symbol &symbol)
{
  Work &w = *work_;
  for (int f = 0; f < w.fields; ++f)
    w.rowsForward(f, from[f]);
  std::vector<Complex *> waves(w.fields);
  for (int f = 0; f < w.fields; ++f)
    waves[f] = reinterpret_cast<Complex *>(w.wavesOf(f));
  for (int first = 0; first < w.bins; first += blockColumns) {
    const int count = std::min(blockColumns, w.bins - first);
    w.gather(first, count);
    for (int c = 0; c < count; ++c) {
      for (int f = 0; f < w.fields; ++f)
        Fftw<Real>::executeOn(w.columnForward.get(), w.blockColumn(f, c), w.wavesOf(f));
      symbol(first + c, waves.data());
      for (int f = 0; f < w.fields; ++f)
        Fftw<Real>::executeOn(w.columnBackward.get(), w.wavesOf(f), w.blockColumn(f, c));
    }
    w.scatter(first, count);
  }
  for (int f = 0; f < w.fields; ++f)
    w.rowsBackward(f, to[f]);
}

template class PlaneTransformOf<double>;
template class PlaneTransformOf<float>;
template void PlaneTransformOf<double>::multiply(const double *const *, double *const *,
                                                 const Symbol &);
template void PlaneTransformOf<float>::multiply(const double *const *, double *const *,
                                                const Symbol &);
template void PlaneTransformOf<float>::multiply(const float *const *, float *const *,
                                                const Symbol &);

namespace {

/// The length of at least n that costs least. \param cost of a length
template<class Cost>
int cheapestLength(int n, const Cost &cost)
{
  int best = fastTransformSize(n);
  for (int size = best; size < 2 * n; size = fastTransformSize(size + 1))
    if (cost(size) < cost(best))
      best = size;
  return best;
}

} // namespace

// Time for a point of a column, measured with FFTW 3.3.10 for 64 to 1200 of them: 1.5 to 2.2 ns
// without a factor 3, 2.2 to 3 with one, 2.8 to 5 with more.
PlaneSize fastPlaneSize(int nx, int ny)
{
  const auto cost = [](int size) {
    constexpr double slower = 1.4; // with each of the first two factors 3
    return size * (size % 9 == 0 ? slower * slower : size % 3 == 0 ? slower : 1.0);
  };
  return {cheapestLength(nx, cost), cheapestLength(ny, cost)};
}

// Measured likewise: 1.0 to 1.3 ns for those of the list, 2^n and 5 2^n from 128 on, 1.5 to 2.5 for
// others.
PlaneSize fastSinglePlaneSize(int nx, int ny)
{
  const auto cost = [](int size) {
    constexpr double slower = 1.7;
    constexpr int fast[] = {144, 192, 240, 384, 400};
    int odd = size;
    while (odd % 2 == 0)
      odd /= 2;
    const bool listed = std::find(std::begin(fast), std::end(fast), size) != std::end(fast);
    return size * (listed || (size >= 128 && (odd == 1 || odd == 5)) ? 1.0 : slower);
  };
  return {cheapestLength(nx, cost), cheapestLength(ny, cost)};
}

PlaneTransform paddedTransform(int nx, int ny, int fields)
{
  const PlaneSize size = fastPlaneSize(2 * nx, 2 * ny);
  return {nx, ny, size.x, size.y, fields};
}

void quarterTransform(Quarter &values, int countX, int countY, bool oddX, bool oddY)
{
  // RODFT00 leaves out the zeros at offset 0 and half the size.
  const int skipX = oddX ? 1 : 0, skipY = oddY ? 1 : 0;
  const int n = countX - 2 * skipX, m = countY - 2 * skipY;
  if (n < 1 || m < 1)
    return;
  const auto at = [&](int i, int j) { return std::size_t(i + skipX) * countY + j + skipY; };
  const auto kind = [](bool odd) { return odd ? FFTW_RODFT00 : FFTW_REDFT00; };
  const auto buffer = fftwArray<double>(std::size_t(n) * m);
  const auto plan = fftwPlan(n + m, [&] {
    return fftw_plan_r2r_2d(n, m, buffer.get(), buffer.get(), kind(oddX), kind(oddY),
                            FFTW_ESTIMATE);
  });
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      buffer[std::size_t(i) * m + j] = values[at(i, j)];
  fftw_execute(plan.get());
  std::fill(values.begin(), values.end(), 0.0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      values[at(i, j)] = buffer[std::size_t(i) * m + j];
}

} // namespace wheelrail
