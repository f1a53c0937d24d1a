// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_STATIC_PATCH_H
#define WHEELRAIL_CREEP_STATIC_PATCH_H

#include "creep/patch/patch_specification.h"

#include <functional>
#include <vector>

namespace wheelrail {

/// Shifts from rest, without rolling: one, or a sequence of loads and forces each of which goes on
/// from the one before, so that what slipped stays slipped. The point's creepage is the shift in m,
/// of a sequence the sum of all; its frictional power and speed are 0.
/// Friction is that of sliding speed 0 and no temperature rise: nothing slides on, nothing heats.
/// Pressure and traction of unlike bodies are solved by turns.
/// Below full sliding this is the problem of Cattaneo (1938) and Mindlin (1949), solved on the
/// cells, so that any surface and any direction will do.
struct StaticPatch {
  /// SI units; forces are those on the wheel.
  PatchPoint point;
  /// Traction and state after the shift; `slip` is the slip in m.
  PatchFields fields;
};

/// \param task its forces, its force ratio, or its shift
/// \throws Error (NotConverged), Error (BadInput) for a force that friction cannot carry
/// A force ratio comes first: it is put in as Fx = -ratio times the sum of mu p, Fy = 0. Then given
/// forces, whose shift is found; else the shift of the task.
/// \param contact its normal contact is the first that is tried
/// \param sequence its loads and forces take the place of the contact's and of the task's
/// \param goOn asked at each stage
/// \param history gets the stages of a sequence, one by one: those before one that fails, too
/// \return nothing when stopped
std::optional<StaticPatch> solveStaticPatch(const CreepPhysics &physics, const FrictionLaw &law,
                                            const PatchContact &contact, const PatchTask &task,
                                            const PatchSequence &sequence,
                                            const std::function<bool()> &goOn,
                                            PatchHistory &history);

} // namespace wheelrail
#endif
