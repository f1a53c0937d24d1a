// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_CREEP_UNDER_FORCE_H
#define WHEELRAIL_CREEP_LINE_CREEP_UNDER_FORCE_H

#include <functional>

namespace wheelrail {

/// The creep at which a traction that grows with the creep has a given value: that nearest to zero
/// where friction falls with sliding.
/// \param force  any sign, in the unit of the traction
/// \param traction at a creep of any sign
/// \return to 1e-8 of the creep
/// \throws Error (NotConverged) for a force that is not reached, and what `traction` throws
double creepUnder(double force, const std::function<double(double creep)> &traction);

} // namespace wheelrail
#endif
