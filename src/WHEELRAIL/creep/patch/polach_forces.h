// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_POLACH_FORCES_H
#define WHEELRAIL_CREEP_PATCH_POLACH_FORCES_H

#include "contact/patch/solvers/kalker.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace wheelrail {

/// Parameters of Polach's law of 2005.
struct PolachParameters {
  double mu0 = 0.0; ///< friction coefficient at slip speed 0, > 0
  double A = 1.0;   ///< its limit at large slip speed over mu0, 0 .. 1
  double B = 0.0;   ///< how fast it falls, s/m, >= 0
  double kA = 1.0;  ///< reduction factor of the area of adhesion, > 0; 1: clean smooth surfaces
  double kS = 1.0;  ///< reduction factor of the area of slip, > 0; Polach: kS <= kA <= 1

  /// Whether kS <= kA <= 1, as Polach states it and some codes ask for. Fits are not held to it:
  /// computed curves, rough ones above all, may lie outside.
  bool inPolachsRange() const { return kS <= kA && kA <= 1.0; }
};

/// The elliptic contact that the law is for: at one load, from which its semi-axes follow at any
/// other (Hertz: a and b grow as the third root of the load). mm, N, MPa.
struct PolachContact {
  double shearModulus;       ///< G of both bodies, MPa
  double a, b;               ///< semi-axes along x and y at `load`, mm
  double load;               ///< N
  KalkerCoefficients kalker; ///< of the ellipse of a/b (`ellipseKalkerCoefficients`)
};

/// Creepages, speed and load; the signs of `Creepage`.
struct PolachState {
  double creep = 0.0;   ///< longitudinal, -
  double lateral = 0.0; ///< -
  double spin = 0.0;    ///< 1/mm
  double speed = 0.0;   ///< m/s, >= 0
  double load = 0.0;    ///< N, > 0
};

struct PolachForce {
  double x = 0.0, y = 0.0; ///< N; against the creepages, as the solvers' forces
};

/// Polach's law: O. Polach, Creep forces in simulations of traction vehicles running on adhesion
/// limit, Wear 258 (2005) 992; with the spin of O. Polach, A fast wheel-rail forces calculation
/// computer code, Vehicle System Dynamics 33 (1999) Suppl., 728. With s the length of (xi, eta),
/// s_yC = eta + phi a where that is larger than eta in size, else eta, s_C the length of
/// (xi, s_yC), w = s V the slip speed:
///   mu    = mu0 [(1 - A) exp(-B w) + A]
///   c     = length of (C11 xi/s, C22 eta/s)
///   eps   = G pi a b c s_C/(4 N mu)
///   F     = (2 N mu/pi) [kA eps/(1 + (kA eps)^2) + atan(kS eps)]
///   K_M   = 1 + 6.3 (1 - exp(-a/b))
///   eps_S = (8/3) k G b sqrt(ab) C23 |s_yC|/(N mu K_M),  k = (kA + kS)/2
///   delta = (eps_S^2 - 1)/(eps_S^2 + 1)
///   F_S   = (9/16) a N mu K_M [eps_S (-delta^3/3 + delta^2/2 - 1/6) + (1 - delta^2)^1.5/3]
///   Fx    = -F xi/s_C,  Fy = -(F eta + F_S phi)/s_C
/// kA = kS = 1 and A = 1 give the form of 1999. Small creepages give (kA + kS)/2 times Kalker's
/// linear forces; the factor k in eps_S is ours and makes that so for the spin too (the sources
/// known to us state kA and kS for F only). At large creepage F tends to mu N.
///
/// The sum of F and the spin's force is not limited to mu N: that is the law's, not an oversight.
PolachForce polachForce(const PolachParameters &parameters, const PolachContact &contact,
                        const PolachState &state);

/// mu of the law at a slip speed w >= 0, m/s.
double polachFriction(const PolachParameters &parameters, double slipSpeed);

/// A point of a creep-force curve that was computed or measured.
struct PolachPoint {
  PolachState state;
  double forceX = 0.0, forceY = 0.0; ///< N
};

enum class PolachFriction {
  Constant, ///< A = 1: mu0, kA, kS are fitted
  Falling   ///< all five
};

constexpr int polachParameters = 5;
constexpr std::array<const char *, polachParameters> polachParameterNames = {"mu0", "A", "B", "kA",
                                                                             "kS"};

/// A fitted law and how much it is worth. Residuals are (F of the law - F of the point)/load: along
/// x for points with longitudinal, along y for points with lateral creep or spin. All weigh the
/// same. Standard errors are of least squares, scaled by the residuals: where the points are
/// computed without noise, they say how far the law itself misses the curve.
struct PolachFit {
  PolachFriction friction = PolachFriction::Falling;
  PolachParameters parameters;
  std::array<double, polachParameters> standardError = {}; ///< 0 for what was not fitted
  std::array<bool, polachParameters> atBound = {};         ///< the best value lies on a bound
  int residuals = 0;                                       ///< number of them
  double rms = 0.0;             ///< of the residuals, with the degrees of freedom in the divisor
  double worst = 0.0;           ///< largest size of a residual
  double conditionNumber = 0.0; ///< of the Jacobian with columns of length 1
  double aicc = 0.0;            ///< Akaike's criterion for small samples
  /// Why the points do not determine the parameters: one runs to a bound that means so, the
  /// condition number exceeds 1e6, a standard error is as large as its parameter (A: as 1). Empty
  /// if they do.
  std::string notIdentifiable;
};

/// Least squares over all points, bounds mu0 > 0, 0 <= A <= 1, B >= 0, kA, kS > 0.
/// \throws Error (NotConverged) for fewer residuals than parameters + 1, or without convergence
/// \throws std::invalid_argument for values that are not finite, loads <= 0, speeds < 0
/// \param largestMu bound of mu0
PolachFit fitPolach(const std::vector<PolachPoint> &points, const PolachContact &contact,
                    PolachFriction friction,
                    double largestMu = std::numeric_limits<double>::infinity());

/// Can the form describe the forces at this point? Its spin is one lateral creepage phi a, as if
/// all of the contact slid alike; that holds while the creepages outweigh the spin everywhere:
/// |phi| times the longer semi-axis at most the length of (xi, eta).
bool isInPolachsSpin(const PolachState &state, const PolachContact &contact);

/// Both fits, and which one to use: the falling one where the points determine all its parameters
/// and its AICc is the smaller one, else that with constant friction.
struct PolachChoice {
  PolachFit best;
  std::string reason; ///< a sentence: why this form of friction
  /// Points that were not fitted, since the form cannot describe their spin, and by how much of the
  /// load the law misses the worst of them.
  int leftOut = 0;
  double worstLeftOut = 0.0;
  std::string warning; ///< a line for the user about spin; empty: none
};

/// The points are those that the form can describe (`isInPolachsSpin`); where these alone do not
/// determine the parameters, all. With spin in the points mu0 is at most the largest T/N seen: the
/// misfit of the spin would otherwise be laid on it.
/// \throws Error (NotConverged) where not even the constant form's parameters are determined: the
///         message says which combination is not
PolachChoice choosePolach(const std::vector<PolachPoint> &points, const PolachContact &contact);

/// polach.json: parameters with standard errors, residual, contact, source.
std::string polachJson(const PolachChoice &choice, const PolachContact &contact);

/// Table of the points: creep, lateral, spin, speed, load, force_x, force_y as computed, and the
/// law's polach_x, polach_y; units in the first line.
std::string polachCsv(const PolachChoice &choice, const PolachContact &contact,
                      const std::vector<PolachPoint> &points);

} // namespace wheelrail
#endif
