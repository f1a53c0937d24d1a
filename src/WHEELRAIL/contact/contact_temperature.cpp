// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/contact_temperature.h"

#include "shared/pi.h"

#include <cmath>

namespace wheelrail {
namespace {
using mcawr::pi;

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
  const auto power = [](double x) { return x * std::sqrt(x); };
  return 4.0 / 3.0 * (power(d + 1.0) - 2.0 * power(d) + power(d - 1.0));
}

double effusivity(const ThermalMaterial &body)
{
  return std::sqrt(body.conductivity * body.density * body.specificHeat);
}

/// rho c v0 lambda of the heated half-space, and what multiplies meanInverseRoot.
double diffusion(double speed, const ThermalMaterial &material)
{
  return material.conductivity * material.density * material.specificHeat * speed;
}
double flashScale(double cellSize, double speed, const ThermalMaterial &material)
{
  return 0.5 * std::sqrt(cellSize / (pi * diffusion(speed, material)));
}
} // namespace

ThermalMaterial pairMaterial(const ThermalMaterial &wheel, const ThermalMaterial &rail)
{
  if (wheel.conductivity == rail.conductivity && wheel.density == rail.density &&
      wheel.specificHeat == rail.specificHeat)
    return wheel;
  const double mean = 0.5 * (effusivity(wheel) + effusivity(rail));
  return {mean * mean / (wheel.density * wheel.specificHeat), wheel.density, wheel.specificHeat};
}

double bulkOfContact(const ThermalMaterial &wheel, const ThermalMaterial &rail,
                     const std::array<double, 2> &bulk)
{
  if (bulk[0] == bulk[1])
    return bulk[0];
  const double ofWheel = effusivity(wheel), ofRail = effusivity(rail);
  return (ofWheel * bulk[0] + ofRail * bulk[1]) / (ofWheel + ofRail);
}

double pecletNumber(double halfWidth, double speed, const ThermalMaterial &material)
{
  return 0.5 * speed * halfWidth * material.density * material.specificHeat / material.conductivity;
}

double meanTemperatureCoefficient()
{
  return 8.0 * std::sqrt(2.0) / (15.0 * std::sqrt(pi));
}

double maximumOverMeanTemperature()
{
  return 0.61730992 / 0.42553843;
}

double meanTemperatureRise(double powerOverLoad, double hertzPressure, double halfWidth,
                           double speed, const ThermalMaterial &material)
{
  return meanTemperatureCoefficient() * powerOverLoad * hertzPressure *
         std::sqrt(halfWidth / diffusion(speed, material));
}

FlashTemperature::FlashTemperature(int cells, double cellSize, double speed,
                                   const ThermalMaterial &material)
    : line_(cells, fastTransformSize(2 * cells))
{
  const double scale = flashScale(cellSize, speed, material);
  kernel_ = line_.spectrumOf([&](int m) { return scale * meanInverseRoot(-m); });
}

Eigen::VectorXd FlashTemperature::rise(const Eigen::VectorXd &heat)
{
  return line_.multiply(heat, kernel_);
}

TravellingHeat::TravellingHeat(int count, double cellSize, double speed,
                               const ThermalMaterial &material)
    : cells_(count), kernel_(count), history_(count)
{
  const double scale = flashScale(cellSize, speed, material);
  for (int m = 0; m < cells_; ++m)
    kernel_[m] = scale * meanInverseRoot(m);
}

std::vector<double> &TravellingHeat::historyAt(int cell)
{
  return history_[(cell + steps_) % cells_];
}

// Histories stay where they are while the material moves: after k steps the cell i of the contact
// is what began as cell i + k, so that the one that has left at the trailing side is the one that
// comes in, with its memory cleared.
void TravellingHeat::step(const Eigen::VectorXd &heat)
{
  ++steps_;
  historyAt(cells_ - 1).clear(); // new material comes in
  for (int i = 0; i < cells_; ++i) {
    std::vector<double> &past = historyAt(i);
    if (heat[i] != 0.0 || !past.empty())
      past.push_back(heat[i]);
  }
}

double TravellingHeat::rise(int cell) const
{
  const std::vector<double> &past = history_[(cell + steps_) % cells_];
  const auto length = static_cast<Eigen::Index>(past.size());
  return Eigen::Map<const Eigen::VectorXd>(past.data(), length).reverse().dot(kernel_.head(length));
}

} // namespace wheelrail
