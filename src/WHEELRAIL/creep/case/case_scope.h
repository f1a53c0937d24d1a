// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_CASE_SCOPE_H
#define WHEELRAIL_CREEP_CASE_CASE_SCOPE_H

#include "creep/case/case_reader.h"

namespace wheelrail {

/// Contact and mode that a case asks for: one bit of those of line and point.
/// A load without a width is a point contact.
Scope scopeOf(CaseReader &reader);

/// Refuses every keyword that is given and not for this contact, mode and kind of surface, and
/// those that another one rules out: by the tables `keywords` and `exclusions`.
/// \throws what `CaseReader::refuse` throws
void checkScope(const CaseReader &reader, Scope here);

} // namespace wheelrail
#endif
