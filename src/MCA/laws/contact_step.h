// SPDX-License-Identifier: GPL-2.0-or-later
/// \file contact_step.h
/// The longest stable step of a sample of several materials, from each two that can meet.
#ifndef MCA_LAWS_CONTACT_STEP_H
#define MCA_LAWS_CONTACT_STEP_H

#include "critical_step.h"
#include "law_set.h"

namespace mca {

/// The limits where automata of two materials meet. Of equal materials those of criticalStep(). Of
/// unlike ones the lesser of two packings: all contacts are that of the pair (its 2G, viscosity and
/// diameter, the larger D K of both sides), all automata have the mass and the moment of inertia of
/// the one side, or of the other. An automaton whose contacts are of several kinds vibrates no
/// faster than in the worst of these (doc/laws.md, Time integration). `pressed` is infinite where
/// the laws have no plastic flow.
/// \param i,j  materials that checkMaterial() accepts, in units in which a stress is an energy per
///             volume
/// \param interface  what they have of their own, in the same units
CriticalStep contactStep(const LawSet &, const Material &i, const Material &j, const Packing &,
                         const Interface & = {});

/// The longest stable step of these limits under these laws [time]: as CriticalStep::plain() or
/// centred() has it, and at most `pressed`.
double longestStep(const LawSet &, const CriticalStep &);

} // namespace mca

#endif
