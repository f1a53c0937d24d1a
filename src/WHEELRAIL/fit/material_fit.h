// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_MATERIAL_FIT_H
#define WHEELRAIL_FIT_MATERIAL_FIT_H

#include "fit/fit_condition.h"
#include "law/mu_table.h"
#include "law/softening_material.h"

#include <vector>

namespace wheelrail {

/// Puts each run at its temperature of the material.
/// \throws Error (BadInput) for a run that has not the strength and modulus of the material at any
///         temperature
void placeInMaterial(std::vector<FrictionRun> &runs, const SofteningMaterial &material);

/// The conditions as a table over p/sigma_0 and temperature, at the speed that most of them have.
/// Conditions of other speeds give the exponent of the speed, by what they differ from the one of
/// the same pressure and temperature (weighted least squares of the logarithms, the error widened
/// where they differ from a power); without any it is 0.
/// \param conditions at least one, of runs that have their temperatures
/// \throws Error (NotConverged) for two conditions of one pressure, temperature and speed, and for
///         one of another speed that has none beside it
MuTable tableOf(const std::vector<FitCondition> &conditions, const std::vector<FrictionRun> &runs);

} // namespace wheelrail

#endif
