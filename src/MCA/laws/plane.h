// SPDX-License-Identifier: GPL-2.0-or-later
/// \file plane.h
/// Plane strain and plane stress: the moduli that stand for the third direction.
///
/// Any consistent set of units; dimensions stand in brackets. No LAMMPS type in here.
#ifndef MCA_LAWS_PLANE_H
#define MCA_LAWS_PLANE_H

namespace mca {

/// What the elastic law of an automaton needs of its material.
struct ElasticModuli {
  double shear; ///< G [stress]
  double bulk;  ///< K [stress]: sigma_mean = K tr(eps), eps the strain in the plane
  double D;     ///< weight of the mean stress in the response of a contact [-]
};

/// Plane strain: the solid's own K and D = 1 - 2G/(3K).
/// \param shear  G [stress], > 0
/// \param bulk   K of the solid [stress], > 0
inline ElasticModuli planeStrainModuli(double shear, double bulk)
{
  return {shear, bulk, 1.0 - 2.0 * shear / (3.0 * bulk)};
}

/// Plane stress: Hooke's law in the plane is sigma = 2G eps + l' tr(eps), l' = 2Gl/(l + 2G), l = K
/// - 2G/3. With K' = (2/3)(G + l') and D = l'/K' the mean stress K' tr(eps) is (sigma_xx +
/// sigma_yy)/3, so that sigma_zz = 3 sigma_mean - sigma_xx - sigma_yy is 0 (doc/laws.md,
/// Elasticity).
/// \param shear  G [stress], > 0
/// \param bulk   K of the solid [stress], > 0
inline ElasticModuli planeStressModuli(double shear, double bulk)
{
  const double lame = bulk - 2.0 * shear / 3.0;
  const double plane = 2.0 * shear * lame / (lame + 2.0 * shear);
  const double reduced = 2.0 / 3.0 * (shear + plane);
  return {shear, reduced, plane / reduced};
}

} // namespace mca

#endif
