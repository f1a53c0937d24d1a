// SPDX-License-Identifier: GPL-2.0-or-later
/// \file worn_contacts.h
/// Other rules than that of linking.h for worn contacts, whose link broke: when they are as good as
/// contacts that never were linked. Equations: doc/laws.md, Links. No LAMMPS type in here.
#ifndef MCA_WORN_CONTACTS_H
#define MCA_WORN_CONTACTS_H

#include "laws/law_keywords.h"
#include "surfaces.h"

namespace mca {

/// After the force pass of all pairs: the next kinds of the contacts whose link breaks in this step
/// and of those that are worn, under another rule than "unloaded", which the kernel has. No force
/// depends on it: both kinds are unlinked.
///
/// Whatever the rule, a contact is forgotten at the breaking distance d (1 + eps_c), within which
/// all pairs are in the list: else the time at which lists are built would matter.
///
/// With "slid" a worn contact's first total shear holds how far its surfaces have slid since its
/// link broke [diameters].
/// \param rule  not "unloaded"
/// \param dt    the step [time]
/// \return how many more pairs change their kind
double applyWornRule(const WornRule &rule, const Pairs &, const Surfaces &, double dt);

} // namespace mca

#endif
