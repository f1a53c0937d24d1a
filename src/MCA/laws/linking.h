// SPDX-License-Identifier: GPL-2.0-or-later
/// \file linking.h
/// The kinds of link and the transitions between them.
///
/// The paper leaves the criteria open. Preset a has one kind of link and one threshold. The others,
/// among them d, the default, follow a picture: the bulk is strong as an averaged body, while a
/// fresh cold weld is only as strong as its own contact, until it heals.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free: a transition that is
/// switched off has a limit that no stress reaches, infinity.
#ifndef MCA_LAWS_LINKING_H
#define MCA_LAWS_LINKING_H

#include "fracture.h"

namespace mca {

/// Kinds of pair; kept as a double beside the other pair state so that loops vectorise. Linked
/// kinds are positive.
namespace link {
constexpr double worn = -1.0; ///< unlinked; its link broke and it is still under linking pressure
constexpr double none = 0.0;  ///< unlinked: compression and viscosity only
constexpr double bulk = 1.0;  ///< elastic-plastic, breaks by the bulk criterion
constexpr double weld = 2.0;  ///< elastic-brittle
/// With keyword healed_strain what a weld heals to: a bulk link in all but the strain at which it
/// breaks.
constexpr double healed = 3.0;

/// Whether the pair bears tension and shear: a link of any kind.
inline bool isLinked(double kind)
{
  return kind > none;
}

/// Whether a number that was read is one of the kinds.
inline bool isKind(double number)
{
  return number == worn || number == none || number == bulk || number == weld || number == healed;
}

/// 1 for a linked kind, else 0: a factor, since loops over conditions as factors vectorise.
inline double linked(double kind)
{
  return kind > none ? 1.0 : 0.0;
}
} // namespace link

/// Limits of the transitions of one pair of materials, doc/laws.md, Links; the same for (i, j) and
/// (j, i). Infinity is no code here: a stress is compared with it and does not reach it.
struct LinkLimits {
  FractureLimits fracture; ///< of the criterion by which bulk links break
  int criterion;           ///< its number in FractureCriteria; the same for all pairs of a run
  double weldIntensity2;   ///< [stress^2]: a weld breaks at this squared stress intensity
  double linkPressure;     ///< [stress]: elastic compression that links an unlinked contact
  double healPressure;     ///< [stress]: ... that turns a weld or a worn contact into healedKind
  double healedKind;       ///< link::bulk, or link::healed where those break sooner
  double healedIntensity2; ///< squared strain intensity at which a healed link breaks [-]
  double linkedKind;       ///< what an unlinked contact becomes: link::bulk or link::weld
  double unloads;          ///< 1 where a worn contact may heal and is as good as others once it is
                           ///< unloaded, 0 where it stays worn up to the breaking strain
  double breakingStrain;   ///< eps_c of the tougher material [-]
  double countsWork;       ///< 1 where contacts link by plastic work, too, else 0
  double linkWork;         ///< [stress]: plastic work per volume of its automata while they were
                           ///< pressed together that links an unlinked contact
};

/// The kind of a pair after a step.
///
/// An unlinked contact links when its pressure *reaches* linkPressure: one that is still above it
/// when its link breaks is worn: it has to be unloaded first, or be pressed on to healPressure, or
/// by the rule "never" be apart by the breaking strain, at which it is forgotten by any rule. Were
/// it free to link again at once, a sliding weld would break and form every few steps, and
/// friction would depend on the step. For the same reason nothing heals that would break as a bulk
/// link at once.
/// \param kind        kind during the step
/// \param sigma,tau   elastic stresses of the contact, after plastic return [stress]
/// \param eps         its normal strain [-]
/// \param bulkBreaks  it would break as a bulk link; see breaks() of fracture.h
/// \param healedBreaks  it is strained to healedIntensity2, at which a healed link breaks, too
/// \param worked      the plastic work reaches linkWork
/// \param room        stress against lack of room, which presses, too [stress], <= 0
inline double nextKind(double kind, double sigma, double tau, double eps, bool bulkBreaks,
                       const LinkLimits &limit, bool worked = false, double room = 0.0,
                       bool healedBreaks = false)
{
  const double pressing = sigma + room;
  const bool weldBreaks = linkIntensity2(sigma, tau) >= limit.weldIntensity2;
  const bool heals = (-pressing >= limit.healPressure) & !bulkBreaks & !healedBreaks;
  const bool pressed = (-pressing >= limit.linkPressure) | worked;
  const bool breaksAsItIs = bulkBreaks | ((kind == link::healed) & healedBreaks);
  const double ifBulk = breaksAsItIs ? link::worn : kind;
  const double ifHealing = heals ? limit.healedKind : link::weld;
  const double ifWeld = weldBreaks ? link::worn : ifHealing;
  const double ifLinked = kind == link::weld ? ifWeld : ifBulk;
  const bool unloads = limit.unloads > 0.0;
  const double ifKept = (unloads & heals) ? limit.healedKind : link::worn;
  const bool stays = unloads ? pressed : eps < limit.breakingStrain;
  const double ifWorn = stays ? ifKept : link::none;
  const double ifFresh = pressed ? limit.linkedKind : link::none;
  const double ifUnlinked = kind == link::worn ? ifWorn : ifFresh;
  return kind > link::none ? ifLinked : ifUnlinked;
}

} // namespace mca

#endif
