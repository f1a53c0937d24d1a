// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_LAW_MODEL_H
#define WHEELRAIL_FIT_LAW_MODEL_H

#include "law/bounded_mu.h"
#include "law/kappa_law.h"

#include <array>
#include <limits>

namespace wheelrail {

/// What is fitted of one condition: mu at its kappas, the mean over its runs, with the standard
/// error of mu (>= 0, finite).
struct ConditionMean {
  /// rho E v^2/sigma_0^2 and p E/sigma_0^2, as in Eq. 2; >= 0, finite.
  double kappa1 = 0.0;
  double kappa2 = 0.0;
  double mu = 0.0;
  double muSe = 0.0;
  double kappa3 = 1.0; ///< E/sigma_0, > 0
  /// Breaking strain over sigma_0/E, > 0; nan where it is not known.
  double ductility = std::numeric_limits<double>::quiet_NaN();
};

/// What a model may have a power of, beside kappa1 and kappa2.
enum class ThirdNumber { None, Kappa3, Ductility };
/// As in files and on the command line: kappa3, ductility. None: never asked for.
const char *nameOf(ThirdNumber number);
/// 1 of None.
double valueOf(ThirdNumber number, const ConditionMean &mean);

/// What is fitted: parts of Eq. 2, what is left out is zero, or more than it (`boundedMu`).
enum class LawModel {
  Constant,        ///< mu0
  Velocity,        ///< mu0, mu1, b
  Pressure,        ///< mu0, mu2, c: Eq. 4
  VelocityKappa3,  ///< those of Velocity and n: times (kappa3/reference)^n; ours, not the paper's
  Full,            ///< mu0, mu1, mu2, b, c: Eq. 2
  Kappa3,          ///< the same and n
  Ductility,       ///< likewise, times (ductility/reference)^n
  Bounded,         ///< mu0, s, q: a constant bounded by the shear strength
  BoundedRate,     ///< the same, whose strength rises with the speed: s1, d
  BoundedKappa3,   ///< the same and n
  BoundedVelocity, ///< mu0, mu1, b, s, q
  BoundedPressure, ///< mu0, mu2, c, s, q
  BoundedFull      ///< Eq. 2 and s, q
};

/// Models without a bound, from the smallest to the largest one.
constexpr std::array<LawModel, 7> lawModels = {
    LawModel::Constant, LawModel::Velocity, LawModel::Pressure, LawModel::VelocityKappa3,
    LawModel::Full,     LawModel::Kappa3,   LawModel::Ductility};
/// Models of one material, bounded by its shear strength, likewise.
constexpr std::array<LawModel, 6> boundedModels = {
    LawModel::Bounded,         LawModel::BoundedKappa3,   LawModel::BoundedRate,
    LawModel::BoundedVelocity, LawModel::BoundedPressure, LawModel::BoundedFull};

/// Name on the command line and in files: constant, velocity, eq4, velocity_kappa3, eq2,
/// eq2_kappa3, eq2_ductility, bounded, bounded_kappa3 and so on. Never null; lives as long as the
/// program.
const char *nameOf(LawModel model);
/// Number of parameters of a fit.
constexpr int fitParameters = allParameters;
/// What the model has a power of.
ThirdNumber thirdNumberOf(LawModel model);
/// Whether it is bounded by the shear strength.
bool isBounded(LawModel model);
/// Which of `parameterNames` the model fits.
std::array<bool, fitParameters> parametersOf(LawModel model);

} // namespace wheelrail

#endif
