// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_LINE_CONTACTS_H
#define WHEELRAIL_CREEP_LINE_LINE_CONTACTS_H

#include "contact/line/contact_setup.h"
#include "creep/sweep/sweep.h"

#include <string>
#include <vector>

namespace wheelrail {

/// Surfaces and normal contacts of all profiles of a line contact.
/// \param contact, surface SI units, as of `prepareContact`
/// \param pressureLimit Pa; infinite: elastic
/// \param travels the material will move through the contact
/// \return one for each of surface.profiles(), in their order
/// \throws what `prepareAll` and `prepareContact` throw
std::vector<ContactSetup> prepareContacts(const LineContactSpecification &contact,
                                          const SurfaceSpecification &surface, double pressureLimit,
                                          bool travels, const SweepOptions &options);

/// Lines for the user about surfaces, pressures and sizes that can hardly be meant
/// (`plausibility.h`).
/// \param strength sigma_0, Pa; 0: not in use
std::vector<std::string> contactDoubts(const std::vector<ContactSetup> &contacts,
                                       const LineContactSpecification &contact, double strength);

} // namespace wheelrail
#endif
