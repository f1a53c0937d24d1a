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
  double diameter, invDiameter;  ///< d [length], 1/d
  double area;                   ///< contact area S [length^2]
  double twoGi, twoGj;           ///< 2G of both sides [stress]
  double Di, Dj;                 ///< weight of the mean stress of both sides [-]
  double viscosity;              ///< eta [stress time]
  LinkLimits limits;

  double meanTwoG() const { return 0.5 * (twoGi + twoGj); }
};

/// Stresses of a contact [stress], tension positive.
struct ContactStress {
  double trial;   ///< elastic normal stress before the radial return
  double sigma;   ///< elastic normal stress after it; 0 for an open, unlinked pair
  double tau;     ///< shear stress after it
  double normal;  ///< sigma with the viscous part: what makes the force
};

/// \param kind        link::none, link::bulk or link::weld
/// \param e           elastic normal strain r/d - 1 - plastic offset [-]
/// \param gamma       elastic shear [-]
/// \param separation  normal velocity of j seen from i [length/time]
/// \param meanI,meanJ      mean stresses of the automata [stress]
/// \param factorI,factorJ  factors M of their radial returns [-]
inline ContactStress contactStress(const PairLaw &law, double kind, double e, double gamma,
                                   double separation, double meanI, double factorI,
                                   double meanJ, double factorJ)
{
  const bool isBulk = kind == link::bulk, linked = kind != link::none;
  const double sigmaI = normalResponse(e, law.twoGi, law.Di, meanI);
  const double sigmaJ = normalResponse(e, law.twoGj, law.Dj, meanJ);
  const double trial = 0.5 * (sigmaI + sigmaJ);
  const double returned =
      0.5 * (returnedNormal(sigmaI, meanI, factorI) + returnedNormal(sigmaJ, meanJ, factorJ));
  const double shear = 0.5 * (factorI * law.twoGi + factorJ * law.twoGj) * gamma;
  const double viscous = unlinkedStress(trial, law.viscosity, separation, law.invDiameter);
  const double touching = (linked | (e < 0.0)) ? 1.0 : 0.0;
  const double sigma = isBulk ? returned : touching * trial;
  const double tau = isBulk ? shear : law.meanTwoG() * gamma;
  const double normal = linked ? sigma : touching * viscous;
  return {trial, sigma, tau, normal};
}

}  // namespace mca

#endif
