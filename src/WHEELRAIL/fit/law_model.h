// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_LAW_MODEL_H
#define WHEELRAIL_FIT_LAW_MODEL_H

#include "law/kappa_law.h"

#include <array>

namespace wheelrail {

/// What is fitted of one condition: mu at (kappa1, kappa2, kappa3), the mean over its runs, with
/// the standard error of mu (>= 0, finite).
struct ConditionMean {
  /// rho E v^2/sigma_0^2 and p E/sigma_0^2, as in Eq. 2; >= 0, finite.
  double kappa1 = 0.0;
  double kappa2 = 0.0;
  double mu = 0.0;
  double muSe = 0.0;
  double kappa3 = 1.0; ///< E/sigma_0, > 0
};

/// The parts of Eq. 2 that are fitted, what is left out is zero; or more than it.
enum class LawModel {
  Constant,       ///< mu0
  Velocity,       ///< mu0, mu1, b
  Pressure,       ///< mu0, mu2, c: Eq. 4
  VelocityKappa3, ///< those of Velocity and n: times (kappa3/reference)^n; ours, not the paper's
  Full,           ///< mu0, mu1, mu2, b, c: Eq. 2
  Kappa3          ///< the same and n
};

/// All models, from the smallest to the largest one.
constexpr std::array<LawModel, 6> lawModels = {LawModel::Constant, LawModel::Velocity,
                                               LawModel::Pressure, LawModel::VelocityKappa3,
                                               LawModel::Full,     LawModel::Kappa3};

/// Name on the command line and in files: constant, velocity, eq4, velocity_kappa3, eq2,
/// eq2_kappa3. Never null; lives as long as the program.
const char *nameOf(LawModel model);
/// Number of parameters of a fit: those of Eq. 2 and n.
constexpr int fitParameters = lawParameters + 1;
/// Whether the model has a power of kappa3.
bool hasKappa3(LawModel model);
/// Which of mu0, mu1, mu2, b, c, n the model fits.
std::array<bool, fitParameters> parametersOf(LawModel model);
/// Names of the parameters, in their order.
constexpr std::array<const char *, fitParameters> fitParameterNames = {"mu0", "mu1", "mu2",
                                                                       "b",   "c",   "n"};

} // namespace wheelrail

#endif
