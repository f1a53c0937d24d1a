// SPDX-License-Identifier: GPL-2.0-or-later
/// \file contact.h
/// Stresses of one contact of two automata, from its state and their responses.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free.
#ifndef MCA_LAWS_CONTACT_H
#define MCA_LAWS_CONTACT_H

#include "linking.h"
#include "plasticity.h"
#include "viscosity.h"

namespace mca {

/// Laws of one ordered pair of materials (i, j).
struct PairLaw {
  double diameter, invDiameter; ///< d [length], 1/d
  double area;                  ///< contact area S [length^2]
  double twoGi, twoGj;          ///< 2G of both sides [stress]
  double twoG, invTwoG;         ///< their mean [stress], and 1/mean
  double Di, Dj;                ///< weight of the mean stress of both sides [-]
  double viscosity;             ///< eta [stress time]
  double invMassI, invMassJ;    ///< 1/m of both sides [1/mass]
  LinkLimits limits;
};

/// Elastic normal stress of a touching contact [stress]: the mean of both sides' responses.
/// \param e            elastic normal strain r/d - 1 - plastic offset [-]
/// \param meanI,meanJ  mean stresses of the automata [stress]
inline double elasticStress(const PairLaw &law, double e, double meanI, double meanJ)
{
  return 0.5 * (normalResponse(e, law.twoGi, law.Di, meanI) +
                normalResponse(e, law.twoGj, law.Dj, meanJ));
}

/// What the normal stresses of bulk links of both automata return to [stress]: in the plane the
/// mean stress of the automaton, in space the mean of sigma over its bulk links. Both are the same
/// where all contacts are bulk links; elsewhere only the latter makes sure that flow dissipates,
/// since what the automaton contributes is (1-M)/(2G) sum sigma (sigma - centre).
struct ReturnCentre {
  double i, j;
};

/// Normal stress of a bulk link after the radial return of its automata [stress]:
/// sigma - [ (1-M_i)(sigma - centre_i) + (1-M_j)(sigma - centre_j) ]/2.
/// \param factorI,factorJ  M of both automata [-]
inline double returnedStress(double sigma, double centreI, double factorI, double centreJ,
                             double factorJ)
{
  return sigma - 0.5 * ((1.0 - factorI) * (sigma - centreI) + (1.0 - factorJ) * (sigma - centreJ));
}

/// Stresses of a contact [stress], tension positive, and what it turns into.
struct ContactStress {
  double trial;         ///< elastic normal stress before the radial return
  double sigma, tau;    ///< elastic stresses after it, which decide on the next kind
  double normal, shear; ///< what makes the force: with viscosity, and none of a link that breaks
  double kindNext;      ///< kind from the next step on
};

/// \param kind        link::worn, none, bulk or weld
/// \param eps         total normal strain r/d - 1 [-]
/// \param plastic     plastic offset of it [-]
/// \param gamma       elastic shear [-]
/// \param gammaTotal  total shear since linking [-]
/// \param separation  normal velocity of j seen from i [length/time]
/// \param meanI,meanJ      mean stresses of the automata [stress]
/// \param factorI,factorJ  factors M of their radial returns [-]
/// \tparam LOCAL  the criteria of local stress and of plastic work act; they need
/// \param around  stresses along and across the contact; see localStress()
/// \param work    plastic work per volume while pressed together, this step included [stress]
template<bool LOCAL = false>
inline ContactStress contactStress(const PairLaw &law, double kind, double eps, double plastic,
                                   double gamma, double gammaTotal, double separation, double meanI,
                                   double factorI, double meanJ, double factorJ,
                                   const ReturnCentre &centre, const LocalStress &around = {},
                                   double work = 0.0)
{
  const double e = eps - plastic;
  const bool isBulk = kind == link::bulk;
  const double linked = link::linked(kind), pressed = e < 0.0 ? 1.0 : 0.0;
  const double trial = elasticStress(law, e, meanI, meanJ);
  const double returned = returnedStress(trial, centre.i, factorI, centre.j, factorJ);
  const double elasticShear = law.twoG * gamma;
  const double returnedShear = 0.5 * (factorI + factorJ) * elasticShear;
  const double touching = linked > pressed ? linked : pressed;
  const double sigma = isBulk ? returned : touching * trial;
  const double tau = isBulk ? returnedShear : elasticShear;
  const LocalStress local = {sigma, tau, around.along, around.across};
  const bool overloaded = LOCAL && reaches(local, law.limits.bulkStress);
  const bool worked = LOCAL && work >= law.limits.linkWork;
  const double kindNext =
      nextKind(kind, sigma, tau, eps, gammaTotal, law.limits, overloaded, worked);

  const double holds = linked * link::linked(kindNext);
  const double viscous = unlinkedStress(trial, law.viscosity, separation, law.invDiameter);
  const double normal = holds * sigma + (1.0 - holds) * pressed * viscous;
  const double shear = holds * tau;
  return {trial, sigma, tau, normal, shear, kindNext};
}

/// The same in the plane.
template<bool LOCAL = false>
inline ContactStress contactStress(const PairLaw &law, double kind, double eps, double plastic,
                                   double gamma, double gammaTotal, double separation, double meanI,
                                   double factorI, double meanJ, double factorJ,
                                   const LocalStress &around = {}, double work = 0.0)
{
  return contactStress<LOCAL>(law, kind, eps, plastic, gamma, gammaTotal, separation, meanI,
                              factorI, meanJ, factorJ, ReturnCentre{meanI, meanJ}, around, work);
}

} // namespace mca

#endif
