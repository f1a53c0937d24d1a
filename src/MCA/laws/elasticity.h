// SPDX-License-Identifier: GPL-2.0-or-later
/// \file elasticity.h
/// Many-body elasticity of movable cellular automata in plane strain and in space.
///
/// An automaton answers the strain e of each of its contacts by Hooke's law seen along the
/// contact's normal n, with a mean stress that all its contacts make together
/// (Psakhie, Shilko, Smolin et al., Phys. Mesomech. 14 (2011) 224; Shilko et al.,
/// Comput. Mater. Sci. 102 (2015) 267):
///     sigma_i = 2G e + D sigma_mean,i,   D = 1 - 2G/(3K),   tau_i = 2G gamma.
/// The contact carries the mean of its two sides. With the packings of packing.h this is Hooke's
/// law exactly under homogeneous strain, and the gradient of the energy
///     U = sum_i V [ w G sum_j (e^2 + gamma^2) + D sigma_mean,i^2/(2K) ],
/// w = q S/V the packing's weight of a contact. In space gamma and tau are vectors perpendicular
/// to n.
///
/// Any consistent set of units; dimensions stand in brackets. Strains are dimensionless. The
/// functions are branch-free so that loops over them vectorise.
#ifndef MCA_LAWS_ELASTICITY_H
#define MCA_LAWS_ELASTICITY_H

#include "packing.h"
#include "vector.h"

namespace mca {

/// Symmetric stress tensor [stress], tension positive, along the axes of the box; in the plane xz =
/// yz = 0, and zz is what the plane's condition makes it.
struct StressTensor {
  double xx, yy, xy, zz, xz = 0.0, yz = 0.0;
};

/// sigma_mean = K w sum e = K tr(eps) [stress], since sum n n = (N/D) 1 over the contacts of an
/// automaton inside. Where contacts are missing, at a surface, the sum has fewer terms and the
/// stress is lower.
/// \param sumStrain    sum of the elastic normal strains of the contacts that touch [-]
/// \param bulkModulus  K [stress]; K' of planeStressModuli() under plane stress
/// \param weight       w of the packing [-]
inline double meanStress(double sumStrain, double bulkModulus,
                         double weight = packing::hex.stressWeight())
{
  return bulkModulus * weight * sumStrain;
}

/// One contact's share of the averaged stress (1/V) sum_j q S n (sigma n + tau t) of either of its
/// automata, symmetrised [stress]; t is n turned by +90 degrees, zz is left 0. Both automata get
/// the same share: n and t turn round together, and a stress does not see it.
/// \param sigma,tau  stresses of the contact [stress]
/// \param nx,ny      unit normal from the first to the second automaton [-]
inline StressTensor stressShare(double sigma, double tau, double nx, double ny)
{
  constexpr double w = packing::hex.stressWeight();
  const double nxx = nx * nx, nyy = ny * ny, nxy = nx * ny;
  return {w * (sigma * nxx - tau * nxy), w * (sigma * nyy + tau * nxy),
          w * (sigma * nxy + 0.5 * tau * (nxx - nyy)), 0.0};
}

/// Share of a contact in the stress in space, without the packing's weight [stress].
/// \param tau,n  vectors: shear stress of the contact [stress], unit normal [-]
inline StressTensor stressShare(double sigma, const Vector &tau, const Vector &n)
{
  return {n.x * (sigma * n.x + tau.x),
          n.y * (sigma * n.y + tau.y),
          sigma * n.x * n.y + 0.5 * (n.x * tau.y + n.y * tau.x),
          n.z * (sigma * n.z + tau.z),
          sigma * n.x * n.z + 0.5 * (n.x * tau.z + n.z * tau.x),
          sigma * n.y * n.z + 0.5 * (n.y * tau.z + n.z * tau.y)};
}

/// Stress tensor of an automaton in space [stress]. Nothing is assumed of any direction, so that
/// sides without contacts bear none.
/// \param sums    six sums of its contacts' shares: xx, yy, xy, zz, xz, yz [stress]
/// \param weight  w of the packing [-]
inline StressTensor weighted(const double *sums, double weight)
{
  return {weight * sums[0], weight * sums[1], weight * sums[2],
          weight * sums[3], weight * sums[4], weight * sums[5]};
}

/// Stress tensor of an automaton in the plane from the sums of its contacts' shares [stress]:
/// sigma_zz = 3 sigma_mean - sigma_xx - sigma_yy, in plane strain that of Hooke's law, 0 with the
/// moduli of plane stress.
/// \param xx,yy,xy  sums of stressShare(), with the weight of the packing in them [stress]
/// \param mean      sigma_mean of the automaton [stress]
inline StressTensor automatonStress(double xx, double yy, double xy, double mean)
{
  return {xx, yy, xy, 3.0 * mean - xx - yy};
}

/// The stress by which an automaton yields in the plane with plasticity isochoric: sigma_zz is the
/// mean of sigma_xx and sigma_yy, as in a solid that flows in plane strain and keeps its volume.
/// Its intensity is sqrt(3) times the largest shear stress in the plane.
/// \param xx,yy,xy  as above
inline StressTensor flowStress(double xx, double yy, double xy)
{
  return {xx, yy, xy, 0.5 * (xx + yy)};
}

/// One side's normal response sigma_i = 2G e + D sigma_mean,i [stress] (Psakhie et al. 2011,
/// Hooke's law along n).
/// \param e     elastic normal strain of the contact [-]
/// \param mean  mean stress of this side's automaton, of this step [stress]
inline double normalResponse(double e, double twoG, double D, double mean)
{
  return twoG * e + D * mean;
}

/// Elastic energy of an automaton per volume [stress], >= 0 for D >= 0, from sums over its
/// contacts. Each contact is in the sums of both of its automata.
/// \param sumSquares  sum_j (e^2 + gamma^2) [-], of contacts that touch
/// \param mean        mean stress [stress]
/// \param D           weight of the mean stress [-]
/// \param weight      w of the packing [-]
inline double energyDensity(double sumSquares, double mean, double shearModulus, double bulkModulus,
                            double D, double weight = packing::hex.stressWeight())
{
  return weight * shearModulus * sumSquares + D * mean * mean / (2.0 * bulkModulus);
}

/// Rotation of a pair's axis during one step [rad], exact for straight motion: the angle from r(t -
/// dt) to r(t), arctan(stepT/(r - stepN)), by its series up to the seventh power, which vectorises
/// (below 1e-12 up to 0.03 rad).
/// \param slope  relative displacement of the step along t over the former distance along n [-]
inline double axisRotation(double slope)
{
  const double a2 = slope * slope;
  return slope * (1.0 - a2 * (1.0 / 3.0 - a2 * (1.0 / 5.0 - a2 * (1.0 / 7.0))));
}

/// Increment of the shear of a contact [-]: the axis' rotation less the mean rotation of the two
/// automata, so that a rigid rotation of the pair leaves no shear at any distance r (doc/laws.md,
/// Strains of a pair).
/// \param axisTurn  of axisRotation() [rad]
/// \param turns     sum of the rotations of both automata in the step [rad]
inline double shearIncrement(double axisTurn, double turns)
{
  return axisTurn - 0.5 * turns;
}

} // namespace mca

#endif
