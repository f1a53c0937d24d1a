#include "halfplane.h"

#include <algorithm>
#include <cmath>
#include <fftw3.h>
#include <mutex>

namespace wheelrail {
namespace {

constexpr double pi = 3.14159265358979323846;
std::mutex plannerMutex; // FFTW's planner is the one part of it that is not thread-safe

/// Sum over j >= 0 of (-1)^j / (x + j)^2, x > 0: twelve terms, then the mean of the remainder's
/// Euler-Maclaurin expansion f/2 - f'/4 + f'''/48 - f^(5)/480 at the next point.
double alternatingInverseSquares(double x)
{
  double sum = 0.0;
  for (int j = 0; j < 12; ++j) sum += (j % 2 ? -1.0 : 1.0) / ((x + j) * (x + j));
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

int fastTransformSize(int n)
{
  for (int size = std::max(n, 2);; ++size) {
    int rest = size;
    for (int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1 && size % 2 == 0) return size;
  }
}

double cellInfluence(double m)
{
  const double x = std::abs(m);
  if (x < 0.5) return (2.0 / pi) * (1.0 + std::log(2.0)); // the loaded cell itself
  // ln x plus the difference that curvature makes, without cancellation of large terms
  const double s = 0.5 / x;
  const double integral = std::log(x) + (x + 0.5) * std::log1p(s) - (x - 0.5) * std::log1p(-s) - 1.0;
  return -(2.0 / pi) * integral;
}

struct HalfPlane::Transform {
  explicit Transform(int length) : size(length), bins(length / 2 + 1)
  {
    const std::lock_guard<std::mutex> lock(plannerMutex);
    real = fftw_alloc_real(size);
    complex = fftw_alloc_complex(bins);
    forward = fftw_plan_dft_r2c_1d(size, real, complex, FFTW_ESTIMATE);
    backward = fftw_plan_dft_c2r_1d(size, complex, real, FFTW_ESTIMATE);
  }
  ~Transform()
  {
    const std::lock_guard<std::mutex> lock(plannerMutex);
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

HalfPlane::HalfPlane(int cells, Boundary boundary) : n(cells), kind(boundary)
{
  // Cyclic convolution needs room for offsets -(n-1) .. n-1, and one more for the shifted kernel.
  fft = std::make_unique<Transform>(kind == Boundary::Free ? fastTransformSize(2 * n) : n);
  fillPeriodicSpectra();
  if (kind == Boundary::Periodic) return;

  const int size = fft->size;
  std::vector<double> table(size, 0.0), shifted(table), mirrored(table), logarithm(table);
  for (int m = -(n - 1); m <= n - 1; ++m) {
    const int place = (m + size) % size;
    table[place] = cellInfluence(m);
    shifted[place] = 2.0 / (pi * (m + 0.5));
    mirrored[place] = 2.0 / (pi * (0.5 - m));
    logarithm[place] = std::log(std::abs(m + 0.5));
  }
  compliance = transformOf(table);
  stretching = transformOf(shifted);
  stretchingTransposed = transformOf(mirrored);
  faces = transformOf(logarithm);
}

HalfPlane::~HalfPlane() = default;
HalfPlane::HalfPlane(HalfPlane &&) noexcept = default;
HalfPlane &HalfPlane::operator=(HalfPlane &&) noexcept = default;

void HalfPlane::fillPeriodicSpectra()
{
  const int size = fft->size;
  compliance.assign(fft->bins, 0.0);
  stiffness.assign(fft->bins, 0.0);
  for (int m = 1; m < fft->bins; ++m) {
    const double symbol = periodicSymbol(2.0 * pi * m / size);
    compliance[m] = symbol / size; // FFTW's transforms are not normalised
    stiffness[m] = 1.0 / (symbol * size);
  }
  // The mean has no stiffness; half of the lowest wave's keeps the preconditioner definite.
  if (fft->bins > 1) stiffness[0] = 0.5 * stiffness[1];
}

HalfPlane::Spectrum HalfPlane::transformOf(const std::vector<double> &table)
{
  std::copy(table.begin(), table.end(), fft->real);
  fftw_execute(fft->forward);
  Spectrum spectrum(fft->bins);
  for (int m = 0; m < fft->bins; ++m)
    spectrum[m] = std::complex<double>(fft->complex[m][0], fft->complex[m][1]) / double(fft->size);
  return spectrum;
}

HalfPlane::Vector HalfPlane::multiply(const Vector &q, const Spectrum &spectrum)
{
  std::copy(q.data(), q.data() + n, fft->real);
  std::fill(fft->real + n, fft->real + fft->size, 0.0);
  fftw_execute(fft->forward);
  for (int m = 0; m < fft->bins; ++m) {
    const double re = fft->complex[m][0], im = fft->complex[m][1];
    fft->complex[m][0] = re * spectrum[m].real() - im * spectrum[m].imag();
    fft->complex[m][1] = re * spectrum[m].imag() + im * spectrum[m].real();
  }
  fftw_execute(fft->backward);
  return Eigen::Map<const Vector>(fft->real, n);
}

HalfPlane::Vector HalfPlane::displacement(const Vector &q) { return multiply(q, compliance); }
HalfPlane::Vector HalfPlane::stretch(const Vector &q) { return multiply(q, stretching); }
HalfPlane::Vector HalfPlane::stretchTransposed(const Vector &q)
{
  return multiply(q, stretchingTransposed);
}
HalfPlane::Vector HalfPlane::edgeLogarithm(const Vector &charge) { return multiply(charge, faces); }
HalfPlane::Vector HalfPlane::tractionEstimate(const Vector &u) { return multiply(u, stiffness); }

} // namespace wheelrail
