// SPDX-License-Identifier: GPL-2.0-or-later
/// \file fracture.h
/// When a bulk link breaks. The paper does not state its criterion; those of laws/fracture/ are
/// exchangeable, and fracture_criteria.h lists them. Here stands what they are made of.
///
/// A criterion is a type derived from FractureCriterion with
///     static constexpr const char *keyword;  // the word after keyword fracture
///     static FractureLimits limits(const LinkMaterials &);
///     template<class Load> static bool broken(const Load &, const FractureLimits &);
/// where broken() is called for each link in a loop that has to vectorise: no branch (| and & for
/// || and &&, ?: for if) and no call but of inline functions. It reads from the load what it needs;
/// what it does not read costs nothing. A LinkLoad has all; one that says `strainOnly` is asked
/// with a LinkStrain, too.
///
/// Any consistent set of units; dimensions stand in brackets.
#ifndef MCA_LAWS_FRACTURE_H
#define MCA_LAWS_FRACTURE_H

#include "elasticity.h"
#include "material.h"
#include "plane.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace mca {

/// What a criterion needs unless it says otherwise.
struct FractureCriterion {
  /// It knows from the strains alone whether a link breaks, before any stress is known. Links of
  /// such a criterion go the kernel's shortest way.
  static constexpr bool strainOnly = false;
  /// It reads LinkLoad::local, for which both automata have to show their averaged stresses.
  static constexpr bool needsLocalStress = false;
  /// It acts in space, too, not only in the plane.
  static constexpr bool inSpace = true;
  /// Keyword of a number of its own, a multiple of the strength; nullptr: none.
  static constexpr const char *parameter = nullptr;
  /// What the number must be beyond > 0, in words; and whether it is.
  static constexpr const char *parameterRange = "> 0";
  static bool accepts(double /*parameter*/) { return true; }
};

/// The two materials that a link joins, for FractureCriterion's limits(). Holds references: for the
/// call only.
struct LinkMaterials {
  const Material &i, &j;
  ElasticModuli moduliI, moduliJ; ///< under the laws of the plane or of space
  int dimension;                  ///< 2 or 3
  double parameter;               ///< number of the criterion's own keyword; 1 where it has none

  /// sigma_0 of the weaker one [stress]
  double strength() const { return std::min(i.strength, j.strength); }
  /// eps_c of the weaker one [-]
  double breakingStrain() const { return std::min(i.breakingStrain, j.breakingStrain); }
};

/// Numbers that a criterion has made of the two materials, for its broken(); what each of the four
/// means is the criterion's own affair, and those that it does not use are not read. Made once for
/// each pair of materials, so that a loop over links divides nothing.
struct FractureLimits {
  double value[4];
};

/// Stress tensor where two automata meet, in the frame of the contact (after Psakhie, Shilko,
/// Smolin et al., Frattura ed Integrita Strutturale 24 (2013) 26, not compared with its text):
/// sigma and the length tau of the shear stress are those of the contact. What acts along its face
/// is the mean of both automata: in the plane along its line and across the plane, in space the two
/// principal stresses of the face. All [stress].
struct LocalStress {
  double sigma, tau, along, across;
};

/// Strains of a link, all that is known in the strain pass, before any stress.
/// \tparam Shear  a number, or in space a vector
template<class Shear>
struct LinkStrain {
  double eps;       ///< total normal strain, of strain.h [-]
  Shear gammaTotal; ///< total shear since linking, not reduced by plasticity [-]
};

/// All that is known of a link after the radial return; in space shears are lengths of vectors.
struct LinkLoad {
  double eps, gammaTotal; ///< as in LinkStrain [-]
  double e, gamma;        ///< elastic normal strain and shear [-]
  double sigma, tau;      ///< stresses [stress]
  double meanI, meanJ;    ///< mean stresses of both automata [stress]
  LocalStress local;      ///< for criteria that say needsLocalStress
};

/// A bulk link that is pressed together further than this has collapsed and breaks, whatever the
/// criterion [-].
///
/// Under pressure a bulk link flows without end, but at r -> 0 its axis turns by v_t dt/r in a
/// step, so that its shear is as stiff as 1/r^2: with the weight w of packing.h steps are unstable
/// below about r = sqrt(2w) c_s dt. At the longest step of viscous contacts that is 0.06 d; this is
/// the next round number above it where strains are r/d - 1, and 0.41 d where they are logarithmic.
/// Steps that would be unstable above it are refused (critical_step.h).
constexpr double collapseStrain = -0.9;

/// Whether a bulk link breaks, by this criterion or by collapse.
/// \tparam Criterion  one of FractureCriteria
/// \tparam Load       LinkLoad, or LinkStrain for a criterion that says strainOnly
/// \param limits      of this very criterion's limits(); those of another are numbers without a
///                    meaning
template<class Criterion, class Load>
inline bool breaks(const Load &load, const FractureLimits &limits)
{
  return Criterion::broken(load, limits) | (load.eps <= collapseStrain);
}

/// Squared stress intensity of a link [stress^2]: max(sigma, 0)^2 + 3 tau^2, the von Mises form of
/// one contact's tension and shear; compression does not count.
/// \param sigma  normal stress [stress], tension positive
/// \param tau    shear stress [stress], its sign or direction does not count
inline double linkIntensity2(double sigma, double tau)
{
  const double opening = sigma > 0.0 ? sigma : 0.0;
  return opening * opening + 3.0 * tau * tau;
}

/// What acts along the face of a contact in the plane and across the plane; sigma and tau are 0.
/// \param s  mean of both automata's averaged stresses after the return [stress]
/// \param n  unit normal of the contact [-]
inline LocalStress faceStress(const StressTensor &s, const PlaneVector &n)
{
  return {0.0, 0.0, s.xx * n.y * n.y + s.yy * n.x * n.x - 2.0 * s.xy * n.x * n.y, s.zz};
}

/// Stress of a face in space. With P = 1 - n n the face has the stress P s P, whose trace is
/// tr s - n.s.n and whose square is s:s - 2 |s n|^2 + (n.s.n)^2; its principal stresses, in
/// descending order, follow from both. A square that rounding makes negative counts as 0.
inline LocalStress faceStress(const StressTensor &s, const Vector &n)
{
  const Vector t = {s.xx * n.x + s.xy * n.y + s.xz * n.z, s.xy * n.x + s.yy * n.y + s.yz * n.z,
                    s.xz * n.x + s.yz * n.y + s.zz * n.z};
  const double across = dot(t, n);
  const double half = 0.5 * (s.xx + s.yy + s.zz - across);
  const double square = s.xx * s.xx + s.yy * s.yy + s.zz * s.zz +
                        2.0 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz) - 2.0 * dot(t, t) +
                        across * across;
  const double rest = 0.5 * square - half * half;
  const double radius = std::sqrt(rest > 0.0 ? rest : 0.0);
  return {0.0, 0.0, half + radius, half - radius};
}

} // namespace mca

#endif
