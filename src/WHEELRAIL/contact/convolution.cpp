// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/convolution.h"

#include "contact/fftw_memory.h"

#include <algorithm>

namespace wheelrail {

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
  explicit Transform(int length)
      : size(length), bins(length / 2 + 1), real(fftwArray<double>(size)),
        complex(fftwArray<fftw_complex>(bins)),
        forward(fftwPlan(
            size,
            [&] { return fftw_plan_dft_r2c_1d(size, real.get(), complex.get(), FFTW_ESTIMATE); })),
        backward(fftwPlan(size, [&] {
          return fftw_plan_dft_c2r_1d(size, complex.get(), real.get(), FFTW_ESTIMATE);
        }))
  {
  }

  int size, bins;
  FftwArray<double> real;
  FftwArray<fftw_complex> complex;
  FftwPlan forward, backward;
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
  std::fill_n(fft_->real.get(), fft_->size, 0.0);
  for (int m = -(n_ - 1); m <= n_ - 1; ++m)
    fft_->real[(m + fft_->size) % fft_->size] = kernel(m);
  fftw_execute(fft_->forward.get());
  Spectrum spectrum(fft_->bins); // FFTW's transforms are not normalised
  for (int m = 0; m < fft_->bins; ++m)
    spectrum[m] =
        std::complex<double>(fft_->complex[m][0], fft_->complex[m][1]) / double(fft_->size);
  return spectrum;
}

Convolution::Vector Convolution::multiply(const Vector &x, const Spectrum &spectrum)
{
  std::copy(x.data(), x.data() + n_, fft_->real.get());
  std::fill(fft_->real.get() + n_, fft_->real.get() + fft_->size, 0.0);
  fftw_execute(fft_->forward.get());
  for (int m = 0; m < fft_->bins; ++m) {
    const double re = fft_->complex[m][0], im = fft_->complex[m][1];
    fft_->complex[m][0] = re * spectrum[m].real() - im * spectrum[m].imag();
    fft_->complex[m][1] = re * spectrum[m].imag() + im * spectrum[m].real();
  }
  fftw_execute(fft_->backward.get());
  return Eigen::Map<const Vector>(fft_->real.get(), n_);
}

} // namespace wheelrail
