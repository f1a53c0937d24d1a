// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_BOUNDED_MU_H
#define WHEELRAIL_LAW_BOUNDED_MU_H

#include <Eigen/Core>

#include <array>

namespace wheelrail {

/// Place of each parameter in a vector of all that wr_fit knows: those of Eq. 2, the exponent n of
/// a third number, and the shear limit s with the sharpness q of the bend towards it and its rise
/// with the speed, s1 and d. b and mu1 belong to kappa1, c and mu2 to kappa2.
enum LawParameter { Mu0, Mu1, Mu2, B, C, N, S, Q, S1, D };

/// Number of these parameters.
constexpr int allParameters = 10;

/// Names of the parameters, in their order.
constexpr std::array<const char *, allParameters> parameterNames = {"mu0", "mu1", "mu2", "b",  "c",
                                                                    "n",   "s",   "q",   "s1", "d"};

/// One value for each parameter; pure numbers.
using LawParameters = Eigen::Matrix<double, allParameters, 1>;

/// What a law is asked with; pure numbers.
struct Kappas {
  double kappa1 = 0.0; ///< rho E v^2/sigma_0^2, >= 0
  double kappa2 = 0.0; ///< p E/sigma_0^2, >= 0
  double kappa3 = 1.0; ///< E/sigma_0, > 0
};

/// Least bend q of a law: the roundest, mu is half of both sides where they are equal. Below it the
/// bound would act far from where it is reached.
constexpr double roundestBend = 1.0;

/// Eq. 2 times a power of a third number, bounded by the shear strength S sigma_0, which may rise
/// with the speed by a term like Eq. 2's:
///   B  = [mu0 + mu1 kappa1/(1 + b kappa1) + mu2/(1 + c kappa2)] third^n
///   S  = s + s1 kappa1/(1 + d kappa1)
///   mu = (B^-q + (S sigma_0/p)^-q)^(-1/q),      p/sigma_0 = kappa2/kappa3.
/// This minimum of both is smooth, below each of them and monotone in each; where they are equal it
/// is 2^(-1/q) of them. A law without the limit has s = 0: mu is B.
/// \param third kappa3, or the ductility, over its reference, > 0
/// \param gradient by the parameters, unless null; that by s, q, s1 and d is 0 without a limit
/// \return mu; of a B that is not positive, with a limit, that B
double boundedMu(const LawParameters &x, const Kappas &kappas, double third,
                 LawParameters *gradient = nullptr);

} // namespace wheelrail
#endif
