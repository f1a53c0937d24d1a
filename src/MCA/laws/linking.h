/// \file linking.h
/// The two kinds of link and the transitions between them.
///
/// The paper leaves the criteria open. Two presets come near its results: set A has one kind of
/// link and one threshold; set B (default) follows the picture that the bulk is strong as an
/// averaged body while a fresh cold weld is only as strong as its own contact, until it heals.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free: a transition that is
/// switched off has an infinite limit.
#ifndef MCA_LAWS_LINKING_H
#define MCA_LAWS_LINKING_H

#include "fracture.h"

namespace mca {

/// State of a pair; kept as a double beside the other pair state so that loops vectorise.
namespace link {
constexpr double none = 0.0;  ///< compression and viscosity only
constexpr double bulk = 1.0;  ///< elastic-plastic, breaks by the bulk criterion
constexpr double weld = 2.0;  ///< elastic-brittle
}  // namespace link

/// Limits of the transitions of one pair of materials.
struct LinkLimits {
  double bulkStrain2;     ///< eps_c^2 [-]: a bulk link breaks at this squared strain intensity
  double bulkIntensity2;  ///< [stress^2]: ... or at this squared stress intensity
  double weldIntensity2;  ///< [stress^2]: a weld breaks at this squared stress intensity
  double linkPressure;    ///< [stress]: elastic compression that links an unlinked contact
  double healPressure;    ///< [stress]: elastic compression that turns a weld into a bulk link
  double linkedKind;      ///< what an unlinked contact becomes: link::bulk or link::weld
};

/// The state of a pair after a step.
/// \param kind        state during the step
/// \param sigma,tau   elastic stresses of the contact, after plastic return [stress]
/// \param eps         total normal strain r/d - 1 [-]
/// \param gammaTotal  total shear since linking [-]
inline double nextKind(double kind, double sigma, double tau, double eps, double gammaTotal,
                       const LinkLimits &limit)
{
  const double strain2 = strainIntensity2(eps, gammaTotal), intensity2 = linkIntensity2(sigma, tau);
  const bool bulkBreaks = (strain2 >= limit.bulkStrain2) | (intensity2 >= limit.bulkIntensity2);
  const bool weldBreaks = intensity2 >= limit.weldIntensity2;
  const bool weldHeals = -sigma >= limit.healPressure;
  const bool links = -sigma >= limit.linkPressure;
  const double ifBulk = bulkBreaks ? link::none : link::bulk;
  const double ifHealing = weldHeals ? link::bulk : link::weld;
  const double ifWeld = weldBreaks ? link::none : ifHealing;
  const double ifNone = links ? limit.linkedKind : link::none;
  const double ifLinked = kind == link::bulk ? ifBulk : ifWeld;
  return kind == link::none ? ifNone : ifLinked;
}

}  // namespace mca

#endif
