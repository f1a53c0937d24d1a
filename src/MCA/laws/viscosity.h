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

} // namespace mca

#endif
