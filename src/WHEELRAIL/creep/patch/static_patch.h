// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_STATIC_PATCH_H
#define WHEELRAIL_CREEP_STATIC_PATCH_H

#include "creep/patch/patch_point.h"

namespace wheelrail {

struct PatchTask;

/// One shift from rest, without rolling. The point's creepage is the shift in m; its frictional
/// power and speed are 0.
struct StaticPatch {
  PatchPoint point;
  PatchFields fields;
};

/// @param task its forces, its force ratio, or its shift
/// @throws Error (NotConverged), Error (BadInput) for a force that friction cannot carry
StaticPatch solveStaticPatch(const CreepPhysics &physics, const FrictionLaw &law,
                             const PatchContact &contact, const PatchTask &task);

} // namespace wheelrail
#endif
