// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_LINE_CONTACT_TEMPERATURE_H
#define WHEELRAIL_CONTACT_LINE_CONTACT_TEMPERATURE_H

#include "contact/convolution.h"

#include <array>
#include <vector>

namespace wheelrail {

/// Heat from friction between two bodies at a large Peclet number v0 a/(2 kappa) (1600 for Table 2
/// at 10 m/s), where equal ones each take half of it. SI units.
struct ThermalMaterial {
  double conductivity; ///< W/(m K)
  double density;      ///< kg/m3
  double specificHeat; ///< J/(kg K)
};

/// v0 a/(2 kappa), how much faster the contact moves on than heat spreads along it, -.
/// \param halfWidth a, m, of a patch the semi-axis along the way
/// \param speed v0, m/s, > 0
double pecletNumber(double halfWidth, double speed, const ThermalMaterial &material);

/// The material of two equal bodies between which heat makes the same temperature as between these
/// two: at a large Peclet number only the effusivity sqrt(lambda rho c_p) counts, and its sum over
/// both bodies (Carslaw, Jaeger, Conduction of Heat in Solids, sec. 2.8). Equal bodies stay as they
/// are; else density and specific heat are the first one's.
ThermalMaterial pairMaterial(const ThermalMaterial &wheel, const ThermalMaterial &rail);

/// The temperature that two bodies of unlike bulk temperature take where they touch, without
/// friction: the mean of both, weighted with their effusivities (likewise).
/// \param bulk of wheel and rail, K
double bulkOfContact(const ThermalMaterial &wheel, const ThermalMaterial &rail,
                     const std::array<double, 2> &bulk);

/// Where the temperature of the contact comes from.
enum class ThermalModel {
  Off,           ///< no temperature
  Averaged,      ///< Eq. 11: mean rise of a Hertzian contact that slides as a whole
  AveragedPower, ///< Eq. 11 with the frictional power in place of mu times sliding speed
  Local          ///< `FlashTemperature`, `TravellingHeat`
};

struct ThermalSpecification {
  ThermalModel model = ThermalModel::Averaged;
  ThermalMaterial material{}; ///< of both bodies, `pairMaterial`; not used by Off
  double bulk = 0.0;          ///< K, to which friction's heat adds: `bulkOfContact`; point contact
};

/// Eq. 11's coefficient, exactly 8 sqrt(2)/(15 sqrt(pi)) = 0.425538 (the paper rounds to 0.426).
/// A pure number, of the profile of heat that a Hertzian pressure makes.
double meanTemperatureCoefficient();

/// Maximum of Eq. 11's temperature over its mean, 0.61730992/0.42553843.
double maximumOverMeanTemperature();

/// Eq. 11: mean temperature rise over a Hertzian line contact,
/// coefficient x powerOverLoad x p0 x sqrt(a/(lambda rho c_p v0)), K.
/// \param powerOverLoad friction's heat in a second over the load, m/s: mu times the sliding speed
///        where everything slides (Eq. 11 as printed), less below
/// \param hertzPressure p0, Pa
/// \param halfWidth a, m
/// \param speed v0, m/s, > 0
double meanTemperatureRise(double powerOverLoad, double hertzPressure, double halfWidth,
                           double speed, const ThermalMaterial &material);

/// Flash temperature of a heated stretch that moves along a half-space at speed v0:
///   Theta(x) = integral over s > x of q(s)/2 / sqrt(pi lambda rho c_p v0 (s - x)) ds.
/// Heat is uniform on each cell and Theta is its mean over a cell: both integrals are exact, so
/// that the mean over the contact has no error of order sqrt(h), as point sources have.
/// One object has one work buffer: use one per thread.
class FlashTemperature {
 public:
  /// n cells of size `cellSize` (m); the leading edge is at the last cell.
  FlashTemperature(int cells, double cellSize, double speed, const ThermalMaterial &material);

  /// \param heat friction power per area of each cell, both bodies' together, W/m2
  /// \return temperature rise per cell, K
  Eigen::VectorXd rise(const Eigen::VectorXd &heat);

 private:
  Convolution line_;
  Convolution::Spectrum kernel_;
};

/// Flash temperature where heat changes in time: every cell of material remembers the heat of its
/// way through the contact. With heat that does not change it becomes `FlashTemperature`. Each cell
/// of material keeps one number for every step since its first heat.
class TravellingHeat {
 public:
  /// At the start all material is cold. Arguments as of `FlashTemperature`.
  TravellingHeat(int count, double cellSize, double speed, const ThermalMaterial &material);

  /// The material moves on by one cell towards smaller x and takes up heat (W/m2, both bodies').
  void step(const Eigen::VectorXd &heat);
  /// Temperature rise of a cell after the last step, K.
  /// \param cell 0 .. n - 1, as they lie in the contact now
  double rise(int cell) const;

 private:
  std::vector<double> &historyAt(int cell);

  int cells_;
  int steps_ = 0;
  Eigen::VectorXd kernel_; ///< influence of heat m steps ago
  /// Heat of the material, oldest first, from the first heat on; a cell's place is (cell + steps) %
  /// cells.
  std::vector<std::vector<double>> history_;
};

} // namespace wheelrail
#endif
