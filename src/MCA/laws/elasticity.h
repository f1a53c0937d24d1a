/// \file elasticity.h
/// Many-body elasticity of movable cellular automata in plane strain.
///
/// An automaton answers the strain e of each of its contacts by Hooke's law seen along the
/// contact's normal n, with a mean stress that all its contacts make together
/// (Psakhie, Shilko, Smolin et al., Phys. Mesomech. 14 (2011) 224; Shilko et al.,
/// Comput. Mater. Sci. 102 (2015) 267):
///     sigma_i = 2G e + D sigma_mean,i,   D = 1 - 2G/(3K),   tau_i = 2G gamma.
/// The contact carries the mean of its two sides. With a hexagonal packing this is Hooke's law
/// exactly under homogeneous strain, and the gradient of the energy
///     U = sum_i V [ (G/3) sum_j (e^2 + gamma^2) + D sigma_mean,i^2/(2K) ].
///
/// Any consistent set of units; dimensions stand in brackets. Strains are dimensionless. The
/// functions are branch-free so that loops over them vectorise.
#ifndef MCA_LAWS_ELASTICITY_H
#define MCA_LAWS_ELASTICITY_H

#include "packing.h"

namespace mca {

/// What the contacts of one automaton add up to: the plane tensors
/// P = sum (e n n + gamma (n t)_sym) [-] and N = sum n n [-]; t is n turned by +90 degrees.
/// tr P = sum e, and tr N is the number of contacts.
struct ContactSums {
  double Pxx, Pyy, Pxy, Nxx, Nyy, Nxy;
};

/// Plane stress components and the out-of-plane one, all [stress].
struct StressTensor {
  double xx, yy, xy, zz;
};

/// One contact's share of the sums; it is the same for both of its automata.
/// \param e      elastic normal strain [-], tension positive
/// \param gamma  elastic shear [-], half the engineering shear strain
/// \param nx,ny  unit normal from the first to the second automaton [-]
inline ContactSums contactShare(double e, double gamma, double nx, double ny)
{
  const double nxx = nx * nx, nyy = ny * ny, nxy = nx * ny;
  return {e * nxx - gamma * nxy, e * nyy + gamma * nxy, e * nxy + 0.5 * gamma * (nxx - nyy),
          nxx, nyy, nxy};
}

/// sigma_mean = (K/3) sum e = K tr(eps) in plane strain [stress].
/// \param bulkModulus K [stress]
inline double meanStress(const ContactSums &s, double bulkModulus)
{
  return bulkModulus * HexagonalPacking::stressWeight() * (s.Pxx + s.Pyy);
}

/// Stress of an automaton (1/V) sum_j q S n (sigma_i n + tau_i t), symmetrised, from its own
/// response to its contacts; sigma_zz = 3 sigma_mean - sigma_xx - sigma_yy [stress].
/// \param twoG           2G [stress]
/// \param D              1 - 2G/(3K) [-]
/// \param mean           sigma_mean [stress]
inline StressTensor automatonStress(const ContactSums &s, double twoG, double D, double mean)
{
  const double w = HexagonalPacking::stressWeight();
  const double xx = w * (twoG * s.Pxx + D * mean * s.Nxx);
  const double yy = w * (twoG * s.Pyy + D * mean * s.Nyy);
  const double xy = w * (twoG * s.Pxy + D * mean * s.Nxy);
  return {xx, yy, xy, 3.0 * mean - xx - yy};
}

/// One side's normal response sigma_i = 2G e + D sigma_mean,i [stress].
inline double normalResponse(double e, double twoG, double D, double mean)
{
  return twoG * e + D * mean;
}

/// Elastic energy of an automaton per volume [stress], from sums over its contacts.
/// \param sumSquares  sum_j (e^2 + gamma^2) [-]
inline double energyDensity(double sumSquares, double mean, double shearModulus,
                            double bulkModulus)
{
  const double D = 1.0 - 2.0 * shearModulus / (3.0 * bulkModulus);
  return HexagonalPacking::stressWeight() * shearModulus * sumSquares +
         D * mean * mean / (2.0 * bulkModulus);
}

/// Rotation of a pair's axis during one step [rad], exact for straight motion with the given
/// relative velocity: the angle from r(t - dt) to r(t).
/// \param r         distance now [length]
/// \param stepN,stepT  relative displacement of the step along n and t of now [length]
inline double axisRotation(double r, double stepN, double stepT)
{
  const double a = stepT / (r - stepN);
  const double a2 = a * a;
  return a * (1.0 - a2 * (1.0 / 3.0 - a2 * (1.0 / 5.0 - a2 * (1.0 / 7.0))));  // arctan a
}

/// Increment of the shear of a contact [-]: the axis' rotation less the mean rotation of the two
/// automata, so that a rigid rotation of the pair leaves no shear at any distance r.
/// \param turnI,turnJ  rotations of the automata in the step [rad]
inline double shearIncrement(double axisTurn, double turnI, double turnJ)
{
  return axisTurn - 0.5 * (turnI + turnJ);
}

}  // namespace mca

#endif
