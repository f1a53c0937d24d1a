// SPDX-License-Identifier: GPL-2.0-or-later
/// \file energy.h
/// Where the energy of a contact goes: exact book-keeping for the leap-frog steps of LAMMPS.
///
/// The elastic energy U of energyDensity() is quadratic in the elastic strains of the contacts, so
/// that its change between two states is the mean of both gradients times the change of strain,
/// exactly. Likewise the kinetic energy m v(-1/2) v(+1/2)/2, of the velocities half a step before
/// and after, changes by the mean of both forces times the way, exactly. What remains of a
/// contact's work is what it dissipates: in the step, since its force is not the gradient (it has
/// yielded, is viscous, or a neighbour's yielding changes its mean stress), and between steps, when
/// flow, fracture or linking change its state.
///
/// All energies here are per contact area and diameter, S d [stress]. Branch-free.
#ifndef MCA_LAWS_ENERGY_H
#define MCA_LAWS_ENERGY_H

#include "contact.h"

namespace mca {

/// Elastic strains of a contact as its energy sees them: the normal one is 0 while apart, the shear
/// 0 without a link [-].
struct ElasticStrain {
  double normal, shear;
};

/// Normal elastic strain of a contact as its energy sees it [-].
/// \param linked  in the state whose energy is asked for, present or next
/// \param e       eps less the plastic offset [-]
inline double touchingStrain(bool linked, double e)
{
  return linked || isPressed(e) ? e : 0.0;
}

/// Mean of the gradients of U along the normal before and after a change of state at a fixed place
/// [stress]; parameters as of changeLoss().
inline double meanGradient(const PairLaw &law, const ElasticStrain &before,
                           const ElasticStrain &after, const double (&meansBefore)[2],
                           const double (&meansAfter)[2])
{
  return 0.5 * (elasticStress(law, before.normal, meansBefore[0], meansBefore[1]) +
                elasticStress(law, after.normal, meansAfter[0], meansAfter[1]));
}

/// Energy that a change of state at a fixed place sets free [stress], < 0 where it is taken up: the
/// mean of both gradients times the change of strain. Which channel it belongs to is the caller's
/// affair.
/// \param before,after            strains under the present and the next state, at the same place
///                                [-]
/// \param meansBefore,meansAfter  mean stresses of both automata, i and j [stress]
inline double changeLoss(const PairLaw &law, const ElasticStrain &before,
                         const ElasticStrain &after, const double (&meansBefore)[2],
                         const double (&meansAfter)[2])
{
  return meanGradient(law, before, after, meansBefore, meansAfter) *
             (before.normal - after.normal) +
         0.5 * law.twoG * (before.shear * before.shear - after.shear * after.shear);
}

/// One end's half of what a step dissipates [stress]: the work of the force in half of the way less
/// the gradient of U times half of the change of the elastic strains. 0 for a contact that stays
/// elastic.
/// \param normal,shear  stresses that make the force at this end [stress]
/// \param here      elastic strains at this end [-]
/// \param means     mean stresses of both automata at this end [stress]
/// \param moved     change of the total strains in the step, later less earlier [-]
/// \param strained  change of the elastic strains in the step, later less earlier [-]
inline double stepLoss(const PairLaw &law, double normal, double shear, const ElasticStrain &here,
                       const double (&means)[2], const ElasticStrain &moved,
                       const ElasticStrain &strained)
{
  const double gradient = elasticStress(law, here.normal, means[0], means[1]);
  return 0.5 * (normal * moved.normal - gradient * strained.normal + shear * moved.shear -
                law.twoG * here.shear * strained.shear);
}

/// One end's half of what viscous resistance to slip dissipates in a step [stress].
/// \param stress  that makes the force at this end [stress]
/// \param way     of slipOf(), with displacements and rotations in the step, later less earlier,
///                and the normal and the arm of this end [length]
inline double slipLoss(const PairLaw &law, const Vector &stress, const Vector &way)
{
  return 0.5 * dot(stress, way) * law.invDiameter;
}

/// Kinetic energy m v(-1/2) v(+1/2)/2 of one component [energy]; a moment of inertia and an angular
/// velocity do as well. Unlike m v^2/2 it changes by exactly the mean force of both ends times the
/// way.
/// \param mass      m [mass]
/// \param velocity  at the time of the forces [length/time]
/// \param halfKick  change of the velocity in half a step by these forces [length/time]
inline double leapfrogEnergy(double mass, double velocity, double halfKick)
{
  return 0.5 * mass * (velocity - halfKick) * (velocity + halfKick);
}

} // namespace mca

#endif
