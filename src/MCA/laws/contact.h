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

/// What an automaton answers to all its contacts.
struct Response {
  double mean;    ///< mean stress sigma_mean [stress]
  double factor;  ///< M of the radial return, 1 when elastic [-]
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
inline ContactStress contactStress(const PairLaw &law, double kind, double e, double gamma,
                                   double separation, const Response &i, const Response &j)
{
  const bool isBulk = kind == link::bulk, linked = kind != link::none;
  const double sigmaI = normalResponse(e, law.twoGi, law.Di, i.mean);
  const double sigmaJ = normalResponse(e, law.twoGj, law.Dj, j.mean);
  const double trial = 0.5 * (sigmaI + sigmaJ);
  const double returned =
      0.5 * (returnedNormal(sigmaI, i.mean, i.factor) + returnedNormal(sigmaJ, j.mean, j.factor));
  const double shear = 0.5 * (i.factor * law.twoGi + j.factor * law.twoGj) * gamma;
  const double viscous = unlinkedStress(trial, law.viscosity, separation, law.invDiameter);
  const bool touching = linked || e < 0.0;
  ContactStress s;
  s.trial = trial;
  s.sigma = isBulk ? returned : touching ? trial : 0.0;
  s.tau = isBulk ? shear : law.meanTwoG() * gamma;
  s.normal = linked ? s.sigma : touching ? viscous : 0.0;
  return s;
}

}  // namespace mca

#endif
