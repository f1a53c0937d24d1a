// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/random_number.h"
#include "contact/patch/rough_patch.h"

#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <tuple>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double pi = 3.14159265358979323846;

/// One wave: i and j periods along x and y.
struct Wave {
  int i, j;
  double amplitude, phase;
  bool onWheel;
};

/// Waves of a period lengthX x lengthY in the order of j, then i; one of each pair of opposite
/// directions.
std::vector<Wave> wavesOf(const FractalPatch &fractal, std::uint64_t seed, double lengthX,
                          double lengthY)
{
  constexpr double rounding = 1e-12;
  const double low = 2.0 * pi / fractal.wavelengthMax * (1.0 - rounding);
  const double high = 2.0 * pi / fractal.wavelengthMin * (1.0 + rounding);
  const int maxI = static_cast<int>(high * lengthX / (2.0 * pi * fractal.anisotropy));
  const int maxJ = static_cast<int>(high * lengthY / (2.0 * pi));
  std::vector<Wave> waves;
  double squares = 0.0; // mean square of what the amplitude is scaled by
  for (int j = -maxJ; j <= maxJ; ++j)
    for (int i = 0; i <= maxI; ++i) {
      if (i == 0 && j <= 0)
        continue;
      const double kx = 2.0 * pi * i / lengthX, ky = 2.0 * pi * j / lengthY;
      const double q = std::hypot(fractal.anisotropy * kx, ky);
      if (q < low || q > high)
        continue;
      const double amplitude = std::pow(q * fractal.wavelengthMax, -(fractal.hurst + 1.0));
      const double wave = fractal.rmsSlope > 0.0 ? std::hypot(kx, ky) : 1.0;
      squares += 0.5 * std::pow(amplitude * wave, 2);
      // a number of its own for each (i, j), whatever the box; two random numbers from it
      const std::uint64_t number = (static_cast<std::uint64_t>(i) << 32) +
                                   static_cast<std::uint64_t>(2 * std::abs(j) + (j < 0));
      waves.push_back({i, j, amplitude, 2.0 * pi * uniformNumber(seed, 2 * number),
                       uniformNumber(seed, 2 * number + 1) < 0.5});
    }
  const double wanted = fractal.rmsSlope > 0.0 ? fractal.rmsSlope : fractal.rmsHeight;
  for (Wave &wave : waves)
    wave.amplitude *= wanted / std::sqrt(squares);
  return waves;
}

/// Sum of the waves of one body: for each j along x first, then across.
Vector heights(const std::vector<Wave> &waves, bool onWheel, int nx, int ny)
{
  Vector sum = Vector::Zero(static_cast<Eigen::Index>(nx) * ny);
  std::vector<Complex> row(nx);
  for (std::size_t k = 0; k < waves.size();) {
    const int j = waves[k].j;
    row.assign(nx, 0.0);
    bool any = false;
    for (; k < waves.size() && waves[k].j == j; ++k) {
      const Wave &wave = waves[k];
      if (wave.onWheel != onWheel)
        continue;
      any = true;
      for (int ix = 0; ix < nx; ++ix) // the angle's whole turns are taken off as whole numbers
        row[ix] += std::polar(wave.amplitude,
                              wave.phase + pi * ((wave.i * (2L * ix + 1)) % (2L * nx)) / nx);
    }
    if (!any)
      continue;
    for (int iy = 0; iy < ny; ++iy) {
      const Complex turn = std::polar(1.0, pi * ((j * (2L * iy + 1)) % (2L * ny)) / ny);
      for (int ix = 0; ix < nx; ++ix)
        sum[ix + static_cast<Eigen::Index>(nx) * iy] +=
            row[ix].real() * turn.real() - row[ix].imag() * turn.imag();
    }
  }
  return sum;
}

/// Known from the waves.
HeightMapStatistics statisticsOf(const std::vector<Wave> &waves, double lengthX, double lengthY,
                                 double shortest)
{
  double height = 0.0, alongX = 0.0, alongY = 0.0;
  for (const Wave &wave : waves) {
    const double square = 0.5 * wave.amplitude * wave.amplitude;
    height += square;
    alongX += square * std::pow(2.0 * pi * wave.i / lengthX, 2);
    alongY += square * std::pow(2.0 * pi * wave.j / lengthY, 2);
  }
  HeightMapStatistics statistics;
  statistics.step = "generated";
  statistics.rmsHeight = std::sqrt(height);
  statistics.rmsSlopeX = std::sqrt(alongX);
  statistics.rmsSlopeY = std::sqrt(alongY);
  statistics.shortestWavelength = shortest;
  return statistics;
}

} // namespace

RoughPatch fractalPatch(const FractalPatch &fractal, std::uint64_t seed, const PatchGrid &box,
                        double travel)
{
  const double boxX = box.nx * box.dx, boxY = box.ny * box.dy;
  const int boxes = fractal.boxes > 0 ? fractal.boxes : 1 + static_cast<int>(travel / boxX);
  const double alongX = fractal.wavelengthMin * fractal.anisotropy;
  for (const auto &[wave, cell, direction] :
       {std::tuple{alongX, box.dx, "along x"}, {fractal.wavelengthMin, box.dy, "along y"}})
    if (wave < fewestCellsPerWave * cell)
      throw Error(ExitCode::BadInput,
                  fmt::format("points: cells of {:.4g} mm cannot carry waves of {:.4g} mm {}; at "
                              "least {:g} to a wave are needed, {:g} are advised",
                              cell * 1e3, wave * 1e3, direction, fewestCellsPerWave,
                              advisedCellsPerWave));
  const std::vector<Wave> waves = wavesOf(fractal, seed, boxes * boxX, boxY);
  if (waves.empty())
    throw Error(ExitCode::BadInput,
                fmt::format("roughness: no wave between {:g} and {:g} mm has a whole number of "
                            "periods in the box of {:.4g} x {:.4g} mm",
                            fractal.wavelengthMin * 1e3, fractal.wavelengthMax * 1e3, boxX * 1e3,
                            boxY * 1e3));
  RoughPatch patch;
  patch.number = seed;
  patch.shortestWave = std::min(alongX, fractal.wavelengthMin);
  for (const bool onWheel : {true, false}) {
    RoughMap &map = onWheel ? patch.wheel : patch.rail;
    map.nx = boxes * box.nx;
    map.ny = box.ny;
    map.height = heights(waves, onWheel, map.nx, map.ny);
  }
  patch.statistics.push_back(statisticsOf(waves, boxes * boxX, boxY, patch.shortestWave));
  for (const auto &[wave, cell, direction] :
       {std::tuple{alongX, box.dx, "along x"}, {fractal.wavelengthMin, box.dy, "along y"}})
    if (wave < advisedCellsPerWave * cell)
      patch.remarks.push_back(fmt::format(
          "points: waves of {:.4g} mm have {:.1f} cells {}; {:g} are advised", wave * 1e3,
          wave / cell, direction, advisedCellsPerWave));
  return patch;
}

} // namespace wheelrail
