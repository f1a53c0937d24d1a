// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case/case_scope.h"

namespace wheelrail {
namespace {

/// What a keyword of the other contact does not go with.
std::string contactWords(const CaseReader &reader, bool onLine)
{
  if (!onLine)
    return "contact.load: a point contact (with contact.width: a line contact)";
  return reader.has("contact.width") ? "a line contact (contact.width)"
                                     : "a line contact (contact.load_per_length)";
}

std::string modeWords(Scope here)
{
  if (here & (scope::lineFrozen | scope::pointFrozen))
    return "mode frozen";
  return here & (scope::lineMoving | scope::pointMoving) ? "mode moving" : "mode static";
}

/// What a keyword of the other kind of surface does not go with.
std::string surfaceWords(bool measured, bool onLine)
{
  if (!measured)
    return onLine ? "a generated profile" : "a generated surface";
  return onLine ? "measured profiles (roughness.rail, roughness.wheel)"
                : "measured maps (roughness.rail, roughness.wheel)";
}

std::string because(const char *why)
{
  return *why ? ": " + std::string(why) : std::string();
}

} // namespace

Scope scopeOf(CaseReader &reader)
{
  const std::string mode = reader.word("mode");
  const bool onPoint = (reader.has("contact.load") && !reader.has("contact.width")) ||
                       reader.has("contact.approach");
  if (mode == "frozen")
    return onPoint ? scope::pointFrozen : scope::lineFrozen;
  if (mode == "moving")
    return onPoint ? scope::pointMoving : scope::lineMoving;
  return onPoint ? scope::pointStatic : scope::lineStatic;
}

void checkScope(const CaseReader &reader, Scope here)
{
  const bool onLine = here & scope::line;
  const bool measured = reader.has("roughness.rail") || reader.has("roughness.wheel");
  const Scope contact = onLine ? scope::line : scope::point;
  const Scope otherSurface = measured ? scope::generated : scope::measured;
  for (const Keyword &keyword : keywords()) {
    if (!reader.has(keyword.name))
      continue;
    if (!(keyword.scope & contact))
      reader.refuse(keyword.name, contactWords(reader, onLine));
    if (!(keyword.scope & here))
      reader.refuse(keyword.name, modeWords(here) + because(keyword.why));
    if (keyword.scope & otherSurface)
      reader.refuse(keyword.name, surfaceWords(measured, onLine));
  }
  for (const Exclusion &exclusion : exclusions())
    if ((exclusion.scope & here) &&
        (reader.has(exclusion.given) || reader.hasGroup(exclusion.given)))
      reader.refuse(exclusion.excluded, exclusion.given + because(exclusion.why));
}

} // namespace wheelrail
