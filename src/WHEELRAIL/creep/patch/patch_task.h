// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_TASK_H
#define WHEELRAIL_CREEP_PATCH_TASK_H

#include "creep/patch/patch_curve.h"
#include "creep/sweep/creep_task.h"

#include <memory>

namespace wheelrail {

/// What a point contact is asked for, in any of its modes.
std::unique_ptr<CreepTask> taskOf(const PatchSpecification &asked);

} // namespace wheelrail
#endif
