// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_CONTACT_FRICTION_H
#define WHEELRAIL_LAW_CONTACT_FRICTION_H

#include "law/friction_law.h"

#include <Eigen/Core>

#include <string>

namespace wheelrail {

/// Friction that falls with sliding speed (O. Polach, Wear 258 (2005) 992):
/// mu = mu0 [(1 - A) exp(-B w) + A].
struct FallingFriction {
  double mu0 = 0.0; ///< at sliding speed 0, > 0
  double A = 1.0;   ///< limit at large sliding speed over mu0, 0 .. 1
  double B = 0.0;   ///< s/m, >= 0

  /// @param slidingSpeed w, m/s, >= 0
  double operator()(double slidingSpeed) const;
};

/// How a contact takes its friction coefficient from a law; SI units.
struct FrictionSpecification {
  /// "bucher2006", a law file, a table mu(p, v) (a name that ends in ".csv"), "constant" or
  /// "polach". The last two read nothing else but their own numbers, a table nothing else at all.
  std::string law = "bucher2006";
  double mu = 0.0;          ///< of the constant law, > 0
  FallingFriction falling;  ///< of the law "polach"
  bool local = false;       ///< true: mu from the pressure of each cell; false: mean of the law
                            ///< over pressures from 0 to the hardness (Eq. 7)
  bool velocityTerm = true; ///< false: kappa1 = 0 whatever the sliding speed
  double strength = 0.0;    ///< sigma_0 of Eq. 10 at no temperature rise, Pa, > 0
  double strengthTemperature = 0.0; ///< rise at which no strength is left, K, > 0
  double modulus = 0.0;             ///< E of kappa1 and kappa2, Pa, > 0
  double density = 0.0;             ///< rho of kappa1, kg/m3, > 0

  bool isConstant() const { return law == "constant"; }
  bool isFalling() const { return law == "polach"; }
  bool isTable() const;
  /// mu of Eq. 2, from kappa1 and kappa2: it depends on the strength, and so on temperature.
  bool isScaled() const { return !isConstant() && !isFalling() && !isTable(); }
  /// Does the law stand in a file?
  bool isFile() const { return isTable() || (isScaled() && !isBuiltinLaw(law)); }

  /// Eq. 10: sigma_0(Theta) = strength (1 - Theta/strengthTemperature), Pa. Kept above a thousandth
  /// of the strength, so that an iteration can pass through what a solution may not reach.
  double strengthAt(double temperatureRise) const;

  /// 3 sigma_0(Theta), the pressure at which asperities yield (the paper, sec. 3), Pa.
  double hardnessAt(double temperatureRise) const;
};

/// The law that is specified, with its table where it is one; for "constant" and "polach" a law
/// whose mu0 is theirs.
/// @throws Error (BadInput) for a file that cannot be read
FrictionLaw readLaw(const FrictionSpecification &friction);

/// The law as a summary tells it: as `toJson`, or what stands in its place.
nlohmann::ordered_json toJson(const FrictionSpecification &friction, const FrictionLaw &law);

/// Friction coefficient per cell.
/// @param pressure Pa, one value per cell
/// @param slidingSpeed m/s, of the whole contact; its sign does not count
/// @param temperature rise per cell, K; as many as pressures
/// @return mu > 0, one value per cell
/// @throws Error (NotConverged) where the law gives mu <= 0: it does not hold that far from the
///         points it was fitted to
Eigen::VectorXd frictionCoefficient(const FrictionSpecification &friction, const FrictionLaw &law,
                                    const Eigen::VectorXd &pressure, double slidingSpeed,
                                    const Eigen::VectorXd &temperature);

} // namespace wheelrail
#endif
