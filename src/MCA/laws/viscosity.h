// SPDX-License-Identifier: GPL-2.0-or-later
/// \file viscosity.h
/// Viscous resistance of two unlinked automata in contact.
#ifndef MCA_LAWS_VISCOSITY_H
#define MCA_LAWS_VISCOSITY_H

#include "vector.h"

namespace mca {

/// Normal stress of an unlinked contact [stress]: elastic part and F = (eta/sqrt(3)) v_n h over the
/// contact area d h/sqrt(3), hence eta v_n/d, never tensile (Bucher et al. 2006, Table 1; the
/// direction is our choice). In space the same stress acts on the packing's S.
/// \param elastic     elastic normal stress [stress], tension positive
/// \param viscosity   eta [stress time], >= 0
/// \param separation  normal velocity of the second automaton seen from the first [length/time], >
///                    0 when they part
/// \param invDiameter 1/d [1/length]
/// \param pulls       1 where the elastic stress may be > 0 (PairLaw::keepsEnergy), else 0
/// \return <= 0, or at most the elastic stress where that pulls; so viscosity dissipates
inline double unlinkedStress(double elastic, double viscosity, double separation,
                             double invDiameter, double pulls = 0.0)
{
  const double total = elastic + viscosity * separation * invDiameter;
  const double most = pulls * (elastic > 0.0 ? elastic : 0.0);
  return total < most ? total : most;
}

/// What part of the fastest damping of a packing centred velocities take at the new velocity where
/// contacts resist slip [-]. A contact's own part (Packing::ownSlipShare()) would do for accuracy;
/// this one allows the longest step, 8/lambda, since a mode is stable while the part is at least
/// 1 - 2/(lambda dt) and at most 6/(lambda dt) (doc/laws.md, Corrected steps; ours).
constexpr double centredSlipShare = 0.75;

/// Normal velocity of a viscous contact at the time of its step [length/time]. Explicit steps know
/// the one of half a step ago; what the forces with that one change in half a step is added. The
/// contact's own damping, by far the stiffest part of that change, is taken at the new velocity.
/// Second order in the step, as Verlet is; a pair alone keeps (1-x/2)/(1+x/2) of its velocity in
/// a step with x = 2 damping, where the exact motion keeps exp(-x).
/// \param separation  the one of half a step ago [length/time]
/// \param kick        its change in half a step by these forces [length/time]
/// \param damping     eta S/d (1/m_i + 1/m_j) dt/2 [-], PairLaw::centring times
inline double centredSeparation(double separation, double kick, double damping)
{
  return separation + kick / (1.0 + damping);
}

/// Velocity of the second surface seen from the first at the contact point, which lies midway
/// [length/time], perpendicular to n; or what displacements and rotations, or accelerations, make
/// of it. A pair that turns like a rigid body does not slip. With viscosity both a contact that is
/// pressed has the shear stress eta slip/d, per velocity the same as normal stress has: it resists
/// the relative velocity of its surfaces in any direction alike. Its force has the arm r/2 about
/// both centres and dissipates S eta/d slip^2.
/// \param n         unit normal from the first to the second automaton [-]
/// \param velocity  of the second automaton seen from the first [length/time]
/// \param spins     sum of both angular velocities [1/time]
/// \param arm       from a centre to the contact point, r/2 [length]
inline Vector slipOf(const Vector &n, const Vector &velocity, const Vector &spins, double arm)
{
  return velocity - dot(n, velocity) * n - arm * cross(spins, n);
}

/// Slip velocity at the time of its step, as centredSeparation().
/// \param kick     change of the slip in half a step by the forces and torques with the old one
/// \param damping  eta S/d [1/m_i + 1/m_j + arm^2 (1/J_i + 1/J_j)] dt/2 [-], PairLaw::centring
/// times
inline Vector centred(const Vector &slip, const Vector &kick, double damping)
{
  return slip + 1.0 / (1.0 + damping) * kick;
}

} // namespace mca

#endif
