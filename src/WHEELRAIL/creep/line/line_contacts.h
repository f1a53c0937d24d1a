// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_LINE_CONTACTS_H
#define WHEELRAIL_CREEP_LINE_LINE_CONTACTS_H

#include "contact/line/contact_setup.h"
#include "creep/sweep/sweep.h"

#include <vector>

namespace wheelrail {

/// Surfaces and normal contacts of all profiles of a line contact.
/// @param contact, surface SI units, as of `prepareContact`
/// @param pressureLimit Pa; infinite: elastic
/// @param travels the material will move through the contact
/// @return one for each of surface.profiles(), in their order
/// @throws what `prepareAll` and `prepareContact` throw
std::vector<ContactSetup> prepareContacts(const LineContactSpecification &contact,
                                          const SurfaceSpecification &surface, double pressureLimit,
                                          bool travels, const SweepOptions &options);

} // namespace wheelrail
#endif
