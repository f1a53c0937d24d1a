// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_PLANE_TRANSFORM_H
#define WHEELRAIL_PATCH_PLANE_TRANSFORM_H

#include <complex>
#include <functional>
#include <memory>
#include <vector>

namespace wheelrail {

/// Products with operators that are diagonal after a Fourier transform in the plane, of fields
/// that are zero outside nx x ny cells. The transforms of zero rows and of rows that nobody asks
/// for are left out, and each column is transformed, multiplied and transformed back while it is
/// in the cache.
///
/// FFTW plans are FFTW_ESTIMATE, so that results do not depend on a timing and repeat to the last
/// bit. One object has one work buffer: use one per thread.
/// Units come in by fields and symbol; the transforms are not normalised, so that a symbol includes
/// 1/(sizeX sizeY).
/// \tparam Real double, or float: half the time, and products to 1e-6 of their largest
template<class Real>
class PlaneTransformOf {
 public:
  using Complex = std::complex<Real>;
  /// Multiplies the column of x-frequency kx (0 .. sizeX/2): columns[f] are the sizeY values of
  /// field f, y-frequencies in FFTW's order (0, 1, .. -1). Neither direction is normalised.
  using Symbol = std::function<void(int kx, Complex *const *columns)>;

  /// \param fields number of fields that one product takes and gives
  /// \param sizeX, sizeY lengths of the transforms: >= nx, ny; >= 2 nx, 2 ny where the operator's
  ///        products with the fields must not wrap around
  PlaneTransformOf(int nx, int ny, int sizeX, int sizeY, int fields);
  ~PlaneTransformOf();
  PlaneTransformOf(PlaneTransformOf &&) noexcept;
  PlaneTransformOf &operator=(PlaneTransformOf &&) noexcept;

  /// As given to the constructor; those of `fastPlaneSize` are fast.
  int sizeX() const;
  int sizeY() const;

  /// \param fields nx*ny values each, x fastest; replaced by the products
  /// \param symbol called once for each kx from 0 on; negative ones follow from the fields' being
  ///         real
  /// \return nothing: what lies beyond nx x ny cells of the product is dropped
  void multiply(double *const *fields, const Symbol &symbol)
  {
    multiply<double>(fields, fields, symbol);
  }
  /// Products of one place, written to another.
  /// \tparam Value  double, or Real
  template<class Value>
  void multiply(const Value *const *from, Value *const *to, const Symbol &symbol);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};
using PlaneTransform = PlaneTransformOf<double>;

/// Lengths of a transform, for rows (x) and columns.
struct PlaneSize {
  int x, y;
};

/// Lengths that are fast, x >= nx and y >= ny. FFTW_ESTIMATE's plans are slow where a factor 3 is
/// in the length: 270 takes twice as long as 280.
PlaneSize fastPlaneSize(int nx, int ny);

/// `fastPlaneSize` in single precision, where other lengths are fast.
PlaneSize fastSinglePlaneSize(int nx, int ny);

/// A transform of nx x ny cells whose products do not wrap around.
/// \param fields as of `PlaneTransform`
PlaneTransform paddedTransform(int nx, int ny, int fields);

/// A quarter of a spectrum or of a kernel, the rest by symmetry: (kx, ky) at
/// kx*(sizeY/2 + 1) + ky, both from 0 on.
using Quarter = std::vector<double>;

/// In place: values at offsets (ix, iy) >= 0 of a kernel that is even or odd in each direction ->
/// its spectrum at frequencies (kx, ky) >= 0, without the factor -i for each odd direction. Rows:
/// x.
/// \param countX, countY half the transform's sizes plus one
void quarterTransform(Quarter &values, int countX, int countY, bool oddX, bool oddY);

/// Calls `apply(ky, place in a quarter's column, sign of the frequency)` along a column.
template<class Apply>
void forFrequencies(int sizeY, const Apply &apply)
{
  const int half = sizeY / 2;
  for (int ky = 0; ky <= half; ++ky)
    apply(ky, ky, 1.0);
  for (int ky = half + 1; ky < sizeY; ++ky)
    apply(ky, sizeY - ky, -1.0);
}

} // namespace wheelrail
#endif
