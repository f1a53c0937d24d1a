// SPDX-License-Identifier: GPL-2.0-or-later
/// \file coulomb.h
/// Coulomb friction of unlinked contacts that are pressed: a tangential spring that slides where
/// its force reaches mu times the normal force (Cundall and Strack, Geotechnique 29 (1979) 47). The
/// spring is an elastic shear gamma like that of a link, with its stiffness 2G, the motion of
/// pair_motion.h and the force of contactForce(): so it stores the energy of a link's shear, keeps
/// both momenta, and does not grow where a pair turns like a rigid body. Equations: doc/laws.md,
/// Friction.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free.
#ifndef MCA_LAWS_COULOMB_H
#define MCA_LAWS_COULOMB_H

#include "contact.h"

namespace mca {

/// The largest shear stress of a contact [stress]: |F_t| <= mu |F_n|.
/// \param normal  final normal stress, with viscosity and room [stress]; tension has no friction
/// \param ratio   r/d [-], > 0
inline double frictionLimit(const PairLaw &law, double normal, double ratio)
{
  const ActingAreas area = actingAreas(law, ratio);
  return normal < 0.0 ? -law.friction * normal * area.normal / area.shear : 0.0;
}

/// What part of the spring a contact holds [-], 0 to 1; exactly 1 where it sticks.
/// \param size   of the spring's shear [-], >= 0
/// \param limit  of frictionLimit() [stress]
inline double heldShare(const PairLaw &law, double size, double limit)
{
  const double stress = law.twoG * size;
  return stress > limit ? limit / stress : 1.0;
}

} // namespace mca

#endif
