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

/// Von Mises stress intensity of a stress tensor [stress], >= 0: sqrt(3/2 s:s) of its deviator s.
/// Of an automaton it is compared with the yield stress (the paper's stress intensity).
inline double stressIntensity(const StressTensor &s)
{
  const double a = s.xx - s.yy, b = s.yy - s.zz, c = s.zz - s.xx;
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz));
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
inline RadialReturn radialReturn(double intensity, double yieldStress, double shearModulus)
{
  const bool yields = intensity > yieldStress;
  return {yields ? yieldStress / intensity : 1.0,
          yields ? (intensity - yieldStress) / (3.0 * shearModulus) : 0.0};
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
/// \return M' = 1 - part, 0 <= part <= 1, and the strain part sigma_int/(3G), both in place of the
/// first
inline RadialReturn secondReturn(double factor, double intensity, double returned,
                                 double yieldStress, double shearModulus)
{
  const double excess = intensity - yieldStress, taken = intensity - returned;
  const double share = taken > 0.5 * excess ? excess / taken : 2.0;
  const double wanted = (1.0 - factor) * share, part = wanted < 1.0 ? wanted : 1.0;
  return {1.0 - part, part * intensity / (3.0 * shearModulus)};
}

} // namespace mca

#endif
