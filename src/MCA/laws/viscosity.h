// SPDX-License-Identifier: GPL-2.0-or-later
/// \file viscosity.h
/// Viscous resistance of two unlinked automata in contact.
#ifndef MCA_LAWS_VISCOSITY_H
#define MCA_LAWS_VISCOSITY_H

namespace mca {

/// Normal stress of an unlinked contact [stress]: elastic part and F = (eta/sqrt(3)) v_n h over
/// the contact area d h/sqrt(3), never tensile.
/// \param elastic     elastic normal stress [stress], tension positive
/// \param viscosity   eta [stress time]
/// \param separation  normal velocity of the second automaton seen from the first [length/time]
/// \param invDiameter 1/d [1/length]
inline double unlinkedStress(double elastic, double viscosity, double separation,
                             double invDiameter)
{
  const double total = elastic + viscosity * separation * invDiameter;
  return total < 0.0 ? total : 0.0;
}

/// Normal velocity of a viscous contact at the time of its step [length/time]. Explicit steps know
/// the one of half a step ago; what the forces with that one change in half a step is added. The
/// contact's own damping, by far the stiffest part of that change, is taken at the new velocity.
/// Of second order in the step, as Verlet is; a pair alone keeps (1-x/2)/(1+x/2) of its velocity in
/// a step with x = 2 damping, where the exact motion keeps exp(-x).
/// \param separation  the one of half a step ago [length/time]
/// \param kick        its change in half a step by these forces [length/time]
/// \param damping     eta S/d (1/m_i + 1/m_j) dt/2 [-]
inline double centredSeparation(double separation, double kick, double damping)
{
  return separation + kick / (1.0 + damping);
}

} // namespace mca

#endif
