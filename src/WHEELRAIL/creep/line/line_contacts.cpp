// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/line_contacts.h"

#include "creep/sweep/plausibility.h"

#include <algorithm>

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

std::vector<std::string> contactDoubts(const std::vector<ContactSetup> &contacts,
                                       const LineContactSpecification &contact, double strength)
{
  std::vector<std::string> lines;
  const ElasticBody &softer =
      *std::min_element(contact.bodies.begin(), contact.bodies.end(),
                        [](auto &a, auto &b) { return a.youngsModulus < b.youngsModulus; });
  for (const ContactSetup &setup : contacts) {
    for (const std::string &remark : setup.surface.remarks)
      addDoubt(lines, remark);
    if (!setup.surface.statistics.empty())
      addDoubt(lines, slopeDoubt(setup.surface.statistics.back().step,
                                 setup.surface.statistics.back().rmsSlope));
    addDoubt(lines, pressureDoubt(setup.normal.peakPressure() * setup.hertz.modulus, strength,
                                  softer.youngsModulus));
    if (setup.boundary == Boundary::Periodic)
      continue;
    addDoubt(lines, sizeDoubt(setup.hertz.halfWidth, contact.radius));
    addDoubt(lines, radiusDoubt(contact.radius));
  }
  return lines;
}

} // namespace wheelrail
