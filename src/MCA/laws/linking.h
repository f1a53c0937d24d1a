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
  const double intensity2 = linkIntensity2(sigma, tau);
  const bool bulkBreaks = strainIntensity2(eps, gammaTotal) >= limit.bulkStrain2 ||
                          intensity2 >= limit.bulkIntensity2;
  const double ifBulk = bulkBreaks ? link::none : link::bulk;
  const double ifWeld = intensity2 >= limit.weldIntensity2 ? link::none
      : -sigma >= limit.healPressure                       ? link::bulk
                                                           : link::weld;
  const double ifNone = -sigma >= limit.linkPressure ? limit.linkedKind : link::none;
  return kind == link::bulk ? ifBulk : kind == link::weld ? ifWeld : ifNone;
}

}  // namespace mca

#endif
