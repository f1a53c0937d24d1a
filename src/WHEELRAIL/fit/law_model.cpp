// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/law_model.h"

#include <stdexcept>

namespace wheelrail {

const char *nameOf(LawModel model)
{
  switch (model) {
  case LawModel::Constant:
    return "constant";
  case LawModel::Velocity:
    return "velocity";
  case LawModel::Pressure:
    return "eq4";
  case LawModel::VelocityKappa3:
    return "velocity_kappa3";
  case LawModel::Full:
    return "eq2";
  case LawModel::Kappa3:
    return "eq2_kappa3";
  }
  throw std::logic_error("nameOf: no such model");
}

bool hasKappa3(LawModel model)
{
  return model == LawModel::VelocityKappa3 || model == LawModel::Kappa3;
}

std::array<bool, fitParameters> parametersOf(LawModel model)
{
  const bool velocity = model != LawModel::Constant && model != LawModel::Pressure;
  const bool pressure =
      model == LawModel::Pressure || model == LawModel::Full || model == LawModel::Kappa3;
  return {true, velocity, pressure, velocity, pressure, hasKappa3(model)};
}

} // namespace wheelrail
