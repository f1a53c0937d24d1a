// SPDX-License-Identifier: GPL-2.0-or-later
/// \file plasticity.h
/// Plasticity of an automaton: von Mises stress, the three-piece curve of Fig. 5 of Bucher et al.
/// (2006) with isotropic hardening, radial return of its contacts.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free.
/// Flow is isotropic: one number an automaton, the equivalent plastic strain kappa >= 0, says how
/// far it has hardened. Equations: doc/laws.md, Plasticity and Corrected steps; the return of
/// contacts themselves is returnedStress() of contact.h.
#ifndef MCA_LAWS_PLASTICITY_H
#define MCA_LAWS_PLASTICITY_H

#include "elasticity.h"
#include "material.h"

#include <cmath>

namespace mca {

/// The square of stressIntensity() [stress^2].
inline double squaredIntensity(const StressTensor &s)
{
  const double a = s.xx - s.yy, b = s.yy - s.zz, c = s.zz - s.xx;
  return 0.5 * (a * a + b * b + c * c) + 3.0 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz);
}

/// Von Mises stress intensity of a stress tensor [stress], >= 0: sqrt(3/2 s:s) of its deviator s.
/// An automaton's is compared with the yield stress (the paper's stress intensity).
inline double stressIntensity(const StressTensor &s)
{
  return std::sqrt(squaredIntensity(s));
}

/// Yield stress against equivalent plastic strain: straight lines through (0, sigma_y1), (eps_y2 -
/// sigma_y2/E, sigma_y2), (eps_c - sigma_0/E, sigma_0), then constant: Fig. 5 of Bucher et al.
/// (2006) with the elastic strain taken off. Stored as numbers that loops need, without a division.
struct YieldCurve {
  /// sigma_y1, sigma_y2 - sigma_y1, sigma_0 - sigma_y2 [stress], > 0, >= 0, >= 0.
  double y1, rise2, rise3;
  /// Plastic strain at sigma_y2 and 1/length of both pieces [-], all > 0.
  double strain2, inv2, inv3;

  /// The curve of a material that checkMaterial() accepts: its three points have to be in order,
  /// else the divisions give no numbers. Plastic strains are the diagram's total strains less the
  /// elastic part. A material whose sigma_y1 equals sigma_0 is ideally plastic.
  explicit YieldCurve(const Material &m)
      : y1(m.sigmaY1()), rise2(m.sigmaY2() - m.sigmaY1()), rise3(m.strength - m.sigmaY2()),
        strain2(m.plasticStrainY2()), inv2(1.0 / m.plasticStrainY2()),
        inv3(1.0 / (m.plasticStrainUltimate() - m.plasticStrainY2()))
  {
  }

  /// Yield stress Y(kappa) [stress]: sigma_y1 at 0, never above sigma_0.
  /// \param kappa  equivalent plastic strain [-], >= 0, without an upper limit
  double operator()(double kappa) const
  {
    const double s = kappa * inv2, t = (kappa - strain2) * inv3;
    return y1 + rise2 * (s < 1.0 ? s : 1.0) + rise3 * (t < 0.0 ? 0.0 : t < 1.0 ? t : 1.0);
  }

  /// Plastic work per volume up to kappa, the integral of the yield stress [stress]; rises with
  /// kappa, at last with the slope sigma_0.
  /// \param kappa  equivalent plastic strain [-], >= 0
  double work(double kappa) const
  {
    return y1 * kappa + rise2 * rampIntegral(kappa, inv2) +
           rise3 * rampIntegral(kappa - strain2, inv3);
  }

 private:
  /// Integral from 0 to x of min(1, inverse x), 0 for x < 0: x^2 inverse/2 on the ramp, x - 1/(2
  /// inverse) beyond it.
  /// \param x        plastic strain since the ramp's beginning [-]
  /// \param inverse  1 over its length [-], > 0
  static double rampIntegral(double x, double inverse)
  {
    const double s = x * inverse, ramp = s < 0.0 ? 0.0 : s < 1.0 ? s : 1.0;
    return ramp * (x - 0.5 * ramp / inverse);
  }
};

/// The most of 1 - M that an automaton may answer with isochoric, such that flow cannot raise the
/// elastic energy [-], 0 to 1 (doc/laws.md, Energy; ours). To first order in 1 - M an automaton's
/// flow sets (1-M)/4G sum f (sigma - centre)^2 free for each S d, whatever its contacts; to second
/// order some of it comes back, since a contact flows from both sides and since what neighbours
/// flow changes the mean stresses: at most (1-M)^2/8G (1 + c D K/8G) sum f (sigma - centre)^2 in
/// the sum over a sample, with c = 3/2 the dimension for up to one and a half times the packing's
/// contacts. A fifth of the first order is left to the stretch of shear, mostStretch(). In the
/// plane it is 1 up to nu = 0.37, 0.15 at 0.49.
/// \param shearModulus,bulkModulus  G, K [stress], > 0
/// \param D                         weight of the mean stress [-]
/// \param dimension                 2 or 3
inline double mostReturn(double shearModulus, double bulkModulus, double D, int dimension)
{
  const double most = 1.6 / (1.0 + 1.5 * dimension * D * bulkModulus / (8.0 * shearModulus));
  return most < 1.0 ? most : 1.0;
}

/// The most of its normal stress that the stretch of shear may take from a contact in a step [-],
/// by the same argument; parameters as of mostReturn().
inline double mostStretch(double shearModulus, double bulkModulus, double D, int dimension)
{
  return 0.4 / (1.0 + 1.5 * dimension * D * bulkModulus / (2.0 * shearModulus));
}

/// What one automaton's yielding does to its contacts and to itself.
struct RadialReturn {
  /// M = sigma_Y/sigma_int, or 1 when elastic [-]; by secondReturn() down to 0.
  double factor;
  /// Increment of the equivalent plastic strain [-], >= 0; it goes to the next state.
  double strain;
};

/// The return of an automaton by its own yield stress: M = Y/sigma_int and the plastic strain
/// (sigma_int - Y)/(3G) where it yields, 1 and 0 elsewhere (doc/laws.md, Plasticity; radial return
/// of Psakhie et al. 2011). Whether the automaton has a bulk link that could flow is the caller's
/// to ask.
/// \param intensity     trial stress intensity [stress], >= 0
/// \param yieldStress   sigma_Y at the present plastic strain [stress], > 0
/// \param shearModulus  G [stress], > 0
/// \param most          of mostReturn() [-]: the most of 1 - M
inline RadialReturn radialReturn(double intensity, double yieldStress, double shearModulus,
                                 double most = 1.0)
{
  const bool yields = intensity > yieldStress;
  const bool limited = intensity - yieldStress > most * intensity;
  return {limited  ? 1.0 - most
          : yields ? yieldStress / intensity
                   : 1.0,
          limited  ? most * intensity / (3.0 * shearModulus)
          : yields ? (intensity - yieldStress) / (3.0 * shearModulus)
                   : 0.0};
}

/// The return of an automaton that flows, once more (doc/laws.md, Corrected steps; ours). Its
/// contacts take the mean of what both sides answer: where it flows alone, radialReturn() takes
/// half of what it should, and the rest would wait for later steps, as stress above the yield
/// stress that grows with the step. What the first returns of all automata did to it tells how much
/// is needed, at most twice as much: exactly where it flows alone, and where all flow alike.
/// \param factor        M of radialReturn() [-], < 1: it flows
/// \param intensity     trial stress intensity [stress]
/// \param returned      the one after the first returns [stress]; where it is not smaller, the
///                      share is 2
/// \param yieldStress   sigma_Y at the present plastic strain [stress]
/// \param shearModulus  G [stress], > 0
/// \param most          of mostReturn() [-]
/// \return M' = 1 - part, 0 <= part <= most, and the strain part sigma_int/(3G), both in place of
/// the first
inline RadialReturn secondReturn(double factor, double intensity, double returned,
                                 double yieldStress, double shearModulus, double most = 1.0)
{
  const double excess = intensity - yieldStress, taken = intensity - returned;
  // at the yield stress the excess may round to less than 0, with nothing taken
  const double share = excess > 0.0 && taken > 0.5 * excess ? excess / taken : 2.0;
  const double wanted = (1.0 - factor) * share, part = wanted < most ? wanted : most;
  return {1.0 - part, part * intensity / (3.0 * shearModulus)};
}

/// Increment of the equivalent plastic strain of an automaton with isochoric [-]: the plastic work
/// of its flow per volume over its stress intensity. To first order in 1 - M flow sets (1-M)/4G
/// sum [f (sigma - centre)^2 + tau^2] free for each S d, and S d/V = 2w. In the packing itself
/// this is (1 - M) sigma_int/(3G); in one that is stretched, or that does not flow with all of its
/// contacts, that would count what does not flow. It is at most 3/2 of it: a packing drawn by 30 %
/// needs 1.3, and more is done by stresses that the contacts of an automaton hold against each
/// other, which are no part of the averaged one that hardens it (doc/laws.md, Plasticity; ours).
/// \param part          1 - M [-]
/// \param squares       this sum over the contacts that flow, with the work of the stretch of shear
///                      [stress^2]; negative counts as 0
/// \param intensity     trial stress intensity [stress], > 0
/// \param shearModulus  G [stress]
/// \param weight        w of the packing [-]
inline double strainOfWork(double part, double squares, double intensity, double shearModulus,
                           double weight)
{
  const double packing = part * intensity / (3.0 * shearModulus), most = 1.5 * packing;
  const double strain = 0.5 * part * weight * squares / (shearModulus * intensity);
  return strain < 0.0 ? 0.0 : strain < most ? strain : most;
}

} // namespace mca

#endif
