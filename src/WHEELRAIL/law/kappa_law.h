// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_KAPPA_LAW_H
#define WHEELRAIL_LAW_KAPPA_LAW_H

#include "law/law_use.h"

#include <Eigen/Core>

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace wheelrail {

/// Number of parameters of Eq. 2, in the order mu0, mu1, mu2, b, c used for every covariance.
constexpr int lawParameters = 5;
using LawCovariance = Eigen::Matrix<double, lawParameters, lawParameters>;

/// kappa1 = rho E v^2 / sigma_0^2: (impact stress of the moving layer / strength)^2.
/// SI units: kg/m3, Pa, m/s, Pa; dimensionless result, >= 0.
double kappa1(double density, double modulus, double speed, double strength);

/// kappa2 = p E / sigma_0^2: pressure in units of the pressure at which asperities yield.
/// Pressure, modulus and strength in one and the same unit (Pa, or MPa); dimensionless result.
double kappa2(double pressure, double modulus, double strength);

/// The friction law of the nanolevel, Eq. 2 of Bucher et al., Wear 261 (2006) 874:
///   mu(kappa1, kappa2) = mu0 + mu1 kappa1 / (1 + b kappa1) + mu2 / (1 + c kappa2).
/// All parameters are dimensionless; b, c >= 0 so that mu has no pole for kappa1, kappa2 >= 0.
/// It is what wr_fit fits; law/forms/eq2.h is its use in a contact.
struct KappaLaw {
  double mu0 = 0.0;
  double mu1 = 0.0;
  double mu2 = 0.0;
  double b = 0.0;
  double c = 0.0;

  /// Covariance of (mu0, mu1, mu2, b, c); absent where the source states none.
  std::optional<LawCovariance> covariance;
  int n = 0;                ///< conditions that were fitted; 0: the source does not say
  double rmsRelative = 0.0; ///< root mean square of (mu - fit)/fit
  /// Ranges of the fitted conditions, kappa3 = E/sigma_0; absent where the source states none.
  std::optional<Range> kappa1Range, kappa2Range, kappa3Range;
  /// The kappa3 that the law is for, where mu was found to depend on it; absent: mu was taken not
  /// to depend on it.
  std::optional<double> kappa3;
  /// The ductility (breaking strain over sigma_0/E) that the law is for, likewise.
  std::optional<double> ductility;
  /// Ranges of what the runs were made of, by the names in `fittedQuantities`; those that the
  /// source does not state are missing.
  std::map<std::string, Range> fittedOn;
  std::string source; ///< where the numbers come from
  /// A line for the user about the file that it was read from: it has no checksum. Else empty.
  std::string note;

  /// Eq. 2. kappa1, kappa2 >= 0.
  double operator()(double kappa1, double kappa2) const;

  /// Eq. 4, the limit of vanishing speed (kappa1 = 0).
  double staticPart(double kappa2) const;

  /// Eq. 7 in closed form: mean of mu weighted with the load it carries, for pressures distributed
  /// uniformly in 0 .. 3 strength (the hardness). With X = 3 c modulus/strength:
  ///   mu0 + mu1 kappa1/(1 + b kappa1) + 2 mu2 [1/X - ln(1 + X)/X^2].
  /// modulus and strength > 0 in the same unit. Accurate to 1e-14 for every X >= 0: small X use
  /// the series, since the closed form cancels there.
  double averaged(double kappa1, double modulus, double strength) const;
};

/// Quantities of the runs that a law was fitted to: pressure, strength, youngs_modulus in MPa,
/// velocity in m/s, density in kg/m3, viscosity in Pa s.
constexpr std::array<const char *, 6> fittedQuantities = {
    "pressure", "velocity", "strength", "youngs_modulus", "density", "viscosity"};

/// Eq. 3: the paper's fit to its 34 points, with the ranges that the paper states: p and v of sec.
/// 2, strengths and the modulus of Table 1. It varied modulus, density and viscosity too, and does
/// not say how far; kappa3Range is that of Table 1. The paper states no covariance.
KappaLaw bucher2006();

/// A law file as wr_fit writes it (JSON, format "mca-friction-law 1"). Needed are the format and
/// the five parameters; all else says where they come from and may be missing, "checksum" too. The
/// key "report" may hold anything and is skipped.
/// \throws Error (BadInput) naming file, line and key for what is missing, of the wrong type, out
///         of range (all numbers within +-1e100), unknown, given twice or nested too deep, for a
///         covariance that is not symmetric and positive semi-definite, and for a checksum
///         (law_checksum.h) that does not fit the file
KappaLaw readKappaLaw(const std::string &path);

/// The law file's content without its checksum. `readKappaLaw` reads it back to the last bit.
nlohmann::ordered_json toJson(const KappaLaw &law);

} // namespace wheelrail

#endif
