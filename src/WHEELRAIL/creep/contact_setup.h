#ifndef WHEELRAIL_CREEP_CONTACT_SETUP_H
#define WHEELRAIL_CREEP_CONTACT_SETUP_H

#include "contact/hertz.h"
#include "contact/line/contact_interval.h"
#include "contact/normal_contact.h"
#include "creep/case_file.h"
#include "law/friction_law.h"

#include <cmath>
#include <vector>

namespace wheelrail {

/// What all points of a creep curve share: grid, surface and normal contact of one profile.
struct ContactSetup {
  HertzContact hertz;
  int cells = 0;
  double cellSize = 0.0;     ///< m
  std::uint64_t profile = 0; ///< seed, or number of the measured profile from 1 on
  /// Periodic: flat surfaces; `hertz` then holds load, modulus, half the period as halfWidth and
  /// the mean pressure as hertzPressure.
  Boundary boundary = Boundary::Free;
  /// Roughness to be taken off the gap, m. One value per cell; more where material travels through
  /// the contact and the profile is measured. Empty: smooth.
  Eigen::VectorXd roughness;
  bool periodic = true;                      ///< the roughness goes on with its beginning
  std::vector<ProfileStatistics> statistics; ///< after every step of the preparation
  NormalContactResult normal;                ///< without a pressure limit, or with the cold one's

  double position(int cell) const { return (cell + 0.5 - 0.5 * cells) * cellSize; } ///< m
  bool isNominal(int cell) const { return std::abs(position(cell)) <= hertz.halfWidth; }
  /// Mean over the nominal contact of a value per cell.
  double nominalMean(const Eigen::VectorXd &values) const;
  /// Undeformed gap in cells, the material moved on by `travel` cells (towards smaller x).
  Eigen::VectorXd gap(int travel = 0) const;
  /// Number of cells the material can travel.
  int longestTravel() const;
  NormalContactProblem problem(double pressureLimit, int travel = 0) const;

  double realContactLength() const; ///< m, of `normal`
  double realAreaRatio() const { return realContactLength() / (2.0 * hertz.halfWidth); }
};

/// Prepares the surface and solves the normal contact.
/// @param index of the profile, below input.profiles()
/// @throws Error (BadInput) when profiles do not fit, or the contact reaches the domain's ends
ContactSetup prepareContact(const Case &input, std::size_t index);

/// Pressure limit in Pa at a temperature rise in K: the hardness 3 sigma_0(Theta), infinite unless
/// the case asks for it.
double pressureLimit(const Case &input, double temperatureRise);

/// Eq. 10: sigma_0(Theta) = strength (1 - Theta/strengthTemperature), Pa. Kept above a thousandth
/// of the strength, so that an iteration can pass through what a solution may not reach.
double strengthAt(const Case &input, double temperatureRise);

/// Does the temperature act back on friction or pressure?
bool hasFeedback(const Case &input);

/// @throws Error (NotConverged) when a temperature rise that acts back leaves no strength
void checkStrength(const Case &input, double hottest, double speed, double creep);

/// @throws Error (BadInput) unless every cell with pressure is away from the domain's ends
void checkInsideDomain(const Eigen::VectorXd &pressure);

} // namespace wheelrail
#endif
