// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/convolution.h"

#include <algorithm>
#include <fftw3.h>

namespace wheelrail {

std::mutex &fftwPlannerMutex()
{
  static std::mutex mutex;
  return mutex;
}

int fastTransformSize(int n)
{
  for (int size = std::max(n, 2);; ++size) {
    int rest = size;
    for (int factor : {2, 3, 5, 7})
      while (rest % factor == 0)
        rest /= factor;
    if (rest == 1 && size % 2 == 0)
      return size;
  }
}

struct Convolution::Transform {
  explicit Transform(int length) : size(length), bins(length / 2 + 1)
  {
    const std::lock_guard<std::mutex> lock(fftwPlannerMutex());
    real = fftw_alloc_real(size);
    complex = fftw_alloc_complex(bins);
    forward = fftw_plan_dft_r2c_1d(size, real, complex, FFTW_ESTIMATE);
    backward = fftw_plan_dft_c2r_1d(size, complex, real, FFTW_ESTIMATE);
  }
  ~Transform()
  {
    const std::lock_guard<std::mutex> lock(fftwPlannerMutex());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
    fftw_free(real);
    fftw_free(complex);
  }
  Transform(const Transform &) = delete;
  Transform &operator=(const Transform &) = delete;

  int size, bins;
  double *real;
  fftw_complex *complex;
  fftw_plan forward, backward;
};

Convolution::Convolution(int cells, int size) : n_(cells), fft_(std::make_unique<Transform>(size))
{
}
Convolution::~Convolution() = default;
Convolution::Convolution(Convolution &&) noexcept = default;
Convolution &Convolution::operator=(Convolution &&) noexcept = default;

int Convolution::size() const
{
  return fft_->size;
}

Convolution::Spectrum Convolution::spectrumOf(const std::function<double(int)> &kernel)
{
  std::fill(fft_->real, fft_->real + fft_->size, 0.0);
  for (int m = -(n_ - 1); m <= n_ - 1; ++m)
    fft_->real[(m + fft_->size) % fft_->size] = kernel(m);
  fftw_execute(fft_->forward);
  Spectrum spectrum(fft_->bins); // FFTW's transforms are not normalised
  for (int m = 0; m < fft_->bins; ++m)
    spectrum[m] =
        std::complex<double>(fft_->complex[m][0], fft_->complex[m][1]) / double(fft_->size);
  return spectrum;
}

Convolution::Vector Convolution::multiply(const Vector &x, const Spectrum &spectrum)
{
  std::copy(x.data(), x.data() + n_, fft_->real);
  std::fill(fft_->real + n_, fft_->real + fft_->size, 0.0);
  fftw_execute(fft_->forward);
  for (int m = 0; m < fft_->bins; ++m) {
    const double re = fft_->complex[m][0], im = fft_->complex[m][1];
    fft_->complex[m][0] = re * spectrum[m].real() - im * spectrum[m].imag();
    fft_->complex[m][1] = re * spectrum[m].imag() + im * spectrum[m].real();
  }
  fftw_execute(fft_->backward);
  return Eigen::Map<const Vector>(fft_->real, n_);
}

} // namespace wheelrail
