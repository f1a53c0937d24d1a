// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_CONVOLUTION_H
#define WHEELRAIL_CONTACT_CONVOLUTION_H

#include <Eigen/Core>

#include <complex>
#include <functional>
#include <memory>
#include <vector>

namespace wheelrail {

/// Smallest even 2^a 3^b 5^c 7^d >= n: a length that FFTW transforms fast.
/// \param n >= 1
int fastTransformSize(int n);

/// Products with Toeplitz matrices of n cells by FFTW, y_i = sum_j kernel(i - j) x_j: how the
/// influence of cells on each other is computed in n log n. A pure number; units come in by kernel
/// and x.
///
/// One object has one work buffer: use one per thread. Plans are FFTW_ESTIMATE, so that results
/// do not depend on a timing and repeat to the last bit. A product costs two transforms.
/// A periodic line takes size = n and a spectrum of one's own; on a line with free ends zero
/// padding to 2n keeps the ends from influencing each other.
class Convolution {
 public:
  using Vector = Eigen::VectorXd;
  using Spectrum = std::vector<std::complex<double>>;

  /// \param cells n >= 1
  /// \param size length of the transforms; n for a periodic line, >= 2n for one with free ends;
  ///        `fastTransformSize` gives lengths that are fast
  Convolution(int cells, int size);
  ~Convolution();
  Convolution(Convolution &&) noexcept;
  Convolution &operator=(Convolution &&) noexcept;

  /// Number of values that a product takes and gives.
  int cells() const { return n_; }
  int size() const;                           ///< length of the transforms
  int bins() const { return size() / 2 + 1; } ///< of a spectrum

  /// Spectrum (already divided by the size, since FFTW's transforms are not normalised) of
  /// kernel(m), the influence of a cell on one m cells further, m = -(n-1) .. n-1; size >= 2n.
  /// \param kernel called once for each m; its unit times that of x is the product's
  /// \return bins() values, for `multiply` of this object or one of the same size
  Spectrum spectrumOf(const std::function<double(int)> &kernel);

  /// The product with one vector.
  /// \param x         n values
  /// \param spectrum  of `spectrumOf`, or bins() values of one's own
  /// \return n values; exact but for rounding
  Vector multiply(const Vector &x, const Spectrum &spectrum);

 private:
  struct Transform;
  int n_;
  std::unique_ptr<Transform> fft_;
};

} // namespace wheelrail
#endif
