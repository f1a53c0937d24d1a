// SPDX-License-Identifier: GPL-2.0-or-later
/// \file contact.h
/// One contact of two automata: its stresses, what it turns into, its force and its next state,
/// from its present state and what both automata answer. The same in the plane and in space, where
/// shears are vectors: their lengths decide, and the stress acts along them.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free.
/// Order in a step: elasticStresses(), the criterion and nextKind() of linking.h, contactStress(),
/// then contactForce() and nextState(). Tension is positive. Equations: doc/laws.md. Of an
/// automaton a contact knows only its Answer, so that contacts may be worked on in any order.
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

/// The present state of a contact and its strains. Of an unlinked one both shears are 0.
struct Contact {
  double kind;       ///< link::worn, none, bulk or weld
  double eps;        ///< total normal strain r/d - 1 [-]
  double plastic;    ///< plastic offset of it [-]
  double gamma;      ///< elastic shear [-], in space its length
  double gammaTotal; ///< total shear since linking [-], in space its length
  double separation; ///< normal velocity of j seen from i [length/time]
};

/// What an automaton answers its contacts.
struct Answer {
  double mean;   ///< mean stress [stress]
  double factor; ///< M of the radial return [-]
  /// What the normal stresses of its bulk links return to [stress]: in the plane the mean stress,
  /// in space the mean of sigma over its bulk links. Both are the same where all contacts are bulk
  /// links; elsewhere only the latter makes sure that flow dissipates, since what the automaton
  /// contributes is (1-M)/(2G) sum sigma (sigma - centre).
  double centre;
};

/// Elastic normal stress of a contact that touches [stress], tension positive: the mean of both
/// sides' responses sigma_i = 2G e + D sigma_mean,i (doc/laws.md, Elasticity; Psakhie et al. 2011).
/// \param e            elastic normal strain r/d - 1 - plastic offset [-]
/// \param meanI,meanJ  mean stresses of the automata [stress]
inline double elasticStress(const PairLaw &law, double e, double meanI, double meanJ)
{
  return 0.5 * (normalResponse(e, law.twoGi, law.Di, meanI) +
                normalResponse(e, law.twoGj, law.Dj, meanJ));
}

/// Normal stress of a bulk link after the radial return of its automata [stress],
///     sigma - [ (1-M_i)(sigma - centre_i) + (1-M_j)(sigma - centre_j) ]/2
/// (doc/laws.md, Plasticity).
/// \param sigma  elastic normal stress before it [stress]
/// \param i,j    what both automata answer
inline double returnedStress(double sigma, const Answer &i, const Answer &j)
{
  return sigma -
         0.5 * ((1.0 - i.factor) * (sigma - i.centre) + (1.0 - j.factor) * (sigma - j.centre));
}

/// What the return leaves of the shear of a bulk link [-], (M_i + M_j)/2: 1 where neither flows.
inline double returnedShare(const Answer &i, const Answer &j)
{
  return 0.5 * (i.factor + j.factor);
}

/// Elastic stresses of a contact [stress], tension positive.
struct ElasticStresses {
  double trial;      ///< elastic normal stress before the radial return
  double sigma, tau; ///< after it, which decide on the next kind
};

/// Stresses of a contact before and after the return. Linked contacts bear tension, too; an
/// unlinked one has a stress only while it is pressed, e < 0. Only bulk links are returned.
/// \param c    present state and strains; the shear is its size
/// \param i,j  what both automata answer
inline ElasticStresses elasticStresses(const PairLaw &law, const Contact &c, const Answer &i,
                                       const Answer &j)
{
  const double e = c.eps - c.plastic;
  const bool isBulk = c.kind == link::bulk;
  const double linked = link::linked(c.kind), pressed = e < 0.0 ? 1.0 : 0.0;
  const double trial = elasticStress(law, e, i.mean, j.mean);
  const double returned = returnedStress(trial, i, j);
  const double elasticShear = law.twoG * c.gamma;
  const double returnedShear = returnedShare(i, j) * elasticShear;
  const double touching = linked > pressed ? linked : pressed;
  return {trial, isBulk ? returned : touching * trial, isBulk ? returnedShear : elasticShear};
}

/// Stresses of a contact [stress], tension positive, and what it turns into.
struct ContactStress {
  double trial;         ///< elastic normal stress before the radial return
  double sigma, tau;    ///< elastic stresses after it, which decide on the next kind
  double normal, shear; ///< what makes the force: with viscosity, and none of a link that breaks
  double kindNext;      ///< kind from the next step on
};

/// The stresses of a contact whose next kind is known. A link that holds has its elastic stresses;
/// one that breaks in this step, or a pair that was unlinked, has compression with viscosity and no
/// shear.
/// \param s         of elasticStresses() [stress]
/// \param kindNext  what it is from the next step on
inline ContactStress contactStress(const PairLaw &law, const Contact &c, const ElasticStresses &s,
                                   double kindNext)
{
  const double pressed = c.eps - c.plastic < 0.0 ? 1.0 : 0.0;
  const double holds = link::linked(c.kind) * link::linked(kindNext);
  const double viscous = unlinkedStress(s.trial, law.viscosity, c.separation, law.invDiameter);
  const double normal = holds * s.sigma + (1.0 - holds) * pressed * viscous;
  const double shear = holds * s.tau;
  return {s.trial, s.sigma, s.tau, normal, shear, kindNext};
}

/// The same from what both automata answer.
inline ContactStress contactStress(const PairLaw &law, const Contact &c, const Answer &i,
                                   const Answer &j, double kindNext)
{
  return contactStress(law, c, elasticStresses(law, c, i, j), kindNext);
}

/// What a criterion sees of a contact as if it were a bulk link. Its elastic strains are those
/// after the return: what flowed is taken off the normal strain, the shear is tau/2G.
/// \param s     of elasticStresses() [stress]
/// \param face  of faceStress(), for criteria that need the local stress [stress]
inline LinkLoad linkLoad(const PairLaw &law, const Contact &c, const ElasticStresses &s,
                         const Answer &i, const Answer &j, const LocalStress &face)
{
  return {c.eps,
          c.gammaTotal,
          c.eps - c.plastic - (c.kind == link::bulk ? (s.trial - s.sigma) * law.invTwoG : 0.0),
          s.tau * law.invTwoG,
          s.sigma,
          s.tau,
          i.mean,
          j.mean,
          {s.sigma, s.tau, face.along, face.across}};
}

/// The same, and decides on the next kind by nextKind() of linking.h.
/// \tparam Criterion  of FractureCriteria, by which bulk links break
/// \param face        of faceStress() [stress]; only for criteria that need the local stress
/// \param worked      the plastic work reaches linkWork
template<class Criterion>
inline ContactStress contactStress(const PairLaw &law, const Contact &c, const Answer &i,
                                   const Answer &j, const LocalStress &face = {},
                                   bool worked = false)
{
  const ElasticStresses s = elasticStresses(law, c, i, j);
  const bool bulkBreaks = breaks<Criterion>(linkLoad(law, c, s, i, j, face), law.limits.fracture);
  return contactStress(law, c, s, nextKind(c.kind, s.sigma, s.tau, bulkBreaks, law.limits, worked));
}

/// The size of a shear by which laws decide: in the plane a signed number, in space a length >= 0.
/// Either has the dimension of the shear.
inline double shearSize(double shear)
{
  return shear;
}

inline double shearSize(const Vector &shear)
{
  return length(shear);
}

/// Elastic shear stress of a bulk link after the return [stress].
/// \param left   of returnedShare() [-]
/// \param twoG   mean 2G of both sides [stress]
/// \param gamma  elastic shear [-]
inline double returnedShear(double left, double twoG, double gamma)
{
  return left * (twoG * gamma);
}

/// The same in space, along the shear.
inline Vector returnedShear(double left, double twoG, const Vector &gamma)
{
  return (left * twoG) * gamma;
}

/// How the shear of a contact goes on: what is left of it, and the stress that acts along it.
template<class Shear>
struct ShearAnswer {
  double left;  ///< exactly 1 where nothing flows [-]
  Shear acting; ///< [stress]
};

/// In the plane: the stress is that of the contact, with its sign.
/// \param s     of a contact with the shear's size
/// \param left  of the shear, by the returns of both automata [-]
inline ShearAnswer<double> shearAnswer(const PairLaw &, double /*gamma*/, double /*size*/,
                                       const ContactStress &s, double left)
{
  return {left, s.shear};
}

/// In space: both stresses, which are lengths, act along the shear; without a shear there are none.
/// \param gamma  elastic shear before the return [-]
/// \param size   its length [-]
inline ShearAnswer<Vector> shearAnswer(const PairLaw &law, const Vector &gamma, double size,
                                       const ContactStress &s, double /*left*/)
{
  const double divisor = size > 0.0 ? law.twoG * size : 1.0;
  return {s.tau / divisor, s.shear / divisor * law.twoG * gamma};
}

/// What a contact is from the next step on: plastic offset of the normal strain, elastic shear and
/// total shear [-].
template<class Shear>
struct NextState {
  double plastic;
  Shear gamma, gammaTotal;
};

/// \param left  of its shear [-]; see shearAnswer()
template<class Shear>
inline NextState<Shear> nextState(const PairLaw &law, const Contact &c, const ContactStress &s,
                                  const Shear &gamma, const Shear &gammaTotal, double left)
{
  // conditions as factors of 0 or 1, which vectorise
  const double linkedNext = link::linked(s.kindNext), stays = link::linked(c.kind) * linkedNext;
  const double flow = c.kind == link::bulk ? (s.trial - s.sigma) * law.invTwoG : 0.0;
  const double dented = c.plastic + flow;
  // once apart, both surfaces are whole again
  const double apart = c.eps > (dented > 0.0 ? dented : 0.0) ? 1.0 - linkedNext : 0.0;
  return {(1.0 - apart) * dented, (stays * left) * gamma, stays * gammaTotal};
}

/// Force and torque of a contact on its first automaton, in the plane; the second one has the
/// opposite force and the same torque, so that momentum and angular momentum are kept (doc/laws.md,
/// Elasticity).
struct PlaneForce {
  double x, y;   ///< [force]
  double torque; ///< [force length]
};

/// The same in space: [force], [force length].
struct SpaceForce {
  Vector force, torque;
};

/// Force sigma S n + tau S (d/r) t and torque tau S d/2. The shear force acts along t at the
/// distance r; its moment keeps U's gradient exact (elasticity.h).
/// \param normal,shear  stresses that make the force [stress], tension positive
/// \param eps           total normal strain r/d - 1 [-], > -1
/// \param n             unit normal from i to j [-]
inline PlaneForce contactForce(const PairLaw &law, double normal, double shear, double eps,
                               const PlaneVector &n)
{
  const double fn = normal * law.area, ft = shear * law.area / (1.0 + eps);
  return {fn * n.x - ft * n.y, fn * n.y + ft * n.x, 0.5 * shear * law.area * law.diameter};
}

/// In space the moment is (d/2) n x tau S.
/// \param shear  shear stress, perpendicular to n [stress]
inline SpaceForce contactForce(const PairLaw &law, double normal, const Vector &shear, double eps,
                               const Vector &n)
{
  return {law.area * (normal * n + 1.0 / (1.0 + eps) * shear),
          0.5 * law.area * law.diameter * cross(n, shear)};
}

} // namespace mca

#endif
