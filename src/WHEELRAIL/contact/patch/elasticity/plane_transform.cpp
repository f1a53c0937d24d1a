// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/plane_transform.h"

#include "contact/convolution.h"
#include "contact/fftw_memory.h"

#include <algorithm>
#include <vector>

namespace wheelrail {
namespace {
constexpr int blockColumns = 8; ///< gathered together: two cache lines of a row
}

struct PlaneTransform::Work {
  Work(int cellsX, int cellsY, int lengthX, int lengthY, int fieldCount)
      : nx(cellsX), ny(cellsY), sizeX(lengthX), sizeY(lengthY), bins(lengthX / 2 + 1),
        fields(fieldCount), row(fftwArray<double>(sizeX)),
        plane(fftwArray<fftw_complex>(std::size_t(fields) * ny * bins)),
        block(fftwArray<fftw_complex>(std::size_t(fields) * blockColumns * sizeY)),
        rowForward(fftwPlan(
            sizeX,
            [&] { return fftw_plan_dft_r2c_1d(sizeX, row.get(), plane.get(), FFTW_ESTIMATE); })),
        rowBackward(fftwPlan(
            sizeX,
            [&] { return fftw_plan_dft_c2r_1d(sizeX, plane.get(), row.get(), FFTW_ESTIMATE); })),
        columnsForward(columns(FFTW_FORWARD)), columnsBackward(columns(FFTW_BACKWARD))
  {
    std::fill_n(&block[0][0], 2 * std::size_t(fields) * blockColumns * sizeY, 0.0);
  }

  /// A plan of all columns of the block, in place.
  FftwPlan columns(int sign)
  {
    return fftwPlan(sizeY, [&] {
      return fftw_plan_many_dft(1, &sizeY, fields * blockColumns, block.get(), nullptr, 1, sizeY,
                                block.get(), nullptr, 1, sizeY, sign, FFTW_ESTIMATE);
    });
  }

  fftw_complex *spectrumRow(int field, int iy) const
  {
    return plane.get() + (std::size_t(field) * ny + iy) * bins;
  }
  Complex *planeRow(int field, int iy) const
  {
    return reinterpret_cast<Complex *>(spectrumRow(field, iy));
  }
  Complex *column(int field, int c) const
  {
    return reinterpret_cast<Complex *>(block.get()) +
           (std::size_t(field) * blockColumns + c) * sizeY;
  }
  void rowsForward(int field, const double *values);
  void rowsBackward(int field, double *values);
  /// Moves columns firstBin .. between the plane and the block.
  void gather(int firstBin, int count);
  void scatter(int firstBin, int count);

  int nx, ny, sizeX, sizeY, bins, fields;
  FftwArray<double> row;
  FftwArray<fftw_complex> plane, block;
  FftwPlan rowForward, rowBackward, columnsForward, columnsBackward;
};

// Plans of one row serve all: rows of complex numbers are aligned as FFTW's arrays are. The way
// back may destroy the spectrum, which nobody needs any more.
void PlaneTransform::Work::rowsForward(int field, const double *values)
{
  for (int iy = 0; iy < ny; ++iy) {
    std::copy_n(values + std::size_t(iy) * nx, nx, row.get());
    std::fill(row.get() + nx, row.get() + sizeX, 0.0);
    fftw_execute_dft_r2c(rowForward.get(), row.get(), spectrumRow(field, iy));
  }
}

void PlaneTransform::Work::rowsBackward(int field, double *values)
{
  for (int iy = 0; iy < ny; ++iy) {
    fftw_execute_dft_c2r(rowBackward.get(), spectrumRow(field, iy), row.get());
    std::copy_n(row.get(), nx, values + std::size_t(iy) * nx);
  }
}

void PlaneTransform::Work::gather(int firstBin, int count)
{
  for (int f = 0; f < fields; ++f) {
    for (int c = 0; c < blockColumns; ++c)
      std::fill(column(f, c) + ny, column(f, c) + sizeY, Complex(0.0));
    for (int iy = 0; iy < ny; ++iy) {
      const Complex *from = planeRow(f, iy) + firstBin;
      for (int c = 0; c < count; ++c)
        column(f, c)[iy] = from[c];
    }
  }
}

void PlaneTransform::Work::scatter(int firstBin, int count)
{
  for (int f = 0; f < fields; ++f)
    for (int iy = 0; iy < ny; ++iy) {
      Complex *to = planeRow(f, iy) + firstBin;
      for (int c = 0; c < count; ++c)
        to[c] = column(f, c)[iy];
    }
}

PlaneTransform::PlaneTransform(int nx, int ny, int sizeX, int sizeY, int fields)
    : work_(std::make_unique<Work>(nx, ny, sizeX, sizeY, fields))
{
}
PlaneTransform::~PlaneTransform() = default;
PlaneTransform::PlaneTransform(PlaneTransform &&) noexcept = default;
PlaneTransform &PlaneTransform::operator=(PlaneTransform &&) noexcept = default;

int PlaneTransform::sizeX() const
{
  return work_->sizeX;
}
int PlaneTransform::sizeY() const
{
  return work_->sizeY;
}

// Rows first: only the ny rows that hold something, not the sizeY of the padded plane. Then the
// columns, a few at a time: gathered from the rows, transformed, multiplied, transformed back and
// scattered while they are in the cache. Last the same ny rows back; nobody asks for the others.
void PlaneTransform::multiply(double *const *fields, const Symbol &symbol)
{
  Work &w = *work_;
  for (int f = 0; f < w.fields; ++f)
    w.rowsForward(f, fields[f]);
  std::vector<Complex *> columns(w.fields);
  for (int first = 0; first < w.bins; first += blockColumns) {
    const int count = std::min(blockColumns, w.bins - first);
    w.gather(first, count);
    fftw_execute(w.columnsForward.get());
    for (int c = 0; c < count; ++c) {
      for (int f = 0; f < w.fields; ++f)
        columns[f] = w.column(f, c);
      symbol(first + c, columns.data());
    }
    fftw_execute(w.columnsBackward.get());
    w.scatter(first, count);
  }
  for (int f = 0; f < w.fields; ++f)
    w.rowsBackward(f, fields[f]);
}

// Time for a point of a column, measured with FFTW 3.3.10 for 64 to 1200 of them: 1.5 to 2.2 ns
// without a factor 3, 2.2 to 3 with one, 2.8 to 5 with more.
PlaneSize fastPlaneSize(int nx, int ny)
{
  constexpr double slower = 1.4; // with each of the first two factors 3
  const auto cost = [](int size) {
    return size * (size % 9 == 0 ? slower * slower : size % 3 == 0 ? slower : 1.0);
  };
  int best = fastTransformSize(ny);
  for (int size = best; size < slower * slower * ny; size = fastTransformSize(size + 1))
    if (cost(size) < cost(best))
      best = size;
  return {fastTransformSize(nx), best};
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
