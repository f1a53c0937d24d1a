// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SUBSURFACE_REPORT_H
#define WHEELRAIL_CREEP_SUBSURFACE_REPORT_H

#include "creep/patch/patch_curve.h"

#include <string>
#include <vector>

namespace wheelrail {

/// "subsurface_0003.csv", of an operating point, from 1 on.
std::string subsurfaceName(int number);

/// The largest stresses at each depth of the specification, in both bodies, and where: what of a
/// contact flows, and where cracks begin.
/// \param contact, fields of the operating point, SI
std::string subsurfaceCsv(const PatchSpecification &asked, const PatchContact &contact,
                          const PatchFields &fields);

} // namespace wheelrail
#endif
