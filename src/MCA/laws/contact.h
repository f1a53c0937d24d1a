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
///
/// A step of one bulk link, worked. Steel, hexagonal packing of discs, in nm and MPa: d = 2.5, h =
/// 1, S = d h/sqrt(3) = 1.4434, 2G = 158461.5, D = 9/13. It is stretched and sheared, and has
/// flowed before: eps = 5e-4, plastic = 1e-4, gamma = gammaTotal = 2e-4. The mean stresses of i and
/// j are 30 and 20, which are also their centres; i flows with M = 0.8, j does not, M = 1.
///
///     trial   = 2G (eps - plastic) + D (30 + 20)/2       = 80.692    elasticStress()
///     sigma   = trial - (1 - 0.8)(trial - 30)/2          = 75.623    returnedStress()
///     left    = (0.8 + 1)/2                              = 0.9       returnedShare()
///     tau     = left 2G gamma                            = 28.523    elasticStresses()
///     kind    = bulk, as eps is below the breaking strain = 1         nextKind()
///     Fn      = sigma S d/r, where d/r = exp(-eps)       = 109.10    contactForce()
///     Ft      = tau S d/r                                = 41.149
///     torque  = tau S d/2                                = 51.462
///     offset  = plastic + (trial - sigma)/2G             = 1.3199e-4 nextState()
///     shear   = left gamma                               = 1.8e-4
///     total   = gammaTotal, which flow leaves            = 2e-4
///
/// The force on i is Fn along n and Ft along t, that on j its opposite; both get the torque. The
/// last three are what the next step begins with: at the same strains and means its trial stress is
/// sigma.
#ifndef MCA_LAWS_CONTACT_H
#define MCA_LAWS_CONTACT_H

#include "fracture/by_strain.h"
#include "linking.h"
#include "plasticity.h"
#include "room.h"
#include "strain.h"
#include "vector.h"
#include "viscosity.h"

namespace mca {

/// Laws of one ordered pair of materials (i, j): all that a loop over contacts reads of both. Made
/// by makePairLaw() of law_set.h; LawTables::pairs has both (i, j) and (j, i) of unlike materials,
/// so that no loop exchanges sides. Of unlike materials d and eta are the means and S is that of
/// the mean d (doc/laws.md, Unlike materials). All numbers are finite but the limits of transitions
/// that are switched off, which are infinite.
struct PairLaw {
  double diameter, invDiameter; ///< d [length], 1/d
  /// Contact area S of the packing for this d [length^2]; it holds the thickness h in the plane.
  double area;
  /// 2G of both sides [stress], > 0.
  double twoGi, twoGj;
  /// Their mean [stress], and 1/mean: the shear stiffness of the contact, and what makes strains of
  /// returned stresses.
  double twoG, invTwoG;
  /// Weight of the mean stress of both sides [-]; 0 with elasticity pairwise.
  double Di, Dj;
  /// How soon an unlinked contact that is pressed flows with its automata (flow contacts): its
  /// weight in their flow is -contactsFlow e, 1 at most [-]. 0 where none does; huge where all do
  /// at once. With isochoric 2G/sigma_y1, so that a contact that is about to part has little left
  /// to give.
  double contactsFlow;
  /// 1 with isochoric, else 0: stresses act on S d/r (strain.h), and an unlinked contact that
  /// touches follows the gradient of the energy even where the mean stress of its automata pulls.
  double keepsEnergy;
  /// Most of a normal stress that the stretch of shear takes in a step [-], of mostStretch().
  double mostStretch;
  /// eta [stress time], >= 0; 0 where viscosity none is chosen.
  double viscosity;
  /// 1/m of both sides [1/mass], m = rho V of the cell; what holds an automaton is not known here.
  double invMassI, invMassJ;
  /// When links break, form and heal; strengths are those of the weaker material.
  LinkLimits limits;
  double invInertiaI, invInertiaJ; ///< 1/J of both sides [1/(mass length^2)]
  /// How many times its own damping a viscous contact takes at the new velocity [-]: 1; where it
  /// resists slip, so many that neighbours' dampings are in it, centredSlipShare in all.
  double centring;
  double friction; ///< mu of unlinked contacts [-], >= 0
};

/// How plastic shear lengthens a contact in a step; of shearStretch().
struct Stretch {
  double longer = 0.0; ///< by how much, so that its surroundings keep their volume [-]
  /// What the square of the elastic shear loses [-]: times G what this sets free for each S d.
  double squares = 0.0;
};

/// The present state of a contact and its strains, as its laws see them. Of an unlinked one both
/// shears are 0: what PairState keeps in their place, plastic work, is no shear and is taken out
/// before.
struct Contact {
  double kind;  ///< link::worn, none, bulk, weld or healed
  double ratio; ///< r/d [-], > 0
  /// Total normal strain, normalStrain() of r/d [-].
  double eps;
  /// Plastic offset of it [-]; the elastic strain is eps - plastic.
  double plastic;
  /// Elastic shear [-], an angle along t, in space the length of the vector.
  double gamma;
  /// Total shear since linking [-], not reduced by flow, in space the length of the vector.
  double gammaTotal;
  /// Normal velocity of j seen from i [length/time], > 0 when they part. Only unlinked contacts and
  /// links that break in this step read it.
  double separation;
  /// What plastic shear does to its length in this step; nothing but with isochoric.
  Stretch stretch = {};
};

/// What an automaton answers its contacts: all that a contact knows of it, a row
/// RowLayout::Response. Known after the yield pass; for automata of other ranks after the message
/// that follows.
struct Answer {
  double mean; ///< mean stress [stress]
  /// M of the radial return [-], in [0, 1]; exactly 1 where the automaton does not flow.
  double factor;
  /// What the normal stresses of its contacts return to [stress]: with radial in the plane the mean
  /// stress, else the mean of sigma over the contacts that flow, by their weights. Only the latter
  /// makes sure that flow dissipates, since what the automaton contributes is (1-M)/(2G) sum sigma
  /// (sigma - centre), and that the sum of their strains stays, hence the volume.
  double centre;
  /// Its pressure against lack of room [stress], >= 0; 0 but with isochoric.
  double room = 0.0;
};

/// Overlap above which an unlinked contact is pressed [-]. Far below any strain that matters, and
/// far above the round-off of places, 1e-10 d in a row of a million automata. So automata of a
/// perfect lattice, at r = d but for round-off, do not touch, whatever the units and the place. A
/// force jumps there, by the mean stress of the automata and by viscosity, as it does in the paper
/// at e = 0; what decides is a motion and no round-off.
constexpr double leastOverlap = 1e-9;

/// \param e  elastic normal strain of the contact [-]
inline bool isPressed(double e)
{
  return e < -leastOverlap;
}

/// Weight of a contact in the flow of its automata [-], 0 to 1: 1 of a bulk or healed link, with
/// flow contacts that of PairLaw::contactsFlow of an unlinked one that is pressed. Welds are
/// brittle.
/// \param contactsFlow  of its PairLaw
/// \param kind          of the contact, see link
/// \param e             its elastic normal strain [-]
inline double flowing(double contactsFlow, double kind, double e)
{
  const double weight = -contactsFlow * e, most = weight < 1.0 ? weight : 1.0;
  const double pressed = isPressed(e) ? 1.0 : 0.0;
  const double flows = pressed * most * (1.0 - link::linked(kind));
  return kind == link::weld ? 0.0 : link::linked(kind) + flows;
}

/// Elastic normal stress of a contact that touches [stress], tension positive: the mean of both
/// sides' responses sigma_i = 2G e + D sigma_mean,i (doc/laws.md, Elasticity; Psakhie et al. 2011).
/// \param e            elastic normal strain: eps less the plastic offset [-]
/// \param meanI,meanJ  mean stresses of the automata [stress]
inline double elasticStress(const PairLaw &law, double e, double meanI, double meanJ)
{
  return 0.5 * (normalResponse(e, law.twoGi, law.Di, meanI) +
                normalResponse(e, law.twoGj, law.Dj, meanJ));
}

/// Normal stress of a bulk link after the radial return of its automata [stress],
///     sigma - [ (1-M_i)(sigma - centre_i) + (1-M_j)(sigma - centre_j) ]/2
/// (doc/laws.md, Plasticity; Psakhie et al., Phys. Mesomech. 14 (2011) 224, with the mean of both
/// sides). Each side takes half, so that an automaton that flows alone is returned by half of what
/// its own yield stress asks for; see secondReturn().
/// \param sigma  elastic normal stress before it [stress]
/// \param flows  its weight in the flow, of flowing() [-]
/// \param i,j    what both automata answer
inline double returnedStress(double sigma, double flows, const Answer &i, const Answer &j)
{
  return sigma -
         0.5 * flows *
             ((1.0 - i.factor) * (sigma - i.centre) + (1.0 - j.factor) * (sigma - j.centre));
}

/// What the return leaves of the shear of a bulk link [-], (M_i + M_j)/2: 1 where neither flows, in
/// which case no digit of the shear changes.
inline double returnedShare(const Answer &i, const Answer &j)
{
  return 0.5 * (i.factor + j.factor);
}

/// By how much a contact has to lengthen so that plastic shear of its surroundings keeps their
/// volume (doc/laws.md, Plasticity; ours). Contacts carry their shear with them as they rotate: a
/// simple shear g stretches those of an automaton, ln(r/d), by g^2/8 in the mean over the
/// directions of a plane, by g^2/10 in space, and shears them by as much in the mean square. So
/// lengthening by what the square of its plastic shear grows takes that off.
/// \param left   of returnedShare() [-]: (1 - left) gamma flows in this step
/// \param gamma  elastic shear [-], a number in the plane, a Vector in space
/// \param total  total shear since linking [-]
template<class Shear>
inline Stretch shearStretch(double left, const Shear &gamma, const Shear &total)
{
  const double square = dot(gamma, gamma); // longer: (total - left gamma)^2 - (total - gamma)^2
  return {(1.0 - left) * (2.0 * dot(gamma, total) - (1.0 + left) * square),
          (1.0 - left) * (1.0 + left) * square};
}

/// What of the stretch a contact takes off its normal stress [stress]. Where that brings the stress
/// nearer to 0 it dissipates: at most mostStretch() of the stress. Where it does not, under
/// pressure above all, the work against the stress is at most half of what the shear sets free.
/// \param sigma  normal stress after the return [stress]
inline double stretchedOff(const PairLaw &law, double sigma, const Stretch &stretch)
{
  constexpr double none = 1e-300; // no stress needs no work
  const double size = sigma < 0.0 ? -sigma : sigma, most = law.mostStretch * size;
  // asked for, so that no division is left where a compiler knows that there is none
  const double work = 0.25 * law.twoG * law.twoG * stretch.squares;
  const double paid = stretch.squares > 0.0 ? work / (size + none) : 0.0;
  const double against = paid < most ? paid : most;
  const double top = sigma > 0.0 ? most : against, bottom = sigma > 0.0 ? against : most;
  const double less = law.twoG * stretch.longer, lower = less < top ? less : top;
  return lower > -bottom ? lower : -bottom;
}

/// Normal stress of a contact that flows [stress]: after the return and with its stretch. An
/// unlinked contact flows towards 0 at most, and flow lengthens it up to the breaking strain at
/// most: farther apart two automata do not touch. What it has above 0, where the mean stress of its
/// automata pulls, flows off at once and makes no force with radial; with isochoric it is left
/// alone (PairLaw::keepsEnergy). Nor does flow shorten it further than a link, collapseStrain:
/// nearer together it is elastic, and two automata never come to lie on each other.
/// \param trial    normal stress before the return [stress]
/// \param plastic  plastic offset of its normal strain [-]
/// \param flows    of flowing() [-]
/// \param stretch  of shearStretch() [-]
/// \param linked   1 or 0
inline double flowedStress(const PairLaw &law, double trial, double plastic, double flows,
                           const Stretch &stretch, double linked, const Answer &i, const Answer &j)
{
  const double returned = returnedStress(trial, flows, i, j);
  const double sigma = returned - stretchedOff(law, returned, stretch);
  const double room = law.limits.breakingStrain - plastic;
  const double lowest = trial - law.twoG * (room > 0.0 ? room : 0.0);
  const double depth = plastic - collapseStrain;
  const double highest = trial + law.twoG * (depth > 0.0 ? depth : 0.0);
  const double pulled = law.keepsEnergy * (trial > 0.0 ? trial : 0.0);
  const double pressed = sigma < pulled ? sigma : pulled;
  const double least = pressed > lowest ? pressed : lowest;
  return linked > 0.0 ? sigma : least < highest ? least : highest;
}

/// Elastic stresses of a contact [stress], tension positive; without viscosity.
struct ElasticStresses {
  /// Elastic normal stress before the radial return, also of a pair that is apart, where it acts on
  /// nothing.
  double trial;
  /// After it, which decide on the next kind. sigma of an unlinked pair that is apart is 0; tau is
  /// that of the shear given, a signed number in the plane and a length >= 0 in space.
  double sigma, tau;
};

/// Stresses of a contact before and after the return. Linked contacts bear tension, too; an
/// unlinked one has a stress only while it is pressed. Those of flowing() are returned.
/// \param c    present state and strains; gamma is its size
/// \param i,j  what both automata answer
/// \return numbers for any finite input; conditions are selected, not branched on
inline ElasticStresses elasticStresses(const PairLaw &law, const Contact &c, const Answer &i,
                                       const Answer &j)
{
  const double e = c.eps - c.plastic;
  const double flows = flowing(law.contactsFlow, c.kind, e);
  const double linked = link::linked(c.kind), pressed = isPressed(e) ? 1.0 : 0.0;
  const double trial = elasticStress(law, e, i.mean, j.mean);
  const double returned = flowedStress(law, trial, c.plastic, flows, c.stretch, linked, i, j);
  const double elasticShear = law.twoG * c.gamma;
  const double returnedShear = returnedShare(i, j) * elasticShear;
  const double touching = linked > pressed ? linked : pressed;
  return {trial, flows > 0.0 ? returned : touching * trial,
          flows > 0.0 ? returnedShear : elasticShear};
}

/// Elastic normal stress on which the viscosity of a contact acts that is pressed and unlinked, or
/// breaks in this step [stress]: after the return, but of a link that breaks the one before.
/// \param kind         present kind
/// \param eps,plastic  its normal strain and plastic offset [-]
inline double viscousStress(const PairLaw &law, double kind, double eps, double plastic,
                            const Answer &i, const Answer &j)
{
  Contact c{}; // without shear and room: it has no part in this stress
  c.kind = kind;
  c.eps = eps;
  c.plastic = plastic;
  const ElasticStresses s = elasticStresses(law, c, i, j);
  return link::isLinked(kind) ? s.trial : s.sigma;
}

/// Stresses of a contact [stress], tension positive, and what it turns into. Their shears are along
/// t in the plane, with their sign, and in space the length along the present shear.
struct ContactStress {
  double trial;      ///< elastic normal stress before the radial return
  double sigma, tau; ///< elastic stresses after it, which decide on the next kind
  /// What makes the force: with viscosity, and without tension and shear of a link that breaks.
  double normal, shear;
  /// Kind from the next step on. A link that is new has no force of a link in this step.
  double kindNext;
  /// What resists lack of room, a part of `normal`.
  double room;
  /// What its viscosity makes of `normal`.
  double viscous;
};

/// Shear stress on the face of the first automaton by which a viscous contact resists slip
/// [stress].
/// \param slip  of slipOf() [length/time]
inline Vector slipStress(const PairLaw &law, const Vector &slip)
{
  return law.viscosity * law.invDiameter * slip;
}

/// On which areas the stresses of a contact act at a distance [length^2]; strain.h.
struct ActingAreas {
  double normal, shear;
};

/// \param ratio  r/d [-], > 0
inline ActingAreas actingAreas(const PairLaw &law, double ratio)
{
  const double nearer = law.area / ratio;
  return {law.keepsEnergy > 0.0 ? nearer : law.area, nearer};
}

/// 1/d by which a viscous stress is made of a velocity [1/length], such that its force is that of
/// Table 1 at any distance.
/// \param ratio  r/d [-], > 0
inline double viscousInverse(const PairLaw &law, double ratio)
{
  return law.keepsEnergy > 0.0 ? law.invDiameter * ratio : law.invDiameter;
}

/// The stresses of a contact whose next kind is known. A link that holds has its elastic stresses;
/// one that breaks in this step, or a pair that was unlinked, has compression with viscosity and no
/// shear. So the force depends on the present state alone, and on the breaking that follows from
/// it; linking and healing act from the next step on.
/// \param s         of elasticStresses() [stress]
/// \param room      of roomStress() [stress]
/// \param kindNext  what it is from the next step on
inline ContactStress contactStress(const PairLaw &law, const Contact &c, const ElasticStresses &s,
                                   double room, double kindNext)
{
  const double pressed = isPressed(c.eps - c.plastic) ? 1.0 : 0.0;
  const double holds = link::linked(c.kind) * link::linked(kindNext);
  const double elastic = link::linked(c.kind) > 0.0 ? s.trial : s.sigma;
  const double unlinked = (1.0 - holds) * pressed *
                          unlinkedStress(elastic, law.viscosity, c.separation,
                                         viscousInverse(law, c.ratio), law.keepsEnergy);
  const double normal = holds * s.sigma + unlinked + room;
  const double shear = holds * s.tau;
  return {s.trial,
          s.sigma,
          s.tau,
          normal,
          shear,
          kindNext,
          room,
          unlinked -
              (1.0 - holds) * pressed * unlinkedStress(elastic, 0.0, 0.0, 0.0, law.keepsEnergy)};
}

/// Stresses of a contact from what both automata answer.
/// \param kindNext  as nextKind() of linking.h found it for this very evaluation, as for the
///                  questions of Step::contact(), which do not decide again
inline ContactStress contactStress(const PairLaw &law, const Contact &c, const Answer &i,
                                   const Answer &j, double kindNext)
{
  return contactStress(law, c, elasticStresses(law, c, i, j), roomStress(c.ratio, i.room, j.room),
                       kindNext);
}

/// What of its normal strain flows in the step [-]: 0 of a contact that does not flow.
/// \param trial,sigma  normal stress before and after the return [stress]
inline double flowOf(const PairLaw &law, const Contact &c, double trial, double sigma)
{
  return flowing(law.contactsFlow, c.kind, c.eps - c.plastic) > 0.0 ? (trial - sigma) * law.invTwoG
                                                                    : 0.0;
}

/// What a criterion sees of a contact as if it were a bulk link. Its elastic strains are those
/// after the return: what flowed is taken off the normal strain, the shear is tau/2G. Welds and
/// unlinked contacts are asked, too: what would break at once as a bulk link does not heal.
/// \param s     of elasticStresses() [stress]
/// \param i,j   what both automata answer; the mean stresses are handed on
/// \param face  of faceStress(), for criteria that need the local stress [stress]; its sigma and
///              tau are not read, those of the contact take their places
inline LinkLoad linkLoad(const PairLaw &law, const Contact &c, const ElasticStresses &s,
                         const Answer &i, const Answer &j, const LocalStress &face)
{
  LinkLoad load;
  load.eps = c.eps;
  load.gammaTotal = c.gammaTotal;
  load.e = c.eps - c.plastic - flowOf(law, c, s.trial, s.sigma);
  load.gamma = s.tau * law.invTwoG;
  load.sigma = s.sigma;
  load.tau = s.tau;
  load.meanI = i.mean;
  load.meanJ = j.mean;
  load.local = face;
  load.local.sigma = s.sigma;
  load.local.tau = s.tau;
  return load;
}

/// Stresses of a contact, whose next kind is decided by nextKind() of linking.h. The kernel's force
/// pass is this function for all pairs but those of blocks of bulk links of which none breaks by
/// its strain.
/// \tparam Criterion  of FractureCriteria, by which bulk links break
/// \param c       with the size of its shears, and the separation that the force pass knows
/// \param face    of faceStress() [stress]; only for criteria that need the local stress
/// \param worked  the plastic work reaches LinkLimits::linkWork; false where no law counts it
template<class Criterion>
inline ContactStress contactStress(const PairLaw &law, const Contact &c, const Answer &i,
                                   const Answer &j, const LocalStress &face = {},
                                   bool worked = false)
{
  const ElasticStresses s = elasticStresses(law, c, i, j);
  const bool bulkBreaks = breaks<Criterion>(linkLoad(law, c, s, i, j, face), law.limits.fracture);
  const bool healedBreaks = strainIntensity2(c.eps, c.gammaTotal) >= law.limits.healedIntensity2;
  const double room = roomStress(c.ratio, i.room, j.room);
  return contactStress(law, c, s, room,
                       nextKind(c.kind, s.sigma, s.tau, c.eps, bulkBreaks, law.limits, worked,
                                c.eps < 0.0 ? room : 0.0, healedBreaks));
}

/// The size of a shear by which laws decide: in the plane the signed number itself, of which
/// criteria take the square, in space a length >= 0. Either has the dimension of the shear.
inline double shearSize(double shear)
{
  return shear;
}

inline double shearSize(const Vector &shear)
{
  return length(shear);
}

/// Elastic shear stress of a bulk link after the return [stress], for blocks in which no link
/// breaks.
/// \param left   of returnedShare() [-]
/// \param twoG   mean 2G of both sides [stress]
/// \param gamma  elastic shear [-]
inline double returnedShear(double left, double twoG, double gamma)
{
  return left * (twoG * gamma);
}

/// Returned shear in space: a vector along the shear, whose direction stays.
inline Vector returnedShear(double left, double twoG, const Vector &gamma)
{
  return (left * twoG) * gamma;
}

/// How the shear of a contact goes on: what is left of it, and the stress that acts along it.
/// \tparam Shear  a number in the plane, a Vector in space
template<class Shear>
struct ShearAnswer {
  /// Factor of the elastic shear from the next step on, while the pair stays linked [-]; exactly 1
  /// where nothing flows.
  double left;
  /// What makes the force [stress]; 0 of an unlinked contact and of a link that breaks.
  Shear acting;
};

/// In the plane: the stress is that of the contact, with its sign.
/// \param s     of a contact with the shear's size
/// \param left  of the shear, by the returns of both automata [-]; of returnedShare() for bulk
///              links, else 1
inline ShearAnswer<double> shearAnswer(const PairLaw &, double /*gamma*/, double /*size*/,
                                       const ContactStress &s, double left)
{
  return {left, s.shear};
}

/// In space: both stresses, which are lengths, act along the shear; without a shear there are none.
/// The share that is left is found from the stresses, so that it agrees with them to rounding.
/// \param gamma  elastic shear before the return [-], perpendicular to the normal
/// \param size   its length [-], >= 0
/// \param s      of a contact with this length as its gamma
inline ShearAnswer<Vector> shearAnswer(const PairLaw &law, const Vector &gamma, double size,
                                       const ContactStress &s, double /*left*/)
{
  const double divisor = size > 0.0 ? law.twoG * size : 1.0;
  return {s.tau / divisor, s.shear / divisor * law.twoG * gamma};
}

/// What a contact is from the next step on: plastic offset of the normal strain, elastic shear and
/// total shear [-]. Its kind is ContactStress::kindNext.
template<class Shear>
struct NextState {
  double plastic;
  Shear gamma, gammaTotal;
};

/// The next state (doc/laws.md, Plasticity and Links). The offset takes what flowed, (trial -
/// sigma)/2G; an unlinked pair keeps it until its automata are apart, eps > max(offset, 0), and
/// both surfaces are whole again, or until lack of room closes the gap that a dent leaves, r < d:
/// then they touch, without stress yet. Neither changes the elastic energy.
/// With isochoric a link that breaks keeps its offset for a step: strainLeft() reads it. Shears
/// last only while a link lasts: a new link begins with none, a healed weld keeps both.
/// \param s           stress of this contact
/// \param gamma       elastic shear at this step, before the return [-]
/// \param gammaTotal  total shear since linking [-]; 0 of an unlinked contact
/// \param left        share of its elastic shear that is left [-]; see shearAnswer()
template<class Shear>
inline NextState<Shear> nextState(const PairLaw &law, const Contact &c, const ContactStress &s,
                                  const Shear &gamma, const Shear &gammaTotal, double left)
{
  // conditions as factors of 0 or 1, which vectorise
  const double linkedNext = link::linked(s.kindNext), stays = link::linked(c.kind) * linkedNext;
  const double flow = flowOf(law, c, s.trial, s.sigma);
  const bool closes =
      (c.eps > c.plastic) & (c.eps < 0.0) & (s.room < 0.0) & !link::isLinked(c.kind);
  const double dented = closes ? c.eps : c.plastic + flow;
  // once apart, both surfaces are whole again; a link that breaks leaves its strain first
  const double unlinked = 1.0 - (law.keepsEnergy > 0.0 ? link::linked(c.kind) : linkedNext);
  const double apart = c.eps > (dented > 0.0 ? dented : 0.0) ? (1.0 - linkedNext) * unlinked : 0.0;
  return {(1.0 - apart) * dented, (stays * left) * gamma, stays * gammaTotal};
}

/// Force and torque of a contact on its first automaton, in the plane; the second one has the
/// opposite force and the same torque, so that momentum and angular momentum are kept (doc/laws.md,
/// Elasticity).
struct PlaneForce {
  double x, y; ///< [force]
  /// About z, positive from x to y [force length].
  double torque;
};

/// Force of a contact in space: [force], [force length]; both along the axes of the box.
struct SpaceForce {
  Vector force, torque;
};

/// Force sigma S n + tau S (d/r) t and torque tau S d/2; with isochoric sigma acts on S d/r, too.
/// The shear force acts along t, n turned by +90 degrees, at the distance r; its moment tau S d is
/// what both torques balance, and d/r keeps the force the gradient of U (elasticity.h).
/// \param normal,shear  stresses that make the force [stress], tension positive
/// \param ratio         r/d [-], > 0
/// \param n             unit normal from i to j [-]
inline PlaneForce contactForce(const PairLaw &law, double normal, double shear, double ratio,
                               const PlaneVector &n)
{
  const ActingAreas area = actingAreas(law, ratio);
  const double fn = normal * area.normal, ft = shear * area.shear;
  return {fn * n.x - ft * n.y, fn * n.y + ft * n.x, 0.5 * shear * law.area * law.diameter};
}

/// Force of a contact in space, where the moment is (d/2) n x tau S on either automaton.
/// \param shear  shear stress [stress], perpendicular to n: a part along n would be a normal stress
inline SpaceForce contactForce(const PairLaw &law, double normal, const Vector &shear, double ratio,
                               const Vector &n)
{
  const ActingAreas area = actingAreas(law, ratio);
  return {(normal * area.normal) * n + area.shear * shear,
          0.5 * law.area * law.diameter * cross(n, shear)};
}

} // namespace mca

#endif
