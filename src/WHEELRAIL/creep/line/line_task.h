// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_LINE_TASK_H
#define WHEELRAIL_CREEP_LINE_LINE_TASK_H

#include "creep/line/creep_curve.h"
#include "creep/line/static_contact.h"
#include "creep/sweep/creep_task.h"

#include <memory>

namespace wheelrail {

/// What a line contact is asked for: to roll, or to carry a force at rest.
std::unique_ptr<CreepTask> taskOf(const CreepSpecification &asked);
std::unique_ptr<CreepTask> taskOf(const StaticSpecification &asked);

} // namespace wheelrail
#endif
