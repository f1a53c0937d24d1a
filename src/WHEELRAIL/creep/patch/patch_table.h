// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_TABLE_H
#define WHEELRAIL_CREEP_PATCH_TABLE_H

#include "creep/patch/patch_curve.h"
#include "creep/sweep/result_head.h"

#include <string>

namespace wheelrail {

/// The forces of a sweep as a regular table over load, speed, spin, lateral and longitudinal creep,
/// from which a multibody code interpolates.

/// \throws Error (Usage) for a case that makes no such table: not rolling, a sequence, forces
///         given, several surfaces, values of an axis that do not increase
void checkPatchTable(const PatchSpecification &asked);

/// CSV: lines that begin with '#' (what it is, units, the grid, the head), the names of the
/// columns, one row for each point of the grid in the order of the columns, the last coordinate
/// fastest. A point that did not converge has a row without forces.
/// \param curves of a specification that `checkPatchTable` passed; mm, N, m/s
std::string patchTable(const PatchSpecification &asked, const PatchCurves &curves,
                       const ResultHead &head);

} // namespace wheelrail
#endif
