// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/line_contacts.h"

namespace wheelrail {

std::vector<ContactSetup> prepareContacts(const LineContactSpecification &contact,
                                          const SurfaceSpecification &surface, double pressureLimit,
                                          bool travels, const SweepOptions &options)
{
  std::vector<ContactSetup> contacts(surface.profiles());
  prepareAll(contacts.size(), options, [&](std::size_t k) {
    contacts[k] = prepareContact(contact, surface, k, pressureLimit, travels);
  });
  return contacts;
}

} // namespace wheelrail
