#include "contact_temperature.h"

#include <cmath>

namespace wheelrail {
namespace {
constexpr double pi = 3.14159265358979323846;

/// Mean over a cell of the unit source on a cell m further ahead, of 1/sqrt(distance), h = 1:
/// second difference of (4/3) d^(3/2); for far cells its expansion, where the difference would
/// cancel.
double meanInverseRoot(int m)
{
  if (m < 0)
    return 0.0;
  if (m == 0)
    return 4.0 / 3.0;
  const double d = m;
  if (m > 300)
    return (1.0 + 1.0 / (16.0 * d * d)) / std::sqrt(d);
  return 4.0 / 3.0 * (std::pow(d + 1.0, 1.5) - 2.0 * std::pow(d, 1.5) + std::pow(d - 1.0, 1.5));
}
} // namespace

double meanTemperatureCoefficient()
{
  return 8.0 * std::sqrt(2.0) / (15.0 * std::sqrt(pi));
}

double maximumOverMeanTemperature()
{
  return 0.61730992 / 0.42553843;
}

double meanTemperatureRise(double frictionRatio, double hertzPressure, double slidingSpeed,
                           double halfWidth, double speed, const ThermalMaterial &material)
{
  const double diffusion = material.conductivity * material.density * material.specificHeat * speed;
  return meanTemperatureCoefficient() * frictionRatio * hertzPressure * slidingSpeed *
         std::sqrt(halfWidth / diffusion);
}

FlashTemperature::FlashTemperature(int cells, double cellSize, double speed,
                                   const ThermalMaterial &material)
    : line(cells, fastTransformSize(2 * cells))
{
  const double diffusion = material.conductivity * material.density * material.specificHeat * speed;
  const double scale = 0.5 * std::sqrt(cellSize / (pi * diffusion));
  kernel = line.spectrumOf([&](int m) { return scale * meanInverseRoot(-m); });
}

Eigen::VectorXd FlashTemperature::rise(const Eigen::VectorXd &heat)
{
  return line.multiply(heat, kernel);
}

} // namespace wheelrail
