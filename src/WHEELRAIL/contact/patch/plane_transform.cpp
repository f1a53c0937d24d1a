// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/plane_transform.h"

#include "contact/convolution.h"

#include <algorithm>
#include <fftw3.h>
#include <mutex>
#include <vector>

namespace wheelrail {
namespace {
constexpr int blockColumns = 8; ///< gathered together: two cache lines of a row
}

struct PlaneTransform::Work {
  Work(int cellsX, int cellsY, int lengthX, int lengthY, int fieldCount)
      : nx(cellsX), ny(cellsY), sizeX(lengthX), sizeY(lengthY), bins(lengthX / 2 + 1),
        fields(fieldCount)
  {
    const std::lock_guard<std::mutex> lock(fftwPlannerMutex());
    row = fftw_alloc_real(sizeX);
    rowSpectrum = fftw_alloc_complex(bins);
    plane = fftw_alloc_complex(std::size_t(fields) * ny * bins);
    block = fftw_alloc_complex(std::size_t(fields) * blockColumns * sizeY);
    rowForward = fftw_plan_dft_r2c_1d(sizeX, row, rowSpectrum, FFTW_ESTIMATE);
    rowBackward = fftw_plan_dft_c2r_1d(sizeX, rowSpectrum, row, FFTW_ESTIMATE);
    const int howMany = fields * blockColumns;
    columnsForward = fftw_plan_many_dft(1, &sizeY, howMany, block, nullptr, 1, sizeY, block,
                                        nullptr, 1, sizeY, FFTW_FORWARD, FFTW_ESTIMATE);
    columnsBackward = fftw_plan_many_dft(1, &sizeY, howMany, block, nullptr, 1, sizeY, block,
                                         nullptr, 1, sizeY, FFTW_BACKWARD, FFTW_ESTIMATE);
    std::fill_n(&block[0][0], 2 * std::size_t(howMany) * sizeY, 0.0);
  }
  ~Work()
  {
    const std::lock_guard<std::mutex> lock(fftwPlannerMutex());
    for (fftw_plan plan : {rowForward, rowBackward, columnsForward, columnsBackward})
      fftw_destroy_plan(plan);
    fftw_free(row);
    fftw_free(rowSpectrum);
    fftw_free(plane);
    fftw_free(block);
  }
  Work(const Work &) = delete;
  Work &operator=(const Work &) = delete;

  Complex *planeRow(int field, int iy) const
  {
    return reinterpret_cast<Complex *>(plane) + (std::size_t(field) * ny + iy) * bins;
  }
  Complex *column(int field, int c) const
  {
    return reinterpret_cast<Complex *>(block) + (std::size_t(field) * blockColumns + c) * sizeY;
  }
  void rowsForward(int field, const double *values);
  void rowsBackward(int field, double *values);
  /// Moves columns firstBin .. between the plane and the block.
  void gather(int firstBin, int count);
  void scatter(int firstBin, int count);

  int nx, ny, sizeX, sizeY, bins, fields;
  double *row;
  fftw_complex *rowSpectrum, *plane, *block;
  fftw_plan rowForward, rowBackward, columnsForward, columnsBackward;
};

void PlaneTransform::Work::rowsForward(int field, const double *values)
{
  for (int iy = 0; iy < ny; ++iy) {
    std::copy_n(values + std::size_t(iy) * nx, nx, row);
    std::fill(row + nx, row + sizeX, 0.0);
    fftw_execute(rowForward);
    std::copy_n(reinterpret_cast<Complex *>(rowSpectrum), bins, planeRow(field, iy));
  }
}

void PlaneTransform::Work::rowsBackward(int field, double *values)
{
  for (int iy = 0; iy < ny; ++iy) {
    std::copy_n(planeRow(field, iy), bins, reinterpret_cast<Complex *>(rowSpectrum));
    fftw_execute(rowBackward);
    std::copy_n(row, nx, values + std::size_t(iy) * nx);
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

void PlaneTransform::multiply(double *const *fields, const Symbol &symbol)
{
  Work &w = *work_;
  for (int f = 0; f < w.fields; ++f)
    w.rowsForward(f, fields[f]);
  std::vector<Complex *> columns(w.fields);
  for (int first = 0; first < w.bins; first += blockColumns) {
    const int count = std::min(blockColumns, w.bins - first);
    w.gather(first, count);
    fftw_execute(w.columnsForward);
    for (int c = 0; c < count; ++c) {
      for (int f = 0; f < w.fields; ++f)
        columns[f] = w.column(f, c);
      symbol(first + c, columns.data());
    }
    fftw_execute(w.columnsBackward);
    w.scatter(first, count);
  }
  for (int f = 0; f < w.fields; ++f)
    w.rowsBackward(f, fields[f]);
}

} // namespace wheelrail
